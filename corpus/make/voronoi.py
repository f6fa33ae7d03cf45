"""Voronoi diagrams in qvoronoi's form, written to corpus/voronoi with their sites, and the table of their verdicts."""
from fractions import Fraction
from random import Random

from exact import canonical_delaunay
from files import CORPUS, write_node

FOLDER = CORPUS / "voronoi"


def centre(a, b, c):
    """Of the circle through three points, exactly."""
    (ax, ay), (bx, by), (cx, cy) = ([Fraction(x) for x in p] for p in (a, b, c))
    bx, by, cx, cy = bx - ax, by - ay, cx - ax, cy - ay
    twice = 2 * (bx * cy - by * cx)
    b2, c2 = bx * bx + by * by, cx * cx + cy * cy
    return ax + (cy * b2 - by * c2) / twice, ay + (bx * c2 - cx * b2) / twice


def diagram(sites):
    """Vertices as doubles; for each site the corners of its cell from 1, with 0 if it is unbounded; and ridges."""
    triangles = canonical_delaunay(sites)
    vertices = [tuple(float(x) for x in centre(*(sites[v] for v in t))) for t in triangles]
    beside = {}
    for i, t in enumerate(triangles):
        for v in t:
            beside.setdefault(tuple(sorted(set(t) - {v})), []).append(i + 1)
    cells = [[i + 1 for i, t in enumerate(triangles) if s in t] for s in range(len(sites))]
    for edge, around in beside.items():
        for s in edge:
            if len(around) == 1 and 0 not in cells[s]:
                cells[s].insert(0, 0)
    ridges = [[*edge, *around, *([0] if len(around) == 1 else [])] for edge, around in sorted(beside.items())]
    return vertices, cells, ridges


def write(name, sites, vertices, cells, ridges):
    FOLDER.mkdir(exist_ok=True)
    write_node(FOLDER / f"{name}.node", sites, 2, base=0)
    rows = lambda lists: [" ".join(map(str, [len(row), *row])) for row in lists]
    lines = ["2", f"{len(vertices) + 1} {len(cells)} 1", "-10.101 -10.101", *(f"{x!r} {y!r}" for x, y in vertices), *rows(cells)]
    lines += [str(len(ridges)), *rows(ridges)] if ridges else []
    (FOLDER / f"{name}.qvoronoi").write_text("\n".join(lines) + "\n")


SQUARE = [(0, 0), (4, 0), (4, 4), (0, 4), (2, 2)]


def entries():
    """(name, what it is, options, verdict), after writing the files."""
    dice = Random(1)
    sites = [(dice.random(), dice.random()) for _ in range(40)]
    write("uniform-2d", sites, *diagram(sites))
    yield "uniform-2d", "forty random sites, corners rounded to doubles", "--within 1e-12x --structure", "holds"
    vertices, cells, ridges = diagram(SQUARE)
    write("square", SQUARE, vertices, cells, ridges)
    yield "square", "a square and its centre, whose cells have no rounded corner", "--structure", "holds"
    grid = [(x, y) for x in range(4) for y in range(4)]
    write("grid-2d", grid, *diagram(grid))
    yield "grid-2d", "a grid: four cells meet at each corner, which is listed twice", "--structure", "holds"
    write("clipped", SQUARE[:1] + SQUARE[2:3], [(-2, 6), (-2, -2), (6, -2), (6, 6)], [[1, 2, 3], [1, 3, 4]], [])
    yield "clipped", "two sites with cells that were cut off at a box, as polygons", "", "holds"
    moved = [(x + (x == 2 and y == 4) / 64, y) for x, y in vertices]
    write("corner-moved", SQUARE, moved, cells, ridges)
    yield "corner-moved", "a corner is off by 1/64", "--within 1e-12x", "voronoi.cell-differs"
    write("cell-missing", SQUARE, vertices, [*cells[:4], []], ridges)
    yield "cell-missing", "the cell of the centre has no corners", "--within 1e-12x", "voronoi.cell-missing"
    write("unknown-vertex", SQUARE, vertices, [*cells[:4], [*cells[4], 9]], ridges)
    yield "unknown-vertex", "a cell has corner 9 of 4", "", "voronoi.unknown-vertex"
    write("vertex-unmatched", SQUARE, [*vertices, (2.5, 2.5)], cells, ridges)
    yield "vertex-unmatched", "a vertex is listed that no cell has", "--structure", "voronoi.vertex-unmatched"
    write("ridge-missing", SQUARE, vertices, cells, [ridge for ridge in ridges if ridge[:2] != [0, 4]])
    yield "ridge-missing", "the ridge between the centre and a corner is not listed", "--structure", "voronoi.ridge-missing"
    other = {1: 2, 2: 3, 3: 4, 4: 1}
    write("ridge-differs", SQUARE, vertices, cells, [[*r[:2], *(other[v] for v in r[2:])] if r[:2] == [0, 4] else r for r in ridges])
    yield "ridge-differs", "the ridge between the centre and a corner has the ends of another", "--structure", "voronoi.ridge-differs"


def write_all():
    rows = ["\t".join((f"{name}.qvoronoi", f"{name}.node", options, verdict, what)) for name, what, options, verdict in entries()]
    (FOLDER / "expected.tsv").write_text("\n".join(rows) + "\n")
