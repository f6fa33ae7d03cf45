#!/usr/bin/env python3
"""Counts of how many of TetGen's meshes of solids that are not convex, and that hold, there is a verified certificate.

    proofs/solids.py CIRCUMSPECT CIRCUMSPECT_VERIFIED [SURFACE..] [--prisms N] [--at-most N] [--seed S]

Each SURFACE is an .obj or .off file, such as those of public collections, which are not kept here. Left out are those that are not
closed, that are convex, or that have more faces than `--at-most`. Prisms are drawn: right ones over L, U, combs and stars. TetGen
(`tetgen`, in the PATH) meshes each, prisms with and without quality; what `check` says is no Steiner triangulation does not count.
Exit code 1: a certificate is not verified beside the user's own files.
"""
import argparse
import collections
import math
import pathlib
import random
import re
import resource
import subprocess
import sys
import tempfile

MOST_SECONDS = 60  # of a processor, for a certificate


def surface(path):
    """The vertices, as the words of the file, equal ones once, and the faces."""
    points, faces = [], []
    lines = [line.split("#")[0].split() for line in path.read_text(errors="replace").splitlines()]
    lines = [line for line in lines if line]
    if path.suffix.lower() == ".off":
        words = [word for line in lines for word in line][1:]
        vertices, count = int(words[0]), int(words[1])
        points = [tuple(words[3 + 3 * i:6 + 3 * i]) for i in range(vertices)]
        at = 3 + 3 * vertices
        for _ in range(count):
            length = int(words[at])
            faces.append([int(v) for v in words[at + 1:at + 1 + length]])
            at += 1 + length
    else:
        points = [tuple(line[1:4]) for line in lines if line[0] == "v"]
        for line in lines:
            if line[0] == "f":
                corners = [int(word.split("/")[0]) for word in line[1:]]
                faces.append([v - 1 if v > 0 else len(points) + v for v in corners])
    own = {}
    number = [own.setdefault(point, len(own)) for point in points]
    faces = [[number[v] for v in face] for face in faces]
    used = sorted({v for face in faces for v in face})
    renumbered = {v: i for i, v in enumerate(used)}
    listed = list(own)
    return [listed[v] for v in used], [[renumbered[v] for v in face] for face in faces]


def is_closed(faces):
    edges = collections.Counter(edge for face in faces for edge in zip(face, face[1:] + face[:1]))
    return all(count == 1 and edges[w, v] == 1 for (v, w), count in edges.items())


def is_convex(points, faces):
    """To rounding: it tells what is tried, and nothing of what is counted."""
    places = [tuple(map(float, point)) for point in points]
    size = max(abs(x) for place in places for x in place)
    for face in faces:
        a, b, c = (places[v] for v in face[:3])
        u, v = [y - x for x, y in zip(a, b)], [y - x for x, y in zip(a, c)]
        n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
        heights = [sum(x * (y - z) for x, y, z in zip(n, place, a)) for place in places]
        if max(heights) > 1e-9 * size ** 3 and min(heights) < -1e-9 * size ** 3:
            return False
    return True


def prism(dice):
    """Over a polygon that is not convex."""
    kind, n = dice.choice(("star", "L", "U", "comb")), dice.choice((5, 6, 8, 10, 12))
    if kind == "star":
        radii = [dice.randint(30, 100) for _ in range(n)]
        base = [(round(math.cos(2 * math.pi * i / n) * r), round(math.sin(2 * math.pi * i / n) * r)) for i, r in enumerate(radii)]
    elif kind == "L":
        a, b = dice.randint(2, 8), dice.randint(2, 8)
        base = [(0, 0), (10, 0), (10, a), (b, a), (b, 10), (0, 10)]
    elif kind == "U":
        a, b = dice.randint(2, 5), dice.randint(7, 10)
        base = [(0, 0), (12, 0), (12, 9), (b, 9), (b, 3), (a, 3), (a, 9), (0, 9)]
    else:
        base = [(0, 0), (20, 0), *((20 - 2 * i, 10 if i % 2 == 0 else 3 + dice.randint(0, 3)) for i in range(11))]
    n, height = len(base), dice.randint(3, 30)
    points = [(*map(str, xy), str(z)) for z in (0, height) for xy in base]
    walls = [[i, (i + 1) % n, (i + 1) % n + n, i + n] for i in range(n)]
    return kind, points, [list(range(n))[::-1], list(range(n, 2 * n)), *walls]


