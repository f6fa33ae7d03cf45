"""Right meshes of domains."""
from domain_meshes import *
from domains import joined, schonhardt

STEINER_ONLY = [("steiner-triangulation", HOLD), ("steiner-cdt", HOLD), ("cdt", "domain.steiner-forbidden")]
TRIANGULATION = [("plc-triangulation", HOLD), ("steiner-triangulation", HOLD), ("steiner-cdt", "cdt.facet-not-local")]
CDT = [("plc-triangulation", HOLD), ("steiner-triangulation", HOLD), ("cdt", HOLD), ("steiner-cdt", HOLD)]
DELAUNAY = [*CDT, ("conforming-delaunay", HOLD)]


def accept(name, what, points, cells, simplices, claims, mesh_points=None, **more):
    return DomainMesh(f"accept/{name}", what, points, cells, mesh_points or points, simplices, claims, **more)


def cubes():
    squares = facets(CUBE_SQUARES)
    yield accept("cube-five", "a cube in five tetrahedra", CUBE, squares, FIVE, DELAUNAY)
    yield accept("cube-six", "a cube in six tetrahedra", CUBE, squares, canonical_delaunay(CUBE), DELAUNAY)
    around = [0, 2, 3, 7, 5, 4]
    yield accept("cube-around-diagonal", "a cube in six tetrahedra around a diagonal that is not the canonical one", CUBE,
                 squares + facets([(1, 6)]), [(1, 6, a, around[i - 1]) for i, a in enumerate(around)], DELAUNAY)
    turned = [7 - v for v in range(8)]
    yield accept("cube-renumbered", "vertices in another order and counted from 1: they are matched by coordinates", CUBE,
                 squares, [tuple(turned[v] for v in t) for t in FIVE], DELAUNAY, [CUBE[turned[v]] for v in range(8)], base=1)
    halves = facets([(0, 1, 3), (0, 2, 3), *CUBE_SQUARES[1:]])
    yield accept("cube-square-in-two", "one square of the domain is two coplanar triangles", CUBE, halves, FIVE, DELAUNAY)
    square = CUBE + [(1, 1, 2), (3, 1, 2), (3, 3, 2), (1, 3, 2)]
    yield accept("internal-square", "a square that hangs free inside a cube", square, squares + facets([(8, 9, 10, 11)]),
                 canonical_delaunay(square), DELAUNAY)
    on_edge = CUBE + [(1, 0, 0)]
    yield accept("steiner-point-on-segment", "a Steiner point on a segment, in two polygons", CUBE, squares,
                 canonical_delaunay(on_edge), STEINER_ONLY, on_edge)
    within = CUBE + [(1, 2, 0), (2, 1, 2)]
    yield accept("steiner-points-in-polygon-and-volume", "a Steiner point in a polygon, another in the cube", CUBE, squares,
                 canonical_delaunay(within), STEINER_ONLY, within)
    outside = CUBE + [(8, 0, 0), (8, 4, 0)]
    yield accept("dangling-square", "a square that dangles from an edge of a cube: its triangles are in the .face file",
                 outside, squares + facets([(1, 3, 9, 8)]), FIVE, DELAUNAY, listed=[(1, 3, 9), (1, 8, 9)])
    spike = CUBE + [(9, 9, 9)]
    yield accept("dangling-segment", "a segment that sticks out of a cube: it is in the .edge file", spike,
                 squares + facets([(7, 8)]), FIVE, DELAUNAY, listed=[(7, 8)])
    lonely = CUBE + [(9, 9, 9), (2, 2, 1)]
    yield accept("isolated-vertices", "a vertex of the domain inside a cube, another outside it", lonely,
                 squares + [([(9,)], [])], delaunay_inside(lonely, lambda p: max(p) < 4), CDT)
    nested = joined(box((0, 0, 0), (9, 9, 9)), box((3, 3, 3), (6, 6, 6)))
    is_shell = lambda p: not all(3 < x < 6 for x in p)
    yield accept("hollow-cube", "a hole seed in the inner of two cubes", nested[0], facets(nested[1]),
                 delaunay_inside(nested[0], is_shell), DELAUNAY, holes=[(4, 4, 4)])
    yield accept("cube-in-cube", "the same without the seed", nested[0], facets(nested[1]), canonical_delaunay(nested[0]), DELAUNAY)


