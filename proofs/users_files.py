#!/usr/bin/env python3
"""A certificate is about the user's files as they stand: circumspect-verified refuses it beside any others.

    proofs/users_files.py CIRCUMSPECT CIRCUMSPECT_VERIFIED

Drawn point sets are meshed and certified. Beside files that spell the same numbers in another way, the certificate is verified.
It is not where a number is another one, a row is missing or added, or a header announces one row too many or too few; nor
where decimals are taken at their word and the certificate took them for doubles, or the other way round.

Of every kind of file that is read, a word behind any line or in place of its first one is malformed, and the answer names the file
and the line.
"""
import pathlib
import re
import subprocess
import sys
import tempfile

import forgeries

# Families of points, or points, and claims about their triangulations.
SETS = [("uniform", "delaunay", 2), ("integers", "triangulation", 3), ("grid", "delaunay", 3), ("small-weights", "weighted-delaunay", 2),
        ("submerged", "weighted-delaunay", 3), ("uniform", "complex", 3), ("uniform", "surface-delaunay", 2),
        ([(x / 8, y / 16, x * y / 16, x / 4096) for x, y in ((0, 1), (7, 0), (3, 9), (8, 5), (-4, 4))], "weighted-delaunay", 3),
        ([(x / 8, y / 8, x / 4 - y / 8) for x, y in ((0, 1), (7, 0), (3, 9), (8, 5), (-4, 4))], "delaunay", 3),
        ([(x, 2 * x) for x in (0, 5, 95 * 10**17, -3 << 66, 7 << 68)], "triangulation", 2)]
# No numbers, and no integers.
NO_NUMBERS = ("x", "1_0", "0x1", "--1", "1..2", "/2", "1/", "1/0", "1/-2", "1e", "e1", "1e+", "1e1_0", ".", "-", "inf", "nan", "1e400", "1x")
NO_INTEGERS = (*NO_NUMBERS, "1.", "1e0", "1/1", str(2**63))


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


def the_same(points, simplices, claim):
    """What says the same: how, and the texts of both files."""
    texts = points.text(), simplices.text()
    yield "as they are", *texts
    spelled = points.copy()
    spelled.rows = [[row[0], *(f"{word}e0" if "e" not in word and "/" not in word else word for word in row[1:])] for row in points.rows]
    yield "with exponents", spelled.text(), texts[1]
    yield "with tabs and the line ends of others", *(text.replace(" ", " \t").replace("\n", "\t\r\n") for text in texts)
    yield "with comments and empty lines", *(text.replace("\n", " # 7\n\n#7\n") for text in texts)
    yield "without the last line end", *(text.rstrip("\n") for text in texts)
    wider = points.copy(), simplices.copy()
    wider[0].header[2:] = [str(int(points.header[2]) + 2), "1"]
    wider[1].header[2:] = ["1"]
    for file, columns in zip(wider, (["0.5", "7e1", "-3"], ["1/3"])):
        file.rows = [[*row, *columns] for row in file.rows]
    yield "with further columns", *(file.text() for file in wider)
    turned = simplices.copy()
    turned.rows = [[row[0], *reversed(row[1:])] for row in simplices.rows]
    yield "with vertices in another order", texts[0], turned.text()


def altered(file, columns):
    """Files that say something else: how, and the file. `columns`: of the numbers that matter."""
    for announced in (-1, 1):
        for column in range(len(file.header)):
            other = file.copy()
            other.header[column] = str(int(file.header[column]) + announced)
            yield f"{announced:+} in column {column} of the header", other
    other = file.copy()
    other.header[-1] = str(int(other.header[-1]) + 2)
    other.rows = [[*row, "1", "1"] for row in other.rows]
    if len(file.header) == 4:
        yield "two more markers", other
    other = file.copy()
    other.rows[-1][0] = str(int(other.rows[-1][0]) + 1)
    yield "a number of rows left out", other
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


def unreadable(file, numbers):
    """The file with a word that is none of its numbers, or with one too many: the line, and the text. `numbers`: the columns of a
    row that need not be integers."""
    lines = [file.header, *file.rows]
    for place, line in enumerate(lines):
        for column, words in enumerate([*[NO_NUMBERS if place and k in numbers else NO_INTEGERS for k in range(len(line))], ["1"]]):
            for word in words if place < 2 else words[:1]:
                changed = [*lines[:place], [*line[:column], word, *line[column + 1:]], *lines[place + 1:]]
                yield place + 1, "".join(" ".join(row) + "\n" for row in changed)


