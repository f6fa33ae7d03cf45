"""Meshes whose claim holds: the book's examples, and inputs that bring floating-point programs down."""
from fractions import Fraction
from math import ldexp

from exact import PointSet, canonical_delaunay, oriented, regular_triangulation
from files import Entry, neighbor_rows
from point_sets import *

HOLDS = [("delaunay", "holds")]


def delaunay(name, what, points, **more):
    return Entry(f"accept/{name}", what, points, canonical_delaunay(points), more.pop("claims", HOLDS), **more)


def book():
    yield delaunay("figure-4-1-sliver", "Figure 4.1, left: the Delaunay tetrahedralization of the hexahedron; "
                   "its three tetrahedra stand around a vertical edge and one of them is a sliver", HEXAHEDRON)
    yield Entry("accept/figure-4-1-two-tetrahedra", "Figure 4.1, right: the same five points in two nicely shaped "
                "tetrahedra; a triangulation, but not Delaunay", HEXAHEDRON, [(0, 1, 2, 4), (1, 0, 2, 3)],
                [("triangulation", "holds"), ("delaunay", "delaunay.facet-not-local"),
                 ("delaunay --by definition", "delaunay.vertex-in-ball")])
    yield delaunay("figure-4-2-skew-lines-5", "Figure 4.2: 5 + 5 points on two skew lines, one tetrahedron for each pair "
                   "of edges; the only triangulation of these points", two_skew_lines(5))
    yield delaunay("figure-4-2-skew-lines-9", "Figure 4.2 with 9 + 9 points: 64 tetrahedra on 18 points", two_skew_lines(9))
    yield delaunay("figure-4-4-two-cubes", "Figure 4.4: two cubes that share a square; the least-vertex triangulation",
                   TWO_CUBES)
    yield Entry("accept/figure-4-4-other-diagonal", "Figure 4.4, another Delaunay triangulation: both cubes in five "
                "tetrahedra, mirrored so that the square between them is cut by one diagonal", TWO_CUBES,
                five_tetrahedra(TWO_CUBES, 0) + five_tetrahedra(TWO_CUBES, 1), HOLDS)
    yield delaunay("cube-pulled", "cube, six tetrahedra at the lexicographically minimum vertex (the canonical answer)", CUBE)
    yield Entry("accept/cube-five-tetrahedra", "cube, five tetrahedra: as Delaunay as the six of the canonical answer",
                CUBE, five_tetrahedra(CUBE, 0), HOLDS)
    yield delaunay("octahedron", "regular octahedron, four tetrahedra around one of its three axes", OCTAHEDRON)
    yield Entry("accept/octahedron-other-axis", "the same octahedron around an axis that the canonical answer does not use",
                OCTAHEDRON, [oriented(PointSet(OCTAHEDRON), (2, 3, a, b)) for a in (0, 1) for b in (4, 5)], HOLDS)


def five_tetrahedra(points, x):
    """The unit cube that begins at x: four corners and the tetrahedron between them; neighbouring cubes are mirrored."""
    s, at = PointSet(points), {p: i for i, p in enumerate(points)}
    corner = lambda a, b, c: at[(x + (a if x % 2 == 0 else 1 - a), b, c)]
    cut = [(0, 0, 0), (0, 1, 1), (1, 0, 1), (1, 1, 0)]
    flipped = lambda p, i: tuple(1 - v if j == i else v for j, v in enumerate(p))
    corners = [[corner(*p), *(corner(*flipped(p, i)) for i in range(3))] for p in cut]
    middle = [corner(*(1 - v for v in p)) for p in cut]
    return [oriented(s, t) for t in [*corners, middle]]


