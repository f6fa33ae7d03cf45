"""Surfaces of triangles, judged with the claim `surface-delaunay`: at each edge the angles opposite have a sum of at most 180 degrees."""
from files import Entry
from point_sets import CUBE, OCTAHEDRON
from reject import cube_surface, reject

BENT = [(-2, 0, 0), (2, 0, 0), (0, 0, 4), (0, 1, 0)]  # cotangents of 3/4 and −3/4 opposite the edge 0 1
CLAIM = "surface-delaunay"


def entries():
    yield Entry("accept/surface-bent", "two triangles, not in one plane, whose angles opposite their edge have a sum of 180 degrees exactly",
                BENT, [(0, 1, 2), (1, 0, 3)], [(CLAIM, "holds")])
    yield Entry("accept/surface-cube", "the surface of a cube: at the diagonal of each square the sum is 180 degrees exactly", CUBE, cube_surface(),
                [(CLAIM, "holds")])
    yield Entry("accept/surface-pages", "three triangles at one edge, which is counted and not judged", OCTAHEDRON,
                [(0, 1, 2), (0, 1, 3), (0, 1, 4)], [(CLAIM, "holds")])
    yield reject("surface.edge-not-delaunay", "two triangles with wide angles opposite their edge: the other diagonal is right",
                 [(0, 0, 0), (4, 0, 0), (2, 1, 0), (2, 0, 1)], [(0, 1, 2), (1, 0, 3)], claims=[(CLAIM, "surface.edge-not-delaunay")])
    yield reject("surface.edge-not-delaunay--by-a-hair", "the two bent triangles, one of them lower by the last bit of its height",
                 [*BENT[:2], (0, 0, 4 - 2 ** -51), BENT[3]], [(0, 1, 2), (1, 0, 3)], claims=[(CLAIM, "surface.edge-not-delaunay")])
