"""Meshes of domains whose vertices were moved by a few billionths, as rounding moves them: for --within."""
from domain_meshes import *

E = 1e-9
NEAR = "steiner-triangulation --within 1e-8"
EXACT = "steiner-triangulation"
TRIANGLE_AND_POINT = [(0, 0), (1, 0), (0, 1), (5, 5)]


def moved(points, at, by):
    return [tuple(x + b for x, b in zip(p, by)) if i == at else p for i, p in enumerate(points)]


def cube_with_middle():
    """A cube that is cut across the middle of the edge 0 1, and that point off the edge."""
    points = CUBE + [(2, 0, 0)]
    return moved(points, 8, (0, 3 * E, 4 * E)), canonical_delaunay(points)


def room(above, flip):
    """A cube upon the floor z = 0 or below it, by the cube's numbers; `flip` takes the other diagonal of the floor."""
    z = 4 if above else -4
    points = [(x, y, h) for h in (0, z) for y in (0, 4) for x in (0, 4)]
    cells = [(0, 1, 3, 7), (0, 1, 5, 7), (0, 2, 3, 7), (0, 2, 6, 7), (0, 4, 5, 7), (0, 4, 6, 7)]
    return points, [tuple(v ^ 1 for v in t) for t in cells] if flip else cells


def accepted():
    points, mesh = cube_with_middle()
    claims = [(NEAR, HOLD), ("steiner-triangulation --within 5.1e-9", HOLD), ("steiner-triangulation --within 1", HOLD),
              (EXACT, "domain.segment-missing"), ("steiner-triangulation --within 4.9e-9", "domain.segment-missing"),
              ("plc-triangulation --within 1e-8", "domain.steiner-forbidden")]
    yield DomainMesh("accept/within--segment", "a Steiner point 5e-9 off its segment", CUBE, facets(CUBE_SQUARES), points, mesh, claims)
    corner = moved(CUBE, 7, (-E, 2 * E, -2 * E))
    yield DomainMesh("accept/within--vertex", "a corner of a cube that was moved by 3e-9: three squares are no longer flat", CUBE,
                     facets(CUBE_SQUARES), corner, FIVE, [("plc-triangulation --within 1e-8", HOLD), (EXACT, "domain.vertex-missing")])
    points, cells = room(True, False)
    dented = moved(moved(points, 0, (0, 0, 3 * E)), 3, (0, 0, 3 * E))
    yield DomainMesh("accept/within--flat-tetrahedron", "a tetrahedron of height 3e-9 with all vertices in one square", points,
                     facets(CUBE_SQUARES), dented, [*cells, (0, 1, 2, 3)], [(NEAR, HOLD), (EXACT, "domain.vertex-missing")])
    below, lower = room(False, True)
    both = points + below[4:]
    number = lambda v: v if v < 4 else v + 4
    lower = [tuple(number(v) for v in t) for t in lower]
    squares = [*CUBE_SQUARES, *(tuple(number(v) for v in s) for s in CUBE_SQUARES if set(s) != {0, 1, 2, 3})]
    dented = moved(moved(both, 0, (0, 0, 3 * E)), 3, (0, 0, 3 * E))
    yield DomainMesh("accept/within--flat-tetrahedron-between", "the same in a wall between two rooms", both, facets(squares), dented,
                     [*cells, *lower, (0, 1, 2, 3)], [(NEAR, HOLD), (EXACT, "domain.vertex-missing")])
    square = [(0, 0, 0), (4, 0, 0), (4, 4, 0), (0, 4, 0)]
    yield DomainMesh("accept/within--dangling", "a square in space of two triangles that are not in one plane", square,
                     facets([(0, 1, 2, 3)]), moved(square, 0, (0, 0, E)), [],
                     [("cdt --within 1e-8", HOLD), (EXACT, "domain.vertex-missing")], listed=[(0, 1, 2), (0, 2, 3)], kind="enclosed")
    ring = moved(RING, 4, (2 * E, -E))
    yield DomainMesh("accept/within--plane-ring", "a square with a square hole, one corner of which was moved", RING, RING_LINES, ring,
                     RING_TRIANGLES, [("plc-triangulation --within 1e-8", HOLD), (EXACT, "domain.vertex-missing")], holes=[(4, 4)])
    with_lone = CUBE + [(9, 9, 9)]
    points, mesh = cube_with_middle()
    yield DomainMesh("accept/within--lone-vertex", "a vertex of the domain alone outside the cube, and a Steiner point off its segment",
                     with_lone, facets(CUBE_SQUARES), points + [(9, 9, 9)], mesh,
                     [(NEAR, HOLD), (EXACT, "domain.segment-missing")])
    yield DomainMesh("accept/within--plane-lone-vertex", "a triangle of a domain that has a vertex alone outside", TRIANGLE_AND_POINT,
                     [(0, 1), (1, 2), (2, 0)], TRIANGLE_AND_POINT, [(0, 1, 2)], [("cdt --within 0", HOLD), ("cdt", HOLD)])


def rejected():
    points, mesh = cube_with_middle()
    near_wall = lambda t: sum(v in t for v in (0, 8)) == 2
    yield DomainMesh("reject/domain.polygon-not-tiled--within", "a Steiner point off its segment, and a tetrahedron at a wall missing",
                     CUBE, facets(CUBE_SQUARES), points, [t for t in mesh if t != next(filter(near_wall, mesh))],
                     [(NEAR, "domain.polygon-not-tiled"), (EXACT, "domain.segment-missing")],
                     listed=[(0, 8), (1, 8), *((i, j) for i in range(8) for j in range(i + 1, 8) if bin(i ^ j).count("1") == 1 and (i, j) != (0, 1))])
    inner = CUBE + [(2, 2, 2), (2, 0, 0)]
    whole = canonical_delaunay(inner)
    hole = next(t for t in whole if 8 in t and sum(v in t for v in (0, 1, 9)) < 2)
    yield DomainMesh("reject/domain.uncovered--within", "a Steiner point off its segment, and a gap inside", CUBE, facets(CUBE_SQUARES),
                     moved(inner, 9, (0, 3 * E, 4 * E)), [t for t in whole if t != hole], [(NEAR, "domain.uncovered")],
                     listed=[tuple(v for v in hole if v != 8)])
    ring = moved(RING, 4, (2 * E, -E))
    yield DomainMesh("reject/domain.outside--within-2d", "a square hole with a corner moved, filled", RING, RING_LINES, ring,
                     [*RING_TRIANGLES, (4, 5, 6), (4, 6, 7)], [(NEAR, "domain.outside"), (EXACT, "domain.vertex-missing")], holes=[(4, 4)])
    book = [(0, 0, 0), (0, 0, 4), (8, 0, 0), (8, 80 * E, 4), (-4, 1, 2)]
    yield DomainMesh("reject/domain.images-meet", "three triangles at one edge, two of them at a tiny angle and exchanged near the edge",
                     book, facets([(0, 1, 2), (0, 1, 3), (0, 1, 4)]), book + [(1, 6 * E, 3.5), (1, 4 * E, 4)], [],
                     [(NEAR, "domain.images-meet")],
                     listed=[(0, 1, 5), (0, 5, 2), (0, 1, 6), (0, 6, 3), (0, 1, 4)], kind="enclosed")


def entries():
    return [*accepted(), *rejected()]
