"""Meshes judged by themselves, with the claim `complex`: of parts that are not convex, of surfaces, of what was meshed apart."""
from itertools import permutations

from exact import PointSet
from files import Entry
from point_sets import CUBE, OCTAHEDRON, grid
from reject import TETRAHEDRON, cube_surface, reject


def accept(name, what, points, simplices, claims=(("complex", "holds"),), **more):
    return Entry(f"accept/{name}", what, points, simplices, list(claims), **more)


def alone(rule, what, points, simplices, *options, **more):
    """Breaks the rule as a mesh alone, if that is demanded; and holds if it is not."""
    claim = " ".join(["complex", *options])
    return reject(rule, what, points, simplices, claims=[(claim, rule.split("--")[0])] + ([("complex", "holds")] if options else []), **more)


def square_ring():
    """Eight triangles around a square hole: inner corners 0 to 3, outer ones 4 to 7."""
    points = [(2, 2), (-2, 2), (-2, -2), (2, -2), (5, 6), (-6, 5), (-5, -6), (6, -5)]
    return points, [t for i in range(4) for j in [(i + 1) % 4] for t in ((i, 4 + i, 4 + j), (i, 4 + j, j))]


def spiral_ramp():
    """The same strip, going round a quarter more than once, so that its end lies on its beginning."""
    points, ring = square_ring()
    points += [(3, 2), (-2, 3), (6, 7), (-7, 6)]
    strip = [(3, 7, 10), (3, 10, 8), (8, 10, 11), (8, 11, 9)]
    return points, [t for t in ring if set(t) not in ({3, 7, 4}, {3, 4, 0})] + strip


def ring_of_tetrahedra():
    """Around vertex 8 the link is an annulus: every edge is right, and the vertex is not."""
    square = [(2, 2), (-2, 2), (-2, -2), (2, -2)]
    points = [(*p, 3) for p in square] + [(x, y, -3) for x, y in square] + [(0, 0, 0)]
    steps = [(i, (i + 1) % 4) for i in range(4)]
    return points, [t for i, j in steps for t in ((8, i, j, i + 4), (8, j, i + 4, j + 4))]


def crossed_halves():
    """Two halves of an octahedron, meshed apart: one cuts the square between them from 0 to 1, the other from 2 to 3."""
    return OCTAHEDRON, [(4, 0, 1, 2), (4, 0, 1, 3), (5, 2, 3, 0), (5, 2, 3, 1)]


def accepted():
    yield accept("complex-square-ring-2d", "eight triangles around a square hole, no triangulation of a convex hull", *square_ring(),
                 claims=[("complex --manifold --connected", "holds"), ("triangulation", "triangulation.hull-not-convex")])
    yield accept("complex-bow-tie-2d", "two triangles that meet in a vertex, which is proper, and a point beside them that nobody uses",
                 [(0, 0), (4, 1), (4, -1), (-4, 1), (-4, -1), (0, 9)], [(0, 1, 2), (0, 3, 4)],
                 claims=[("complex --allow-unused", "holds")])
    yield accept("complex-cube-surface", "the surface of a cube, outwards all around", CUBE, outwards(cube_surface()),
                 claims=[("complex --manifold --closed --connected --oriented", "holds")])
    yield accept("complex-hanging-vertex-2d", "a triangle refined beside one that is not, as programs do that refine without closure",
                 [(0, 0), (4, 0), (0, 4), (4, 4), (2, 2)], [(0, 1, 4), (0, 4, 2), (1, 3, 2)],
                 claims=[("complex --allow hanging-vertex", "holds")])
    yield accept("complex-listed-faces", "a cube, its surface and the diagonal inside: all that is listed beside the tetrahedra is a face of some",
                 CUBE, list(kuhn()), claims=[("complex --faces", "holds")], listed=[*cube_surface(), (0, 7)])
    yield accept("complex-nested-cubes", "a cube in the hole of a cube, apart from it", *nested())


def outwards(surface):
    s = PointSet(CUBE + [(0.5, 0.5, 0.5)])
    return [t if s.orientation((*t, 8)) > 0 else (t[1], t[0], t[2]) for t in surface]


def other_diagonal(surface):
    """The square at z = 0 has the corners 0, 1, 3 and 2."""
    rest = [t for t in surface if not {*t} <= {0, 1, 2, 3}]
    assert len(rest) == len(surface) - 2 and any({0, 3} < {*t} < {0, 1, 2, 3} for t in surface)
    return [*rest, (0, 1, 2), (1, 2, 3)]


