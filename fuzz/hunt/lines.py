"""What every adapter in Python does: reads points from the standard input, writes triangles to the standard output."""
import os
import sys


class Refused(Exception):
    """The library says that it does not take this input, as its documents tell."""


def indices(points):
    """From a point that a library returns back to its index; it has to be the same two or three doubles."""
    known = {tuple(point): index for index, point in enumerate(points)}
    return lambda point: known.get(tuple(map(float, point)), -1)


def serve(triangulate):
    """`triangulate` is given a list of points, and returns lists of indices."""
    out = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)  # libraries print what they like
    while header := sys.stdin.readline():
        points = [tuple(map(float, sys.stdin.readline().split())) for _ in range(int(header.split()[0]))]
        try:
            simplices = [" ".join(str(int(v)) for v in simplex) for simplex in triangulate(points)]
            out.write("\n".join([f"{len(simplices)} {len(points[0]) + 1}", *simplices]) + "\n")
        except Refused as refusal:
            out.write(f"refused {refusal}\n")
        except Exception as error:
            out.write(f"raised {type(error).__name__}: {str(error).splitlines()[:1]}\n")
        out.flush()
