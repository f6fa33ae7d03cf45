#!/usr/bin/env python3
"""A certificate is about the user's files as they stand: circumspect-verified refuses it beside any others.

    proofs/users_files.py CIRCUMSPECT CIRCUMSPECT_VERIFIED

Drawn point sets are meshed and certified. Beside files that spell the same numbers in another way, the certificate is verified.
It is not where a number is another one, a row is missing or added, or a header announces one row too many or too few; nor
where decimals are taken at their word and the certificate took them for doubles, or the other way round.
"""
import collections
import pathlib
import random
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


def hold_decimals(programs, folder):
    """Decimals taken at their word are other numbers than the doubles nearest to them. How many pairs of files were tried."""
    circumspect, verified = programs
    node, ele = folder / "decimal.node", folder / "decimal.ele"
    points = ["0.1 0.3", "-0.1 2.7e0", "12.5E-1 -.7", "-35e-1 -0.05", "+0.6 110e-2", "-120e-2 -2.30"]
    rows = [[str(index), *row.split()] for index, row in enumerate(points)]
    own = "".join(" ".join(row) + "\n" for row in [[str(len(rows)), "2", "0", "0"], *rows])
    node.write_text(own)
    subprocess.run([circumspect, "build", "delaunay", node, "-o", folder / "built.ele", "--quiet"], check=True)
    ele.write_text((folder / "built.ele").read_text())
    readings = ([], ["--coordinates", "decimal"])
    certificates = [folder / "of-doubles", folder / "of-decimals"]
    for reading, certificate in zip(readings, certificates):
        node.write_text(own)
        subprocess.run([circumspect, "certify", ele, "--claim", "triangulation", *reading, "--quiet", "-o", certificate], check=True)

    def is_verified(reading, certificate):
        run = subprocess.run([verified, certificate, *reading, node, ele], capture_output=True, text=True, check=False)
        assert run.stdout, f"expected an answer about\n{node.read_text()}"
        return run.stdout.startswith("verified: triangulation")

    tried = 0
    for reading in readings:
        for certificate in certificates:
            fits = (reading == readings[1]) == (certificate == certificates[1])
            assert is_verified(reading, certificate) == fits, f"{certificate.name} {reading}: expected {fits}"
            tried += 1
    for reading, certificate in zip(readings, certificates):
        for row in rows:
            for column in (1, 2):
                word = row[column]
                for other in (word[1:] if word[0] == "-" else "-" + word.lstrip("+"), word + "1", word[:-1] + str(9 - int(word[-1]))):
                    row[column] = other
                    node.write_text("".join(" ".join(one) + "\n" for one in [[str(len(rows)), "2", "0", "0"], *rows]))
                    assert not is_verified(reading, certificate), f"{other} for {word}, {reading}: expected a refusal"
                    tried += 1
                row[column] = word
    return tried


# Meshes of corpus/domains beside their domains, and claims that hold.
DOMAINS = [("accept/plane-ring", "accept/plane-ring", "cdt"), ("accept/cube-square-in-two", "accept/cube-square-in-two", "cdt"),
           ("accept/hollow-cube", "accept/hollow-cube", "cdt"), ("tetgen/tunnel.1", "tunnel", "steiner-cdt")]  # the last has polygons with holes
EDITS = 60


def edited(text, dice):
    """The text with one token or one row changed, as a slip of a writer would."""
    rows = [line.split() for line in text.splitlines() if line.split("#")[0].strip()]
    place = dice.randrange(len(rows))
    row = rows[place]
    column = dice.randrange(len(row))
    edit = dice.choice(("number", "number", "drop", "double", "without", "again", "segment"))
    lists = 1 + int(rows[0][0])  # the header of segments or facets
    if edit == "number":
        word = row[column]
        row[column] = str(int(word) + dice.choice((-1, 1))) if word.lstrip("-").isdigit() else str(float(word) + 0.25)
    elif edit == "drop":
        del row[column]
    elif edit == "double":
        row.insert(column, row[column])
    elif edit == "segment":  # one less, or one more: in space a facet of two corners
        less = rows[0][1] == "2" and dice.random() < 0.5
        rows[lists][0] = str(int(rows[lists][0]) + (-1 if less else 1))
        ends = [dice.choice(rows[1:lists])[0] for _ in range(2)]
        rows[lists + 1:lists + 1 + less] = [] if less else [["0", *ends]] if rows[0][1] == "2" else [["1"], ["2", *ends]]
    elif edit == "without":
        del rows[place]
    else:
        rows.insert(place, list(row))
    return "".join(" ".join(row) + "\n" for row in rows)


def hold_domains(programs, folder):
    """Edited domains: what the command refuses to read, the proved checker refuses; and if one certificate fits the other's
    file, so does the other one. How many were tried, of each outcome."""
    circumspect, verified = programs
    corpus = pathlib.Path(__file__).resolve().parent.parent / "corpus/domains"
    dice, counts = random.Random(1), collections.Counter()

    def certified(ele, poly, claim, certificate):
        run = subprocess.run([circumspect, "certify", ele, "--domain", poly, "--claim", claim, "--quiet", "-o", certificate],
                             capture_output=True, text=True, check=False)
        return run.returncode

    def fits(certificate, ele, poly):
        return subprocess.run([verified, certificate, ele.with_suffix(".node"), ele, poly], capture_output=True, text=True,
                              check=False).stdout.startswith("verified")

    for mesh, domain, claim in DOMAINS:
        ele, poly, own, other = corpus / f"{mesh}.ele", corpus / f"{domain}.poly", folder / "own", folder / "other.poly"
        assert certified(ele, poly, claim, own) == 0 and fits(own, ele, poly), f"{domain}: expected a verified certificate"
        for _ in range(EDITS):
            other.write_text(edited(poly.read_text(), dice))
            code = certified(ele, other, claim, folder / "others")
            if code not in (0, 1):
                what = "unreadable"
                assert code == 2 or not fits(own, ele, other), f"{domain}, edited: the command refuses\n{other.read_text()}"
            else:
                forth, back = fits(own, ele, other), fits(folder / "others", ele, poly)
                assert forth == back, f"{domain}, edited: one certificate fits both of it and\n{other.read_text()}"
                assert fits(folder / "others", ele, other), f"{domain}, edited: no certificate of its own\n{other.read_text()}"
                what = "the same" if forth else "another"
            counts[what] += 1
    assert len(counts) == 3, counts
    return sum(counts.values())


def main():
    programs = [pathlib.Path(name).resolve() for name in sys.argv[1:3]]
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        tried = sum(hold(programs, folder, *one) for one in SETS) + hold_decimals(programs, folder) + hold_domains(programs, folder)
    print(f"{tried} pairs of files: a certificate is verified beside the user's own alone")


if __name__ == "__main__":
    main()
