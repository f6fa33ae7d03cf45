#!/usr/bin/env python3
"""Stores a finding of a campaign: its files and its line in corpus/findings, its entry on the page of the library, its row in the table.

    store.py TARGET FOLDER --name jdt-flat --builds DIR [--kind "documented limitation"] [--call 'new Jdt({points})'] [--says TEXT]

FOLDER is that of the finding, with minimal.node. The library is run again: what it makes of the input now is what is stored and judged. In the
call, {points} stands for the points in parentheses that `--row` gives: [x, y] by default. The page has to be there already.
"""
import argparse
import re
import shutil
import subprocess
import sys
from pathlib import Path

from hunt import HERE, POINT_CLAIMS, answer_once, is_near, points_of, targets
from summary import EXPECTED, PAGES

COUNTS = "none one two three four five six seven eight nine ten eleven twelve".split()
WORDS = {"triangulation.unused-point": "A point is a vertex of no {simplex}.",
         "delaunay.facet-not-local": "A facet is not locally Delaunay, by {margin} of the ball.",
         "simplex.degenerate": "A {simplex} is flat, exactly.",
         "triangulation.hull-not-convex": "A part of the convex hull is not covered.",
         "triangulation.hull-not-closed": "The boundary of what is covered is not closed.",
         "triangulation.unknown-vertex": "A {simplex} has a corner that is none of the points.",
         "triangulation.covered-twice": "Points are covered more than once.",
         "complex.overlap": "Two simplices overlap.",
         "complex.facet-overused": "More than two simplices share a facet.",
         "complex.duplicate-simplex": "The same {simplex} is listed twice.",
         "simplex.repeated-vertex": "A {simplex} names the same vertex twice.",
         "hull.facet-not-supporting": "Points lie on both sides of a facet of the hull.",
         "hull.uncovered": "Part of the boundary of the hull is covered by no facet.",
         "simplex.wrong-dimension": "A facet has another number of vertices than a simplex.",
         "hang": "There is no answer in time."}


def number(x):
    return str(int(x)) if x == int(x) and abs(x) < 1e15 else repr(x)


def size(points):
    flat = [x for point in points for x in point]
    count = COUNTS[len(points)].capitalize() if len(points) < len(COUNTS) else str(len(points))
    integers = all(x == int(x) for x in flat)
    largest = max(map(abs, flat))
    return f"{count} {'integer ' if integers else ''}points" + (f" of at most {int(largest)}" if integers and 1 < largest < 1e6 else "")


def said(lines):
    """At most ten lines of a verdict, and its last."""
    return (lines[:9] + ["…", lines[-1]]) if len(lines) > 11 else lines


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("target")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--name", required=True)
    parser.add_argument("--builds", required=True)
    parser.add_argument("--kind", default="fault")
    parser.add_argument("--call")
    parser.add_argument("--row", default="[{}]")
    parser.add_argument("--says", default="")
    parser.add_argument("--circumspect", default=str(HERE.parent / "build/release/bin/circumspect"))
    arguments = parser.parse_args()
    row = next(one for one in targets() if one["target"] == arguments.target)
    assert row["claim"] in POINT_CLAIMS, "expected a library of points"
    node = EXPECTED.parent / f"{arguments.name}.node"
    shutil.copy(arguments.folder / "minimal.node", node)
    points = points_of(node)
    ended = answer_once(row, arguments.builds, node)
    if ended == 0:
        check = [arguments.circumspect, "check", node.with_suffix(".ele").name, "--claim", row["claim"], "--points", node.name]
        lines = subprocess.run(check, cwd=node.parent, capture_output=True, text=True).stdout.rstrip().splitlines()
        assert lines[-1].startswith("fails:"), f"{arguments.name}: expected it to fail again, found {lines[-1]}"
        signature = lines[-1].split()[3]
    else:
        signature = re.sub(r"-(rounding|extreme|flat)$", "", arguments.folder.name)
        lines = [f"found: {signature}"]
    margin = re.search(r"worst relative margin (\S+)", "\n".join(lines))
    words = WORDS.get(signature, "The process ends, without an answer.").format(
        simplex="triangle" if len(points[0]) == 2 else "tetrahedron", margin=f"{float(margin[1]):.2g}" if margin else "")
    near = " Some of the points are flat or cospherical up to 10⁻⁹ and not exactly, or they lie far from the origin." if is_near(points) else ""
    given = ", ".join(arguments.row.format(", ".join(map(number, point))) for point in points)
    call = [arguments.call.replace("{points}", given)] if arguments.call else []
    entry = [f"## {arguments.name}", "", f"**{arguments.kind.capitalize()}.** {size(points)}. {words}{near}" + (f" {arguments.says}" if arguments.says else ""),
             "", "```", *call, *said(lines), "```", ""]
    page = PAGES / f"{row['page']}.md"
    page.write_text(page.read_text().rstrip() + "\n\n" + "\n".join(entry))
    title = page.read_text().split("\n", 1)[0][2:]
    with (PAGES / "README.md").open("a") as readme:
        readme.write(f"| [{arguments.name}]({row['page']}.md#{arguments.name}) | {title} | `{signature}` | {len(points)} | {arguments.kind} |\n")
    with EXPECTED.open("a") as expected:
        mesh = f"{arguments.name}.ele" if ended == 0 else "-"
        expected.write("\t".join([arguments.name, row["claim"], signature, node.name, mesh, f"hunt.py {row['target']} --on {node.name}"]) + "\n")
    print(f"{arguments.name}: {signature}, {len(points)} points")


if __name__ == "__main__":
    sys.exit(main())
