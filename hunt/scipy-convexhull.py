from scipy.spatial import ConvexHull, QhullError

from lines import Refused, serve


def facets(points):
    """Its documents list QhullError, of geometrical degeneracy, among what it raises."""
    try:
        return ConvexHull(points).simplices
    except QhullError as error:
        raise Refused(str(error).strip().splitlines()[0]) from error


serve(facets)
