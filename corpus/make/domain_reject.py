"""Wrong meshes of domains. Each breaks the one rule that its file name begins with, up to "--"."""
from domain_meshes import *
from domains import joined
from exact import canonical_delaunay

SQUARES = facets(CUBE_SQUARES)
# A kite that floats beside a cube.
FLAG = [(12, 0, 20), (20, 0, 20), (16, 1, 20), (16, -1, 20)]
FLAG_CELLS = SQUARES + facets([(8, 10, 9, 11)])
FLAG_HALVES = [(8, 9, 10), (8, 9, 11)]


def reject(name, what, points, cells, simplices, claim, mesh_points=None, claims=(), **more):
    """Breaks its rule under `claim`; `claims` are further ones, with their verdicts."""
    rule = name.split("--")[0]
    return DomainMesh(f"reject/{name}", what, points, cells, mesh_points or points, simplices, [(claim, rule), *claims], **more)


def vertices():
    lonely = CUBE + [(2, 2, 1)]
    inner = SQUARES + [([(8,)], [])]
    yield reject("domain.vertex-missing", "the domain has a vertex inside a cube, the mesh has no such point", lonely, inner, FIVE,
                 "plc-triangulation", CUBE)
    yield reject("domain.vertex-missing--in-polygon", "a vertex inside a square of the domain; the mesh passes over it",
                 CUBE + [(1, 2, 0)], [([CUBE_SQUARES[0], (8,)], []), *SQUARES[1:]], FIVE, "steiner-triangulation", CUBE)
    yield reject("domain.vertex-missing--one-ulp-off", "a corner of the mesh is one unit in the last place from the domain's",
                 CUBE, SQUARES, FIVE, "steiner-triangulation", [*CUBE[:7], (4, 4, 4.000000000000001)])
    yield reject("domain.vertex-missing--2d", "a vertex inside a square of the plane", RING[:4] + [(4, 4)], RING_LINES[:4],
                 [(0, 1, 2), (0, 2, 3)], "cdt", RING[:4])
    steiner = {"segment": (1, 0, 0), "polygon": (1, 2, 0), "polyhedron": (2, 1, 2)}
    for place, point in steiner.items():
        yield reject(f"domain.steiner-forbidden--in-{place}", f"a Steiner point in a {place}, where none is allowed", CUBE, SQUARES,
                     canonical_delaunay(CUBE + [point]), "plc-triangulation", CUBE + [point], [("steiner-cdt", HOLD)])
    yield reject("domain.steiner-forbidden--2d", "the same in the plane", RING[:4], RING_LINES[:4],
                 [(0, 1, 4), (1, 2, 4), (2, 3, 4), (0, 3, 4)], "cdt", RING[:4] + [(4, 4)], [("steiner-cdt", HOLD)])


def shared_by_three():
    kite = [(0, 0), (4, 0), (2, 3), (2, -3), (1, 7)]
    yield reject("complex.facet-overused--2d", "three triangles at one segment", kite, [(0, 1), (0, 4), (4, 1), (1, 3), (3, 0)],
                 [(0, 1, 2), (0, 1, 3), (0, 1, 4)], "plc-triangulation",
                 claims=[("steiner-triangulation --within 1e-8", "complex.facet-overused")])


def pinched():
    """Two tetrahedra that share the segment 0 1 and nothing else; a Steiner point in its middle."""
    points = [(0, 0, 0), (0, 0, 8), (5, 1, 4), (5, -1, 4), (-5, 1, 4), (-5, -1, 4)]
    return points, [(0, 1, 2), (0, 1, 3), (0, 2, 3), (1, 2, 3), (0, 1, 4), (0, 1, 5), (0, 4, 5), (1, 4, 5)], points + [(0, 0, 4)]