def nested():
    """27 small cubes less the one in the middle, in which there is a smaller cube."""
    points = grid(4, 4, 4)
    mesh = []
    for corner in grid(3, 3, 3):
        if corner == (1, 1, 1):
            continue
        cube = [points.index(tuple(a + b for a, b in zip(corner, p))) for p in CUBE]
        mesh += [tuple(cube[v] for v in t) for t in kuhn()]
    inner = [tuple(1.25 + x / 2 for x in p) for p in CUBE]
    mesh += [tuple(v + len(points) for v in t) for t in kuhn()]
    return points + inner, mesh


def kuhn():
    """A cube as six tetrahedra around its diagonal, which cuts all faces of a grid alike."""
    for order in permutations((4, 2, 1)):
        yield tuple(sum(order[:i]) for i in range(4))


def rejected():
    yield alone("complex.points-equal", "two triangles whose common edge has its ends twice, as at interfaces of parts",
                [(0, 0), (4, 0), (0, 4), (4, 0), (0, 4), (4, 4)], [(0, 1, 2), (3, 5, 4)])
    yield alone("complex.hanging-vertex", "a vertex in the edge of a triangle that was not refined",
                [(0, 0), (4, 0), (0, 4), (4, 4), (2, 2)], [(0, 1, 4), (0, 4, 2), (1, 3, 2)])
    yield alone("complex.hanging-vertex--in-face-3d", "a tetrahedron stands with one corner on a face of another", TETRAHEDRON + [(1, 1, 0), (0, 0, -5), (3, 0, -5), (0, 3, -5)],
                [(0, 1, 2, 3), (4, 5, 6, 7)])
    yield alone("complex.faces-cross", "two parts that were meshed apart cut the square between them along different diagonals", *crossed_halves())
    yield alone("complex.overlap--spiral-ramp-2d", "a strip whose end lies on its beginning, with edges and boundary as they should be", *spiral_ramp())
    yield alone("complex.overlap--nested-3d", "a tetrahedron inside another, apart from its boundary", TETRAHEDRON + [(1, 1, 1), (2, 1, 1), (1, 2, 1), (1, 1, 2)],
                [(0, 1, 2, 3), (4, 5, 6, 7)])
    yield alone("simplex.degenerate--others-form-a-complex", "a flat tetrahedron on the square that two halves cut differently: the rest is right",
                OCTAHEDRON, [*crossed_halves()[1], (0, 1, 2, 3)])
    negative = [(1, 0, 2, 3), (2, 1, 3, 4)]
    yield alone("simplex.inverted", "two tetrahedra, both of negative volume", [(0, 0, 0), (2, 0, 0), (0, 2, 0), (0, 0, 2), (3, 3, 3)],
                negative, "--oriented=positive")
    surface = outwards(cube_surface())
    yield alone("complex.not-oriented", "the surface of a cube with one triangle turned over", CUBE,
                [(t[1], t[0], t[2]) if i == 5 else t for i, t in enumerate(surface)], "--oriented")
    yield alone("complex.not-manifold", "a ring of tetrahedra around a vertex, whose link is an annulus", *ring_of_tetrahedra(), "--manifold")
    yield alone("complex.not-manifold--three-triangles", "three triangles at one edge, like pages of a book",
                [(0, 0, 0), (0, 0, 4), (3, 0, 2), (-3, 1, 2), (0, -3, 2)], [(0, 1, 2), (0, 1, 3), (0, 1, 4)], "--manifold")
    yield alone("complex.not-closed", "the surface of a cube without one triangle", CUBE, surface[1:], "--closed")
    yield alone("complex.stray-face", "the surface that is listed beside the tetrahedra of a cube cuts one of its squares along the other diagonal",
                CUBE, list(kuhn()), "--faces", listed=other_diagonal(cube_surface()))
    yield alone("complex.stray-face--2d", "the boundary that is listed beside the triangles leads straight past a vertex",
                [(0, 0), (8, 0), (4, 3), (0, 6), (8, 6)], [(0, 1, 2), (0, 2, 3), (2, 4, 3)], "--faces", listed=[(0, 1), (1, 4), (4, 3), (3, 0)])
    yield alone("complex.not-connected", "two triangles that meet in a vertex only", [(0, 0), (4, 1), (4, -1), (-4, 1), (-4, -1)],
                [(0, 1, 2), (0, 3, 4)], "--connected")


def entries():
    yield from accepted()
    yield from rejected()
