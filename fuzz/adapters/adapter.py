# A worker for `circumspect campaign --worker -- python3 mine.py`: it answers each case with
# simplices.
import sys

from scipy.spatial import Delaunay, QhullError


def triangulate(points):
    """Put your own library here: a list of points, and back come rows of indices, from 0."""
    return Delaunay(points).simplices


for header in sys.stdin:
    count = int(header.split()[0])
    points = [[float(x) for x in sys.stdin.readline().split()] for _ in range(count)]
    try:
        simplices = triangulate(points)
    except (QhullError, ValueError, IndexError) as error:  # what the library's documents let it refuse
        print("error", str(error).split("\n")[0], flush=True)
        continue
    print("\n".join([str(len(simplices)), *(" ".join(map(str, row)) for row in simplices)]), flush=True)
