#!/usr/bin/env python3
"""Measures circumspect check --memory on meshes larger than that, and prints a table (docs/distributed.md):

    /usr/bin/python3 bench/memory.py build/release/bin/circumspect [SIDE [SIZE...]]

The meshes are Freudenthal's of a grid of SIDE cubes along each axis (256: 100,663,296 tetrahedra), written in pieces: sorted,
shuffled points and tetrahedra, and both with a tetrahedron missing. Each is judged in every SIZE of memory (default: 2G),
and once by check without --memory, on as many threads as there are processors. Time by the clock; memory at most.
"""
import itertools
import os
import pathlib
import sys
import tempfile
import time

import numpy as np

from taken import taken

PIECE = 1 << 20  # rows


class Shuffle:
    """i -> a i + b modulo n, and back: an order without locality that takes no memory."""

    def __init__(self, n):
        self.n, self.b = n, n // 3
        self.a = next(a for a in itertools.count(int(n * 0.6180339887) | 1) if np.gcd(a, n) == 1)
        self.inverse = pow(self.a, -1, n)

    def __call__(self, i):
        return (i * self.a + self.b) % self.n

    def back(self, i):
        return (i - self.b) % self.n * self.inverse % self.n


def header(file, kind, rows, columns):
    np.lib.format.write_array_header_1_0(file, {"descr": kind, "fortran_order": False, "shape": (rows, columns)})


def pieces(count):
    for first in range(0, count, PIECE):
        yield np.arange(first, min(count, first + PIECE), dtype=np.int64)


def write_points(path, side, shuffle):
    """Point i of the grid stands in row shuffle(i)."""
    count = (side + 1) ** 3
    with open(path, "wb") as file:
        header(file, "<f8", count, 3)
        for rows in pieces(count):
            i = shuffle.back(rows) if shuffle else rows
            np.stack([i // (side + 1) ** 2, i // (side + 1) % (side + 1), i % (side + 1)], axis=1).astype("<f8").tofile(file)


def write_simplices(path, side, shuffle_points, shuffle_rows, missing):
    """Of each cube the six paths from corner to corner."""
    count = 6 * side ** 3
    steps = np.array([(side + 1) ** 2, side + 1, 1])
    paths = np.array([np.concatenate([[0], np.cumsum(steps[list(order)])]) for order in itertools.permutations(range(3))])
    with open(path, "wb") as file:
        header(file, "<i4", count - (missing is not None), 4)
        for rows in pieces(count):
            if missing is not None:
                rows = rows[rows != missing]
            number = shuffle_rows(rows) if shuffle_rows else rows
            cube = number // 6
            corner = cube // side ** 2 * steps[0] + cube // side % side * steps[1] + cube % side
            vertices = corner[:, None] + paths[number % 6]
            (shuffle_points(vertices) if shuffle_points else vertices).astype("<i4").tofile(file)


def main(arguments):
    command = str(pathlib.Path(arguments[0]).resolve())
    side = int(arguments[1]) if len(arguments) > 1 else 256
    sizes = arguments[2:] or ["2G"]
    count = 6 * side ** 3
    print("| order | tetrahedra | | verdict | seconds | of processors | memory, MB |\n| --- | ---: | --- | --- | ---: | ---: | ---: |")
    with tempfile.TemporaryDirectory(dir=os.environ.get("TMPDIR", "/var/tmp")) as scratch:
        points, simplices = pathlib.Path(scratch) / "p.npy", pathlib.Path(scratch) / "s.npy"
        for order in ["sorted", "shuffled"]:
            of_points = Shuffle((side + 1) ** 3) if order == "shuffled" else None
            of_rows = Shuffle(count) if order == "shuffled" else None
            write_points(points, side, of_points)
            for missing in [None, count // 2]:
                write_simplices(simplices, side, of_points, of_rows, missing)
                files = [str(simplices), "--points", str(points)]
                expected = None
                for words in [[], *(["--memory", size] for size in sizes)]:
                    start = time.monotonic()
                    processor, memory, code, said = taken([command, "check", *files, *words])
                    seconds = time.monotonic() - start
                    found = code, [line for line in said.splitlines() if not line.startswith("cause:")]  # none in parts
                    expected = expected or found
                    if found != expected:
                        raise SystemExit(f"{words}: expected {expected}, found {found}")
                    print(f"| {order} | {count - (missing is not None)} | `check {' '.join(words)}`" +
                          f" | {said.splitlines()[-1].split(':')[0]} | {seconds:.1f} | {processor:.1f} | {memory:.0f} |", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
