from scipy.spatial import Delaunay, QhullError

from lines import Refused, serve


def triangulate(points):
    """Its documents list QhullError, of geometrical degeneracy, among what it raises."""
    try:
        return Delaunay(points).simplices
    except QhullError as error:
        raise Refused(str(error).strip().splitlines()[0]) from error


serve(triangulate)
