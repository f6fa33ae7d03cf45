import os
import sys

sys.path.insert(0, os.environ["BUILDS"] + "/src/Delaunator-Python")
from Delaunator import Delaunator

from lines import serve


def triangulate(points):
    made = Delaunator([list(point) for point in points]).triangles
    return [made[k:k + 3] for k in range(0, len(made), 3)]


serve(triangulate)
