#!/usr/bin/env python3
"""Measures circumspect-mpi against circumspect check, and prints the table of docs/distributed.md:

    /usr/bin/python3 bench/ranks.py build/release/bin [POINTS [RANKS...]]      (ranks: 1 2 4 8)

A mesh of random points that SciPy makes, as arrays without neighbours: along a curve, and shuffled. Times are the
least of some rounds, by the clock, files included; of ranks what their phases take, so without the start of mpirun, which
takes a third of a second. Where more ranks run than there are processors they wait for each other. A million points
take SciPy a minute or two. Under the table stands what the measured bytes make expect of 10^10 tetrahedra on 1,000 ranks.
"""
import pathlib
import subprocess
import sys
import tempfile
import time

import numpy as np
import scipy.optimize
import scipy.spatial

ROUNDS = 3
SIZE_OF_MODEL, RANKS_OF_MODEL = 10 ** 10, 1000
MPIRUN = ["mpirun", "--quiet", "--allow-run-as-root", "--oversubscribe", "-n"]


def along_curve(points):
    """The order of points in the unit cube along Morton's curve."""
    cells = (points * 1024).astype(np.uint64)
    key = np.zeros(len(points), np.uint64)
    for bit in range(10):
        for axis in range(3):
            key |= (cells[:, axis] >> np.uint64(bit) & np.uint64(1)) << np.uint64(3 * bit + axis)
    return np.argsort(key, kind="stable")


def meshes(count, folder):
    """Writes the mesh in both orders: (name, file of points, file of simplices, number of simplices)."""
    random = np.random.default_rng(1)
    points = random.random((count, 3))
    points = points[along_curve(points)]
    simplices = scipy.spatial.Delaunay(points).simplices.astype(np.int64)
    simplices = simplices[along_curve(points[simplices].mean(axis=1))]
    number = random.permutation(count)
    shuffled = np.empty_like(points)
    shuffled[number] = points
    for name, vertices, cells in [("along a curve", points, simplices),
                                  ("shuffled", shuffled, number[simplices][random.permutation(len(simplices))])]:
        files = [folder / f"{name.replace(' ', '-')}.{kind}.npy" for kind in ("points", "simplices")]
        np.save(files[0], vertices)
        np.save(files[1], cells)
        yield name, files[0], files[1], len(simplices)


def run(command):
    """How long it takes by the clock, and what it writes to standard error."""
    start = time.monotonic()
    ended = subprocess.run(command, capture_output=True, text=True, check=True)
    return time.monotonic() - start, ended.stderr


def rows_of(statistics):
    """The rows of --statistics as (rank, phase, seconds, bytes, messages, memory)."""
    for line in statistics.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if len(cells) == 6 and cells[0].isdigit():
            yield int(cells[0]), cells[1], float(cells[2]), *map(int, cells[3:])


def seconds_of_ranks(rows):
    """The phases of the rank that takes longest."""
    sums = {}
    for row in rows:
        sums[row[0]] = sums.get(row[0], 0) + row[2]
    return max(sums.values())


def measure(build, all_ranks, name, points, simplices, size):
    """Prints the rows of one mesh; every round runs all of them, so that other work on the machine meets all alike."""
    files = [str(simplices), "--points", str(points)]
    check, least, rows = [], {ranks: [] for ranks in all_ranks}, {}
    for _ in range(ROUNDS):
        check.append(run([str(build / "circumspect"), "check", "--threads", "2", *files])[0])
        for ranks in all_ranks:
            said = run([*MPIRUN, str(ranks), str(build / "circumspect-mpi"), *files, "--statistics"])[1]
            rows[ranks] = list(rows_of(said))
            least[ranks].append(seconds_of_ranks(rows[ranks]))
    of_ranks = {ranks: (max(row[5] for row in rows[ranks]), sum(row[3] for row in rows[ranks])) for ranks in all_ranks}
    print(f"| {name} | {size} | `check --threads 2` | {min(check):.2f} | 1 | | | |")
    for ranks in all_ranks:
        sent, messages = sum(row[3] for row in rows[ranks]), sum(row[4] for row in rows[ranks])
        memory = max(row[5] for row in rows[ranks])
        print(f"| {name} | {size} | {ranks} rank{'s' if ranks > 1 else ''} | {min(least[ranks]):.2f} | "
              f"{min(least[ranks]) / min(check):.2f} | {sent / size:.1f} | {messages} | {memory * ranks / size:.0f} |",
              flush=True)
    return of_ranks


def fitted(shapes, values):
    """Factors that are not negative, one for each shape, with which the shapes add up to the values as well as may be."""
    return scipy.optimize.nnls(np.array(shapes, float), np.array(values, float))[0]


def print_model(name, of_ranks, size):
    """What a rank has: so much, and so much a tetrahedron. What all send: so much a tetrahedron that does not stay, and so much
    a facet on the borders of parts and of the mesh; there are about size^(2/3) P^(1/3) of these."""
    if len(of_ranks) < 3:
        return
    process, each = fitted([[1, size / ranks] for ranks in of_ranks], [memory for memory, _ in of_ranks.values()])
    shape = [[size * (ranks - 1) / ranks, size ** (2 / 3) * ranks ** (1 / 3) * (ranks - 1) / ranks] for ranks in of_ranks]
    moved, border = fitted(shape, [sent for _, sent in of_ranks.values()])
    part = SIZE_OF_MODEL / RANKS_OF_MODEL
    memory = process + each * part
    sent = (moved * SIZE_OF_MODEL + border * SIZE_OF_MODEL ** (2 / 3) * RANKS_OF_MODEL ** (1 / 3)) / RANKS_OF_MODEL
    print(f"\n{name}: a rank takes {process / 1e6:.0f} MB and {each:.0f} bytes a tetrahedron of its part; all send {moved:.1f} bytes a "
          f"tetrahedron that does not stay, and {border:.0f} a facet on a border. {SIZE_OF_MODEL:.0e} tetrahedra on {RANKS_OF_MODEL} "
          f"ranks: {memory / 1e9:.2f} GB a rank, of which it sends {sent / 1e6:.0f} MB.\n", flush=True)


def main(arguments):
    build = pathlib.Path(arguments[0])
    count = int(arguments[1]) if len(arguments) > 1 else 1000000
    all_ranks = [int(word) for word in arguments[2:]] or [1, 2, 4, 8]
    print("| order | tetrahedra | | seconds | of `check` | bytes sent, a tetrahedron | messages | "
          "memory of a rank, bytes a tetrahedron of its part |")
    print("| --- | ---: | --- | ---: | ---: | ---: | ---: | ---: |")
    measured = []
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        for name, points, simplices, size in meshes(count, folder):
            measured.append((name, measure(build, all_ranks, name, points, simplices, size), size))
    for one in measured:
        print_model(*one)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