def segments():
    points, polygons, with_middle = pinched()
    yield reject("domain.vertex-in-edge", "two tetrahedra share a segment; only one of them is subdivided at its middle",
                 points, facets(polygons), [(0, 1, 2, 3), (0, 4, 5, 6), (1, 4, 5, 6)], "steiner-triangulation", with_middle)
    wing = CUBE + [(8, 0, 0), (8, 4, 0)]
    yield reject("domain.vertex-in-edge--dangling-polygon", "the cube is subdivided at the middle of an edge, the square that "
                 "dangles from that edge is not", wing, SQUARES + facets([(1, 3, 9, 8)]),
                 [tuple(10 if v == 8 else v for v in t) for t in canonical_delaunay(CUBE + [(4, 1, 0)])],
                 "steiner-triangulation", wing + [(4, 1, 0)],
                 listed=[(1, 3, 9), (1, 8, 9)])
    yield reject("domain.segment-missing", "a segment across a cube, which five tetrahedra do not have", CUBE,
                 SQUARES + facets([(0, 7)]), FIVE, "cdt")
    yield reject("domain.segment-missing--2d", "the other diagonal of a square", RING[:4], [*RING_LINES[:4], (1, 3)],
                 [(0, 1, 2), (0, 2, 3)], "cdt")
    yield reject("domain.segment-missing--dangling", "a segment sticks out of a cube; no .edge file has it", CUBE + [(9, 9, 9)],
                 SQUARES + facets([(7, 8)]), FIVE, "cdt")
    yield reject("domain.segment-missing--in-polygon", "a slit in a square of the domain, cut by the other diagonal", CUBE,
                 [([CUBE_SQUARES[0], (1, 2)], []), *SQUARES[1:]], FIVE, "cdt")
    square = [(0, 0), (8, 0), (8, 8), (0, 8)]
    yield reject("domain.segment-missing--half-2d", "half of a diagonal is an edge, the other half is not", square,
                 [*cycle(4), (0, 2)], [(0, 1, 4), (0, 3, 4), (1, 4, 5), (4, 5, 6), (3, 4, 6), (1, 2, 5), (2, 5, 6), (2, 3, 6)],
                 "steiner-triangulation", square + [(4, 4), (6, 5), (5, 6)])


def polygons():
    bipyramid = facets([*BIPYRAMID_SIDES, (0, 1, 2)])
    yield reject("domain.polygon-not-tiled", "a triangle inside a bipyramid, and three tetrahedra around an edge that pierces it",
                 BIPYRAMID, bipyramid, [(0, 1, 3, 4), (1, 2, 3, 4), (0, 2, 3, 4)], "plc-triangulation")
    wing = CUBE + [(8, 0, 0), (8, 4, 0)]
    dangling = SQUARES + facets([(1, 3, 9, 8)])
    yield reject("domain.polygon-not-tiled--half-dangling", "of a dangling square one of two triangles is listed", wing, dangling,
                 FIVE, "cdt", listed=[(1, 3, 9), (1, 8), (8, 9)])
    yield reject("domain.polygon-not-tiled--corner-missing", "a cube without the tetrahedron at one corner", CUBE, SQUARES, FIVE[:4],
                 "plc-triangulation", listed=[(3, 7), (5, 7), (6, 7)])
    two = [(x, y, z) for x in (0, 4, 8) for y in (0, 4) for z in (0, 4)]
    rooms = [(0, 4, 6, 2), (4, 8, 10, 6), (1, 5, 7, 3), (5, 9, 11, 7), (0, 4, 5, 1), (4, 8, 9, 5), (2, 6, 7, 3), (6, 10, 11, 7),
             (0, 1, 3, 2), (4, 5, 7, 6), (8, 9, 11, 10)]
    five = lambda v: [tuple(v[i] for i in t) for t in FIVE]
    left, right = [0, 4, 2, 6, 1, 5, 3, 7], [4, 8, 6, 10, 5, 9, 7, 11]
    yield reject("complex.overlap--both-sides-differ", "two rooms: the square between them is cut along one diagonal from the left "
                 "and along the other from the right", two, facets(rooms), five(left) + five(right), "plc-triangulation")
    yield reject("complex.overlap--hanging-node-2d", "inside a square, a triangle whose edge is two edges, with a vertex between, "
                 "for its neighbours", RING[:4], RING_LINES[:4], [(0, 1, 2), (0, 3, 4), (2, 3, 4)], "steiner-triangulation",
                 RING[:4] + [(4, 4)])
    mirrored = [right[i ^ 1] for i in range(8)]
    yield reject("complex.overlap--stray-face", "the two rooms as they should be, and a listed triangle across one of them", two, facets(rooms),
                 five(left) + five(mirrored), "plc-triangulation", listed=[(0, 6, 5), (0, 7, 5)])


def coverage():
    yield reject("domain.uncovered", "the tetrahedron in the middle of a cube is missing; all squares are tiled", CUBE, SQUARES,
                 FIVE[1:], "plc-triangulation")
    yield reject("domain.uncovered--2d", "a triangle is missing, its edges are there", RING[:4], [*RING_LINES[:4], (0, 2)],
                 [(0, 1, 2)], "cdt", listed=[(2, 3), (0, 3), (0, 2)])
    nested = joined(box((0, 0, 0), (9, 9, 9)), box((3, 3, 3), (6, 6, 6)))
    whole, hollow = canonical_delaunay(nested[0]), delaunay_inside(nested[0], lambda p: not all(3 < x < 6 for x in p))
    yield reject("domain.uncovered--inner-cube", "a cube inside a cube that is not a hole", nested[0], facets(nested[1]), hollow,
                 "steiner-triangulation")
    yield reject("domain.outside--hole", "the hole of a hollow cube is meshed", nested[0], facets(nested[1]), whole, "plc-triangulation",
                 holes=[(4, 4, 4)])
    points, simplices = prisms([*L_TRIANGLES, (2, 3, 4)], L_OUTLINE, 3)
    lids = prism_facets(list(range(6)), 6)
    yield reject("domain.outside", "an L-shaped prism, meshed up to its convex hull", points, lids, simplices, "plc-triangulation")
    yield reject("triangulation.hull-not-convex", "the hull is the domain; the L-shaped prism alone is meshed", points, lids,
                 prisms(L_TRIANGLES, L_OUTLINE, 3)[1], "plc-triangulation", kind="hull")
    yield reject("domain.outside--2d", "the hole of a ring is meshed", RING, RING_LINES, [*RING_TRIANGLES, (4, 5, 6), (4, 6, 7)],
                 "cdt", holes=[(4, 4)])
    yield reject("domain.outside--listed-edge-2d", "a listed edge outside the domain", RING[:4] + [(12, 9)],
                 [*RING_LINES[:4], (2, 4)], [(0, 1, 2), (0, 2, 3)], "cdt", listed=[(2, 4), (1, 4)])


