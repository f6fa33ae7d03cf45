#!/usr/bin/python3
"""Hunts one target of targets.tsv: a library that triangulates, behind an adapter that answers on its standard output.

    PYTHONPATH=build/release/python fuzz/hunt/hunt.py delaunator --builds DIR --output DIR [--time 120]
    PYTHONPATH=build/release/python fuzz/hunt/hunt.py delaunator --builds DIR --on corpus/findings/delaunator-overlap.node

It draws inputs from the families of `circumspect generate`, sends each to the adapter, judges the answer exactly, and makes
one input of each signature small. It prints one line of JSON and writes each finding into OUTPUT/TARGET/.
"""
import argparse
import itertools
import json
import os
import re
import select
import shlex
import subprocess
import sys
import time
from fractions import Fraction
from pathlib import Path

import numpy as np

import circumspect
from circumspect import _core
from circumspect.campaigns import Case, Subject, is_wanted

HERE = Path(__file__).resolve().parent
COLUMNS = ("target", "library", "version", "language", "dimensions", "numbers", "build", "command", "claim")
# What users have: families of which a coordinate is outside 2^-100 … 2^100 belong to the extreme regime alone.
EXTREME = {"huge", "tiny", "mixed-exponents", "extreme-exponents"}
# What is wrong by less than this share of the ball, or of the hull, is rounding. What is wrong by more, on points of which some
# are flat or cospherical up to this share and not exactly, or that lie far from the origin, is a fault that only exact
# predicates avoid: "near".
MARGIN = 1e-9
KINDS = ("fault", "near", "rounding")


class Refused(Exception):
    """The library says that it does not take this input."""


class Adapter:
    """A program that reads `n d` and n points, and writes `m k` and m simplices; or `refused TEXT`, or `raised TEXT`."""

    def __init__(self, command, seconds):
        self.command, self.seconds, self.process, self.rest = command, seconds, None, b""

    def start(self):
        self.process = subprocess.Popen(self.command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                                        start_new_session=True)
        self.rest = b""

    def processor_time(self):
        try:
            fields = Path(f"/proc/{self.process.pid}/stat").read_text().rsplit(")", 1)[1].split()
        except OSError:
            return 0.0
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def line(self, spent, since):
        while b"\n" not in self.rest:
            if not select.select([self.process.stdout], [], [], 1.0)[0]:
                # By processor time, so that a loaded machine makes no hang; by the clock only for what sleeps.
                if self.processor_time() - spent > self.seconds or time.monotonic() - since > 20 * self.seconds:
                    self.close()
                    raise TimeoutError(f"no answer within {self.seconds:g} s of processor time")
                continue
            more = os.read(self.process.stdout.fileno(), 1 << 20)
            if not more:
                code = self.process.wait()
                self.process = None
                raise ConnectionError(f"the process ended by {'signal' if code < 0 else 'exit code'} {abs(code)}")
            self.rest += more
        line, self.rest = self.rest.split(b"\n", 1)
        return line.decode("utf-8", "replace")

    def __call__(self, points, segments=()):
        if self.process is None:
            self.start()
        spent, since = self.processor_time(), time.monotonic()
        text = f"{len(points)} {points.shape[1]}" + (f" {len(segments)}" if len(segments) else "") + "\n"
        text += "".join(" ".join(map(repr, row)) + "\n" for row in points.tolist())
        text += "".join(f"{a} {b}\n" for a, b in segments)
        try:
            self.process.stdin.write(text.encode())
            self.process.stdin.flush()
        except BrokenPipeError:
            pass  # the next line says how it ended
        first = self.line(spent, since)
        while not first.split(" ")[0].isdigit():  # libraries print what they like
            if first.startswith("refused "):
                raise Refused(first)
            if first.startswith("raised "):
                raise RuntimeError(first)
            first = self.line(spent, since)
        count, size = map(int, first.split()[:2])
        rows = [list(map(int, self.line(spent, since).split())) for _ in range(count)]
        return np.array(rows, dtype=np.int64).reshape(count, size)

    def close(self):
        if self.process is not None:
            self.process.kill()
            self.process.wait()
            self.process = None


class Target(Subject):
    """The adapter as a subject of campaigns; how it ended is told apart from what it wrote."""

    refused = 0

    def answer(self, case):
        try:
            made = self.function(case.points)
        except Refused:
            self.refused += 1
            return "refused", None
        except RuntimeError as error:
            return "raised", str(error)
        except TimeoutError as error:
            return "hang", str(error)
        except ConnectionError as error:
            return "crash", str(error)
        except ValueError as error:
            self.function.close()
            return "no-mesh", str(error)
        try:
            from circumspect.meshes import mesh_of
            return "mesh", mesh_of(case.points, made)
        except Exception as error:
            return "no-mesh", str(error)


