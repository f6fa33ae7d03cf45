"""Meshes that a lattice repeats, written to corpus/periodic with their points, and the table of their verdicts."""
from itertools import permutations, product
from random import Random

from exact import canonical_delaunay
from files import CORPUS, write_node

FOLDER = CORPUS / "periodic"


def sum_of(lattice, multiples):
    return tuple(sum(m * vector[axis] for m, vector in zip(multiples, lattice)) for axis in range(len(lattice)))


def mesh(points, lattice):
    """The cells of a finite part whose first corner is where it was listed, as rows of (point, offset)."""
    offsets = list(product((0, -1, 1), repeat=len(lattice)))
    copies = [(v, o) for o in offsets for v in range(len(points))]
    places = [tuple(x + y for x, y in zip(points[v], sum_of(lattice, o))) for v, o in copies]
    cells = ([copies[i] for i in t] for t in canonical_delaunay(places))
    return [cell for cell in cells if not any(min(cell)[1])]


def cubes(d):
    """One point, and the unit cube cut along its diagonal."""
    cells = []
    for order in permutations(range(d)):
        corner, cell = [0] * d, [(0, (0,) * d)]
        for axis in order:
            corner[axis] = 1
            cell.append((0, tuple(corner)))
        cells.append(cell)
    return cells


def write(name, points, cells):
    FOLDER.mkdir(exist_ok=True)
    d = len(points[0])
    write_node(FOLDER / f"{name}.node", points, d, base=0)
    corners = len(cells[0])
    lines = [f"{len(cells)} {corners} {d * corners}"]
    lines += [" ".join(map(str, (i, *(v for v, _ in cell), *(x for _, offset in cell for x in offset)))) for i, cell in enumerate(cells)]
    (FOLDER / f"{name}.ele").write_text("\n".join(lines) + "\n")


def entries():
    """(name, what it is, options, verdict), after writing the files."""
    square, box = [(4, 0), (0, 4)], "--box 0,0,4,4"
    dice = Random(3)
    points = [(dice.randrange(1 << 12) / 1024, dice.randrange(1 << 12) / 1024) for _ in range(8)]
    cells = mesh(points, square)
    write("plane", points, cells)
    yield "plane", "eight random points, repeated by a square", box, "holds"
    skew = [(5, 1), (-1, 4)]
    write("skew", points[:3], mesh(points[:3], skew))
    yield "skew", "three points, repeated by a parallelogram", "--lattice 5,1,-1,4", "holds"
    solid = [tuple(dice.randrange(1 << 12) / 1024 for _ in range(3)) for _ in range(3)]
    write("space", solid, mesh(solid, [(4, 0, 0), (0, 4, 0), (0, 0, 4)]))
    yield "space", "three random points, repeated by a cube", "--box 0,0,0,4,4,4", "holds"
    write("cubes", [(0, 0, 0)], cubes(3))
    yield "cubes", "one point, and the cube cut along its diagonal: eight points on each sphere", "--box 0,0,0,1,1,1", "holds"
    write("cell-missing", points, cells[1:])
    yield "cell-missing", "a triangle is missing", box, "complex.not-closed"
    shifted = [[(v, (x + (i == 2 and j == 0), y)) for j, (v, (x, y)) in enumerate(cell)] for i, cell in enumerate(cells)]
    write("offset-wrong", points, shifted)
    yield "offset-wrong", "a corner is in the next box", box, "complex.not-closed"
    alone = [(0, (0, 0)), (0, (1, 0)), (0, (1, 1))]
    for name, what, cell, verdict in [
            ("unknown-vertex", "a corner is no point", [(0, (0, 0)), (1, (1, 0)), (0, (1, 1))], "triangulation.unknown-vertex"),
            ("two-corners", "a cell has two corners", alone[:2], "simplex.wrong-dimension"),
            ("corner-twice", "a corner is listed twice", [alone[0], alone[1], alone[1]], "simplex.repeated-vertex"),
            ("flat", "a point and its copies in the next two boxes are in line", [*alone[:2], (0, (2, 0))], "simplex.degenerate")]:
        write(name, [(0, 0)], [cell])
        yield name, what, "--box 0,0,1,1", verdict
    write("turned", [(0, 0)], [alone, [(0, (0, 0)), (0, (0, 1)), (0, (1, 1))]])
    yield "turned", "two triangles of a square, of which one is turned over", "--box 0,0,1,1 --oriented", "simplex.orientation"
    write("point-moved", [(points[0][0] + 1.5, points[0][1] + 0.5), *points[1:]], cells)
    yield "point-moved", "a point is on the other side of its neighbours", box, "complex.overlap"
    write("cell-twice", points, [*cells, cells[4]])
    yield "cell-twice", "a triangle is listed twice", box, "complex.duplicate-simplex"
    moved = [(v, (x + 1, y - 1)) for v, (x, y) in cells[4]]
    write("cell-twice-moved", points, [*cells, moved])
    yield "cell-twice-moved", "a triangle is listed twice, once in another box", box, "complex.facet-overused"
    write("point-left-out", [*points, (1, 1)], cells)
    yield "point-left-out", "a point is not a corner", box, "triangulation.unused-point"
    others = [(x + 0.375, y + 0.625) for x, y in points]
    write("two-sheets", points + others, cells + [[(v + 8, offset) for v, offset in cell] for cell in cells])
    yield "two-sheets", "two meshes of the same box, one over the other", box, "triangulation.covered-twice"
    write("stretched", points, cells)
    yield "stretched", "the mesh of the square, in a longer box", "--box 0,0,9,4", "delaunay.facet-not-local"


def write_all():
    rows = ["\t".join((f"{name}.ele", options, verdict, what)) for name, what, options, verdict in entries()]
    (FOLDER / "expected.tsv").write_text("\n".join(rows) + "\n")

