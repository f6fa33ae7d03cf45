"""Inputs that are not piecewise linear complexes, each named after its breach of Definition 4.3, up to "--".

There is no case for plc.index-out-of-range and plc.degenerate-segment: the readers refuse such files, which
are in corpus/malformed/.
"""
import files
from domain_meshes import *

SIDES = facets(CUBE_SQUARES)
ULP = 4.000000000000001  # the double after 4


def cases():
    """(name, what, points, cells, holes)"""
    yield "plc.duplicate-vertex", "the last vertex is the first again", CUBE + [(0, 0, 0)], SIDES + [([(8,)], [])], []
    yield "plc.duplicate-vertex--2d", "an isolated vertex on a corner", RING[:4] + [(9, 9)], RING_LINES[:4], []
    yield "plc.degenerate-polygon", "three vertices in a line", CUBE + [(9, 0, 0)], SIDES + facets([(0, 1, 8)]), []
    yield ("plc.degenerate-polygon--there-and-back", "a line that goes out and returns the same way",
           CUBE + [(9, 0, 0), (9, 9, 0)], SIDES + facets([(1, 8, 9, 8)]), [])
    warped = [*CUBE[:7], (4, 4, 5)]
    yield "plc.polygon-not-planar", "a cube with one corner lifted", warped, SIDES, []
    slight = [*CUBE[:7], (4, 4, ULP)]
    yield "plc.polygon-not-planar--one-ulp", "a cube with one corner lifted by one unit in the last place", slight, SIDES, []
    yield "plc.vertex-in-segment", "a vertex on an edge of a cube that ignores it", CUBE + [(1, 0, 0)], SIDES, []
    yield ("plc.vertex-in-segment--2d", "a T-junction of two segments", RING[:4] + [(4, 0), (4, 9)],
           [*RING_LINES[:4], (4, 5)], [])
    yield ("plc.crossing-segments", "two segments cross inside a cube", CUBE, SIDES + facets([(0, 7), (1, 6)]), [])
    yield "plc.crossing-segments--2d", "both diagonals of a square", RING[:4], [*RING_LINES[:4], (0, 2), (1, 3)], []
    yield ("plc.crossing-segments--outlines", "the outlines of two coplanar triangles cross",
           [(0, 0, 0), (4, 0, 0), (0, 4, 0), (1, 1, 0), (5, 1, 0), (1, 5, 0)], facets([(0, 1, 2), (3, 4, 5)]), [])
    window = CUBE + [(1, 1, 0), (3, 1, 0), (3, 3, 0), (1, 3, 0)]
    framed = lambda seed: [([CUBE_SQUARES[0], (8, 9, 10, 11)], [seed]), *SIDES[1:]]
    yield "plc.polygon-hole-seed", "the seed of a polygon's hole is off its plane", window, framed((2, 2, 1)), []
    yield "plc.polygon-hole-seed--on-line", "the seed lies on the outline of the hole", window, framed((1, 2, 0)), []
    yield "plc.polygon-hole-seed--outside", "the seed lies beyond the polygon", window, framed((9, 9, 0)), []
    yield ("plc.polygon-hole-seed--beside-hole", "the seed lies beside the hole, in the polygon itself", window,
           framed((0.5, 2, 0)), [])
    yield ("plc.segment-pierces-polygon", "a segment goes in through a square of a cube", CUBE + [(2, 2, 2), (2, 2, 9)],
           SIDES + facets([(8, 9)]), [])
    yield ("plc.segment-pierces-polygon--lone-triangle", "a triangle that encloses nothing, and a segment through it",
           [(0, 0, 0), (8, 0, 0), (0, 8, 0), (2, 2, -1), (2, 2, 5)], facets([(0, 1, 2), (3, 4)]), [])
    yield ("plc.polygons-cross", "two squares cross in a line between two vertices that both list",
           [(-4, 0, -4), (4, 0, -4), (4, 0, 4), (-4, 0, 4), (0, -4, -4), (0, 4, -4), (0, 4, 4), (0, -4, 4), (0, 0, -4), (0, 0, 4)],
           facets([(0, 8, 1, 2, 9, 3), (4, 8, 5, 6, 9, 7)]), [])
    yield ("plc.polygons-overlap", "a square and its half", CUBE, SIDES + facets([(0, 1, 2)]), [])
    yield "plc.hole-seed-on-wall", "a hole seed on a square of a cube", CUBE, SIDES, [(2, 2, 4)]
    yield "plc.hole-seed-on-wall--2d", "a hole seed on a segment", RING, RING_LINES, [(3, 4)]


# An input may have more breaches than that of its name.
MORE = {"plc.degenerate-polygon": ",plc.vertex-in-segment"}


def entries():
    """(name, what, all breaches)"""
    return [(name, what, name.split("--")[0] + MORE.get(name, "")) for name, what, *_ in cases()]


def write():
    folder = files.CORPUS / "domains/invalid"
    folder.mkdir(exist_ok=True)
    for name, what, points, cells, holes in cases():
        (folder / f"{name}.poly").write_text(poly(what, points, cells, holes, len(points[0])))
