"""Point sets that more than one kind of entry uses."""
from itertools import product
from math import cos, nextafter, pi, sin, sqrt
from random import Random

CUBE = list(product((0, 1), repeat=3))
TWO_CUBES = list(product((0, 1, 2), (0, 1), (0, 1)))  # Figure 4.4
OCTAHEDRON = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
HEXAHEDRON = [(-10, 0, 0), (10, 0, 0), (0, 17, 0), (0, 1, 8), (0, 1, -8)]  # Figure 4.1
# Seven points that wind twice around the origin, always turning left.
TWICE_AROUND = [(14280, 6877), (-7858, 9854), (-4612, -5783), (3739, -1801), (1181, 5176), (-10000, 0), (3269, -14323)]


def grid(*counts):
    return list(product(*(range(n) for n in counts)))


def two_skew_lines(n):
    """Figure 4.2: n points on each of two lines."""
    return [(3 * i, 0, 0) for i in range(n)] + [(n, 2 * i - n, 7) for i in range(n)]


def integer_sphere(square, dimension):
    """All integer points at one distance from the origin: exactly cospherical."""
    r = int(sqrt(square)) + 1
    return [p for p in product(range(-r, r + 1), repeat=dimension) if sum(x * x for x in p) == square]


def moment_curve(n, dimension=3):
    """Vertices of a cyclic polytope; their Delaunay triangulation can have quadratically many simplices."""
    return [tuple(t ** (i + 1) for i in range(dimension)) for t in range(n)]


def random_points(n, dimension, seed):
    r = Random(seed)
    return [tuple(r.random() for _ in range(dimension)) for _ in range(n)]


def sphere_surface(n, seed):
    """Doubles near the unit sphere: cospherical but for roundoff."""
    r, points = Random(seed), []
    while len(points) < n:
        p = [r.uniform(-1, 1) for _ in range(3)]
        length = sqrt(sum(x * x for x in p))
        if 0.1 < length <= 1:
            points.append(tuple(x / length for x in p))
    return points


def circle(n):
    """Doubles near the unit circle."""
    return [(cos(2 * pi * i / n), sin(2 * pi * i / n)) for i in range(n)]


def nudge(x, ulps):
    for _ in range(abs(ulps)):
        x = nextafter(x, 9e307 if ulps > 0 else -9e307)
    return float(x)


def jittered(points, seed):
    """Each coordinate moved by -1, 0 or 1 unit in its last place."""
    r = Random(seed)
    return [tuple(nudge(float(x), r.choice((-1, 0, 1))) for x in p) for p in points]


def rotated(points, angle, axis_tilt):
    """Turned in floating point about z, then about x: planes and lines are lost by roundoff."""
    out = []
    for x, y, z in points:
        x, y = x * cos(angle) - y * sin(angle), x * sin(angle) + y * cos(angle)
        y, z = y * cos(axis_tilt) - z * sin(axis_tilt), y * sin(axis_tilt) + z * cos(axis_tilt)
        out.append((x, y, z))
    return out


def clusters(per_cluster, size, seed):
    r = Random(seed)
    centres = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.3, 0.4, 1.0)]
    return [tuple(c + size * r.uniform(-1, 1) for c in centre) for centre in centres for _ in range(per_cluster)]


def oblique_plane(points):
    """Points of the plane, exactly on an oblique plane in space."""
    return [(u + 2 * v, 3 * u - v, u - 4 * v) for u, v in points]


def scaled(points, factor):
    return [tuple(x * factor for x in p) for p in points]