def points_of(programs, family, dimension):
    """A file of drawn points; of points that are listed, the last number of each is a weight if there is one more."""
    if isinstance(family, str):
        return programs.run("generate", family, "--points", "9", "--seed", "1", "--dimension", str(dimension), "-o", "-").stdout
    rows = [f"{len(family)} {dimension} {len(family[0]) - dimension} 0", *(" ".join(map(repr, (k, *row))) for k, row in enumerate(family))]
    return "\n".join(rows) + "\n"


def hold(programs, folder, family, claim, dimension):
    """How many pairs of files were tried. Raises an AssertionError where the answer is wrong."""
    node, ele, certificate, points = (folder / name for name in ("mesh.node", "mesh.ele", "certificate", "points.node"))
    points.write_text(points_of(programs, family, dimension))
    weights = claim == "weighted-delaunay"
    for asked in (["build", "weighted-delaunay" if weights else "delaunay", points, "-o", ele],
                  ["certify", ele, "--claim", claim, "-o", certificate]):
        run = programs.run(*asked, "--quiet")
        assert run.returncode == 0, f"{asked}: {run.stderr}"
    own = File(node.read_text()), File(ele.read_text())
    texts, tried = tuple(file.text() for file in own), 0

    def answer(*texts):
        node.write_text(texts[0])
        ele.write_text(texts[1])
        return programs.answer(certificate, node, ele)[0]

    for how, *same in the_same(*own, claim):
        line = answer(*same)
        assert line.startswith(f"verified: {claim}"), f"{family} {how}: expected 'verified', found '{line}'"
        tried += 1
    numbers = range(1, 1 + dimension + weights)
    for which, columns in ((0, numbers), (1, range(1, len(own[1].rows[0])))):
        for how, other in altered(own[which], columns):
            line = answer(*(other.text() if which == k else texts[k] for k in (0, 1)))
            assert line and not line.startswith("verified"), f"{family}, file {which}, {how}: expected a refusal, found '{line}'"
            tried += 1
        for place, text in unreadable(own[which], () if which else numbers) if weights and dimension == 2 else ():
            line = answer(*(text if which == k else texts[k] for k in (0, 1)))
            fault = f"malformed: {re.escape(str(ele if which else node))}:{place}: expected .*, found ['0-9].*"
            assert re.fullmatch(fault, line), f"expected a fault in line {place}, found '{line}':\n{text}"
            tried += 1
    return tried


def hold_decimals(programs, folder):
    """Decimals taken at their word are other numbers than the doubles nearest to them. How many pairs of files were tried."""
    node, ele = folder / "decimal.node", folder / "decimal.ele"
    points = ["0.1 0.3", "-0.1 2.7e0", "12.5E-1 -.7", "-35e-1 -0.05", "+0.6 110e-2", "3e1 -.2e2", "-120e-2 -2.30"]
    rows = [[str(index), *row.split()] for index, row in enumerate(points)]
    own = "".join(" ".join(row) + "\n" for row in [[str(len(rows)), "2", "0", "0"], *rows])
    node.write_text(own)
    programs.run("build", "delaunay", node, "-o", folder / "built.ele", "--quiet").check_returncode()
    ele.write_text((folder / "built.ele").read_text())
    readings = ([], ["--coordinates", "decimal"])
    certificates = [folder / "of-doubles", folder / "of-decimals"]
    for reading, certificate in zip(readings, certificates):
        node.write_text(own)
        programs.run("certify", ele, "--claim", "triangulation", *reading, "--quiet", "-o", certificate).check_returncode()

    def is_verified(reading, certificate):
        line = programs.answer(certificate, *reading, node, ele)[0]
        assert line, f"expected an answer about\n{node.read_text()}"
        return line.startswith("verified: triangulation")

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


# Meshes of the corpus, and options of certify: the vertices of a simplex stand in an order that
# matters there.
ORDERED = [("periodic/plane.ele", ("--claim", "periodic-delaunay", "--box", "0,0,4,4")),
           ("periodic/cell-missing.ele", ("--claim", "periodic-delaunay", "--box", "0,0,4,4")),
           ("reject/complex.duplicate-simplex--2d.ele", ("--claim", "triangulation"))]
