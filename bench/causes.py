#!/usr/bin/env python3
"""Plants one cause at a time in good meshes of about 100,000 simplices, in the plane and in space, and prints whether `check`
names it by a line `cause:` (docs/causes.md):

    /usr/bin/python3 bench/causes.py build/release/bin/circumspect [--few] [MESH ...]

SciPy triangulates random points of the plane, and TetGen (in PATH) those of space. Domains are two rooms with a wall between,
with random points in the plane, and in space with those that TetGen adds. The same is planted in each MESH, of triangles in the
plane or of tetrahedra, in a format that meshio reads, as far as it holds as a complex. `--few` takes meshes of about 3,000
simplices. The exit code is 1 if a cause is not named, if the answer does not name its place, or if one is named where none is.
"""
import pathlib
import re
import subprocess
import sys
import tempfile
from fractions import Fraction

import numpy as np
import scipy.spatial

SEED = 1


class Mesh:
    """Points, simplices, the claim that holds of them, and further arguments of check, such as a domain."""

    def __init__(self, name, points, cells, asks):
        self.name, self.points, self.cells, self.asks = name, points, cells, asks
        self.other_points = None  # what a user who takes the wrong file may take

    def with_lists(self, points, cells, asks=()):
        return Mesh(self.name, points, cells, [*self.asks, *asks])

    def vertex_inside(self, rng):
        """One that no facet of the boundary has."""
        size = self.cells.shape[1]
        facets = np.sort(np.concatenate([np.delete(self.cells, i, axis=1) for i in range(size)]), axis=1)
        unique, counts = np.unique(facets, axis=0, return_counts=True)
        inside = np.setdiff1d(self.cells, unique[counts == 1])
        return int(rng.choice(inside))

    def answer(self, command, folder):
        np.save(folder / "points.npy", self.points)
        np.save(folder / "cells.npy", self.cells.astype(np.int32))
        asked = [command, "check", folder / "cells.npy", "--points", folder / "points.npy", *self.asks]
        return subprocess.run(asked, capture_output=True, text=True, check=False)


def positive(points, cells):
    """The same simplices, all with one sign."""
    cells = cells.copy()
    turned = np.linalg.det(points[cells[:, 1:]] - points[cells[:, :1]]) < 0
    cells[turned, :2] = cells[turned, 1::-1]
    return cells


