from shapely.geometry import MultiPoint
from shapely.ops import triangulate as delaunay

from lines import indices, serve


def triangulate(points):
    index = indices(points)
    return [[index(point) for point in triangle.exterior.coords[:3]] for triangle in delaunay(MultiPoint(points))]


serve(triangulate)
