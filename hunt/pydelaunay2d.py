import os
import sys

sys.path.insert(0, os.environ["BUILDS"] + "/src/pyDelaunay2D")
from delaunay2D import Delaunay2D

from lines import serve


def triangulate(points):
    """The frame has to contain the points; its documents give centre and radius as the way to say so."""
    largest = max(abs(x) for point in points for x in point)
    triangulation = Delaunay2D(center=(0, 0), radius=100 * largest)
    for point in points:
        triangulation.addPoint(point)
    return triangulation.exportTriangles()


serve(triangulate)