def constrained_delaunay():
    both = lambda rule: [("steiner-cdt", rule), ("cdt --by definition", "cdt.visible-vertex-in-ball"), ("plc-triangulation", HOLD)]
    hexahedron = [(-10, 0, 0), (10, 0, 0), (0, 17, 0), (0, 1, 8), (0, 1, -8)]
    sides = [(i, (i + 1) % 3, apex) for i in range(3) for apex in (3, 4)]
    yield reject("cdt.facet-not-local", "Figure 4.1, right, with the hexahedron as domain", hexahedron, facets(sides),
                 [(0, 1, 2, 3), (0, 1, 2, 4)], "cdt", claims=both("cdt.facet-not-local"))
    yield reject("cdt.facet-not-local--2d", "the long diagonal of a kite", KITE, KITE_OUTLINE, [(0, 1, 2), (0, 1, 3)], "cdt",
                 claims=both("cdt.facet-not-local"))
    yield reject("cdt.visible-vertex-in-ball", "the same hexahedron by definition: a ball, and a vertex in it that is visible",
                 hexahedron, facets(sides), [(0, 1, 2, 3), (0, 1, 2, 4)], "cdt --by definition")
    yield reject("cdt.facet-not-local--beside-a-wall-2d", "a wall that covers part of the view does not excuse the rest",
                 KITE + [(2, 0)], [*KITE_OUTLINE, (0, 4)], [(0, 4, 2), (0, 4, 3), (4, 1, 2), (4, 1, 3)], "cdt",
                 claims=both("cdt.facet-not-local"))
    yield reject("cdt.dangling-not-delaunay", "the long diagonal of a kite that floats beside a cube", CUBE + FLAG, FLAG_CELLS, FIVE, "cdt",
                 listed=FLAG_HALVES, claims=[("plc-triangulation", HOLD), ("steiner-cdt", "cdt.dangling-not-delaunay")])


def conforming():
    points = RING[:4] + [(3, 3), (6, 3), (7, 7), (3, 6)]
    mesh = [t for t in canonical_delaunay(points) if not {5, 7} <= {*t}] + [(4, 5, 6), (4, 6, 7)]
    yield reject("delaunay.facet-not-local--2d", "the wrong diagonal of a quadrilateral, which the domain demands", points,
                 [*RING_LINES[:4], (4, 6)], mesh, "conforming-delaunay", claims=[("cdt", HOLD)])
    yield reject("delaunay.vertex-in-ball--outside-2d", "a vertex in a triangle's ball, hidden behind the outside of the domain",
                 [(0, 0), (8, 0), (4, 2), (4, -1), (14, -1)],
                 [(0, 1), (1, 2), (2, 0), (1, 3), (3, 4), (4, 1)], [(0, 1, 2), (1, 3, 4)], "conforming-delaunay",
                 claims=[("cdt", HOLD)])
    yield reject("delaunay.vertex-in-ball--loose-vertex-2d", "a vertex that the domain has apart from its triangle, in that one's ball",
                 [(0, 0), (4, 0), (0, 4), (3, 3)], [(0, 1), (1, 2), (2, 0)], [(0, 1, 2)], "conforming-delaunay")
    yield reject("delaunay.no-empty-ball", "the long diagonal of a kite that floats beside a cube: both triangles have the other's "
                 "apex in every ball", CUBE + FLAG, FLAG_CELLS, FIVE, "conforming-delaunay", listed=FLAG_HALVES)
    yield reject("delaunay.no-empty-ball--edge", "a segment beside a cube, and vertices on two sides of its middle", CUBE + FLAG,
                 SQUARES + [([(8, 9), (10,), (11,)], [])], FIVE, "conforming-delaunay", listed=[(8, 9)], claims=[("cdt", HOLD)])


def entries():
    return [*vertices(), *shared_by_three(), *segments(), *polygons(), *coverage(), *constrained_delaunay(), *conforming()]