def planted(mesh, rng):
    """(what is planted, the mesh, what a cause says, what names the place)"""
    points, cells = mesh.points, mesh.cells
    vertex = mesh.vertex_inside(rng)
    k = int(np.flatnonzero((cells == vertex).any(axis=1))[0])
    row = " ".join(map(str, cells[k]))
    ascending = " ".join(map(str, sorted(cells[k])))
    if "complex" not in mesh.asks:
        yield "missing", mesh.with_lists(points, np.delete(cells, k, axis=0)), f"is missing: {ascending} fills", None
    moved = points.copy()
    star = points[np.unique(cells[(cells == vertex).any(axis=1)])]
    moved[vertex] = star.mean(axis=0) + 1.5 * np.ptp(star, axis=0)
    yield "moved", mesh.with_lists(moved, cells), f"name vertex {vertex}", None
    turned = cells.copy()
    turned[k, :2] = turned[k, 1::-1]
    yield "inverted", mesh.with_lists(points, turned, ["--oriented"]), "in the other order", " ".join(map(str, turned[k]))
    yield "listed twice", mesh.with_lists(points, np.concatenate([cells, cells[k:k + 1]])), "listed twice: " + row, None
    yield "doubled nodes", doubled(mesh), "equal", None
    yield "1-based", mesh.with_lists(points, cells + 1), "indices seem to begin at 1", None
    cut, new = cells.copy(), len(points)
    s, middle = halved(points, cells, k)
    cut[s, 0] = new
    half = cells[s].copy()
    half[1] = new
    yield ("hanging", mesh.with_lists(np.concatenate([points, [middle]]), np.concatenate([cut, [half]])),
           "lies inside faces of simplices that are not cut", f"\\b{new}\\b")
    others = "points seem to be those of another mesh"
    yield "points in another order", mesh.with_lists(rng.permutation(points), cells), others, None
    if mesh.other_points is not None:
        yield "points of another mesh", mesh.with_lists(mesh.other_points, cells), others, None
        more = np.concatenate([mesh.other_points] * (1 + len(points) // len(mesh.other_points)))
        more[:, 0] += np.arange(len(more)) / len(more)
        yield "more points, of another mesh", mesh.with_lists(more, cells), others, None


def halved(points, cells, k):
    """A simplex from k on the middle of whose first edge is a double, as is that of one edge in thousands of arbitrary ones."""
    for s in [*range(k, len(cells)), *range(k)]:
        a, b = points[cells[s, :2]]
        if all(Fraction(x) + Fraction(y) == Fraction(x + y) for x, y in zip(a, b)):
            return s, (a + b) / 2
    raise ValueError("no edge has a middle in doubles")


def doubled(mesh, wall=None):
    """The half beyond a wall, or else beyond the middle, has nodes of its own where it meets the other one."""
    middles = mesh.points[mesh.cells].mean(axis=1)[:, 0]
    beyond = middles > (np.median(middles) if wall is None else wall)
    common = np.intersect1d(mesh.cells[beyond], mesh.cells[~beyond])
    own = np.arange(len(mesh.points))
    own[common] = len(mesh.points) + np.arange(len(common))
    cells = mesh.cells.copy()
    cells[beyond] = own[cells[beyond]]
    return mesh.with_lists(np.concatenate([mesh.points, mesh.points[common]]), cells)


def tetgen(path, switches):
    subprocess.run(["tetgen", switches, path], check=True, stdout=subprocess.DEVNULL)
    read = lambda suffix: np.loadtxt(path.with_name(path.stem + ".1." + suffix), skiprows=1, comments="#")[:, 1:]
    return read("node")[:, :3], read("ele")[:, :4].astype(int)


def write_domain(path, points, walls):
    """Segments or polygons, from 0."""
    rows = lambda lists: "".join(f"{i} " + " ".join(map(repr, row)) + "\n" for i, row in enumerate(lists))
    text = f"{len(points)} {len(points[0])} 0 0\n{rows(points)}{len(walls)} 0\n"
    if len(walls[0]) == 2:
        text += rows(walls)
    else:
        text += "".join("1\n3 " + " ".join(map(str, wall)) + "\n" for wall in walls)
    path.write_text(text + "0\n" + ("0\n" if len(walls[0]) == 3 else ""))


def plane_rooms(folder, count, rng):
    """Rooms whose walls are cut so finely that each piece is Delaunay, since points keep away from them."""
    n = int(count ** 0.5 / 3)
    walls, corners = [], {}
    at = lambda *p: corners.setdefault(p, len(corners))
    for i in range(n):
        walls += [(at(x, i), at(x, i + 1)) for x in (0, n, 2 * n)]
        for y in (0, n):
            walls += [(at(i, y), at(i + 1, y)), (at(n + i, y), at(n + i + 1, y))]
    free = on_a_grid(rng.random((count, 2))) * [2 * n, n]
    from_walls = np.minimum(np.minimum(free[:, 1], n - free[:, 1]), np.abs(free[:, :1] - [0, n, 2 * n]).min(axis=1))
    points = np.concatenate([np.array(list(corners), float), free[from_walls > 0.5]])
    write_domain(folder / "plane.poly", points.tolist(), walls)
    cells = scipy.spatial.Delaunay(points).simplices.astype(int)
    mesh = Mesh("rooms, plane", points, positive(points, cells), ["--domain", folder / "plane.poly"])
    return mesh, apart_in_the_plane(mesh, n)


def apart_in_the_plane(mesh, n):
    """The right room has its own nodes at the wall, a third of an edge higher, but for the ends."""
    apart = doubled(mesh, wall=n)
    own = np.arange(len(mesh.points), len(apart.points))
    ends = np.isin(apart.points[own, 1], [0, n])
    apart.points[own[~ends], 1] += 1 / 3
    twin = np.arange(len(apart.points))
    same = {tuple(p): v for v, p in enumerate(mesh.points)}
    twin[own[ends]] = [same[tuple(apart.points[v])] for v in own[ends]]
    used, cells = np.unique(twin[apart.cells], return_inverse=True)
    return Mesh(mesh.name, apart.points[used], cells.reshape(apart.cells.shape), ["--claim", "triangulation"])


def room_walls(n, rooms, is_mirrored):
    """Triangles of the walls of some rooms; those of the wall between have their diagonals in one of two ways."""
    corners, triangles = {}, []

    def add(wall, mirrored=False):
        for i in range(n):
            for j in range(n):
                a, b, c, d = (corners.setdefault(wall(i + x, j + y), len(corners)) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1)))
                triangles.extend([(a, b, d), (b, c, d)] if mirrored else [(a, b, c), (a, c, d)])

    for x in sorted({x for room in rooms for x in (room, room + 1)}):
        add(lambda i, j, x=x: (x * n, i, j), is_mirrored and x == 1)
    for room in rooms:
        for side in (0, n):
            add(lambda i, j, r=room, s=side: (r * n + i, s, j))
            add(lambda i, j, r=room, s=side: (r * n + i, j, s))
    return (np.array(list(corners)) / n).tolist(), triangles


