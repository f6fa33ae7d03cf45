#!/usr/bin/env python3
"""A certificate is about the domain of the user's own .poly file: circumspect-verified refuses it beside any other.

    proofs/users_domains.py CIRCUMSPECT CIRCUMSPECT_VERIFIED

Two domains are meshed and certified. Beside a file that says the same (numbered from elsewhere and in another order, with other line
ends, with its points in a .node file, with hole points where nothing is enclosed) the certificate is verified. It is not where a
vertex, a segment, a polygon or a hole point is another one. A word that is no number, or one more number in a line, is malformed, and the
answer names the line.
"""
import collections
import itertools
import pathlib
import random
import re
import subprocess
import sys
import tempfile

import forgeries

# Higher than wide, with holes, a vertex of no segment, and markers and attributes wherever they
# are allowed.
PLANE = """\
13 2 1 1
3 0 0 .5 1
4 8 0 .5 1
5 8 24 .5 1
6 0 24 .5 1
7 2 2 .5 2
8 4 2 .5 2
9 4 4 .5 2
10 2 4 .5 2
11 5 8 .5 2
12 7 8 .5 2
13 7 10 .5 2
14 5 10 .5 2
15 6 20 .5 0
12 1
1 3 4 1
2 4 5 1
3 5 6 1
4 6 3 1
5 7 8 2
6 8 9 2
7 9 10 2
8 10 7 2
9 11 12 2
10 12 13 2
11 13 14 2
12 14 11 2
2
1 3 3
2 6 9
2
1 1 1 5 .1
2 1 5 5 .1
"""
HOLES = "2\n1 3 3\n2 6 9\n"
BOTTOM = "2 0 1\n4 1 2 3 4\n2 1 3\n"
# A box with an edge and a point in it; corners that repeat others, and a polygon on two lines.
SPACE = """\
9 3 1 1
1 0 0 0 7 1
2 8 0 0 7 1
3 8 8 0 7 1
4 0 8 0 7 1
5 0 0 40 7 1
6 8 0 40 7 1
7 8 8 40 7 1
8 0 8 40 7 1
9 4 4 33 7 0
7 1
2 0 1
4 1 2 3 4
2 1 3
1 0 1
5 5 6 7 8 5
1 0 1
5 1 2 2 6 5
1 0 1
4 2 3
7 6
1 0 1
4 3 4 8 7
1 0 1
4 4 1 5 8
1 0 1
2 1 9
0
1
1 1 1 1 5 .1
"""


def with_line(text, place, *lines):
    """The text with these lines in place of one."""
    rows = text.splitlines()
    return "\n".join([*rows[:place], *lines, *rows[place + 1:], ""])


def renumbered(text, step):
    """The points numbered from elsewhere, and in another order."""
    rows = [line.split() for line in text.splitlines()]
    points, d = int(rows[0][0]), int(rows[0][1])
    first = int(rows[1][0])
    place = {str(first + k): str(100 + (k * step + 3) % points) for k in range(points)}
    ordered = sorted(([place[row[0]], *row[1:]] for row in rows[1:points + 1]), key=lambda row: int(row[0]))
    section, at = [], points + 2
    if d == 2:
        for row in rows[at:at + int(rows[at - 1][0])]:
            section.append([row[0], place[row[2]], place[row[1]], *row[3:]])
    else:
        for _ in range(int(rows[at - 1][0])):
            lines, holes, _ = map(int, rows[at + len(section)])
            section.append(rows[at + len(section)])
            for _ in range(lines):
                row, taken = rows[at + len(section)], rows[at + len(section)][1:]
                section.append([row[0], *(place[word] for word in taken)])
                if len(taken) < int(row[0]):
                    section.append([place[word] for word in rows[at + len(section)]])
            section += [rows[at + len(section) + k] for k in range(holes)]
    rows[1:at + len(section)] = [*ordered, rows[at - 1], *section]
    return "\n".join(" ".join(row) for row in rows) + "\n"


