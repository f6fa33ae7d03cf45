#!/usr/bin/env python3
"""Measures circumspect check on meshes with one fault of each kind against the same mesh when it holds, and prints a
table:

    /usr/bin/python3 bench/faults.py build/release/bin/circumspect [POINTS]

A mesh of random points that SciPy makes, as arrays without neighbours (default: 150,000 points, a million tetrahedra), and,
if there is a tetgen, TetGen's mesh of a ball with POINTS / 6 triangles, against the ball. Times are processor time of all
threads, the least of three, files included; every round runs all rows. Memory is the most that the process had.
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile

import numpy as np
import scipy.spatial

from taken import taken

ROUNDS = 3


def measured(command):
    """Processor seconds, the most memory in MB, and the rule that the last line names, or "holds"."""
    seconds, memory, _, said = taken(command)
    last = said.splitlines()[-1].split()
    found = last[3] if last[0] == "fails:" else last[0].rstrip(":")
    return seconds, memory, found


def turned(points, simplices, count, rng):
    """As many 2-3 flips of pairs of tetrahedra that have none in common: facets that are not locally Delaunay."""
    neighbors = scipy.spatial.Delaunay(points).neighbors
    used, keep, new = np.zeros(len(simplices), bool), np.ones(len(simplices), bool), []
    for s in rng.permutation(len(simplices)):
        if len(new) >= 3 * count:
            break
        t = neighbors[s][0]
        if t < 0 or used[s] or used[t]:
            continue
        apex, face = simplices[s][0], simplices[s][1:]
        other = next(v for v in simplices[t] if v not in face)
        three = [[apex, other, face[i], face[(i + 1) % 3]] for i in range(3)]
        signs = {np.sign(np.linalg.det(points[row[1:]] - points[row[0]])) for row in three}
        if len(signs) > 1 or 0 in signs:  # the two are not convex together
            continue
        used[[s, t]], keep[[s, t]] = True, False
        new += three
    return np.concatenate([simplices[keep], np.array(new, simplices.dtype)])


def faulty(points, simplices, rng):
    """(what is wrong, points, simplices)"""
    k = len(simplices) // 2
    with_row = lambda row: np.concatenate([simplices[:k], np.array([row], simplices.dtype), simplices[k + 1:]])
    a = simplices[k]
    far = simplices[(k + len(simplices) // 3) % len(simplices)][0]
    yield "an index that names no point", points, with_row([a[0], a[1], a[2], len(points)])
    yield "a vertex twice in a tetrahedron", points, with_row([a[0], a[1], a[2], a[2]])
    yield "a tetrahedron twice", points, np.concatenate([simplices[:k], simplices[k:k + 1], simplices[k:]])
    yield "a tetrahedron missing", points, np.delete(simplices, k, axis=0)
    yield "a tetrahedron with another vertex", points, with_row([a[0], a[1], a[2], far])
    yield "a point that no tetrahedron has", np.concatenate([points, [[0.5, 0.5, 0.5]]]), simplices
    moved = points.copy()
    moved[a[0]] = 2 * points[a].mean(axis=0) - points[a[0]]
    yield "a point moved through a facet", moved, simplices
    yield "a 2-3 flip", points, turned(points, simplices, 1, rng)
    yield "20,000 2-3 flips", points, turned(points, simplices, min(20000, len(simplices) // 20), rng)


def print_rows(rows):
    """rows: (name, tetrahedra, command); the first one holds."""
    least = {}
    for _ in range(ROUNDS):
        for name, size, command in rows:
            seconds, memory, found = measured(command)
            before = least.get(name, (seconds,))[0]
            least[name] = (min(before, seconds), memory, found, size)
    holding = least[rows[0][0]]
    for name, (seconds, memory, found, size) in least.items():
        print(f"| {name} | {size} | {found} | {seconds:.2f} | {seconds / holding[0]:.2f} | {memory:.0f} | "
              f"{memory / holding[1]:.2f} |", flush=True)


def ball(count, folder, command):
    """Rows for TetGen's mesh of a ball with about so many triangles."""
    rng = np.random.default_rng(1)
    at = rng.normal(size=(count // 2 + 2, 3))
    at = np.round(at / np.linalg.norm(at, axis=1)[:, None], 9)  # TetGen writes 16 digits
    faces = scipy.spatial.ConvexHull(at).simplices
    inwards = np.linalg.det(at[faces]) < 0
    faces[inwards] = faces[inwards][:, ::-1]
    off = folder / "ball.off"
    off.write_text(f"OFF\n{len(at)} {len(faces)} 0\n" + "".join(f"{x!r} {y!r} {z!r}\n" for x, y, z in at.tolist()) +
                   "".join(f"3 {a} {b} {c}\n" for a, b, c in faces.tolist()))
    subprocess.run(["tetgen", "-pYQq1.4a0.00001", str(off)], check=True, stdout=subprocess.DEVNULL)
    mesh = folder / "ball.1.ele"
    lines = mesh.read_text().splitlines()
    size = int(lines[0].split()[0])
    check = lambda path: [command, "check", str(path), "--domain", str(off), "--claim", "steiner-triangulation"]
    rows = [("a ball that holds", size, check(mesh))]
    for name, number in [("a ball, a tetrahedron missing", size // 2)]:
        other = folder / "missing.1.ele"
        shutil.copy(mesh.with_suffix(".node"), other.with_suffix(".node"))
        body = [line for line in lines[1:] if not line.startswith("#")]
        first = int(body[0].split()[0])
        kept = [line.split() for i, line in enumerate(body) if i != number]
        other.write_text(f"{size - 1} 4 0\n" + "".join(f"{i + first} {' '.join(row[1:5])}\n" for i, row in enumerate(kept)))
        rows.append((name, size - 1, check(other)))
    return rows


def main(arguments):
    command = str(pathlib.Path(arguments[0]).resolve())
    count = int(arguments[1]) if len(arguments) > 1 else 150000
    rng = np.random.default_rng(1)
    points = rng.random((count, 3))
    simplices = scipy.spatial.Delaunay(points).simplices.astype(np.int32)
    print("| mesh | tetrahedra | | seconds | of holding | memory, MB | of holding |\n"
          "| --- | ---: | --- | ---: | ---: | ---: | ---: |", flush=True)
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        rows = []
        for i, (name, at, cells) in enumerate([("a mesh that holds", points, simplices), *faulty(points, simplices, rng)]):
            files = [folder / f"{i}.{kind}.npy" for kind in "ps"]
            np.save(files[0], at)
            np.save(files[1], cells)
            rows.append((name, len(cells), [command, "check", str(files[1]), "--points", str(files[0])]))
        print_rows(rows)
        if shutil.which("tetgen"):
            print_rows(ball(count // 6, folder, command))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
