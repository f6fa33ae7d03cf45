# A worker for `circumspect campaign --worker --updates insert,delete -- python3 mine.py`: points
# come and go.
import sys

from scipy.spatial import Delaunay


class Structure:
    """Put your own library here. Its points are a list: insert appends, delete takes the one at a place out."""
    def __init__(self, points):
        self.points = points
    def insert(self, *point):
        self.points.append(list(point))
    def delete(self, place):
        del self.points[int(place)]
    def restore(self):
        self.points = [[float(x) for x in repr(p)[1:-1].split(",")] for p in self.points]  # written and read again
    def simplices(self):
        return Delaunay(self.points).simplices  # rows of places in the list, from 0


for counts in map(str.split, sys.stdin):
    words = [sys.stdin.readline().split() for _ in range(int(counts[0]) + int(counts[6]))]
    structure = Structure([list(map(float, point)) for point in words[:int(counts[0])]])
    for name, *numbers in words[int(counts[0]):]:
        getattr(structure, name)(*map(float, numbers))
    rows = structure.simplices()
    print("\n".join([str(len(rows)), *(" ".join(map(str, row)) for row in rows)]), flush=True)
