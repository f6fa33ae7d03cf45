#!/usr/bin/env python3
"""What real meshes cost beside a check of points, beside TetGen and beside the readers of others, with goals, as the table of
docs/performance.md. `make bench-goals` compiles what it needs and runs it:

    bench/goals.py build/bench [MESH.ele ...] [--only WORD] [--divide N] [--rounds N] [--web build/web]

`tetgen` is in PATH. Without meshes, all rows are printed, of random points, boxes and bumpy spheres; --only takes those with a word
in their names, --divide makes their meshes so many times smaller. Of meshes, which have a .node and a .face file beside them, the
goals that are about a mesh of a domain are printed, in a line for each mesh; the boundary of each is its domain. Times are of the
processor, files included, the least of three; every round runs all rows, so that whatever else the machine does is in all of them.
What is not there (a package for npm, a reader of others) is named. The exit code is 1 if a goal is missed.
"""
import argparse
import math
import os
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile

import formats
import ranks
from taken import taken
from within_goals import write_bumpy_sphere, write_moved

CLAIM = ["--claim", "steiner-triangulation"]


def write_points(path, count):
    dice = random.Random(1)
    rows = "".join("%d %r %r %r\n" % (i, dice.random(), dice.random(), dice.random()) for i in range(count))
    path.write_text(f"{count} 3 0 0\n{rows}")


def write_box(path, is_tilted):
    """A box of twelve triangles, its faces along the axes or turned about two of them."""
    a, b = (0.3, 0.4) if is_tilted else (0, 0)
    points = []
    for i in range(8):
        x, y, z = i & 1, i >> 1 & 1, i >> 2 & 1
        x, y = x * math.cos(a) - y * math.sin(a), x * math.sin(a) + y * math.cos(a)
        y, z = y * math.cos(b) - z * math.sin(b), y * math.sin(b) + z * math.cos(b)
        points.append("%.17g %.17g %.17g\n" % (x, y, z))
    faces = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    triangles = "".join(f"3 {p} {q} {r}\n3 {p} {r} {s}\n" for p, q, r, s in faces)
    path.write_text(f"OFF\n8 12 0\n{''.join(points)}{triangles}")


def meshed(path, switches):
    """TetGen's mesh of a file."""
    subprocess.run(["tetgen", switches, path], check=True, stdout=subprocess.DEVNULL)
    return path.with_name(path.stem + ".1.ele")


def rows_of(path):
    """The rows of one of TetGen's files, without header, indices and comments."""
    lines = [line for line in path.read_text().splitlines() if not line.startswith("#")]
    return [line.split()[1:] for line in lines[1:]]


def boundary_of(mesh):
    """The surface that a mesh has, which is its domain exactly."""
    faces = [row[:3] for row in rows_of(mesh.with_suffix(".face"))]
    used = {v: i for i, v in enumerate(dict.fromkeys(v for face in faces for v in face))}
    points = rows_of(mesh.with_suffix(".node"))
    lines = [" ".join(points[int(v)][:3]) for v in used] + [" ".join(["3", *(str(used[v]) for v in face)]) for face in faces]
    surface = mesh.with_name(mesh.stem + "-boundary.off")
    surface.write_text("\n".join(["OFF", f"{len(used)} {len(faces)} 0", *lines]) + "\n")
    return surface


