import math

import cv2

from lines import Refused, indices, serve


def triangulate(points):
    """Subdiv2D takes single precision; the points are such. Its rectangle is of ints, and its vertices 1 to 3 are far outside."""
    if max(abs(x) for point in points for x in point) > 2 ** 29:
        raise Refused("coordinates beyond the rectangle of ints")
    low = [math.floor(min(p[k] for p in points)) for k in (0, 1)]
    size = [math.floor(max(p[k] for p in points)) - low[k] for k in (0, 1)]
    aside = 2 + max(size) // 1000
    subdiv = cv2.Subdiv2D((low[0] - aside, low[1] - aside, size[0] + 2 * aside, size[1] + 2 * aside))
    for point in points:
        subdiv.insert(point)
    index = indices(points)
    made = [[index(t[0:2]), index(t[2:4]), index(t[4:6])] for t in map(list, subdiv.getTriangleList())]
    return [triangle for triangle in made if -1 not in triangle]


serve(triangulate)