def others():
    points, simplices = prisms(L_TRIANGLES, L_OUTLINE, 3)
    lids = prism_facets(list(range(6)), 6)
    yield accept("l-prism", "a reflex edge", points, lids, simplices, CDT)
    yield accept("l-prism-hull", "the hull as the domain: the polygons of the L are constraints inside", points, lids,
                 prisms([*L_TRIANGLES, (2, 3, 4)], L_OUTLINE, 3)[1], CDT, kind="hull")
    kite, halves = prisms([(0, 1, 2), (0, 1, 3)], KITE, 2)
    yield accept("not-delaunay", "constrained Delaunay and not Delaunay: a wall hides each half's apices from the other",
                 kite, prism_facets([0, 2, 1, 3], 4, walls=[(0, 1)]), halves,
                 [*CDT, ("conforming-delaunay", "delaunay.facet-not-local,delaunay.vertex-in-ball")])
    points, polygons = schonhardt()
    centre = points + [(0, 0, 5)]
    yield accept("schonhardt-with-centre", "every tetrahedron has the one vertex inside", centre,
                 facets(polygons) + [([(6,)], [])], [(*t, 6) for t in polygons], TRIANGULATION)
    yield accept("schonhardt-steiner", "the same vertex as a Steiner point: without it there is no triangulation",
                 points, facets(polygons), [(*t, 6) for t in polygons],
                 [*TRIANGULATION[1:], ("plc-triangulation", "domain.steiner-forbidden")], centre)
    yield accept("one-triangle-in-space", "a surface and no volume: triangles alone", [(0, 0, 0), (3, 0, 0), (0, 3, 0)],
                 facets([(0, 1, 2)]), [], DELAUNAY, listed=[(0, 1, 2)], kind="enclosed")
    yield accept("unit-triangle-in-space", "the same, where a vertex is one beside the first: it is not another point of a certificate",
                 [(0, 0, 0), (1, 0, 0), (0, 1, 0)], facets([(0, 1, 2)]), [], [("cdt", HOLD)], listed=[(0, 1, 2)], kind="enclosed")


def plane():
    yield accept("plane-ring", "a square with a square hole", RING, RING_LINES, RING_TRIANGLES, DELAUNAY, holes=[(4, 4)])
    yield accept("plane-square-in-square", "the same, filled", RING, RING_LINES, [*RING_TRIANGLES, (4, 5, 6), (4, 6, 7)], DELAUNAY)
    yield accept("plane-l", "a reflex corner", L_OUTLINE, cycle(6), L_TRIANGLES, DELAUNAY)
    yield accept("plane-l-hull", "the hull as the domain", L_OUTLINE, cycle(6), [*L_TRIANGLES, (2, 3, 4)], DELAUNAY, kind="hull")
    yield accept("plane-not-delaunay", "constrained Delaunay and not Delaunay", KITE, [*KITE_OUTLINE, (0, 1)],
                 [(0, 1, 2), (0, 1, 3)], [*CDT, ("conforming-delaunay", "delaunay.facet-not-local,delaunay.vertex-in-ball")])
    yield accept("plane-dangling-segment", "a segment outside, in the .edge file", RING[:4] + [(12, 9)],
                 [*RING_LINES[:4], (2, 4)], [(0, 1, 2), (0, 2, 3)], DELAUNAY, listed=[(2, 4)])
    split = RING[:4] + [(4, 0)]
    yield accept("plane-steiner-point-on-segment", "a Steiner point on a segment", RING[:4], RING_LINES[:4],
                 canonical_delaunay(split), STEINER_ONLY, split)


def entries():
    return [*cubes(), *others(), *plane()]
