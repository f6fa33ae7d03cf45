#!/usr/bin/env python3
"""What `check --within` costs beside the exact verdict, as a table (docs/performance.md):

    bench/within_goals.py build/release/bin/circumspect [SURFACE.off ...]

Without a surface it makes one: a bumpy sphere of 100,820 triangles. TetGen (`tetgen -pMFQ`, in PATH) meshes each. The mesh is
checked as it is, then with 1 % of its vertices moved by a unit in the last place, then with all of them moved: exactly,
for the surface with its vertices where the mesh has them, and with --within for the surface as it was. So the same mesh is
judged both times. Times are of the processor, files included, the least of three. The exit code is 1 if a made
surface is above the goal, where no vertex or 1 % of them are moved.
"""
import math
import pathlib
import random
import resource
import subprocess
import sys
import tempfile

ROUNDS = 3
GOAL = 1.5
DISTANCE = "1e-12x"
CLAIM = "steiner-triangulation"  # moved points are no longer in the same balls
FINENESS = 71  # 20 * 71^2 triangles
# A regular icosahedron.
GOLDEN = (1 + math.sqrt(5)) / 2
CORNERS = [(-1, GOLDEN, 0), (1, GOLDEN, 0), (-1, -GOLDEN, 0), (1, -GOLDEN, 0), (0, -1, GOLDEN), (0, 1, GOLDEN),
           (0, -1, -GOLDEN), (0, 1, -GOLDEN), (GOLDEN, 0, -1), (GOLDEN, 0, 1), (-GOLDEN, 0, -1), (-GOLDEN, 0, 1)]
FACES = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6),
         (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7),
         (9, 8, 1)]


def write_bumpy_sphere(path, fineness):
    places, points, triangles = {}, [], []

    def vertex(weights):
        key = tuple(sorted((v, w) for v, w in weights if w))
        if key not in places:
            at = [sum(CORNERS[v][axis] * w for v, w in weights) for axis in range(3)]
            length = math.sqrt(sum(x * x for x in at))
            x, y, z = (x / length for x in at)
            radius = 1 + 0.1 * math.sin(5 * x + 1) * math.cos(7 * y) * math.sin(6 * z + 2)
            places[key] = len(points)
            points.append((x * radius, y * radius, z * radius))
        return places[key]

    for face in FACES:
        def at(*weights):
            return vertex(list(zip(face, weights)))
        for i in range(fineness):
            for j in range(fineness - i):
                k = fineness - i - j
                triangles.append((at(i, j, k), at(i + 1, j, k - 1), at(i, j + 1, k - 1)))
                if k > 1:
                    triangles.append((at(i + 1, j, k - 1), at(i + 1, j + 1, k - 2), at(i, j + 1, k - 1)))
    path.write_text(f"OFF\n{len(points)} {len(triangles)} 0\n" + "".join("%.17g %.17g %.17g\n" % p for p in points)
                    + "".join("3 %d %d %d\n" % t for t in triangles))


def write_moved(mesh, moved, share):
    """A copy of a mesh with a share of its vertices moved by an ulp in each coordinate, or not."""
    dice = random.Random(1)
    lines = []
    for line in mesh.with_suffix(".node").read_text().splitlines():
        words = line.split()
        if lines and words and words[0][0] != "#" and dice.random() < share:
            words[1:4] = [repr(math.nextafter(float(x), dice.choice([-math.inf, math.inf, float(x)])))
                          for x in words[1:4]]
        lines.append(" ".join(words))
    moved.with_suffix(".node").write_text("\n".join(lines) + "\n")
    moved.with_suffix(".ele").write_bytes(mesh.with_suffix(".ele").read_bytes())


def write_surface_of(mesh, surface, moved):
    """The surface with its vertices, the first ones of the mesh, where the mesh has them."""
    rows = [line.split() for line in mesh.with_suffix(".node").read_text().splitlines()]
    nodes = [row for row in rows if row and row[0][0] != "#"][1:]
    lines = surface.read_text().splitlines()
    vertices = int(lines[1].split()[0])
    lines[2:2 + vertices] = [" ".join(node[1:4]) for node in nodes[:vertices]]
    moved.write_text("\n".join(lines) + "\n")


def seconds(command, mesh, surface, *more):
    """The processor time of a check, the least of some, and its last line."""
    times = []
    for _ in range(ROUNDS):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        run = subprocess.run([command, "check", mesh, "--domain", surface, "--claim", CLAIM, *more], capture_output=True, text=True,
                             check=False)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        times.append(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
        if not run.stdout.splitlines()[-1:] or not run.stdout.splitlines()[-1].startswith("holds"):
            sys.exit(f"expected that {mesh} holds, found: {(run.stdout + run.stderr).splitlines()[-1:]}")
    return min(times)


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    command, surfaces = sys.argv[1], [pathlib.Path(name) for name in sys.argv[2:]]
    missed = False
    print("| surface | triangles | tetrahedra | vertices moved | exact | within | times |")
    print("| --- | ---: | ---: | ---: | ---: | ---: | ---: |")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        if not surfaces:
            write_bumpy_sphere(folder / "bumpy-sphere.off", FINENESS)
        for given in surfaces or [folder / "bumpy-sphere.off"]:
            surface, other = folder / given.name, folder / "other.off"
            surface.write_bytes(given.read_bytes())
            subprocess.run(["tetgen", "-pMFQ", surface], check=True, stdout=subprocess.DEVNULL)
            mesh, moved = folder / (surface.stem + ".1.ele"), folder / "moved.ele"
            sizes = f"{surface.read_text().split()[2]} | {mesh.read_text().split()[0]}"
            for share, words in ((0, "none"), (0.01, "1 %"), (1, "all")):
                write_moved(mesh, moved, share)
                write_surface_of(moved, surface, other)
                exact = seconds(command, moved, other)
                within = seconds(command, moved, surface, "--within", DISTANCE)
                missed |= not surfaces and share < 1 and within > GOAL * exact
                print(f"| {surface.stem} | {sizes} | {words} | {exact:.2f} s | {within:.2f} s | {within / exact:.2f} |",
                      flush=True)
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
