import math

import cv2

from lines import indices, serve


def triangulate(points):
    """Subdiv2D takes single precision; the points are such. Its vertices 1 to 3 are far outside."""
    low = [math.floor(min(p[k] for p in points)) for k in (0, 1)]
    high = [math.floor(max(p[k] for p in points)) for k in (0, 1)]
    subdiv = cv2.Subdiv2D((*low, high[0] - low[0] + 2, high[1] - low[1] + 2))
    for point in points:
        subdiv.insert(point)
    index = indices(points)
    made = [[index(t[0:2]), index(t[2:4]), index(t[4:6])] for t in map(list, subdiv.getTriangleList())]
    return [triangle for triangle in made if -1 not in triangle]


serve(triangulate)
