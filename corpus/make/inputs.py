"""The inputs that the peers (TetGen, Qhull, CGAL) were run on: peers/inputs/NAME.node."""
from math import pi

from point_sets import *


def inputs():
    yield "random-3d-50", "50 uniform random points", random_points(50, 3, 100)
    yield "random-3d-500", "500 uniform random points", random_points(500, 3, 101)
    yield "grid-3d-4x4x4", "64 grid points", grid(4, 4, 4)
    yield "cospherical-3d-48", "all 48 integer points at square distance 17 from the origin", integer_sphere(17, 3)
    yield "cospherical-3d-72", "the 72 integer points at square distance 41 that have no coordinate 0", [
        p for p in integer_sphere(41, 3) if all(p)]
    yield "coplanar-3d", "a 5 x 4 grid on an oblique plane in space", oblique_plane(grid(5, 4))
    yield "collinear-3d", "ten points on a line in space", [(3 * t, 1 - t, 2 * t) for t in (4, 1, 0, 9, 7, 3, 2, 5, 8, 6)]
    yield "clusters-3d", "four clusters of ten points, 1e-6 wide, 1 apart", clusters(10, 1e-6, 102)
    yield "tight-clusters-3d", "four clusters of ten points, 1e-12 wide, 1 apart", clusters(10, 1e-12, 103)
    yield "sphere-3d-100", "100 doubles near the unit sphere", sphere_surface(100, 104)
    yield "cube-3d", "the corners of a cube", CUBE
    yield "two-cubes-3d", "Figure 4.4: two cubes that share a square", TWO_CUBES
    yield "two-lines-3d", "Figure 4.2: 8 + 8 points on two skew lines", two_skew_lines(8)
    yield "grid-ulp-3d", "3 x 3 x 3 grid points, off by up to one unit in the last place", jittered(
        [(x + 1, y + 1, z + 1) for x, y, z in grid(3, 3, 3)], 105)
    yield "rotated-grid-3d", "4 x 4 x 4 grid points, turned in floating point", rotated(grid(4, 4, 4), pi / 5, pi / 7)
    yield "huge-3d", "30 random points with coordinates up to 1e140", scaled(random_points(30, 3, 106), 1e140)
    yield "tiny-3d", "30 random points with coordinates up to 1e-140", scaled(random_points(30, 3, 107), 1e-140)
    yield "huge-beside-tiny-3d", "a random cluster of width 1e-30 beside one of width 1e30", (
        scaled(random_points(10, 3, 108), 1e-30) + scaled(random_points(10, 3, 109), 1e30))
    yield "flat-faces-3d", "points on the faces of a cube, each off its plane by roundoff", rotated(
        [p for p in grid(5, 5, 5) if set(p) & {0, 4}], 0.7, 0.4)
    yield "moment-curve-3d", "16 points on the moment curve", moment_curve(16)
    yield "random-2d-100", "100 uniform random points of the plane", random_points(100, 2, 110)
    yield "grid-2d-6x6", "36 grid points of the plane", grid(6, 6)
    yield "cocircular-2d", "32 integer points on one circle", integer_sphere(1105, 2)
    yield "circle-2d", "40 doubles near the unit circle", circle(40)
    yield "grid-ulp-2d", "5 x 5 grid points, off by up to one unit in the last place", jittered(
        [(x + 1, y + 1) for x, y in grid(5, 5)], 111)


# Inputs on which a random search saw a program go wrong (points of these families, nearly coplanar,
# nearly collinear, turned grids and prisms, near duplicates), shrunk by leaving out points as long
# as the verdict on that program's output stayed the same. Their files are kept as they were found.
HUNTED = [
    ("hunted-tetgen-flat-3d", "part of a turned prism; TetGen makes a flat tetrahedron"),
    ("hunted-tetgen-duplicate-3d", "near a line but for two points; TetGen lists a tetrahedron twice"),
    ("hunted-tetgen-overused-3d", "off one plane by roundoff; three of TetGen's tetrahedra share a triangle"),
    ("hunted-tetgen-overlap-3d", "five points off one plane by roundoff; TetGen's tetrahedra overlap"),
    ("hunted-tetgen-unused-3d", "near a line but for two points; TetGen drops a point"),
    ("hunted-tetgen-not-closed-3d", "off one plane by roundoff; the boundary of TetGen's mesh branches"),
    ("hunted-tetgen-dent-3d", "five points off one plane by roundoff; TetGen's mesh is not convex"),
    ("hunted-tetgen-covered-twice-3d", "six points off one plane by roundoff; TetGen covers part of space twice, "
     "behind a boundary that is closed and locally convex"),
    ("hunted-tetgen-not-delaunay-3d", "near a line but for two points; TetGen's mesh is not Delaunay"),
    ("hunted-tetgen-crash-3d", "part of a turned grid; TetGen fails an assertion"),
    ("hunted-qhull-flat-3d", "seven small integer points; `Qt` leaves a flat simplex"),
    ("hunted-qhull-overlap-3d", "grid points off by one unit in the last place; overlapping simplices"),
    ("hunted-qhull-dent-3d", "grid points off by one unit in the last place; a hull sliver is missing"),
    ("hunted-qhull-sphere-3d", "five doubles near the unit sphere; not Delaunay"),
    ("hunted-qhull-far-2d", "five points of the plane around (1e8, 1e8)"),
    ("hunted-qhull-near-duplicate-2d", "three pairs of points 1e-13 apart"),
    ("hunted-qhull-joggled-overlap-2d", "four points of the plane, two of them 1e-13 apart; the joggled solution folds over"),
    ("hunted-qhull-joggled-flat-2d", "five small integer points; the joggled solution keeps a flat triangle"),
]