def the_same(text):
    """What says the same: how, the .poly file, and the .node file beside it."""
    yield "as it is", text, None
    yield "with tabs and the line ends of others", text.replace(" ", " \t").replace("\n", "\t\r\n"), None
    yield "with comments and empty lines", text.replace("\n", " # 7\n\n#7\n"), None
    yield "without the last line end", text.rstrip("\n"), None
    yield "renumbered", renumbered(text, 4), None
    rows = text.splitlines(keepends=True)
    points = 1 + int(rows[0].split()[0])
    for header in (f"0 {rows[0].split()[1]} 0 0\n", "0\n"):
        yield "with its points in another file", "".join([header, *rows[points:]]), "".join(rows[:points])
    is_plane, own = text == PLANE, HOLES if text == PLANE else "0\n"
    width, height, middle = 8, 24 if is_plane else 40, [4] * (1 if is_plane else 2)
    for seed in ((*middle, height + 1), (*middle, -1), (width + 1, *middle[1:], 9), (-1, *middle[1:], 9)):
        more = f"{int(own[0]) + 1}{own[1:]}9 {' '.join(map(str, seed))}\n"
        yield f"with a hole point beyond all at {seed}", text.replace("\n" + own, "\n" + more), None
    wider = [f"{row[:-1]} 7\n" if 0 < k < points else row for k, row in enumerate(rows)]
    yield "with further columns", "".join(wider).replace(" 1 1\n", " 2 1\n", 1), None
    yield "with a region of no attribute", text.removesuffix(" .1\n") + "\n", None
    if not is_plane:
        yield "with a hole of a polygon beyond it", text.replace(BOTTOM, BOTTOM.replace("2 0", "2 1") + "1 4 9 0\n"), None


def altered(text):
    """What says something else: how, the .poly file, and the .node file beside it."""
    rows = [line.split() for line in text.splitlines()]
    points, is_plane = int(rows[0][0]), text == PLANE
    counts = {0: 4, points + 1: 2}  # how many, by the line
    for place, row in enumerate(rows[points + 2:-3 if is_plane else -2], points + 2):
        counts[place] = 2 if not is_plane and row[1:] == ["0", "1"] else len(row) == 1
    for place, row in enumerate(rows[:max(counts) + 1]):
        # What stands behind is a marker.
        numbers = range(1, 1 + int(rows[0][1]) if place <= points else len(row) - (is_plane and len(row) == 4))
        if not is_plane and place > points and len(set(row[1:])) < len(row) - 1:
            numbers = ()  # a corner that repeats another one may be any of its neighbours
        for column in range(counts[place]) if counts.get(place) else numbers:
            for other in ("7" + row[column], *(f"{float(row[column]) + by:g}" for by in (1, -1))):
                yield f"{other} in line {place + 1}", with_line(text, place, " ".join([*row[:column], other, *row[column + 1:]])), None
    yield "the last vertex where the first is", with_line(text, points, " ".join([rows[points][0], *rows[1][1:]])), None
    yield "two markers", "".join(f"{line} 1\n" if 0 < k <= points else f"{line}\n" for k, line in enumerate(text.splitlines())).replace(" 1 1\n", " 1 2\n", 1), None
    again = [str(int(rows[points][0]) + 1), *rows[points][1:]]
    yield "a vertex twice", with_line(with_line(text, points, " ".join(rows[points]), " ".join(again)), 0, " ".join([str(points + 1), *rows[0][1:]])), None
    if is_plane:
        yield "without the vertex of no segment", with_line(with_line(text, points), 0, " ".join([str(points - 1), *rows[0][1:]])), None
        for seed in ("5 7 5", "5 5 9", "5 1 23"):
            yield f"with a hole point at {seed}", text.replace(HOLES, f"3{HOLES[1:]}{seed}\n"), None
        yield "without holes", text.replace(HOLES, "0\n"), None
        yield "without their number", text[:text.index(HOLES)], None
    else:
        for seed in ("4 1 0", "1 7 0"):
            yield f"with a hole of a polygon at {seed}", text.replace(BOTTOM, BOTTOM.replace("2 0", "2 1") + f"1 {seed}\n"), None
        for line in ("x 4 9 0", "1 4 9 0 1"):
            yield f"with the hole {line} of a polygon", text.replace(BOTTOM, BOTTOM.replace("2 0", "2 1") + line + "\n"), None
        yield "with a polygon of no corner", text.replace(BOTTOM, BOTTOM.replace("2 0", "3 0") + "0\n"), None
    split = text.splitlines(keepends=True)
    own = "".join(split[:points + 1])
    for how, header, node in (("another dimension", f"0 {5 - int(rows[0][1])} 0 0\n", own), ("no dimension", f"0 {rows[0][1]}\n", own.replace(split[0], f"{points}\n")),
                              ("a row more", "0\n", own + split[points]), ("no points", "0\n", "0 0\n")):
        yield f"points of another file: {how}", "".join([header, *split[points + 1:]]), node


