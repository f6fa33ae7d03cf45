#!/usr/bin/env python3
"""What commands cost beside a check of the same mesh, or beside TetGen, as a table with goals (docs/performance.md):

    bench/beside.py build/release/bin/circumspect [SURFACE.off ...]

`tetgen` is in PATH. It triangulates random points, and meshes surfaces: those given, else a bumpy sphere of 100,820 triangles.
Times are of the processor, files included, the least of three; every round runs all rows, so that whatever else the machine does
is in all of them. The exit code is 1 if a goal is missed, for points and for the sphere.
"""
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile

from taken import taken
from within_goals import FINENESS, write_bumpy_sphere

ROUNDS = 3
BUILT, JUDGED = 30_000, 150_000  # points


def write_points(path, count):
    dice = random.Random(1)
    rows = "".join("%d %r %r %r\n" % (i, dice.random(), dice.random(), dice.random()) for i in range(count))
    path.write_text(f"{count} 3 0 0\n{rows}")


def meshed(path, switches):
    """TetGen's mesh of a file."""
    subprocess.run(["tetgen", switches, path], check=True, stdout=subprocess.DEVNULL)
    return path.with_name(path.stem + ".1.ele")


def without(mesh, name, one_in):
    """A copy in which one tetrahedron of so many is missing; 0: one alone."""
    dice = random.Random(2)
    header, *rows = [line for line in mesh.read_text().splitlines() if not line.startswith("#")]
    count, columns = int(header.split()[0]), header.split()[1:]
    kept = [row.split()[1:] for i, row in enumerate(rows[:count])
            if (i != count // 2 if one_in == 0 else dice.randrange(one_in) != 0)]
    copy = mesh.with_name(name + ".ele")
    lines = "".join(f"{i} {' '.join(row)}\n" for i, row in enumerate(kept))
    copy.write_text(f"{len(kept)} {' '.join(columns)}\n{lines}")
    copy.with_suffix(".node").write_bytes(mesh.with_suffix(".node").read_bytes())
    return copy


class Table:
    """Rows: what is measured, beside which command, the goal of the ratio; all commands in turns."""

    def __init__(self):
        self.rows, self.least = [], {}

    def add(self, name, command, beside, goal):
        self.rows.append((name, tuple(map(str, command)), tuple(map(str, beside)), goal))

    def measure(self):
        commands = list(dict.fromkeys(one for row in self.rows for one in row[1:3]))
        for _ in range(ROUNDS):
            for command in commands:
                seconds, memory, code, _ = taken(command)
                if code not in (0, 1):
                    sys.exit(f"expected an answer of {' '.join(command)}, found exit code {code}")
                before = self.least.get(command, (seconds, memory))
                self.least[command] = min(seconds, before[0]), max(memory, before[1])

    def print(self):
        """The number of goals that are missed."""
        missed = 0
        for name, command, beside, goal in self.rows:
            (seconds, memory), (other, _) = self.least[command], self.least[beside]
            missed += seconds > goal * other
            print(f"| {name} | {seconds:.2f} s | {memory:.0f} MB | {other:.2f} s | {seconds / other:.1f} | {goal} |", flush=True)
        return missed


def add_points(table, command, folder):
    few, many = folder / "few.node", folder / "many.node"
    write_points(few, BUILT)
    write_points(many, JUDGED)
    tetgen = [shutil.which("tetgen"), "-Q", few]
    table.add("`build delaunay`, 30,000 points, beside TetGen", [command, "build", "delaunay", few, "-o", folder / "built.ele"], tetgen, 3)
    mesh = meshed(many, "-Q")
    check = [command, "check", mesh]
    missing = without(mesh, "missing", 30)
    table.add("`compare` with itself, beside `check`", [command, "compare", mesh, mesh], check, 1.5)
    table.add("`certify`, beside `check`", [command, "certify", mesh, "-o", folder / "mesh.cert"], check, 4)
    table.add("`check`, one of 30 missing, beside all", [command, "check", missing], check, 4)
    table.add("`check --memory 256M`, beside `check`", [command, "check", mesh, "--memory", "256M"], check, 2)
    table.add("`check --memory 256M`, one of 30 missing, beside `check`", [command, "check", missing, "--memory", "256M"], check, 3)


def add_surface(table, command, surface):
    mesh = meshed(surface, "-pMFQ")
    check = [command, "check", mesh, "--domain", surface, "--claim", "steiner-triangulation"]
    one, many = (without(mesh, f"{surface.stem}-{name}", share) for name, share in (("one", 0), ("many", 33)))
    name = surface.stem
    table.add(f"{name}: `inspect`, beside `check`", [command, "inspect", "--domain", surface], check, 6)
    table.add(f"{name}: `check`, one missing, beside all", [check[0], "check", one, *check[3:]], check, 1.5)
    table.add(f"{name}: `check`, 3 % missing, beside all", [check[0], "check", many, *check[3:]], check, 1.5)
    table.add(f"{name}: `check --claim conforming-delaunay`, beside that", [*check[:-1], "conforming-delaunay"], check, 1.5)


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    if not shutil.which("tetgen"):
        sys.exit("expected tetgen in PATH, found none: Debian has it in the package tetgen")
    command, surfaces = sys.argv[1], [pathlib.Path(name) for name in sys.argv[2:]]
    table = Table()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        if surfaces:
            for given in surfaces:
                copy = folder / given.name
                copy.write_bytes(given.read_bytes())
                add_surface(table, command, copy)
        else:
            add_points(table, command, folder)
            write_bumpy_sphere(folder / "bumpy-sphere.off", FINENESS)
            add_surface(table, command, folder / "bumpy-sphere.off")
        table.measure()
    print("| what, beside which | processor time | memory | of the other | times | goal |")
    print("| --- | ---: | ---: | ---: | ---: | ---: |")
    return 1 if table.print() and not surfaces else 0


if __name__ == "__main__":
    sys.exit(main())