def determinant(rows):
    """Exactly."""
    rows, sign = [list(row) for row in rows], 1
    value = Fraction(1)
    for k in range(len(rows)):
        pivot = next((r for r in range(k, len(rows)) if rows[r][k]), None)
        if pivot is None:
            return Fraction(0)
        if pivot != k:
            rows[k], rows[pivot], sign = rows[pivot], rows[k], -sign
        value *= rows[k][k]
        for row in rows[k + 1:]:
            factor = row[k] / rows[k][k]
            for j in range(k, len(rows)):
                row[j] -= factor * rows[k][j]
    return sign * value


def least_margin(points):
    """The least |determinant| that is not 0, of the orientations and in-ball tests of the points, relative to their extent.

    Or a number below it that is more than MARGIN, or above it that is less. 0 if they are so far from the origin that their differences have few digits left.
    """
    d = points.shape[1]
    across = np.ptp(points, axis=0).max()
    if across < MARGIN * np.abs(points).max():
        return 0.0
    # Multiples of a power of two: a determinant that is not 0 is at least 1 in those units.
    for one in (1.0, 2.0 ** np.floor(np.log2(across)) / 64):
        if (points / one == np.round(points / one)).all() and (across / one) ** -(d + 2) > MARGIN:
            return float((across / one) ** -(d + 2))
    least = np.inf
    with np.errstate(all="ignore"):
        for size, lifted in ((d + 1, False), (d + 2, True)):
            if len(points) < size:
                continue
            chosen = np.array(list(itertools.combinations(range(len(points)), size)))
            edges = points[chosen[:, 1:]] - points[chosen[:, :1]]
            extent = np.abs(edges).max(axis=(1, 2), keepdims=True)
            unit = edges / extent
            if lifted:
                unit = np.concatenate([unit, (unit ** 2).sum(axis=2, keepdims=True)], axis=2)
            sizes = np.abs(np.linalg.det(unit))
            sure = sizes[sizes > 1e-12]
            least = min(least, sure.min()) if len(sure) else least
            for index in np.flatnonzero(~(sizes > 1e-12))[:500]:
                rows = [[Fraction(x) - Fraction(y) for x, y in zip(points[i].tolist(), points[chosen[index][0]].tolist())]
                        for i in chosen[index][1:]]
                scale = max(abs(x) for row in rows for x in row)
                if not scale:
                    return 0.0
                rows = [[x / scale for x in row] for row in rows]
                exact = determinant([row + [sum(x * x for x in row)] for row in rows] if lifted else rows)
                if exact:
                    return float(abs(exact))
    return float(least)


def margin_of(outcome, points):
    """By how much the facet is not locally Delaunay, or the hull not convex; None of other rules."""
    if outcome.rule == "delaunay.facet-not-local":
        return float(re.search(r"worst relative margin (\S+)", outcome.report).group(1))
    if outcome.rule == "triangulation.hull-not-convex":
        deepest = 0.0
        for face, vertex in re.findall(r"\n  face     ([\d ]+)\n  vertex   (\d+)", outcome.report):
            rows = points[[*map(int, face.split()), int(vertex)]]
            edges = rows[1:] - rows[0]
            extent = np.abs(edges).max()
            normal = np.sqrt(max(np.linalg.det((edges[:-1] / extent) @ (edges[:-1] / extent).T), 0.0))
            deepest = max(deepest, abs(np.linalg.det(edges / extent)) / max(normal, 1e-300))
        return deepest
    return None


def kind_of(outcome, points):
    """One of KINDS. Large inputs have to become small before they can be more than near misses."""
    margin = margin_of(outcome, points)
    if margin is not None and margin < MARGIN:
        return "rounding"
    return "fault" if len(points) <= 24 and least_margin(points) > MARGIN else "near"


def length(points):
    return sum(len(f"{x:.17g}") if x != int(x) or abs(x) > 1e15 else len(str(int(x))) for x in points.ravel().tolist())


