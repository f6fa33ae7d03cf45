#!/usr/bin/env python3
"""A certificate is about the user's files as they stand: circumspect-verified refuses it beside any others.

    proofs/users_files.py CIRCUMSPECT CIRCUMSPECT_VERIFIED

Drawn point sets are meshed and certified. Beside files that spell the same numbers in another way, the certificate is verified.
It is not where a number is another one, a row is missing or added, or a header announces one row too many or too few.
"""
import pathlib
import subprocess
import sys
import tempfile

SETS = [("uniform", "delaunay", 2), ("integers", "triangulation", 3), ("grid", "delaunay", 3), ("small-weights", "weighted-delaunay", 2),
        ("submerged", "weighted-delaunay", 3)]


class File:
    """A file of numbered rows after a header of counts."""

    def __init__(self, text):
        self.header, *self.rows = [line.split() for line in text.splitlines() if line and not line.startswith("#")]

    def copy(self):
        return File(self.text())

    def text(self):
        return "".join(" ".join(row) + "\n" for row in [self.header, *self.rows])

    def counted(self):
        """With the count that it has."""
        self.header[0] = str(len(self.rows))
        return self


def the_same(points, simplices):
    """What says the same: how, and both files."""
    yield "as they are", points, simplices
    spelled = points.copy()
    spelled.rows = [[row[0], *(f"{word}e0" if "e" not in word and "/" not in word else word for word in row[1:])] for row in points.rows]
    yield "with exponents", spelled, simplices


def altered(file, columns):
    """Files that say something else: how, and the file. `columns`: of the numbers that matter."""
    for announced in (-1, 1):
        other = file.copy()
        other.header[0] = str(len(file.rows) + announced)
        yield f"{announced:+} row announced", other
    for place in (0, len(file.rows) - 1):
        other = file.copy()
        del other.rows[place]
        for index in range(place, len(other.rows)):
            other.rows[index] = other.rows[index] if place else [str(int(file.rows[0][0]) + index), *other.rows[index][1:]]
        yield f"without row {place}", other.counted()
        for column in columns:
            other = file.copy()
            word = other.rows[place][column]
            other.rows[place][column] = "-7" + word[1:] if word[0] == "-" else "7" + word
            yield f"another number in column {column} of row {place}", other
    other = file.copy()
    other.rows.append([str(int(file.rows[-1][0]) + 1), *file.rows[-1][1:]])
    yield "the last row twice", other.counted()


def hold(programs, folder, family, claim, dimension):
    """How many pairs of files were tried. Raises an AssertionError where the answer is wrong."""
    circumspect, verified = programs
    node, ele, certificate = folder / "mesh.node", folder / "mesh.ele", folder / "certificate"
    points = folder / "points.node"
    subprocess.run([circumspect, "generate", family, "--points", "9", "--seed", "1", "--dimension", str(dimension), "-o", points,
                    "--quiet"], check=True)
    construction = "weighted-delaunay" if claim == "weighted-delaunay" else "delaunay"
    subprocess.run([circumspect, "build", construction, points, "-o", ele, "--quiet"], check=True)
    subprocess.run([circumspect, "certify", ele, "--claim", claim, "--quiet", "-o", certificate], check=True)
    own = File(node.read_text()), File(ele.read_text())
    tried = 0

    def answer(files):
        node.write_text(files[0].text())
        ele.write_text(files[1].text())
        return subprocess.run([verified, certificate, node, ele], capture_output=True, text=True, check=False).stdout

    for how, *files in the_same(*own):
        line = answer(files)
        assert line.startswith(f"verified: {claim}"), f"{family} {how}: expected 'verified', found '{line}'"
        tried += 1
    weights = 1 if construction == "weighted-delaunay" else 0
    for which, columns in ((0, range(1, 1 + dimension + weights)), (1, range(1, 2 + dimension))):
        for how, other in altered(own[which], columns):
            files = [other if which == k else own[k] for k in (0, 1)]
            line = answer(files)
            assert line and not line.startswith("verified"), f"{family}, file {which}, {how}: expected a refusal, found '{line}'"
            tried += 1
    return tried


def main():
    programs = [pathlib.Path(name).resolve() for name in sys.argv[1:3]]
    with tempfile.TemporaryDirectory() as folder:
        tried = sum(hold(programs, pathlib.Path(folder), *one) for one in SETS)
    print(f"{tried} pairs of files: a certificate is verified beside the user's own alone")


if __name__ == "__main__":
    main()
