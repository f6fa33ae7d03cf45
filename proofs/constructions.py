#!/usr/bin/env python3
"""Holds the constructions of the oracle to the one that is proved.

    proofs/constructions.py CIRCUMSPECT CIRCUMSPECT_VERIFIED [--sets N] [--seed S]

Each point set is drawn by `circumspect generate`. `circumspect-verified build delaunay` and every algorithm of
`circumspect build delaunay` have to make the same triangulation of it, the canonical one. Exit code 1: two of them differ.
"""
import argparse
import pathlib
import random
import re
import subprocess
import sys
import tempfile

FAMILIES = ("uniform", "integers", "grid", "cube", "circle", "sphere", "clusters", "pyramid")


def ran(*command):
    return subprocess.run(list(map(str, command)), capture_output=True, text=True)


def simplices(rows):
    """The vertices of each, in order; the first line counts them."""
    header, *lines = [line.split() for line in rows.splitlines() if line and not line.startswith("#")]
    found = {tuple(sorted(map(int, line[1:1 + int(header[1])]))) for line in lines}
    assert len(found) == int(header[0]), "a simplex is listed twice"
    return found


def misread(verified, points):
    """Which other file is not refused: one that announces a point more or less than it lists, has a point twice, or points that do not
    span; nothing if all are."""
    header, *rows = [line.split() for line in points.read_text().splitlines() if line and not line.startswith("#")]
    first, d, count = int(rows[0][0]), int(header[1]), len(rows)
    other = points.with_name("other.node")
    for announced, listed, message in (
            (count - 1, rows, "expected the end of the file"), (count + 1, rows, "expected point"),
            (count + 1, [*rows, [str(first + count), *rows[0][1:]]],
             f"other.node:{count + 2}: expected distinct points, found point {first} and point {first + count} in one place"),
            (d, rows[:d], f"expected points that span the {'plane' if d == 2 else 'space'}, found {d} points that do not")):
        other.write_text("\n".join(" ".join(row) for row in [[str(announced), *header[1:]], *listed]) + "\n")
        run = ran(verified, "build", "delaunay", other)
        if run.returncode != 3 or message not in run.stdout:
            return f"{announced} points announced, {len(listed)} listed: {run.stdout}"
    return None


def decimals_are_doubles(verified, points):
    """Whether --coordinates decimal is ignored: two points that are one double are two decimals."""
    points.write_text("4 2\n0 0 0\n1 0.1 0\n2 0.10000000000000000001 0\n3 0 1\n")
    codes = [ran(verified, "build", "delaunay", *options, points).returncode for options in ((), ("--coordinates", "decimal"))]
    return codes != [3, 0]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("circumspect")
    parser.add_argument("verified")
    parser.add_argument("--sets", type=int, default=24)
    parser.add_argument("--seed", type=int, default=1)
    asked = parser.parse_args()
    help_text = ran(asked.circumspect, "build", "delaunay", "--help").stdout
    algorithms = re.search(r"--algorithm ([a-z|-]+)", help_text)[1].split("|")
    dice = random.Random(asked.seed)
    made = compared = 0
    with tempfile.TemporaryDirectory() as scratch:
        points, mesh = pathlib.Path(scratch) / "points.node", pathlib.Path(scratch) / "mesh.ele"
        for number in range(asked.sets):
            family, dimension = FAMILIES[number % len(FAMILIES)], dice.choice((2, 3))
            drawn = ran(asked.circumspect, "generate", family, "--points", dice.randint(6, 30), "--dimension", dimension, "--seed",
                        asked.seed * 1000 + number, "-o", points, "--quiet")
            proved = ran(asked.verified, "build", "delaunay", points)
            if drawn.returncode != 0 or proved.returncode == 3 and "that do not" in proved.stdout:  # they lie in a plane
                continue
            made += 1
            read = misread(asked.verified, points) if made == 1 else None
            if read is not None:
                print(f"expected a refusal, found {read}\nof a file like\n{points.read_text()}", file=sys.stderr)
                return 1
            expected = simplices(proved.stdout)
            for algorithm in algorithms:
                built = ran(asked.circumspect, "build", "delaunay", points, "--algorithm", algorithm, "-o", mesh, "--quiet")
                if built.returncode != 0 or simplices(mesh.read_text()) != expected:
                    print(f"{algorithm} differs from what is proved, of {family} in dimension {dimension}, seed "
                          f"{asked.seed * 1000 + number}: {built.stderr}\n{points.read_text()}", file=sys.stderr)
                    return 1
                compared += 1
        if decimals_are_doubles(asked.verified, points):
            print(f"expected two points with --coordinates decimal alone, of\n{points.read_text()}", file=sys.stderr)
            return 1
    print(f"{made} point sets, {compared} triangulations by {len(algorithms)} algorithms: all are what is proved")
    return 0 if made >= asked.sets / 2 else 1


if __name__ == "__main__":
    sys.exit(main())