def degenerate():
    yield delaunay("cospherical-30", "all 30 integer points at distance 3 from the origin, every ball test a tie",
                   integer_sphere(9, 3))
    yield delaunay("cospherical-with-centre", "the same 30 points and their centre: every cell is cut off by many ties",
                   integer_sphere(9, 3) + [(0, 0, 0)])
    yield delaunay("grid-3x3x3", "27 grid points: eight cubes, all ties at once", grid(3, 3, 3))
    yield delaunay("grid-2x3x4", "a box of grid points, zero-based indices and boundary markers", grid(2, 3, 4), base=0, marks=3)
    yield delaunay("points-on-hull-faces", "a cube with points on its edges and in its faces: coplanar hull facets, no flat tetrahedra",
                   scaled(CUBE, 4) + [(2, 0, 0), (2, 2, 0), (1, 3, 0), (4, 2, 2), (2, 2, 4), (0, 0, 3), (2, 1, 1)])
    yield delaunay("coplanar-in-space", "a 3 x 4 grid on an oblique plane: the simplices are triangles", oblique_plane(grid(3, 4)))
    yield delaunay("coplanar-in-space-off", "the same kind of planar mesh in space, as OFF",
                   oblique_plane([(0, 0), (4, 1), (1, 3), (5, 5), (2, 2), (-1, 4)]), form="off")
    yield delaunay("collinear-in-space", "points on a line in space, unsorted: the simplices are edges",
                   [(2 * t, -t, 3 * t) for t in (4, 0, 7, 1, -3, 2)])
    yield delaunay("collinear-in-plane", "points on a line in the plane", [(t, 2 * t) for t in (3, 1, 2)])
    yield delaunay("no-points", "the empty set: its empty mesh holds", [])
    yield delaunay("one-point", "one point: one simplex of one vertex", [(3, 1, 4)])
    yield delaunay("one-point-in-plane", "one point of the plane", [(3, 1)])
    yield delaunay("two-points", "two points in space: one edge", [(0, 0, 0), (1, 2, 3)])
    yield delaunay("three-points", "three points in space: one triangle", [(0, 0, 0), (1, 2, 3), (1, 0, 0)])
    yield delaunay("four-points", "one tetrahedron", [(0, 0, 0), (3, 0, 0), (0, 3, 0), (0, 0, 3)])
    yield delaunay("moment-curve-12", "12 points on the moment curve: quadratically many tetrahedra, coordinates up to 1331",
                   moment_curve(12))
    yield delaunay("two-lines-in-plane", "points on two parallel lines of the plane", [(x, y) for y in (0, 5) for x in (0, 1, 3, 7, 8)])


def other_triangulations():
    points = random_points(18, 3, 4)
    height = lambda p: p[0] ** 2 + 9 * p[1] ** 2 + 50 * p[2] ** 2
    yield Entry("accept/triangulation-anisotropic-3d", "random points, Delaunay under a stretched metric: a triangulation only",
                points, regular_triangulation(PointSet(points, height)),
                [("triangulation", "holds"), ("delaunay", "delaunay.facet-not-local")])
    points = [(x, y) for x, y in random_points(25, 2, 5)]
    yield Entry("accept/triangulation-anisotropic-2d", "the same in the plane", points,
                regular_triangulation(PointSet(points, lambda p: p[0] ** 2 + 30 * p[1] ** 2)),
                [("triangulation", "holds"), ("delaunay", "delaunay.facet-not-local")])
    s = PointSet(CUBE)
    mixed = [t if i % 2 else (t[1], t[0], *t[2:]) for i, t in enumerate(canonical_delaunay(CUBE))]
    yield Entry("accept/cube-mixed-orientation", "orientation is not part of the claim unless it is asked for", CUBE, mixed, HOLDS)
    yield Entry("accept/cube-all-negative", "one consistent orientation, the negative one", CUBE,
                [(t[1], t[0], *t[2:]) for t in canonical_delaunay(CUBE)], HOLDS + [("delaunay --oriented", "holds")])
    yield Entry("accept/cube-all-positive", "one consistent orientation, the positive one", CUBE,
                canonical_delaunay(CUBE), [("delaunay --oriented", "holds")])


def neighbors():
    claim = [("delaunay --neighbors", "holds")]
    mesh = canonical_delaunay(CUBE)
    yield Entry("accept/neighbors", "a cube with the true neighbours of its simplices in a .neigh file", CUBE, mesh, claim,
                neighbors=neighbor_rows(mesh))
    points = grid(3, 3)
    mesh = canonical_delaunay(points)
    yield Entry("accept/neighbors-2d", "nine grid points of the plane and the true neighbours, zero-based", points, mesh, claim,
                neighbors=neighbor_rows(mesh), base=0)