def judged(programs, folder, points, faces, options):
    """What becomes of TetGen's mesh."""
    circumspect, verified = programs
    rows = [f"{len(points)} 3 0 0", *(f"{i} {' '.join(point)}" for i, point in enumerate(points)), f"{len(faces)} 0"]
    rows += [f"1 0\n{len(face)} {' '.join(map(str, face))}" for face in faces]
    domain, mesh, certificate = folder / "solid.poly", folder / "solid.1.ele", folder / "certificate"
    domain.write_text("\n".join([*rows, "0", "0", ""]))
    mesh.unlink(missing_ok=True)
    subprocess.run(["tetgen", options, domain], cwd=folder, capture_output=True, timeout=300, check=False)
    if not mesh.exists():
        return "not meshed by TetGen"
    claim = ["--domain", domain, "--claim", "steiner-triangulation"]
    made = subprocess.run([circumspect, "certify", mesh, *claim, "-o", certificate], capture_output=True, text=True,
                          preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (MOST_SECONDS, MOST_SECONDS + 1)))
    lacking = re.search("there is no certificate of this mesh: (.*)", made.stderr)
    if lacking:
        return f"no certificate: {lacking[1]}"
    if made.returncode < 0:
        return f"no certificate: {MOST_SECONDS} s of a processor did not suffice"
    if made.returncode != 0:
        rule = re.search("steiner-triangulation [^ ]* ([a-z.-]+)", made.stdout)
        return f"does not hold: {rule[1] if rule else (made.stdout + made.stderr).strip()[-120:]}"
    line = subprocess.run([verified, certificate, mesh.with_suffix(".node"), mesh, domain], capture_output=True, text=True).stdout.strip()
    return "verified" if line.startswith("verified: steiner-triangulation, ") else f"WRONG: {line}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("circumspect")
    parser.add_argument("verified")
    parser.add_argument("surfaces", nargs="*", type=pathlib.Path)
    parser.add_argument("--prisms", type=int, default=0)
    parser.add_argument("--at-most", type=int, default=3000)
    parser.add_argument("--seed", type=int, default=1)
    asked = parser.parse_args()
    dice = random.Random(asked.seed)
    programs = [str(pathlib.Path(path).resolve()) for path in (asked.circumspect, asked.verified)]
    counts = collections.Counter()
    solids = []
    for path in asked.surfaces:
        try:
            points, faces = surface(path)
        except (ValueError, IndexError):
            counts["surfaces: not read"] += 1
            continue
        if len(points) < 4 or len(faces) > asked.at_most or not is_closed(faces) or is_convex(points, faces):
            counts["surfaces: of more faces, not closed, or convex"] += 1
        else:
            solids.append((path.name, points, faces, "-pYQ"))
    for number in range(asked.prisms):
        kind, points, faces = prism(dice)
        solids.append((f"prism {number} ({kind})", points, faces, ("-pQ", "-pqQ")[number % 2]))
    with tempfile.TemporaryDirectory() as scratch:
        for name, points, faces, options in solids:
            found = judged(programs, pathlib.Path(scratch), points, faces, options)
            counts[f"{'prisms' if name.startswith('prism ') else 'surfaces'}: {found}"] += 1
            print(f"{name}, {len(faces)} faces, tetgen {options}: {found}", flush=True)
    for what, count in sorted(counts.items()):
        print(f"{count} {what}")
    verified = sum(count for what, count in counts.items() if what.endswith(": verified"))
    holding = verified + sum(count for what, count in counts.items() if "no certificate" in what or "WRONG" in what)
    print(f"{verified} of {holding} meshes that hold have a verified certificate")
    return 1 if any("WRONG" in what for what in counts) else 0


if __name__ == "__main__":
    sys.exit(main())
