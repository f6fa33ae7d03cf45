#!/usr/bin/env python3
"""Gives every stored minimal input to every target: hunt/everywhere.tsv, a row an input, a column a target.

    propagate.py --builds DIR [TARGET ...]      anew for these targets, or for all that answer here
    propagate.py --builds DIR --missing         only the inputs that have no row yet
    propagate.py --page                         writes hunt/pages/everywhere.md from the table

Each column is one campaign with `--corpus corpus/findings` and no drawn case. A cell is `holds`, `refused`, `skipped`, a signature, or `-` where
the target does not take such an input: points of another dimension, or doubles that are not floats for a library that stores floats.
"""
import argparse
import os
import shutil
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

from hunt import HERE, POINT_CLAIMS, VIRTUAL_MACHINES, command_of, is_here, points_of, targets

CORPUS = HERE.parent / "corpus" / "findings"
TABLE = HERE / "everywhere.tsv"
PAGE = HERE.parent / "hunt" / "pages" / "everywhere.md"
NUMBERS = "none one two three four five six seven eight nine ten eleven twelve".split()


def points_of_any(path):
    """A .node file, or a .qhull file: dimension, count, and a point a line."""
    if path.suffix == ".node":
        return points_of(path)
    lines = [line.split() for line in path.read_text().splitlines() if line and not line.startswith("#")]
    return [[float(x) for x in line] for line in lines[2:2 + int(lines[1][0])]]


def inputs():
    """The files by name, with their points."""
    paths = sorted(path for path in CORPUS.iterdir() if path.suffix in (".node", ".qhull"))
    return {path.name: points_of_any(path) for path in paths}


def is_of_floats(points):
    try:
        return all(struct.unpack("f", struct.pack("f", x))[0] == x for point in points for x in point)
    except OverflowError:
        return False


def column(row, corpus, arguments):
    """What the target makes of each input in a folder, each in a process of its own."""
    made = {}
    command = command_of(row, arguments.builds)
    given = {str(len(points_of_any(path)[0])) for path in corpus.iterdir() if path.suffix in (".node", ".qhull")}
    for dimension in sorted(given & set(row["dimensions"].split(","))):
        with tempfile.TemporaryDirectory() as folder:
            words = [arguments.circumspect, "campaign", "--worker", "--claim", row["claim"], "--dimension", dimension, "--cases", "0",
                     "--worker-cases", "1", "--corpus", str(corpus), "--minimize-runs", "1", "--minimize-time", "1s", "--output", folder, "--quiet", "--jobs", "1"]
            words += ["--limit-memory", "0"] if Path(command[0]).name in VIRTUAL_MACHINES else []
            subprocess.run([*words, "--", *command], cwd=HERE.parent, check=False)
            lines = [line.split("\t") for line in (Path(folder) / "journal.tsv").read_text().splitlines()]
        paths = next(line[2] for line in lines if line[:2] == ["setting", "--corpus"]).split()
        for line in lines:
            if line[0] == "case":
                made[Path(paths[int(line[1])]).name] = line[4] if line[3] == "finding" else line[3]
    return made


def read_table():
    if not TABLE.exists():
        return {}, []
    lines = [line.split("\t") for line in TABLE.read_text().splitlines()]
    names = lines[0][1:]
    return {line[0]: dict(zip(names, line[1:])) for line in lines[1:]}, names


def write_table(cells):
    given = inputs()
    single = {row["target"] for row in targets() if row["numbers"] == "single"}
    names = [row["target"] for row in targets() if any(row["target"] in cells.get(name, {}) for name in given)]
    lines = [["input", *names]]
    for name, points in given.items():
        row = [cells.get(name, {}).get(target, "-") if target not in single or is_of_floats(points) else "-" for target in names]
        lines.append([name, *row])
    TABLE.write_text("".join("\t".join(line) + "\n" for line in lines))


