#!/usr/bin/env python3
"""Measures what certificates cost and how many there are, and prints the table of docs/certificates.md.

    proofs/measured.py CIRCUMSPECT CIRCUMSPECT_VERIFIED [--divide N]

It takes a quarter of an hour on two processors. TetGen and Qhull (qdelaunay) have to be in the PATH. `--divide 100` tries the script
itself, on the hundredth part of everything.
"""
import argparse
import collections
import concurrent.futures
import os
import pathlib
import random
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
# Points that make some 10^6 triangles, and 10^6 tetrahedra.
POINTS = {2: 500_500, 3: 149_500}
# So many runs of forgeries.py, and forgeries of each of its inputs: more than 10^5 in all.
BATCHES, FORGERIES = 17, 50


def last_lines(*command):
    """What a script of this folder prints at its end; its failure ends this one, too."""
    run = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
    if run.returncode != 0:
        sys.exit(f"{command[0]}: exit code {run.returncode}\n{run.stdout[-3000:]}{run.stderr[-3000:]}")
    return run.stdout.splitlines()


def random_mesh(dimension, count, folder):
    """Random points in .node, and Qhull's Delaunay triangulation of them in .ele."""
    chance = random.Random(7)
    points = [" ".join(str(chance.random()) for _ in range(dimension)) for _ in range(count)]
    said = subprocess.run(["qdelaunay", "Qt", "i"], input="\n".join([str(dimension), str(count), *points]),
                          capture_output=True, text=True, check=True).stdout.splitlines()
    mesh = folder / f"random-{dimension}d"
    mesh.with_suffix(".node").write_text("\n".join([f"{count} {dimension} 0 0", *(f"{i} {p}" for i, p in enumerate(points))]) + "\n")
    mesh.with_suffix(".ele").write_text("\n".join([f"{said[0]} {dimension + 1} 0", *(f"{i} {s}" for i, s in enumerate(said[1:]))]) + "\n")
    return mesh, int(said[0])


def seconds_and_memory(*command):
    """What the checker takes to verify a Delaunay triangulation: seconds of a processor, and the most bytes at once."""
    with subprocess.Popen([str(word) for word in command], stdout=subprocess.PIPE, text=True) as process:
        said = process.stdout.read()
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0 or not said.startswith("verified: delaunay"):
        sys.exit(f"{command[0]}: exit code {process.returncode}: {said}")
    return used.ru_utime + used.ru_stime, 1024 * used.ru_maxrss


def simplices(circumspect, verified, divide, folder):
    """The rows about large meshes."""
    for dimension, name in ((3, "tetrahedra"), (2, "triangles")):
        mesh, count = random_mesh(dimension, POINTS[dimension] // divide, folder)
        node, ele, certificate = mesh.with_suffix(".node"), mesh.with_suffix(".ele"), mesh.with_suffix(".cert")
        subprocess.run([circumspect, "certify", ele, "-o", certificate], check=True, stdout=subprocess.DEVNULL)
        for files, where in (((node, ele), "beside the user's own files"), ((), "alone")):
            taken, memory = min(seconds_and_memory(verified, certificate, *files) for _ in range(3))
            yield (f"{count:,} {name} of random points, {where}", "`circumspect-verified`, the best of three",
                   f"{taken:.1f} s and {memory / 1e6:.0f} MB: {1e6 * taken / count:.1f} µs and {memory / count:.0f} bytes each")


def forgeries(programs, batches):
    """What becomes of those of all batches, as many at a time as there are processors."""
    def said(seed):
        return last_lines(HERE / "forgeries.py", *programs, "--forgeries", FORGERIES, "--seed", seed)

    counts = collections.Counter()
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for line in (line for lines in pool.map(said, range(1, batches + 1)) for line in lines):
            found = re.fullmatch(r"(?:forgeries|rebuilt): (.*): (\d+)", line)
            if found:
                counts[found[1]] += int(found[2])
    told = ", ".join(f"{count:,} {what}" for what, count in sorted(counts.items()))
    return f"{sum(counts.values()):,}, none verified and false: {told}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("circumspect", type=pathlib.Path)
    parser.add_argument("verified", type=pathlib.Path)
    parser.add_argument("--divide", type=int, default=1)
    options = parser.parse_args()
    programs, divide = (options.circumspect.resolve(), options.verified.resolve()), options.divide
    print("| | command | found |\n| --- | --- | --- |")

    def row(what, command, found):
        print(f"| {what} | {command} | {found} |", flush=True)

    row("rows of the corpus", "`proofs/covered.py ..`", last_lines(HERE / "covered.py", *programs, *(["--listed"] if divide > 1 else []))[-1])
    prisms = max(200 // divide, 4)
    row("TetGen's meshes of prisms over L, U, combs and stars", f"`proofs/solids.py .. --prisms {prisms} --seed 7`",
        last_lines(HERE / "solids.py", *programs, "--prisms", prisms, "--seed", 7)[-1])
    with tempfile.TemporaryDirectory() as folder:
        for cells in simplices(*programs, divide, pathlib.Path(folder)):
            row(*cells)
    batches = max(BATCHES // divide, 1)
    row("forgeries", f"`proofs/forgeries.py .. --forgeries {FORGERIES} --seed S`, S from 1 to {batches}", forgeries(programs, batches))


if __name__ == "__main__":
    main()
