#!/usr/bin/env python3
"""Runs the command on inputs that once took it too long, and prints what each takes: the table of docs/performance.md.

    costly_inputs.py COMMAND

Seconds are those of the processor in the command itself, so that other work on the machine hardly changes them. Each input
has a limit; an input whose answer is long by its nature is ended by --limit, and then the command must have said beforehand how
long it may take, or have printed part of its answer, in the memory that it is given. Exit code 1: one took more.
"""
import argparse
import math
import os
import pathlib
import random
import subprocess
import sys
import tempfile

MEGABYTES = 500


def ring(n, radius, heights):
    return [(round(math.cos(2 * math.pi * i / n) * radius), round(math.sin(2 * math.pi * i / n) * radius), z)
            for z in heights for i in range(n)]


def poly(points, polygons=(), segments=()):
    lines = [f"{len(points)} {len(points[0])} 0 0"]
    lines += [f"{i} {' '.join(map(str, point))}" for i, point in enumerate(points)]
    lines.append(f"{len(polygons) if len(points[0]) == 3 else len(segments)} 0")
    for polygon in polygons:
        lines += ["1", f"{len(polygon)} {' '.join(map(str, polygon))}"]
    lines += [f"{i} {a} {b}" for i, (a, b) in enumerate(segments)]
    return "\n".join([*lines, "0", ""])


def double_cone(n):
    sides = [(apex, 2 + i, 2 + (i + 1) % n) for apex in (0, 1) for i in range(n)]
    return poly([(0, 0, 3000), (0, 0, -3000), *ring(n, 10 ** 6, [0])], sides)


def book(n):
    return poly([(0, 0, 0), (0, 0, 1000), *ring(n, 10 ** 6, [500])], [(0, 1, 2 + i) for i in range(n)])


def prism(n):
    sides = [(i, (i + 1) % n, n + (i + 1) % n, n + i) for i in range(n)]
    return poly(ring(n, 10 ** 6, [0, 1000]), [range(n), range(n, 2 * n), *sides])


def crossing(n):
    ends = random.Random(1).sample(range(100000), n)
    points = [point for i in range(n) for point in ((0, 7 * i), (100000, ends[i]))]
    return poly(points, (), [(2 * i, 2 * i + 1) for i in range(n)])


def points(n, d, size):
    dice = random.Random(2)
    return "\n".join([f"{n} {d} 0 0", *(f"{i} {' '.join(str(dice.randrange(size)) for _ in range(d))}" for i in range(n)), ""])


# What it is, the file and its text, the arguments, the seconds that it may take.
INPUTS = [
    ("a double cone of 1,000 triangles a side", "cone.poly", double_cone(1000), ["inspect", "cone.poly"], 5),
    ("the same of 4,000", "cones.poly", double_cone(4000), ["inspect", "cones.poly"], 30),
    ("a book of 1,000 pages on one segment", "book.poly", book(1000), ["inspect", "book.poly"], 5),
    ("a prism over a polygon of 1,500 corners", "prism.poly", prism(1500), ["inspect", "prism.poly"], 10),
    ("2,000 segments, most of which cross, 20 crossings", "cross.poly", crossing(2000), ["inspect", "cross.poly"], 5),
    ("the same, all crossings", "cross.poly", crossing(2000),
     ["inspect", "cross.poly", "--max-errors", "0", "--limit", "20s"], 25),
    ("30 points in dimension 10", "ten.node", points(30, 10, 1000), ["inspect", "ten.node", "--limit", "20s"], 25),
    ("21 points in dimension 16", "sixteen.node", points(21, 16, 1000), ["check", "sixteen.ele", "--limit", "20s"], 25),
    ("2,000 points of space, by definition", "many.node", points(2000, 3, 10 ** 6),
     ["check", "many.ele", "--by", "definition", "--limit", "20s"], 25)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command", type=os.path.abspath)
    command = parser.parse_args().command
    faults = 0
    print("| the input | command | seconds | MB | it said beforehand |\n| --- | --- | --: | --: | --- |")
    with tempfile.TemporaryDirectory(prefix="costly-") as folder:
        for what, file, text, arguments, most in INPUTS:
            pathlib.Path(folder, file).write_text(text, encoding="utf-8")
            if arguments[0] == "check":
                subprocess.run([command, "build", "delaunay", file, "-o", arguments[1], "--quiet"], cwd=folder, check=True)
            out, err = pathlib.Path(folder, "out"), pathlib.Path(folder, "err")
            with open(out, "wb") as printed, open(err, "wb") as said:
                process = subprocess.Popen([command, *arguments], cwd=folder, stdout=printed, stderr=said, stdin=subprocess.DEVNULL)
                _, status, usage = os.wait4(process.pid, 0)
            process.returncode = code = os.waitstatus_to_exitcode(status)
            seconds, megabytes = usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024
            told = [line for line in err.read_text(encoding="utf-8").splitlines() if "may take" in line]
            ended = b"by --limit" in out.read_bytes()[-400:] or code == 4
            word = told[0].split(" may take about ")[1].split(" (")[0] if told else "-"
            print(f"| {what} | `{' '.join(arguments)}` | {seconds:.1f}{', ended by its limit' if ended else ''} | {megabytes:.0f} | {word} |", flush=True)
            if code not in (0, 1, 3, 4) or seconds > most or megabytes > MEGABYTES:
                print(f"{what}: expected at most {most} s and {MEGABYTES} MB, found {seconds:.1f} s, {megabytes:.0f} MB, exit code {code}")
                faults += 1
            if ended and not told and out.stat().st_size < 10000:
                print(f"{what}: ended by its limit, and had neither said how long it may take nor printed a part of its answer")
                faults += 1
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