def space_rooms(folder, count):
    n = max(3, round((count / 500) ** 0.5))
    switches = f"-pYqQa{1.7 / count:.9f}"
    domain = folder / "space.poly"
    write_domain(domain, *room_walls(n, [0, 1], False))
    points, cells = tetgen(domain, switches)
    mesh = Mesh("rooms, space", points, positive(points, cells), ["--domain", domain, "--claim", "steiner-triangulation"])
    halves = []
    for room in (0, 1):
        write_domain(folder / f"{room}.poly", *room_walls(n, [room], room == 1))
        halves.append(tetgen(folder / f"{room}.poly", switches))
    both = np.concatenate([halves[0][0], halves[1][0]])
    unique, number = np.unique(both, axis=0, return_inverse=True)
    joined = np.concatenate([halves[0][1], halves[1][1] + len(halves[0][0])])
    return mesh, Mesh(mesh.name, unique, number.ravel()[joined], ["--claim", "triangulation"]), n


def on_a_grid(points):
    """So that the middles of edges are doubles, and lie in them."""
    return np.round(points * 2**30) / 2**30


def of_points(folder, count, rng):
    plane = on_a_grid(rng.random((count // 2, 2)))
    mesh = Mesh("points, plane", plane, scipy.spatial.Delaunay(plane).simplices.astype(int), ["--claim", "delaunay"])
    yield mesh
    space = on_a_grid(rng.random((round(count / 6.6), 3)))
    lines = "".join(f"{i} {x!r} {y!r} {z!r}\n" for i, (x, y, z) in enumerate(space.tolist()))
    (folder / "space.node").write_text(f"{len(space)} 3 0 0\n{lines}")
    yield Mesh("points, space", space, tetgen(folder / "space.node", "-Q")[1], ["--claim", "delaunay"])


def given(name):
    import meshio  # Debian's python3-meshio, only for meshes that are given
    read = meshio.read(name)
    blocks = {block.type: block.data for block in read.cells}
    kind = "tetra" if "tetra" in blocks else "triangle"
    cells = np.concatenate([block.data for block in read.cells if block.type == kind])
    used, cells = np.unique(cells, return_inverse=True)
    dimension = 3 if kind == "tetra" else 2
    return Mesh(pathlib.Path(name).name, read.points[used, :dimension], cells.reshape(-1, dimension + 1), ["--claim", "complex"])


def as_complex(mesh):
    alone = Mesh(mesh.name, mesh.points, mesh.cells, ["--claim", "complex"])
    alone.other_points = mesh.other_points
    return alone


def rows(folder, count, names, rng):
    """(mesh, what is planted, mesh with it, what a cause says, what names the place); first that mesh itself."""
    crossed = []
    if names:
        meshes = [given(name) for name in names]
    else:
        meshes = list(of_points(folder, count, rng))
        rooms, apart = plane_rooms(folder, count // 2, rng)
        walls, other, n = space_rooms(folder, count)
        meshes += [rooms, walls]
        crossed = [(apart, "parts that were meshed apart meet: "), (other, f"meet in {n * n} quadrilaterals with different diag")]
    for mesh in list(meshes):
        mesh.other_points = rng.random((len(mesh.points) * 9 // 10, mesh.points.shape[1]))
    if not names:
        meshes += [as_complex(mesh) for mesh in meshes]
    for mesh in meshes:
        mesh.cells = positive(mesh.points, mesh.cells)
        yield mesh, "nothing", mesh, None, None
        for row in planted(mesh, rng):
            yield mesh, *row
    for mesh, words in crossed:
        for one in (mesh, as_complex(mesh)):
            yield one, "crossed interface", one, words, None


def main(arguments):
    few = "--few" in arguments
    arguments = [word for word in arguments if word != "--few"]
    if not arguments:
        sys.exit(__doc__)
    command = pathlib.Path(arguments[0]).resolve()
    rng = np.random.default_rng(SEED)
    print("| mesh | claim | simplices | planted | | what is said |\n| --- | --- | ---: | --- | --- | --- |", flush=True)
    wrong = 0
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        for mesh, what, one, words, place in rows(folder, 3_000 if few else 100_000, arguments[1:], rng):
            answer = one.answer(command, folder)
            said = answer.stdout or answer.stderr
            causes = re.findall(r"^cause: (.*)$", said, re.M)
            if words is None:
                result = "holds" if said.splitlines()[-1].startswith("holds: ") and not causes else "WRONG"
            else:
                # Equal points are a fault of the input, unless the claim is complex.
                is_named = words in (causes[0] if causes else answer.stderr)
                result = "named" if is_named and (place is None or re.search(place, said)) else "NOT NAMED"
            wrong += result.isupper()
            claim = one.asks[one.asks.index("--claim") + 1] if "--claim" in one.asks else "cdt"
            words_said = (causes[0] if causes else answer.stderr.strip().partition(": ")[2].partition(": ")[2])[:120]
            print(f"| {mesh.name} | {claim} | {len(one.cells)} | {what} | {result} | {words_said} |", flush=True)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