def simpler(points):
    """Inputs of which each is simpler to read than the last, if it is so at all."""
    for row in points:
        yield points - row
    top = np.abs(points).max()
    if top > 0:
        exponent = int(np.floor(np.log2(top)))
        for power in (1, 2, 3, 4, 5, 6, 8, 10, 13, 17, 24):
            yield np.round(points * 2.0 ** (power - exponent))
        yield points * 2.0 ** -exponent
    yield np.abs(points)
    yield points[:, ::-1].copy()
    for index in np.ndindex(points.shape):
        x = float(points[index])
        for value in [0.0, 1.0, -1.0, float(np.round(x))] + [float(f"{x:.{k}g}") for k in range(1, 17)]:
            if value != x:
                other = points.copy()
                other[index] = value
                yield other


def tidied(points, still_fails, seconds):
    """As long as something gives."""
    end = time.monotonic() + seconds
    changed = True
    while changed and time.monotonic() < end:
        changed = False
        for k in range(len(points)):
            fewer = np.delete(points, k, axis=0)
            if still_fails(fewer, None):
                points, changed = fewer, True
                break
        if changed:
            continue
        for other in simpler(points):
            if time.monotonic() > end:
                break
            if np.isfinite(other).all() and length(other) < length(points) and still_fails(other, None):
                points, changed = other, True
                break
    return points


class Hunt:
    """Counts, and the first cases of each signature."""

    def __init__(self, target, arguments, single):
        self.target, self.arguments = target, arguments
        self.counts, self.first, self.looked = {}, {}, {}
        self.single = single

    def stored(self, points):
        """As the library stores them: one that takes floats is given floats."""
        if self.single:
            with np.errstate(over="ignore"):
                points = np.unique(points.astype(np.float32), axis=0).astype(np.float64)
        return points

    def note(self, outcome, case, family):
        self.counts[outcome.rule] = self.counts.get(outcome.rule, 0) + 1
        if len(self.first.get((outcome.rule, "fault"), ())) >= 3:
            return
        looked = self.looked[outcome.rule] = self.looked.get(outcome.rule, 0) + 1
        if looked <= self.arguments.looks:
            self.first.setdefault((outcome.rule, kind_of(outcome, case.points)), []).append((case, family))

    def minimal(self, rule, kind, case, end):

        def still_fails(points, _):
            if time.monotonic() > end:
                return False
            if len(points) <= points.shape[1] or len(np.unique(points, axis=0)) < len(points) or not is_wanted(points, False):
                return False
            if self.single and (points.astype(np.float32) != points).any():
                return False
            outcome = self.target.outcome(Case(points))
            return outcome.rule == rule and KINDS.index(kind_of(outcome, points)) <= KINDS.index(kind)

        points = case.points
        for _ in range(2):
            points, _ = _core.minimized(points, None, still_fails, 20000, self.arguments.small_time)
            points = tidied(points, still_fails, self.arguments.small_time)
            kind = kind_of(self.target.outcome(Case(points)), points)
        return points, kind