def outcome(cell):
    """right, rounding, refused, extreme or otherwise; empty where nothing is asked: a flat set has no mesh to be right."""
    if cell in ("-", "skipped", "flaky") or cell.endswith("-flat"):
        return ""
    if cell in ("holds", "refused"):
        return {"holds": "right", "refused": "refused"}[cell]
    if "-rounding" in cell:
        return "rounding"
    return "extreme" if cell.endswith("-extreme") else "otherwise"


def page():
    cells, names = read_table()
    of = {row["target"]: row for row in targets()}
    given = inputs()
    out = ["# Every minimal input, given to every library", "",
           f"`corpus/findings` holds {len(given)} sets of points on which some program was wrong. Each is small, and each has broken somebody:",
           "a collection to try one's own triangulator on, with `circumspect campaign --corpus corpus/findings --cases 0 --dimension 2 -- ...`.",
           "Here each was given to each library that was hunted. `hunt/everywhere.tsv` has the outcome of each, and",
           "`hunt/propagate.py` writes it and this page.", "",
           "These are outcomes, and not all of them are faults: [the pages of the libraries](README.md) say what each promises. Many of the inputs are nearly",
           "degenerate, or lie far from the origin. *Rounding* is a facet that is not locally Delaunay by less than 10⁻⁹ of the ball.",
           "*Far* are inputs with numbers beyond 2¹⁰⁰ or below 2⁻¹⁰⁰, which came out otherwise than right; sets that lie in a hyperplane are not counted.", "",
           "| library | version | inputs | right | rounding | refused | far | otherwise |", "| --- | --- | --- | --- | --- | --- | --- | --- |"]
    tally = []
    for name in names:
        made = [outcome(row.get(name, "-")) for row in cells.values()]
        counts = [made.count(one) for one in ("right", "rounding", "refused", "extreme", "otherwise")]
        counts.insert(0, sum(counts))
        tally.append((counts[-1] / max(1, counts[0]), name, counts))
    for _, name, counts in sorted(tally):
        row = of[name]
        link = f"[{row['library']}]({row['page']}.md)" if (PAGE.parent / f"{row['page']}.md").exists() else row["library"]
        out.append(f"| {link} | {row['version']} | " + " | ".join(map(str, counts)) + " |")
    out += ["", "## By input", "", "| input | points | wrong in | which |", "| --- | --- | --- | --- |"]
    rows = []
    for one, points in given.items():
        made = {name: outcome(cells.get(one, {}).get(name, "-")) for name in names}
        asked = [name for name in names if made[name]]
        wrong = [name for name in asked if made[name] in ("extreme", "otherwise")]
        if asked:
            rows.append((-len(wrong), one, f"| `{one}` | {len(points)} in dimension {len(points[0])} | {len(wrong)} of {len(asked)} | {', '.join(wrong)} |"))
    out += [line for _, _, line in sorted(rows)]
    PAGE.write_text("\n".join(out) + "\n")


def add_columns(corpus, arguments):
    for row in targets():
        if row["claim"] not in POINT_CLAIMS - {"convex-hull", "voronoi"} or arguments.target and row["target"] not in arguments.target:
            continue
        if not is_here(row, arguments.builds):
            print(f"{row['target']}: is not here", flush=True)
            continue
        cells, _ = read_table()
        for name, cell in column(row, corpus, arguments).items():
            cells.setdefault(name, {})[row["target"]] = cell
        write_table(cells)
        print(row["target"], flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("target", nargs="*")
    parser.add_argument("--builds", help="the folder where libraries were installed or built")
    parser.add_argument("--missing", action="store_true")
    parser.add_argument("--page", action="store_true")
    parser.add_argument("--circumspect", default=os.environ.get("CIRCUMSPECT", str(HERE.parent / "build/release/bin/circumspect")))
    arguments = parser.parse_args()
    if arguments.builds:
        with tempfile.TemporaryDirectory() as folder:
            rows, _ = read_table()
            for name in inputs():
                if name not in rows or not arguments.missing:
                    shutil.copy(CORPUS / name, folder)
            add_columns(Path(folder), arguments)
    page()


if __name__ == "__main__":
    sys.exit(main())
