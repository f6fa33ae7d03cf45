"""The program qconvex, with Qt, which triangulates facets that are not simplices."""
import subprocess

from lines import Refused, serve


def facets(points):
    rows = [" ".join(repr(x) for x in point) for point in points]
    text = "\n".join([str(len(points[0])), str(len(points)), *rows]) + "\n"
    done = subprocess.run(["qconvex", "Qt", "i"], input=text, capture_output=True, text=True)
    if done.returncode:
        # Qhull explains its errors; those of a flat or narrow hull are among what its manual tells.
        raise Refused(done.stderr.strip().splitlines()[0])
    count, *lines = done.stdout.split("\n")
    return [[int(v) for v in line.split()] for line in lines[:int(count)]]


serve(facets)