RING = "3 2 0 0\n0 0 0\n1 4 0\n2 0 4\n"


def hold_orders(programs, folder):
    """Where offsets, or evidence, go by the places of vertices in their simplices, the files have them in this order; and only of a
    convex hull are vertices in a cycle its edges. How many files were tried."""
    corpus, certificate = pathlib.Path(__file__).resolve().parent.parent / "corpus", folder / "ordered.cert"
    node, ele, tried = folder / "ordered.node", folder / "ordered.ele", 0

    def is_verified():
        return programs.answer(certificate, node, ele)[0].startswith("verified")

    for name, options in ORDERED:
        own = File((corpus / name).read_text())
        node.write_text((corpus / name).with_suffix(".node").read_text())
        ele.write_text(own.text())
        programs.run("certify", ele, *options, "--quiet", "-o", certificate)
        assert is_verified(), name
        row = own.rows[0]
        row[1], row[2] = row[2], row[1]
        ele.write_text(own.text())
        assert not is_verified(), f"{name}: expected a refusal of the first simplex in another order"
        row[1], row[2] = row[2], row[1]
        own.rows.append([str(int(own.rows[-1][0]) + 1), *own.rows[-1][1:]])
        ele.write_text(own.counted().text())
        assert not is_verified(), f"{name}: expected a refusal of one simplex more"
        tried += 3
    node.write_text(RING)
    ele.write_text("3 1\n0 0\n1 1\n2 2\n")
    programs.run("certify", ele, "--claim", "complex", "--quiet", "-o", certificate)
    assert is_verified(), "three vertices"
    tried += 1
    for claim in ("complex", "triangulation"):
        ele.write_text("3 2\n0 0 1\n1 1 2\n2 2 0\n")
        programs.run("certify", ele, "--claim", claim, "--quiet", "-o", certificate)
        assert is_verified(), f"{claim}: three edges"
        ele.write_text("3 1\n0 0\n1 1\n2 2\n")
        assert not is_verified(), f"{claim}: expected a refusal of three vertices"
        tried += 2
    # Refutations of an entry that names no point, and of no simplices, are not about meshes without
    # these faults.
    for own, others in (("1 3\n0 0 1 9\n", ["1 3\n0 0 1 2\n", "1 3\n0 0 1 1\n", "1 3\n0 0 1 0\n"]), ("0 3\n", ["1 3\n0 0 1 2\n", "1 2\n0 0 1\n"])):
        ele.write_text(own)
        programs.run("certify", ele, "--claim", "triangulation", "--quiet", "-o", certificate)
        assert is_verified(), own
        for other in others:
            ele.write_text(other)
            assert not is_verified(), f"expected a refusal of {other}, since the certificate is about {own}"
        tried += 1 + len(others)
    return tried


def certificates_of_each_kind():
    """Of those in proofs/mutants that are verified, the smallest with these sections, and with these words on the first line beside
    the claim and the dimension."""
    kinds = {}
    for path in sorted((pathlib.Path(__file__).parent / "mutants").glob("*.cert")):
        lines = path.read_text().splitlines()
        kind = (*lines[1].split()[4:], *(line.split()[0] for line in lines[2:] if line[:1].isalpha()))
        if lines[0].startswith("# verified") and (kind not in kinds or len(lines) < len(kinds[kind])):
            kinds[kind] = lines
    return list(kinds.values())


# They begin with a word that stands nowhere else, and a file cannot do without them.
LINES = ("scale", "spans", "sample", "because", "end")


