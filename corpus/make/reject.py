"""Broken meshes. Each breaks exactly one rule: the one that its file name begins with, up to "--"."""
from accept import five_tetrahedra
from exact import PointSet, canonical_delaunay, oriented, regular_triangulation
from files import Entry, neighbor_rows
from point_sets import *

SQUARE = [(0, 0), (4, 0), (4, 4), (0, 4)]
TETRAHEDRON = [(0, 0, 0), (6, 0, 0), (0, 6, 0), (0, 0, 6)]


def reject(name, what, points, simplices, **more):
    rule = name.split("--")[0]
    claims = more.pop("claims", [("delaunay", rule)])
    return Entry(f"reject/{name}", what, points, simplices, claims, **more)


def without(mesh, *vertices):
    """The mesh without the one simplex that has these vertices."""
    rest = [t for t in mesh if set(t) != set(vertices)]
    assert len(rest) == len(mesh) - 1
    return rest


def simplex_rules():
    cube = canonical_delaunay(CUBE)
    yield reject("simplex.repeated-vertex", "a cube and a simplex that names a vertex twice", CUBE, [*cube, (0, 1, 1, 3)])
    yield reject("simplex.repeated-vertex--2d", "the same in the plane", SQUARE, [(0, 1, 2), (0, 2, 3), (3, 3, 3)])
    yield reject("simplex.degenerate", "a cube and a flat tetrahedron in one of its faces, as roundoff makes them",
                 CUBE, [*cube, (0, 1, 2, 3)])
    yield reject("simplex.degenerate--2d", "a triangle whose vertices are collinear, on the hull", [(0, 0), (2, 0), (4, 0), (2, 3)],
                 [(0, 1, 3), (1, 2, 3), (0, 1, 2)])
    yield reject("simplex.degenerate--in-doubles", "exactly coplanar corners of a parallelogram, apex below, and the flat tetrahedron "
                 "between them: the usual determinant in doubles gives it a volume", *flat_but_not_in_doubles())
    yield reject("simplex.degenerate--only-simplex", "four coplanar vertices of five points, and nothing flat about the others",
                 [(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (1, 1, 5)], [(0, 1, 2, 4), (0, 2, 3, 4), (0, 1, 2, 3)])
    flipped = [(t[1], t[0], *t[2:]) if i == 2 else t for i, t in enumerate(cube)]
    yield reject("simplex.orientation", "a cube with one simplex listed inside out; an error only where orientation is asked for",
                 CUBE, flipped, claims=[("delaunay --oriented", "simplex.orientation"), ("delaunay", "holds")])
    yield reject("simplex.orientation--2d", "the same in the plane", SQUARE, [(0, 1, 2), (0, 3, 2)],
                 claims=[("delaunay --oriented", "simplex.orientation"), ("delaunay", "holds")])
    yield reject("simplex.wrong-dimension--tetrahedra-of-coplanar-points", "a coplanar set in space has a mesh of triangles, not tetrahedra",
                 [(x, y, x + y) for x, y in grid(3, 2)], [(0, 1, 2, 3), (2, 3, 4, 5)])
    yield reject("simplex.wrong-dimension--surface", "the surface of a cube: triangles where tetrahedra are due", CUBE, cube_surface())
    yield reject("simplex.wrong-dimension--edges-of-plane", "edges where triangles are due", SQUARE, [(0, 1), (1, 2), (2, 3), (3, 0)])


def cube_surface():
    hull = {}
    for t in canonical_delaunay(CUBE):
        for v in t:
            f = tuple(sorted(set(t) - {v}))
            hull[f] = hull.get(f, 0) + 1
    return sorted(f for f, n in hull.items() if n == 1)


def flat_but_not_in_doubles():
    """A random parallelogram that is exact in doubles, but whose volume computed in doubles is not zero."""
    r = Random(1)
    while True:
        a, u, v, n = ([r.randrange(2 ** 49) / 2 ** 50 for _ in range(3)] for _ in range(4))
        b, c = ([x + y for x, y in zip(a, w)] for w in (u, v))
        d = [x + y for x, y in zip(b, v)]
        below = [x - 1 for x in n]
        rows = [[x - y for x, y in zip(p, d)] for p in (a, b, c)]
        (x1, y1, z1), (x2, y2, z2), (x3, y3, z3) = rows
        rounded = x1 * (y2 * z3 - z2 * y3) + y1 * (z2 * x3 - x2 * z3) + z1 * (x2 * y3 - y2 * x3)
        points = [tuple(p) for p in (a, b, c, d, below)]
        s = PointSet(points)
        if rounded and not s.orientation((0, 1, 2, 3)) and s.orientation((0, 1, 2, 4)):
            return points, [oriented(s, (0, 1, 2, 4)), oriented(s, (1, 2, 3, 4)), (0, 1, 2, 3)]


def complex_rules():
    cube = canonical_delaunay(CUBE)
    yield reject("complex.duplicate-simplex", "a simplex listed again with its vertices in another order", CUBE,
                 [*cube, tuple(reversed(cube[3]))])
    yield reject("complex.duplicate-simplex--2d", "the same in the plane", SQUARE, [(0, 1, 2), (0, 2, 3), (1, 2, 0)])
    five = TETRAHEDRON[:3] + [(1, 1, 5), (1, 1, -5), (2, 2, 9)]
    yield reject("complex.facet-overused", "three tetrahedra at one triangle", five, [(0, 1, 2, 3), (0, 1, 2, 4), (0, 1, 2, 5)])
    yield reject("complex.facet-overused--2d", "three triangles at one edge", [(0, 0), (4, 0), (2, 3), (2, -3), (1, 7)],
                 [(0, 1, 2), (0, 1, 3), (0, 1, 4)])
    yield reject("complex.overlap", "two tetrahedra on the same side of the triangle that they share", TETRAHEDRON[:3] + [(1, 1, 5), (2, 1, 7)],
                 [(0, 1, 2, 3), (0, 1, 2, 4)])
    yield reject("complex.overlap--2d", "two triangles on the same side of the edge that they share",
                 [(0, 0), (4, 0), (1, 3), (3, 2)], [(0, 1, 2), (0, 1, 3)])
    yield reject("complex.overlap--t-junction-2d", "a triangle whose edge is two edges, with a vertex between, for its neighbours",
                 *t_junction())
    yield reject("complex.overlap--crossed-diagonals-3d", "inside the mesh, a square cut by one diagonal seen from above and by the other "
                 "seen from below", *crossed_diagonals())


def neighbor_rule():
    claims = [("delaunay --neighbors", "complex.wrong-neighbor"), ("delaunay", "holds")]
    mesh = canonical_delaunay(CUBE)
    rows = neighbor_rows(mesh)
    at = next(i for i, row in enumerate(rows) if len({*row} - {None}) > 1)
    rows[at] = rows[at][1:] + rows[at][:1]
    yield reject("complex.wrong-neighbor", "the neighbours of one simplex, each opposite the wrong vertex", CUBE, mesh,
                 neighbors=rows, claims=claims)
    points = grid(3, 3)
    mesh = canonical_delaunay(points)
    rows = neighbor_rows(mesh)
    inner = next(j for j, x in enumerate(rows[0]) if x is not None)
    rows[0][inner] = None
    yield reject("complex.wrong-neighbor--missing-2d", "no neighbour is listed where there is one; zero-based", points, mesh,
                 neighbors=rows, claims=claims, base=0)
    points = [(0, 0, 0), (1, 1, 0), (2, 2, 0), (3, 3, 0)]
    yield reject("complex.wrong-neighbor--hull-1d", "edges in a row; the last lists the first as its neighbour across the end of the row",
                 points, [(0, 1), (1, 2), (2, 3)], neighbors=[[1, None], [2, 0], [0, 1]], claims=claims)


def t_junction():
    points = [(-20, -20), (20, -20), (20, 20), (-20, 20), (-4, 0), (4, 0), (0, 9), (0, -9), (0, 0)]
    mesh = canonical_delaunay(points[:8])
    return points, [*without(mesh, 4, 5, 7), (4, 7, 8), (8, 7, 5)]


def crossed_diagonals():
    outer = [(9, 0, 1), (-9, 1, 0), (0, 9, 2), (1, -9, 0), (0, 2, 9), (1, 0, -9)]
    points = scaled(OCTAHEDRON, 2) + outer
    rest = [t for t in canonical_delaunay(points) if not set(t) <= set(range(6))]
    s = PointSet(points)
    halves = [(4, 0, 1, 2), (4, 0, 1, 3), (5, 2, 3, 0), (5, 2, 3, 1)]
    return points, [oriented(s, t) for t in halves] + rest


def vertex_rules():
    cube = canonical_delaunay(CUBE)
    yield reject("triangulation.unknown-vertex", "one simplex names point 9 of 8", CUBE, [*cube, (0, 1, 2, 8)])
    yield reject("triangulation.unknown-vertex--zero-of-one-based", "one simplex names point 0 of points numbered from 1", CUBE,
                 [*cube, (3, 1, 2, -1)])
    yield reject("triangulation.unknown-vertex--negative", "one simplex names point -1 of points numbered from 0: a ghost vertex that leaked",
                 SQUARE, [(0, 1, 2), (0, 2, 3), (0, 1, -1)], base=0)
    yield reject("triangulation.unused-point", "a point in the interior that no simplex uses", CUBE + [(0.5, 0.25, 0.125)], cube)
    yield reject("triangulation.unused-point--outside", "a point beyond the hull of all simplices", CUBE + [(3, 3, 3)], cube)
    yield reject("triangulation.unused-point--on-edge", "a point on an edge of the mesh", SQUARE + [(2, 0)], [(0, 1, 2), (0, 2, 3)])
    near = scaled(CUBE, 1.0) + [(nudge(1.0, -1), 1.0, 1.0)]
    yield reject("triangulation.unused-point--near-duplicate", "a point left out because it is one unit in the last place from another", near, cube)
    yield reject("triangulation.unused-point--no-simplices", "points, and an empty mesh", CUBE, [])
    yield reject("triangulation.unused-point--hull-vertex-collinear", "an end of a row of points that the mesh does not reach",
                 [(0, 0, 0), (1, 1, 1), (2, 2, 2)], [(0, 1)])


def hull_rules():
    yield reject("triangulation.hull-not-closed--bow-tie-2d", "two triangles that meet in a vertex", [(0, 0), (4, 1), (4, -1), (-4, 1), (-4, -1)],
                 [(0, 1, 2), (0, 3, 4)])
    yield reject("triangulation.hull-not-closed--shared-edge-3d", "two tetrahedra that meet in an edge only",
                 [(0, 0, 0), (0, 0, 4), (4, 1, 2), (4, -1, 2), (-4, 1, 2), (-4, -1, 2)], [(0, 1, 2, 3), (0, 1, 4, 5)])
    yield reject("triangulation.hull-not-closed--figure-4-4-incompatible", "Figure 4.4: each cube triangulated for itself, so that "
                 "their common square is cut by crossing diagonals", *incompatible_cubes())
    yield reject("triangulation.hull-not-closed--t-junction-2d", "a square halved, one half cut again at the middle of the common diagonal",
                 SQUARE + [(2, 2)], [(0, 1, 2), (0, 4, 3), (4, 2, 3)])
    yield reject("triangulation.hull-not-closed--gap-on-line", "a row of points with a gap between two edges", [(0, 0, 0), (1, 2, 3), (2, 4, 6), (3, 6, 9)],
                 [(0, 1), (2, 3)])
    yield reject("triangulation.hull-not-convex", "the canonical mesh of a cube without one of its six tetrahedra", CUBE,
                 without(canonical_delaunay(CUBE), 0, 1, 3, 7))
    yield reject("triangulation.hull-not-convex--2d", "the last triangle on the hull is missing", [(0, 0), (4, 1), (8, 0), (4, 7)], [(0, 1, 3), (1, 2, 3)])
    yield reject("triangulation.hull-not-convex--interior-hole", "one tetrahedron amid the mesh is missing", *interior_hole())
    yield reject("triangulation.hull-not-convex--two-pieces", "two tetrahedra far from each other", TETRAHEDRON + [tuple(x + 50 for x in p) for p in TETRAHEDRON],
                 [(0, 1, 2, 3), (4, 5, 6, 7)])
    yield reject("triangulation.hull-not-convex--touching-at-vertex-3d", "two tetrahedra that meet in a vertex only",
                 TETRAHEDRON + [(-6, 0, 0), (0, -6, 0), (0, 0, -6)], [(0, 1, 2, 3), (0, 4, 5, 6)])
    points = [(0, 0, 1), (4, 0, 1), (4, 4, 1), (0, 4, nudge(1.0, 1)), (2, 1, -3)]
    yield reject("triangulation.hull-not-convex--one-ulp-sliver-missing", "a hull sliver of one unit in the last place is missing, as where "
                 "a program takes the four points for coplanar", points, without(canonical_delaunay(points), 0, 1, 2, 3))
    points = [(0.0, 0.0), (0.5, nudge(0.0, 1)), (1.0, 0.0), (0.5, 1.0)]
    yield reject("triangulation.hull-not-convex--smallest-notch-2d", "the hull turns in by 2^-1074, the least positive double", points,
                 [(0, 1, 3), (1, 2, 3)])


def incompatible_cubes():
    s = PointSet(TWO_CUBES)
    upside_down = [tuple(v ^ 1 for v in t) for t in five_tetrahedra(TWO_CUBES, 0)]
    other = [tuple(v + 4 for v in t) for t in canonical_delaunay(TWO_CUBES[4:])]
    return TWO_CUBES, [oriented(s, t) for t in upside_down + other]


def interior_hole():
    points = scaled(CUBE, 8) + [tuple(1 + 6 * x for x in p) for p in random_points(14, 3, 21)]
    mesh = canonical_delaunay(points)
    inner = next(t for t in mesh if min(t) >= 8)
    return points, without(mesh, *inner)


def fan(centre, ring):
    """The fan around the centre (a tuple of vertices), beginning where its barycentre is inside all boundary facets."""
    n = len(ring)
    return [(*centre, ring[i], ring[(i + 1) % n]) for i in (*range(2, n), 0, 1)]


def covering():
    plane = [(0, 0), *TWICE_AROUND]
    yield reject("triangulation.covered-twice--doubly-winding-fan-2d", "a fan that winds twice around a vertex: every edge matched and locally "
                 "Delaunay, the boundary one closed and locally convex cycle, all points used", plane, fan((0,), range(1, 8)))
    ring = [(x, y, 0) for x, y in TWICE_AROUND]
    yield reject("triangulation.covered-twice--doubly-winding-fan-3d", "the doubly winding ring around an edge, apices above and below",
                 [(0, 0, 1000), (0, 0, -1000), *ring], fan((0, 1), range(2, 9)))
    yield reject("triangulation.covered-twice--doubly-winding-cone-3d", "the doubly winding fan as the coplanar base of a cone",
                 [(0, 0, 0), (0, 0, 3000), *ring], fan((0, 1), range(2, 9)))
    yield reject("triangulation.covered-twice--star-2d", "two triangles across each other, nothing shared",
                 [(0, 6), (-5, -3), (5, -3), (0, -6), (5, 3), (-5, 3)], [(0, 1, 2), (3, 4, 5)])
    yield reject("triangulation.covered-twice--nested-3d", "a tetrahedron inside another", TETRAHEDRON + [(1, 1, 1), (2, 1, 1), (1, 2, 1), (1, 1, 2)],
                 [(4, 5, 6, 7), (0, 1, 2, 3)])


def delaunay_rule():
    yield reject("delaunay.facet-not-local", "two tetrahedra where three would be Delaunay", [(0, 0, 0), (6, 0, 0), (0, 6, 0), (2, 2, 2), (2, 2, -2)],
                 [(0, 1, 2, 3), (0, 2, 1, 4)])
    yield reject("delaunay.facet-not-local--2d", "the wrong diagonal of a quadrilateral", [(0, 0), (4, 1), (5, 5), (1, 4)], [(0, 1, 2), (0, 2, 3)])
    up = nudge(1.0, 1)
    yield reject("delaunay.facet-not-local--one-ulp-2d", "three corners of a square, the fourth one unit in the last place out, and the wrong diagonal",
                 [(0, 0), (1, 0), (0, 1), (up, 1)], [(0, 1, 3), (0, 3, 2)])
    points = CUBE[:-1] + [(nudge(1.0, -1), 1, 1)]
    yield reject("delaunay.facet-not-local--one-ulp-3d", "a cube whose last corner is one unit in the last place inside: it lies in the ball "
                 "of a tetrahedron that would do for the cube", *one_ulp_inside(points))
    points = [tuple(x * 2.0 ** -600 for x in p) for p in [(0, 0, 0), (6, 0, 0), (0, 6, 0), (2, 2, 2), (2, 2, -2)]]
    yield reject("delaunay.facet-not-local--underflow", "as the first, scaled by 2^-600: the determinant underflows in doubles", points,
                 [(0, 1, 2, 3), (0, 2, 1, 4)])
    points = [tuple(x * 2.0 ** 600 for x in p) for p in [(0, 0, 0), (6, 0, 0), (0, 6, 0), (2, 2, 2), (2, 2, -2)]]
    yield reject("delaunay.facet-not-local--overflow", "as the first, scaled by 2^600: the determinant overflows in doubles", points,
                 [(0, 1, 2, 3), (0, 2, 1, 4)])
    points = oblique_plane([(0, 0), (4, 1), (5, 5), (1, 4)])
    s = PointSet(points)
    right = canonical_delaunay(points)
    wrong = [(0, 1, 2), (0, 2, 3)] if any({1, 3} <= set(t) for t in right) else [(0, 1, 3), (1, 2, 3)]
    yield reject("delaunay.facet-not-local--oblique-plane", "the wrong diagonal of a quadrilateral that lies on an oblique plane in space",
                 points, [oriented(s, t) for t in wrong])
    points = grid(3, 3, 3)
    s = PointSet(points, lambda p: p[0] ** 2 + (p[1] - 2 * p[0]) ** 2 + p[2] ** 2)
    yield reject("delaunay.facet-not-local--grid-sheared", "grid points, triangulated for a sheared metric: the hull and the complex are fine",
                 points, regular_triangulation(s))
    points = random_points(12, 4, 6)
    s = PointSet(points, lambda p: p[0] ** 2 + 8 * p[1] ** 2 + 20 * p[2] ** 2 + p[3] ** 2)
    yield reject("delaunay.facet-not-local--4d", "a triangulation of 12 points in four dimensions that is Delaunay for a stretched metric only",
                 points, regular_triangulation(s), form="qhull")
    points = random_points(8, 2, 9)
    mesh = regular_triangulation(PointSet(points, lambda p: p[0] ** 2 + 40 * p[1] ** 2))
    yield reject("delaunay.vertex-in-ball", "what the definition says of a mesh with a point in an open circumball",
                 points, mesh, claims=[("delaunay --by definition", "delaunay.vertex-in-ball"), ("delaunay", "delaunay.facet-not-local")])


def one_ulp_inside(points):
    s = PointSet(points, lambda p: sum(x * x for x in p))
    weights = regular_triangulation(PointSet(points, lambda p: p[0] ** 2 + p[1] ** 2 + p[2] ** 2 + p[0] * p[1]))
    return points, [oriented(s, t) for t in weights]


def weighted_rules():
    claims = lambda rule: [("weighted-delaunay", rule), ("weighted-delaunay --by definition", "weighted.point-below-plane")]
    corners = [(0, 0), (4, 0), (0, 4), (4, 4), (1, 1)]
    yield reject("weighted.point-below-plane", "a point so heavy that it has to be a vertex, and is none",
                 corners, [(0, 1, 3), (0, 3, 2)], weights=[0, 0, 0, 0, 9], claims=claims("weighted.point-below-plane"))
    yield reject("weighted.point-below-plane--unweighted", "weights all zero: a point inside the hull is a vertex, whatever its claim",
                 [*TETRAHEDRON, (1, 1, 1)], [(0, 1, 2, 3)], weights=[0] * 5, claims=claims("weighted.point-below-plane"))
    yield reject("weighted.vertex-submerged", "the centre of a tetrahedron, so light that it is submerged, as a vertex",
                 [*TETRAHEDRON, (1, 1, 1)], [(4, 1, 2, 3), (0, 4, 2, 3), (0, 1, 4, 3), (0, 1, 2, 4)], weights=[0, 0, 0, 0, -20],
                 claims=claims("weighted.vertex-submerged"))
    yield reject("weighted.vertex-submerged--2d", "the same in the plane", [(0, 0), (6, 0), (0, 6), (2, 2)],
                 [(3, 1, 2), (0, 3, 2), (0, 1, 3)], weights=[0, 0, 0, -20], claims=claims("weighted.vertex-submerged"))
    yield reject("delaunay.facet-not-local--weighted", "a Delaunay triangulation whose weights turn the diagonal of a square",
                 SQUARE, [(0, 1, 2), (0, 2, 3)], weights=[0, 5, 0, 5],
                 claims=[("weighted-delaunay", "delaunay.facet-not-local"), ("delaunay", "holds")])
    yield reject("triangulation.unused-point--weighted-outside", "a point outside the mesh: however light, it is a vertex",
                 [(0, 0), (4, 0), (0, 4), (5, 5)], [(0, 1, 2)], weights=[0, 0, 0, -1000],
                 claims=[("weighted-delaunay", "triangulation.unused-point")])


def entries():
    for group in (simplex_rules, complex_rules, neighbor_rule, vertex_rules, hull_rules, covering, delaunay_rule, weighted_rules):
        yield from group()