def without(mesh, name, one_in):
    """A copy in which one tetrahedron of so many is missing; 0: one alone."""
    dice = random.Random(2)
    header, rows = mesh.read_text().split("\n", 1)[0].split(), rows_of(mesh)
    kept = [row for i, row in enumerate(rows) if (i != len(rows) // 2 if one_in == 0 else dice.randrange(one_in) != 0)]
    copy = mesh.with_name(name + ".ele")
    lines = "".join(f"{i} {' '.join(row)}\n" for i, row in enumerate(kept))
    copy.write_text(f"{len(kept)} {' '.join(header[1:])}\n{lines}")
    copy.with_suffix(".node").write_bytes(mesh.with_suffix(".node").read_bytes())
    return copy


def size_of(path):
    """How many simplices or triangles a file has, as it is written in the name of a row."""
    words = path.read_text().split(None, 3)
    return f"{int(words[2] if path.suffix == '.off' else words[0]):,}"


class Table:
    """Rows: their names, their goals, and how to say what was measured; all commands in turns."""

    def __init__(self, rounds, only):
        self.rows, self.least, self.rounds, self.only = [], {}, rounds, only
        self.commands = {}

    def wants(self, name):
        return self.only in name

    def add(self, name, goal, value, commands=()):
        """value(): what was measured, in a number, and in words; None if it is not there."""
        if self.wants(name):
            self.rows.append((name, goal, value))
            self.commands.update(dict.fromkeys(commands))

    def times(self, name, command, beside, goal, most=None):
        """Processor time beside that of another command; with `most`, of memory in MB, too."""
        command, beside = (tuple(map(str, words)) for words in (command, beside))

        def value():
            (seconds, memory), (other, _) = self.least[command], self.least[beside]
            share = max(seconds / other / goal, memory / most if most else 0)
            return share * goal, f"{seconds / other:.2f} × ({seconds:.2f} s beside {other:.2f} s; {memory:.0f} MB)"
        self.add(name, (goal, False, f"≤ {goal} ×" + (f", ≤ {most} MB" if most else "")), value, [command, beside])

    def seconds(self, name, command, goal, each=None, words=""):
        """Processor time, or its share of each of some things in µs."""
        command = tuple(map(str, command))

        def value():
            seconds, memory = self.least[command]
            found = seconds / each * 1e6 if each else seconds
            return found, f"{found:.2f} {'µs' if each else 's'} ({seconds:.2f} s; {memory:.0f} MB)"
        self.add(name, (goal, False, f"≤ {goal} {'µs ' + words if each else 's'}"), value, [command])

    def measure(self):
        for _ in range(self.rounds):
            for command in self.commands:
                seconds, memory, code, said = taken(command)
                if code not in (0, 1):
                    sys.exit(f"expected an answer of {' '.join(command)}, found exit code {code}: {said[-500:]}")
                before = self.least.get(command, (seconds, memory))
                self.least[command] = min(seconds, before[0]), max(memory, before[1])

    def print(self):
        """The number of goals that are missed."""
        missed = 0
        print("| what | goal | measured | |\n| --- | --- | --- | --- |")
        for name, (goal, at_least, words), value in self.rows:
            try:
                found, measured = value()
            except (subprocess.CalledProcessError, ValueError) as fault:  # the other rows are printed all the same
                found, measured = None, f"not measured: {getattr(fault, 'stderr', None) or fault}".strip().splitlines()[-1]
            share = None if found is None else goal / found if at_least else found / goal
            verdict = "" if share is None else "met" if share <= 1 else f"missed by {100 * (share - 1):.0f} %"
            missed += verdict.startswith("missed")
            print(f"| {name} | {words} | {measured} | {verdict} |", flush=True)
        return missed

    def print_across(self):
        """A line for what is before the colon in the names of rows, and a column for what is behind it; what misses its goal is bold."""
        lines, goals, missed = {}, {}, 0
        for name, (goal, _, words), value in self.rows:
            subject, column = name.split(": ", 1)
            goals[column] = words
            is_missed = value()[0] > goal
            missed += is_missed
            lines.setdefault(subject, []).append(("**%.2f**" if is_missed else "%.2f") % value()[0])
        print(f"| mesh | tetrahedra | triangles | {' | '.join(goals)} |\n| --- |{' ---: |' * (2 + len(goals))}")
        print(f"| goal | | | {' | '.join(goals.values())} |")
        for subject, cells in lines.items():
            print(f"| {subject} | {' | '.join(cells)} |", flush=True)
        return missed


def add_boxes(table, command, folder, divide):
    """A box whose Steiner points were rounded, beside one along the axes, where they are exact."""
    for number, volume in enumerate((0.0002, 0.000027, 0.0000094)):
        boxes = [folder / f"{kind}{number}.off" for kind in ("tilted", "upright")]
        for box in boxes:
            write_box(box, box is boxes[0])
        meshes = [meshed(box, f"-pMq1.3a{volume * divide:.9f}Q") for box in boxes]
        tilted, upright = ([command, "check", mesh, "--domain", box, *CLAIM] for mesh, box in zip(meshes, boxes))
        name = f"a tilted box of 12 triangles, {size_of(meshes[0])} tetrahedra"
        table.times(f"{name}: `--within`, beside an upright box exactly", [*tilted, "--within", "1e-9x"], upright, 2)
        table.times(f"{name}: failing, with the note that proposes `--within`, beside an upright box", tilted, upright, 1.5)


def add_rounded(table, command, mesh, name):
    """A mesh with one vertex of a hundred moved by a unit in the last place, for the surface as it was, and as it is now."""
    moved = mesh.with_name(mesh.stem + "-moved.ele")
    write_moved(mesh, moved, 0.01)
    moved.with_suffix(".face").write_bytes(mesh.with_suffix(".face").read_bytes())
    exact, rounded = ([command, "check", moved, "--domain", boundary_of(one), *CLAIM] for one in (moved, mesh))
    table.times(f"{name}: `--within`, beside exactly", [*rounded, "--within", "1e-12x"], exact, 2)
    table.times(f"{name}: failing, with the note that proposes `--within`, beside a mesh that holds", rounded, exact, 1.5)


def add_formats(table, command, folder, divide):
    """One mesh in every format, beside NumPy's arrays and beside the readers of others."""
    if not (table.wants("formats") or table.wants("readers")):
        return
    found, reading = [], []
    for mesh, claim in formats.made(folder, 150_000 // divide):
        some = formats.measured(command, mesh, folder, claim, table.rounds)
        # Most of the time of a surface goes into whether its triangles meet.
        judging = 0 if mesh.size == 4 else some[0].seconds
        found += some
        reading += [(one.seconds - judging, one) for one in some]
    for kind, goal in formats.GOALS.items():
        slowest = max((one for one in found if one.kind == kind), key=lambda one: one.times)
        table.add(f"formats, {kind}, beside `.npy`: the slowest", (goal, False, f"≤ {goal} ×"),
                  lambda one=slowest: (one.times, f"{one.times:.2f} × ({one.name}, {one.seconds:.2f} s)"))
    largest = max(found, key=lambda one: one.memory_times)
    table.add("formats, memory, beside `.npy`: the most", (formats.MEMORY, False, f"≤ {formats.MEMORY} ×"),
              lambda: (largest.memory_times, f"{largest.memory_times:.2f} × ({largest.name}, {largest.memory:.0f} MB)"))
    for peer in formats.PEERS:
        beside = [(seconds / one.peers[peer], seconds, one) for seconds, one in reading if one.peers.get(peer)]
        share, seconds, one = max(beside, default=(None, None, None), key=lambda row: row[0])
        text = "not installed"
        if one:
            text = f"{share:.2f} × ({one.name}, {seconds:.2f} s beside {one.peers[peer]:.2f} s; {len(beside)} formats)"
        table.add(f"readers: `check`, of surfaces what it takes beyond `.npy`, beside reading by {peer}: the slowest", (1, False, "≤ 1 ×"),
                  lambda share=share, text=text: (share, text))


def add_domain(table, command, mesh, surface, name):
    check = [command, "check", mesh, "--domain", surface, *CLAIM]
    one, many = (without(mesh, f"{mesh.stem}-{kind}", share) for kind, share in (("one", 0), ("many", 33)))
    table.times(f"{name}: one missing, beside all", [*check[:2], one, *check[3:]], check, 1.5)
    table.times(f"{name}: 3 % missing, beside all", [*check[:2], many, *check[3:]], check, 1.5)
    table.times(f"{name}: `--claim conforming-delaunay`, beside that", [*check[:-1], "conforming-delaunay"], check, 1.5)
    return check


def add_domains(table, command, folder, divide):
    heavy = folder / "bumpy-sphere-82k.off"
    write_bumpy_sphere(heavy, max(2, math.isqrt(64 * 64 // divide)))
    mesh = meshed(heavy, "-pMFQ")
    name = f"domain, surface-heavy ({size_of(mesh)} tetrahedra, {size_of(heavy)} triangles)"
    check = add_domain(table, command, mesh, heavy, name)
    table.seconds(f"{name}: holds", check, 4, int(size_of(heavy).replace(",", "")), "a triangle")
    fine = folder / "bumpy-sphere-32k.off"
    write_bumpy_sphere(fine, max(2, math.isqrt(40 * 40 // divide)))
    mesh = meshed(fine, f"-pMYq1.4a{0.0000064 * divide:.9f}Q")
    add_domain(table, command, mesh, fine, f"domain, {size_of(mesh)} tetrahedra, {size_of(fine)} triangles")


def add_points(table, command, folder, divide):
    files = {}
    for count in (30_000, 150_000, 1_000_000):
        files[count] = folder / f"points-{count}.node"
        write_points(files[count], count // divide)
    mesh = meshed(files[150_000], "-Q")
    check = [command, "check", mesh]
    missing = without(mesh, "missing", 30)
    name = f"points, {size_of(mesh)} tetrahedra"
    table.times(f"{name}: one of 30 missing, beside all", [command, "check", missing], check, 4)
    table.times(f"`build delaunay`, {30_000 // divide:,} points, beside TetGen",
                [command, "build", "delaunay", files[30_000], "-o", folder / "built.ele"], [shutil.which("tetgen"), "-Q", files[30_000]], 3)
    large = meshed(files[1_000_000], "-Q")
    table.times(f"`compare` with itself, {size_of(large)} tetrahedra, beside `check`", [command, "compare", large, large],
                [command, "check", large], 1.5, 500)
    table.times(f"{name}: `certify`, beside `check`", [command, "certify", mesh, "-o", folder / "mesh.cert"], check, 4)
    table.times(f"{name}: `check --memory 256M`, beside `check`", [*check, "--memory", "256M"], check, 2)
    table.times(f"{name}: `check --memory 256M`, one of 30 missing, beside `check`",
                [command, "check", missing, "--memory", "256M"], check, 3)
    return mesh


def add_surfaces(table, command, folder, divide):
    """What is asked of a surface without a mesh."""
    for fineness, goal in ((26, 1), (71, 6)):
        surface = folder / f"bumpy-sphere-{fineness}.off"
        write_bumpy_sphere(surface, max(2, math.isqrt(fineness * fineness // divide)))
        table.seconds(f"`inspect --domain`, {size_of(surface)} triangles", [command, "inspect", "--domain", surface], goal)
        if fineness == 26:
            beside = [shutil.which("tetgen"), "-pYQ", surface]
            for kind in ("steiner-cdt", "conforming-delaunay"):
                table.times(f"`build {kind}`, {size_of(surface)} triangles, beside `tetgen -pY`",
                            [command, "build", kind, surface, "-o", folder / f"{kind}.ele"], beside, 20)


def add_ranks(table, build, mesh):
    """By the clock, in the order in which TetGen writes, the least of some rounds."""
    name = f"2 ranks beside 2 threads, {size_of(mesh)} tetrahedra in TetGen's order, by the clock"
    if not table.wants(name):
        return
    if not (build / "bin/circumspect-mpi").exists():
        table.add(name, (1.5, False, "≤ 1.5 ×"), lambda: (None, "not built"))
        return

    def value():
        threads, two = [], []
        for _ in range(table.rounds):
            threads.append(ranks.run([str(build / "bin/circumspect"), "check", "--threads", "2", str(mesh)])[0])
            said = ranks.run([*ranks.MPIRUN, "2", str(build / "bin/circumspect-mpi"), str(mesh), "--statistics"])[1]
            two.append(ranks.seconds_of_ranks(list(ranks.rows_of(said))))
        return min(two) / min(threads), f"{min(two) / min(threads):.2f} × ({min(two):.2f} s beside {min(threads):.2f} s)"
    table.add(name, (1.5, False, "≤ 1.5 ×"), value)


# Both judge a mesh in arrays on one thread, and print the least processor time of some rounds.
IN_NODE = """import { readFileSync } from 'node:fs';
const [folder, points, cells, rounds] = process.argv.slice(1);
const { check } = await import(folder + '/index.mjs');
const bytes = (path) => new Uint8Array(readFileSync(path)).buffer;
const at = new Float64Array(bytes(points)), simplices = new Int32Array(bytes(cells));
let least = Infinity;
for (let i = 0; i < Number(rounds); ++i) {
  const start = process.cpuUsage();
  if (!check(at, simplices, { dimension: 3 }).holds) throw new Error('the mesh does not hold');
  const { user, system } = process.cpuUsage(start);
  least = Math.min(least, (user + system) / 1e6);
}
console.log(least);"""
IN_PYTHON = """import sys, time
import numpy as np, scipy.spatial, circumspect
def least(call):
    times = []
    for _ in range(int(sys.argv[1])):
        start = time.process_time()
        call()
        times.append(time.process_time() - start)
    return min(times)
if len(sys.argv) > 2:
    points, cells = np.fromfile(sys.argv[2]).reshape(-1, 3), np.fromfile(sys.argv[3], np.int32).reshape(-1, 4)
    print(least(lambda: circumspect.check(points, cells, threads=1)))
else:
    sets = [np.random.default_rng(seed).random((12, 3)) for seed in range(1000)]
    cells = [scipy.spatial.Delaunay(points).simplices for points in sets]
    print(1000 / least(lambda: [circumspect.check(*one) for one in zip(sets, cells)]))"""


def in_python(build, *words):
    """None if the Python package was not built."""
    if not list((build / "python/circumspect").glob("_core*")):
        return None
    environment = {**os.environ, "PYTHONPATH": str(build / "python")}
    return float(subprocess.run(["/usr/bin/python3", "-c", IN_PYTHON, *words], env=environment, check=True, capture_output=True,
                                text=True).stdout)


def add_in_process(table, build, mesh, folder, web):
    name, package = "WebAssembly beside native, in process, one thread", pathlib.Path(web, "package").absolute()

    def web_value():
        points = formats.array.array("d", (float(x) for row in rows_of(mesh.with_suffix(".node")) for x in row[:3]))
        cells = formats.array.array("i", (int(v) for row in rows_of(mesh) for v in row[:4]))
        files = [str(folder / name) for name in ("points.raw", "cells.raw")]
        for path, values in zip(files, (points, cells)):
            pathlib.Path(path).write_bytes(values.tobytes())
        native = in_python(build, str(table.rounds), *files)
        if native is None or not (package / "index.mjs").exists():
            return None, f"not built: {'the Python package' if native is None else 'make npm'}"
        node = subprocess.run(["node", "--input-type=module", "-e", IN_NODE, package, *files, str(table.rounds)], check=True,
                              capture_output=True, text=True)
        return float(node.stdout) / native, f"{float(node.stdout) / native:.2f} × ({float(node.stdout):.2f} s beside {native:.2f} s)"
    table.add(f"{name}, {size_of(mesh)} tetrahedra", (2, False, "≤ 2 ×"), web_value)

    def judging(dimension):
        said = subprocess.run([build / "bin/circumspect_bench", "draw and judge"], check=True, capture_output=True, text=True).stdout
        cells = next(row for row in (line.split("|") for line in said.splitlines())
                     if len(row) > 5 and row[2].strip() == str(dimension) and row[3].strip().startswith("12"))
        rate = float(cells[4]) / (1 - float(cells[5].split()[0]) / 100)
        return rate, f"{rate:.0f} a second ({float(cells[4]):.0f} with drawing)"
    for dimension in (2, 3):
        table.add(f"judge of 12 points, dimension {dimension}, the C++ harness in process", (15000, True, "≥ 15,000 a second"),
                  lambda dimension=dimension: judging(dimension))

    def python_value():
        rate = in_python(build, "5")
        return rate, "not built" if rate is None else f"{rate:.0f} a second"
    table.add("judge of 12 points, dimension 3, Python in process", (10000, True, "≥ 10,000 a second"), python_value)


def add_mesh(table, command, given, folder):
    """The goals of a mesh of a domain, which is its own boundary; it need not be a Delaunay triangulation."""
    mesh = folder / given.name.replace(".1.", ".")
    for ending in (".ele", ".node", ".face"):
        mesh.with_suffix(ending).write_bytes(given.with_suffix(ending).read_bytes())
    surface, name = boundary_of(mesh), f"{mesh.stem} | {size_of(mesh)} | {size_of(boundary_of(mesh))}"
    add_rounded(table, command, mesh, name)
    add_domain(table, command, mesh, surface, name)
    alone = [command, "check", mesh, "--claim", "complex"]
    table.times(f"{name}: `compare` with itself, beside `--claim complex`", [command, "compare", mesh, mesh], alone, 1.5)
    triangles = int(size_of(surface).replace(",", ""))
    table.seconds(f"{name}: `inspect --domain`", [command, "inspect", "--domain", surface], 60, triangles, "a triangle")
    points = formats.array.array("d", (float(x) for row in rows_of(mesh.with_suffix(".node")) for x in row[:3]))
    cells = formats.array.array("i", (int(v) for row in rows_of(mesh) for v in row[:4]))
    found = formats.measured(command, formats.Mesh(points, cells, 4), folder, ["--claim", "complex"], table.rounds, with_peers=False)
    for kind, goal in formats.GOALS.items():
        slowest = max(one.times for one in found if one.kind == kind)
        table.add(f"{name}: formats, {kind}", (goal, False, f"≤ {goal} ×"), lambda slowest=slowest: (slowest, f"{slowest:.2f} ×"))


def add_all(table, command, folder, options):
    divide = options.divide
    add_boxes(table, command, folder, divide)
    rounded = folder / "bumpy-sphere-101k.off"
    write_bumpy_sphere(rounded, max(2, math.isqrt(71 * 71 // divide)))
    mesh = meshed(rounded, f"-pMq1.4a{0.0000075 * divide:.9f}Q")
    add_rounded(table, command, mesh, f"a surface of {size_of(rounded)} triangles, {size_of(mesh)} tetrahedra")
    add_formats(table, command, folder, divide)
    add_domains(table, command, folder, divide)
    add_surfaces(table, command, folder, divide)
    mesh = add_points(table, command, folder, divide)
    add_ranks(table, options.build, mesh)
    add_in_process(table, options.build, mesh, folder, options.web)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("build", type=lambda name: pathlib.Path(name).absolute())
    parser.add_argument("meshes", nargs="*", type=pathlib.Path, metavar="MESH.ele")
    parser.add_argument("--only", default="", metavar="WORD")
    parser.add_argument("--divide", type=int, default=1, metavar="N")
    parser.add_argument("--rounds", type=int, default=3, metavar="N")
    parser.add_argument("--web", default="build/web", metavar="FOLDER")
    options = parser.parse_intermixed_args()
    if not shutil.which("tetgen"):
        sys.exit("expected tetgen in PATH, found none: Debian has it in the package tetgen")
    command, table = options.build / "bin/circumspect", Table(options.rounds, options.only)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for given in options.meshes:
            add_mesh(table, command, given, folder)
        if not options.meshes:
            add_all(table, command, folder, options)
        table.measure()
        return 1 if (table.print_across() if options.meshes else table.print()) else 0


if __name__ == "__main__":
    sys.exit(main())