def unreadable(text):
    """A word that is no number in place of each, and a number more in each line: the line, and the file."""
    for place, line in enumerate(text.splitlines()):
        words = line.split()
        for column in range(len(words)):
            yield place + 1, with_line(text, place, " ".join([*words[:column], "x", *words[column + 1:]]))
        if line != "4 2 3":  # which goes on in the next line
            yield place + 1, with_line(text, place, line + " 1")


def faults(text):
    """What is malformed, and all that is said of it: the answer, the .poly file, and the .node file beside it."""
    rows, is_plane = text.splitlines(), text == PLANE
    lists = 1 + int(rows[0].split()[0])  # the header of segments or facets
    own, elsewhere = "\n".join([*rows[:lists], ""]), "\n".join(["0", *rows[lists:], ""])
    expected = f"expected '{'SEGMENTS' if is_plane else 'FACETS'} [MARKERS]', found 3 numbers"
    yield f"malformed: {{poly}}:{lists + 1}: {expected}", with_line(text, lists, rows[lists] + " 1"), None
    yield f"malformed: {{poly}}:2: {expected}", with_line(elsewhere, 1, rows[lists] + " 1"), own
    yield "malformed: {node}:1: expected 'POINTS DIMENSION [ATTRIBUTES [MARKERS]]', found 1 numbers", elsewhere, "0\n"
    yield "malformed: {node}:2: expected an integer, found 'x'", elsewhere, with_line(own, 1, "x 0 0")
    if is_plane:
        yield f"malformed: {{poly}}:{lists + 2}: expected 4 columns, found 5", with_line(text, lists + 1, rows[lists + 1] + " 1"), None


def hold(programs, folder, text):
    """How many files were tried."""
    poly, ele, certificate = folder / "own.poly", folder / "own.ele", folder / "own.cert"
    poly.write_text(text)
    for asked in (["build", "cdt", poly, "-o", ele], ["certify", ele, "--domain", poly, "--claim", "cdt", "-o", certificate]):
        run = programs.run(*asked, "--quiet")
        assert run.returncode == 0, f"{asked}: {run.stderr}"
    other, beside, tried = folder / "other.poly", folder / "other.node", 0

    def answer(text, node=None):
        other.write_text(text)
        beside.unlink(missing_ok=True)
        if node is not None:
            beside.write_text(node)
        return programs.answer(certificate, other)[0]

    said = programs.answer(certificate, "--hole", "1,,2", poly)
    assert said[1] == 2 and "expected --hole X,Y,Z" in said[0], said
    said = subprocess.run([programs.verified, "--help"], capture_output=True, text=True, check=True).stdout
    assert said.startswith("usage: circumspect-verified "), said
    for how, *files in the_same(text):
        line = answer(*files)
        assert line.startswith("verified: cdt"), f"{how}: expected 'verified', found '{line}':\n{files[0]}"
        tried += 1
    for how, *files in altered(text):
        line = answer(*files)
        assert line.startswith(("rejected: another domain", "malformed: ")), f"{how}: expected a refusal, found '{line}':\n{files[0]}"
        tried += 1
    for place, changed in unreadable(text):
        line = answer(changed)
        assert re.fullmatch(f"malformed: {re.escape(str(other))}:{place}: expected .*, found (['0-9].*|(other|more) numbers)", line), f"expected a fault in line {place}, found '{line}':\n{changed}"
        tried += 1
    for said, *files in faults(text):
        assert answer(*files) == said.format(poly=other, node=beside), f"expected {said}, found {answer(*files)}"
        tried += 1
    if text == PLANE:
        line = programs.answer(certificate, "--hole", "4,25", poly)[0]
        assert line.startswith("verified: cdt") and line.endswith(f": {poly} --hole 4,25"), line
        other.write_text(text.replace(HOLES, f"3{HOLES[1:]}5 7 5\n"))
        line = programs.answer(certificate, "--hole", "5,9", other)[0]
        assert f"{len(text[:text.index(HOLES)].splitlines()) + 4}: found the hole point (7 5)" in line, f"expected the file's own hole point first, found {line}"
    return tried + hold_faces(programs, folder, text)