def hunt(row, arguments):
    adapter = Adapter(command_of(row, arguments), arguments.limit)
    target = Target(adapter, row["claim"], ())
    found = Hunt(target, arguments, row["numbers"] == "single")
    dimension = arguments.dimension or int(row["dimensions"].split(",")[0])
    names = [f.name for f in circumspect.families() if dimension in f.dimensions and not f.weighted and not f.repeats_points
             and not f.is_of_domains and (arguments.extreme or f.name.split("+")[0] not in EXTREME and "+scaled" not in f.name)]
    cases = skipped = large = 0
    start = time.monotonic()
    index = 0
    while time.monotonic() - start < arguments.time:
        index += 1
        most = arguments.points
        if index % 40 == 0:
            most = 300 if dimension == 2 else 120
        family, seed, points, _ = _core.drawn_case(names, dimension, False, most, arguments.seed, index)
        points = found.stored(points)
        size = np.abs(points[points != 0])
        largest = 2.0 ** (25 if found.single else 100)  # of floats and of doubles, an in-circle test has a fourth power
        if not arguments.extreme and len(size) and (size.min() < 1 / largest or size.max() > largest) or not is_wanted(points, False):
            skipped += 1
            continue
        case = Case(points)
        outcome = target.outcome(case)
        cases += 1
        large += len(points) > 24
        if outcome.rule:
            found.note(outcome, case, family)
    seconds, refused = time.monotonic() - start, target.refused
    findings = {}
    folder = Path(arguments.output) / (row["target"] + (f"-{dimension}d" if "," in row["dimensions"] else "")
                                       + ("-extreme" if arguments.extreme else ""))
    folder.mkdir(parents=True, exist_ok=True)
    for old in folder.glob("*.json"):
        old.unlink()
    last_end = time.monotonic() + 2 * arguments.time
    for (rule, kind), firsts in sorted(found.first.items(), key=lambda one: KINDS.index(one[0][1])):
        if any((rule, better) in findings for better in KINDS[:KINDS.index(kind)]):
            continue
        end = min(time.monotonic() + 8 * arguments.small_time, last_end)
        tries = [(*found.minimal(rule, kind, case, end), family) for case, family in firsts[:3 if kind == "fault" else 1]]
        points, kind, family = min(tries, key=lambda one: (KINDS.index(one[1]), len(one[0]), length(one[0])))
        repeats = 0
        for _ in range(3):
            adapter.close()  # a new process has to say the same
            outcome = target.outcome(Case(points))
            repeats += outcome.rule == rule
        findings[rule, kind] = dict(rule=rule, kind=kind, repeats=repeats, family=family, margin=least_margin(points),
                                    points=points.tolist(), report=outcome.report,
                                    simplices=None if outcome.simplices is None else np.asarray(outcome.simplices).tolist())
        (folder / f"{rule}-{kind}.json").write_text(json.dumps(findings[rule, kind], indent=1))
    adapter.close()
    failed = sum(found.counts.values())
    summary = dict(target=row["target"], library=row["library"], version=row["version"], language=row["language"],
                   dimension=dimension, regime="extreme" if arguments.extreme else "sane", cases=cases, large=large, skipped=skipped,
                   seconds=round(seconds), refused=refused, hold=cases - failed - refused, counts=found.counts,
                   found={f"{rule}/{kind}": [len(f["points"]), f["repeats"]] for (rule, kind), f in findings.items()})
    (folder / "summary.json").write_text(json.dumps(summary, indent=1))
    return summary


def answer_once(row, arguments):
    """What the library makes of one .node file, as an .ele file beside it; the exit code tells how it ended otherwise."""
    lines = [line.split() for line in Path(arguments.on).read_text().splitlines()]
    points = np.array([list(map(float, line[1:])) for line in lines[1:1 + int(lines[0][0])]])
    try:
        made = Adapter(command_of(row, arguments), arguments.limit)(points)
    except TimeoutError as error:
        print(error)
        return 124
    except ConnectionError as error:
        print(error)
        return 134
    except (RuntimeError, Refused) as error:
        print(error)
        return 1
    # A vertex that is none of the points given counts as the one after the last.
    rows = ["%d %s" % (i, " ".join(str(v if v >= 0 else len(points)) for v in simplex)) for i, simplex in enumerate(made.tolist())]
    Path(arguments.on).with_suffix(".ele").write_text("\n".join([f"{len(made)} {made.shape[1]} 0", *rows]) + "\n")
    return 0


def command_of(row, arguments):
    os.environ["BUILDS"] = str(Path(arguments.builds).resolve())
    return shlex.split(row["command"].format(builds=os.environ["BUILDS"], here=HERE))


def arguments_and_row(words):
    """The options, and the line of targets.tsv."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("target")
    parser.add_argument("--builds", required=True, help="the folder where libraries were installed or built")
    parser.add_argument("--output", default="hunt", help="the folder for what is found")
    parser.add_argument("--on", metavar="FILE.node", help="hunt for nothing: write what the library makes of this file")
    parser.add_argument("--time", type=float, default=120.0)
    parser.add_argument("--small-time", type=float, default=10.0, help="seconds for each of the two steps that make an input small")
    parser.add_argument("--dimension", type=int, default=0)
    parser.add_argument("--points", type=int, default=20)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--limit", type=float, default=5.0, help="seconds of processor time for an answer")
    parser.add_argument("--looks", type=int, default=150, help="cases of a signature that are asked for more than rounding")
    parser.add_argument("--extreme", action="store_true", help="coordinates of any exponent, and single ulps")
    arguments = parser.parse_args(words)
    lines = [line.split("\t") for line in (HERE / "targets.tsv").read_text().splitlines()[1:]]
    rows = [dict(zip(COLUMNS, line)) for line in lines if line[0] == arguments.target]
    if not rows:
        sys.exit(f"{arguments.target}: expected one of {', '.join(line[0] for line in lines)}")
    return arguments, rows[0]


def main():
    arguments, row = arguments_and_row(sys.argv[1:])
    if arguments.on:
        sys.exit(answer_once(row, arguments))
    print(json.dumps(hunt(row, arguments)))


if __name__ == "__main__":
    main()