def hold_lines(programs, folder):
    """How many slips were tried, at each line that begins with a word and at the one after it, which may be a row: a word behind it, a
    word in place of its first one, and the end of the file before it."""
    path, tried = folder / "slip.cert", 0
    kinds = certificates_of_each_kind()
    assert len(kinds) > 60, len(kinds)

    def expect_fault(line, fault, *lines):
        nonlocal tried
        path.write_text("\n".join([*lines, ""]))
        said = programs.answer(path)[0]
        assert re.fullmatch(f"malformed: {re.escape(str(path))}:{line}: expected {fault}", said), f"expected {fault} in line {line}, found '{said}':\n" + "\n".join(lines)
        tried += 1

    for lines in kinds:
        named = [k for k, line in enumerate(lines) if line[:1].isalpha()]
        for k in sorted({*named, *(k + 1 for k in named[:-1])}):
            expect_fault(k + 1, "(?!'x).*, found ['0-9].*", *lines[:k], lines[k] + " x", *lines[k + 1:])
            expect_fault(k + 1, "(?!'x).*, found 'x.*", *lines[:k], " ".join(["x", *lines[k].split()[1:]]), *lines[k + 1:])
            word = lines[k].split()[0]
            begins = f"'{word}" if word in LINES else ""
            expect_fault(k + 1, f"{begins}.*, found the end of the file", *lines[:k])
        expect_fault(len(lines) + 1, "nothing after 'end', found 'end'", *lines, "end")
    expect_fault(2, "the dimension, 2 or 3, found '4'", "", "circumspect-certificate 1 delaunay 4")
    for name in ("-", "/dev/stdin"):  # more than a pipe holds, and of no length that is known
        whole = "\n".join([*kinds[0][:3], "#" * 200000, *kinds[0][3:], ""])
        run = subprocess.run([programs.verified, name], input=whole, capture_output=True, text=True, check=False)
        assert run.stdout.startswith("verified"), run.stdout
    return tried + 2


def hold_limits(programs, folder):
    """Numbers and lists at the ends of what a certificate may have, and beyond them. How many were tried."""
    path, tried = folder / "limit.cert", 0
    most = " ".join(map(str, range(1, 65)))

    def expect(answer, lines, place, row):
        nonlocal tried
        path.write_text("\n".join([*lines[:place], row, *lines[place + 1:], ""]))
        said = programs.answer(path)[0]
        assert re.match(answer.format(line=f"malformed: {re.escape(str(path))}:{place + 1}: expected"), said), f"{lines[1]} with '{row}': {said}"
        tried += 1

    for lines, k in ((lines, k) for lines in certificates_of_each_kind() for k in range(2, len(lines))):
        word, *numbers = lines[k].split()
        is_delaunay = lines[1].startswith("circumspect-certificate 1 delaunay")
        if word == "reach":
            expect("{line} at most 64 integers, found 65$", lines, k, f"reach 0 {most}")
            expect("(?!malformed)", lines, k, f"reach {most}")
        if word == "simplices" and is_delaunay:  # nothing is number 0
            row = next(j for j in range(k + 1, len(lines)) if lines[j].split()[0] == "1")
            expect("rejected: ", lines, row, "0" + lines[row][1:])
        if word == "points" and is_delaunay:  # each is the user's
            expect("{line} .*, found '-'$", lines, k + 1, " ".join([*lines[k + 1].split()[:-1], "-"]))
        if word == "because":  # also what no simplex has is answered
            for column in range(len(numbers)):
                expect("rejected: |verified: |malformed: ", lines, k, " ".join(["because", *numbers[:column], "99", *numbers[column + 1:]]))
        if word == "spans" and lines[1].endswith(" flat"):
            for few in ("", "1 2 3 4"):
                expect(f"{{line}} 1 to {lines[1].split()[3]} points, found {len(few.split())}$", lines, k, f"spans {few}")
    return tried


def hold_weights(programs, folder):
    """Only the mesh of a certificate about weighted triangulations has weights."""
    for lines in certificates_of_each_kind():
        path = folder / "any.cert"
        path.write_text("\n".join([*lines, ""]))
        run = subprocess.run([programs.verified, "--mesh", path], capture_output=True, text=True, check=False)
        assert run.returncode == 0 and ('"weights"' in run.stdout) == (lines[1].split()[2] == "weighted-delaunay"), f"{lines[1]}: {run.stdout}"


def main():
    programs = [pathlib.Path(name).resolve() for name in sys.argv[1:3]]
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        asked = forgeries.Programs(*programs)
        tried = sum(hold(asked, folder, *one) for one in SETS) + hold_decimals(asked, folder) + hold_orders(asked, folder)
        slips = hold_lines(asked, folder) + hold_limits(asked, folder)
        hold_weights(asked, folder)
    print(f"{tried} pairs of files: a certificate is verified beside the user's own alone; {slips} slips in certificates")


if __name__ == "__main__":
    main()