def floating_point():
    up = nudge(1.0, 1)
    yield delaunay("one-ulp-square", "three corners of a square and the fourth one unit in the last place out: one diagonal is right",
                   [(0, 0), (1, 0), (0, 1), (up, 1)])
    yield delaunay("one-ulp-cube", "a cube with one corner one unit in the last place out: no longer cospherical nor coplanar, "
                   "with slivers on the hull", CUBE[:-1] + [(up, up, up)])
    yield delaunay("one-ulp-hull-sliver", "four points of a square, one raised by one unit in the last place, over an apex: "
                   "the sliver on the hull has to be there", [(0, 0, 1), (4, 0, 1), (4, 4, 1), (0, 4, up), (2, 1, -3)])
    yield delaunay("grid-one-ulp", "3 x 3 x 3 grid at 1, 2, 3 with coordinates off by up to one unit in the last place",
                   jittered([(x + 1, y + 1, z + 1) for x, y, z in grid(3, 3, 3)], 11))
    yield delaunay("circle-of-doubles", "24 doubles near the unit circle: cocircular but for roundoff", circle(24))
    yield delaunay("sphere-of-doubles", "40 doubles near the unit sphere", sphere_surface(40, 3))
    yield delaunay("rotated-grid", "3 x 3 x 3 grid turned in floating point: planes and cubes lost by roundoff, slivers on the hull",
                   rotated(grid(3, 3, 3), 0.6, 0.3))
    yield delaunay("huge-beside-tiny", "1e300 beside 1e-300: products overflow and underflow in doubles",
                   [(0, 0, 0), (1e300, 0, 0), (0, 1e300, 0), (0, 0, 1e300), (1e-300, 1e-300, 1e-300), (1e-300, 2e-300, 1e300),
                    (3e-300, 1, 1e-300), (1e150, 1e-150, 1e150)])
    yield delaunay("subnormal", "coordinates that are small multiples of 2^-1074, the least positive double",
                   [tuple(x * 5e-324 for x in p) for p in [(0, 0, 0), (3, 0, 0), (0, 4, 0), (0, 0, 5), (7, 7, 6), (1, 2, 1)]])
    yield delaunay("largest-doubles", "corners of a cube at plus and minus the largest double, and its centre",
                   [tuple((2 * x - 1) * 1.7976931348623157e308 for x in p) for p in CUBE] + [(0.0, 0.0, 0.0)])
    yield delaunay("far-from-origin", "a small cluster around 2^52: subtraction is exact but squares are not",
                   [tuple(ldexp(1, 52) + x for x in p) for p in [(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0), (0, 0, 1), (2, 3, 1), (1, 1, 3)]])
    yield delaunay("clusters", "four clusters of width 1e-9 at distance 1", clusters(6, 1e-9, 8))
    thirds = [(Fraction(1, 3), 0, 0), (0, Fraction(1, 3), 0), (0, 0, Fraction(1, 3)), (Fraction(2, 7), Fraction(2, 7), Fraction(1, 7)),
              (Fraction(-1, 3), 0, 0)]
    yield delaunay("rational", "coordinates that no double holds, written as fractions", thirds)
    yield delaunay("rational-json", "the same points as JSON, indices from 1", thirds, form="json")


def planar():
    yield delaunay("grid-2d-4x4", "16 grid points of the plane", grid(4, 4))
    yield delaunay("cocircular-2d", "the 32 integer points on the circle of square radius 1105: every triangulation of the polygon is Delaunay", integer_sphere(1105, 2))
    yield delaunay("random-2d", "30 random points of the plane", random_points(30, 2, 1))
    points = [(0, 0), (6, 0), (6, 6), (0, 6), (3, 2), (2, 4)]
    mesh = canonical_delaunay(points)
    yield Entry("accept/planar-off", "a planar mesh as OFF, whose points have a third coordinate 0 and so span a plane in space",
                [(*p, 0) for p in points], mesh, HOLDS, form="off")


def other_dimensions():
    yield delaunay("hypercube", "the 16 corners of the 4-cube, in Qhull's format", grid(2, 2, 2, 2), form="qhull")
    yield delaunay("random-4d", "12 random points in four dimensions", random_points(12, 4, 6), form="qhull")
    yield delaunay("random-5d", "10 random points in five dimensions", random_points(10, 5, 7), form="qhull")
    yield delaunay("random-6d-json", "9 random points in six dimensions, as JSON with hexadecimal coordinates",
                   random_points(9, 6, 12), form="json", base=0)
    yield delaunay("random-3d", "20 random points", random_points(20, 3, 2))


def weighted():
    claims = [("weighted-delaunay", "holds")]
    yield Entry("accept/weighted-submerged", "a light point in the middle of a square is not a vertex: its lifted companion is above the plane",
                [(0, 0), (4, 0), (0, 4), (4, 4), (1, 1)], [(0, 1, 3), (0, 3, 2)], claims, weights=[0, 0, 0, 0, -9])
    yield Entry("accept/weighted-on-plane", "a point whose lifted companion lies on the lower hull without being extreme: a vertex or, as here, not",
                [(0, 0), (4, 0), (0, 4), (1, 1)], [(0, 1, 2)], claims, weights=[0, 0, 0, -6])
    yield Entry("accept/weighted-on-plane-used", "the same point as a vertex", [(0, 0), (4, 0), (0, 4), (1, 1)],
                [(0, 1, 3), (0, 3, 2), (3, 1, 2)], claims, weights=[0, 0, 0, -6])
    points = [tuple(int(100 * x) for x in p) for p in random_points(30, 3, 15)]
    weights = [(7 * i) % 11 * 100 for i in range(30)]
    weight_of = dict(zip(points, weights))
    mesh = regular_triangulation(PointSet(points, lambda p: sum(x * x for x in p) - weight_of[p]))
    yield Entry("accept/weighted-random", "30 random integer points with weights", points, mesh, claims, weights=weights)


def entries():
    for group in (book, degenerate, other_triangulations, neighbors, floating_point, planar, other_dimensions, weighted):
        yield from group()
