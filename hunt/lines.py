"""What every adapter in Python does: it answers the cases of `circumspect campaign --worker` (docs/workers.md)."""
import os
import sys
import traceback


class Refused(Exception):
    """The library says that it does not take this input, as its documents tell."""


def indices(points):
    """From a point that a library returns back to its index; it has to be the same two or three doubles."""
    known = {tuple(point): index for index, point in enumerate(points)}
    return lambda point: known.get(tuple(map(float, point)), -1)


def serve(triangulate):
    """`triangulate` is given a list of points, and returns lists of indices; -1 is a vertex that is none of the points.

    What it raises beside Refused ends the process with exit code 1.
    """
    out = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)  # libraries print what they like
    while header := sys.stdin.readline():
        count = int(header.split()[0])
        points = [tuple(map(float, sys.stdin.readline().split())) for _ in range(count)]
        try:
            simplices = [" ".join(str(int(v) if v >= 0 else count) for v in simplex) for simplex in triangulate(points)]
            out.write("\n".join([f"{len(simplices)}", *simplices]) + "\n")
        except Refused as refusal:
            out.write(f"error {refusal}\n")
        except BaseException:
            traceback.print_exc()
            os._exit(1)
        out.flush()