def hold_faces(programs, folder, text):
    """Of the edges, or triangles, that a file beside the mesh lists. How many such files were tried."""
    certificate, node, ele, poly = (folder / f"own.{name}" for name in ("cert", "node", "ele", "poly"))
    beside, other = (folder / name for name in (("own.edge", "own.face") if text == PLANE else ("own.face", "own.edge")))
    other.unlink(missing_ok=True)
    cells = [line.split()[1:] for line in ele.read_text().splitlines()[1:]]
    size = len(cells[0]) - 1
    own = [cell[:size] for cell in cells[:3]]
    names = sorted({v for cell in cells for v in cell}, key=int)
    stray = next(list(face) for face in itertools.combinations(names, size) if not any(set(face) <= set(cell) for cell in cells))

    def answer(header, rows):
        beside.write_text("\n".join(" ".join(row) for row in [header, *([str(k), *row] for k, row in enumerate(rows))]) + "\n")
        return programs.answer(certificate, node, ele, poly)[0]

    marked, tried = [[*row, "5"] for row in own], 0
    for header, rows in ((["3"], own), (["3", "1"], marked), (["3"], [[*row, "7", "8", "9"] for row in own]), (["0"], [])):
        line = answer(header, rows)
        assert line.startswith("verified: cdt"), f"{beside.name} {header} {rows}: expected 'verified', found '{line}'"
        tried += 1
    for header, rows, place in ((["3", "2"], [[*row, "6"] for row in marked], 1), (["3", "1"], own, 2), (["3"], [*marked[:2], own[2]], 4),
                                (["3"], [*own[:2], marked[2]], 4), (["3"], [[*row, "7", "8", "9", "9"] for row in own], 2),
                                (["2"], own, 4), (["4"], own, 5), (["3"], [["x", *own[0][1:]], *own[1:]], 2), (["3", "1"], [*marked[:2], [*own[2], "x"]], 4)):
        line = answer(header, rows)
        assert line.startswith(f"malformed: {beside}:{place}: expected "), f"{beside.name} {header} {rows}: expected a fault in line {place}, found '{line}'"
        tried += 1
    for header, rows, place in ((["3"], [*own[:2], stray], 4), (["3", "1"], [*marked[:2], [*stray, "1"]], 4), (["3"], [["999", *own[0][1:]], *own[1:]], 2)):
        line = answer(header, rows)
        assert line.startswith("rejected: another mesh, ") and f"{place}: found " in line, f"{beside.name} {rows}: expected a refusal, found '{line}'"
        tried += 1
    return tried


def hold_refuted(programs, folder):
    """A refutation that is about a segment to a vertex which the user's domain does not have."""
    poly, ele, certificate = folder / "refuted.poly", folder / "own.ele", folder / "refuted.cert"
    (folder / "own.poly").write_text(PLANE)
    programs.run("build", "cdt", folder / "own.poly", "-o", ele, "--quiet").check_returncode()
    poly.write_text(PLANE.replace("13 2 1 1\n", "14 2 1 1\n").replace("15 6 20 .5 0\n", "15 6 20 .5 0\n16 7 21 .5 0\n"))
    programs.run("certify", ele, "--domain", poly, "--claim", "cdt", "--quiet", "-o", certificate)
    own = certificate.read_text()
    assert programs.answer(certificate, poly)[0].startswith("verified: not cdt, domain.vertex-missing"), own
    for ends in ("1 15", "15 1"):
        certificate.write_text(own.replace("segments 12\n", f"segments 13\n{ends}\n"))
        assert programs.answer(certificate)[0].startswith("verified: not cdt, domain.vertex-missing"), certificate.read_text()
        line = programs.answer(certificate, poly)[0]
        assert line.endswith("expected 14 vertices, found a segment with another"), f"expected another domain, found '{line}'"


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
    corpus = pathlib.Path(__file__).resolve().parent.parent / "corpus/domains"
    dice, counts = random.Random(1), collections.Counter()

    def certified(ele, poly, claim, certificate):
        return programs.run("certify", ele, "--domain", poly, "--claim", claim, "--quiet", "-o", certificate).returncode

    def fits(certificate, ele, poly):
        return programs.answer(certificate, ele.with_suffix(".node"), ele, poly)[0].startswith("verified")

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
        asked, folder = forgeries.Programs(*programs), pathlib.Path(scratch)
        tried = sum(hold(asked, folder, text) for text in (PLANE, SPACE)) + hold_domains(asked, folder)
        hold_refuted(asked, folder)
    print(f"{tried} files of domains: a certificate is verified beside the user's own alone")


if __name__ == "__main__":
    main()
