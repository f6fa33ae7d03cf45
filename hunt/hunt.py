#!/usr/bin/env python3
"""Hunts a library that triangulates: one target of targets.tsv, a worker for `circumspect campaign`.

    hunt.py delaunator --builds DIR --output DIR [--time 5m] [--regime sane|integers|extreme]
    hunt.py --all --builds DIR --output DIR --time 5m          every target that answers here
    hunt.py --install --builds DIR [TARGET ...]                installs them from npm, and builds them, first; `make soak-hunt`
    hunt.py delaunator --builds DIR --on corpus/findings/delaunator-overlap.node

It runs the campaign of the target, adds a line to the table of runs (--record), and prints each finding with its kind. Exit code 0: no
signature that runs.tsv does not have of this target; 1: there is one; 3: the target cannot be run here.
"""
import argparse
import itertools
import json
import os
import shlex
import shutil
import subprocess
import sys
from fractions import Fraction
from pathlib import Path

from by_hand import determinant, orientation

HERE = Path(__file__).resolve().parent
RUNS = HERE / "runs.tsv"
COLUMNS = ("target", "library", "version", "language", "dimensions", "numbers", "page", "from", "build", "command", "claim")
RUN_COLUMNS = ("target", "dimension", "regime", "date", "seconds", "cases", "holds", "refused", "signatures")
# What users have: no families whose names promise exponents that nobody has, and neither is
# anything scaled.
FAR = {"huge", "tiny", "mixed-exponents", "extreme-exponents"}
# All others are about domains.
POINT_CLAIMS = {"delaunay", "triangulation", "convex-hull", "voronoi"}
# These reserve much address space.
VIRTUAL_MACHINES = {"node", "java", "mono", "julia"}
# Points, some of which are flat or cospherical up to this share of their extent and not exactly, or
# that lie so far from the origin that their differences have few digits left, are "near": only
# exact predicates avoid such faults.
MARGIN = Fraction(1, 10 ** 9)


def table(path, columns):
    lines = path.read_text().splitlines()
    assert tuple(lines[0].split("\t")) == columns, f"{path}: expected the columns {columns}"
    return [dict(zip(columns, line.split("\t"))) for line in lines[1:]]


def targets():
    return table(HERE / "targets.tsv", COLUMNS)


def options_and_command(row, builds):
    """A target that is not a worker has options of the campaign before its command, with ` -- ` between."""
    os.environ["BUILDS"] = str(Path(builds).resolve())
    text = row["command"].replace("{builds}", os.environ["BUILDS"]).replace("{here}", str(HERE))
    options, found, command = text.rpartition(" -- ")
    return shlex.split(options) if found else ["--worker"], shlex.split(command)


def command_of(row, builds):
    return options_and_command(row, builds)[1]


def case_of(points):
    """The text that a worker reads (docs/workers.md)."""
    rows = [f"{len(points)} {len(points[0])} 0 0 0 0", *(" ".join(map(repr, point)) for point in points)]
    return "\n".join(rows) + "\n"


def points_of(path):
    lines = [line.split() for line in Path(path).read_text().splitlines()]
    return [[float(x) for x in line[1:1 + int(lines[0][1])]] for line in lines[1:1 + int(lines[0][0])]]


def answer_once(row, builds, path, others=None):
    """What the library makes of one .node file, as an .ele file beside it, or of the domain of a .case file; a program reads the domain itself,
    with other arguments if some are given. The exit code tells how it ended otherwise."""
    path = Path(path)
    command = command_of(row, builds)
    command = [word.replace("{domain}", path.name).replace("{points}", path.name) for word in (command if others is None else [command[0], *shlex.split(others)])]
    points = points_of(path) if path.suffix == ".node" else []
    given = case_of(points) if points else path.read_text() if path.suffix == ".case" else ""
    try:
        ended = subprocess.run(command, input=given, capture_output=True, text=True, timeout=60, cwd=path.resolve().parent)
    except subprocess.TimeoutExpired:
        print("no answer within 60 s")
        return 124
    if not points or ended.returncode != 0 or not ended.stdout or ended.stdout.startswith("error"):
        print((ended.stdout + ended.stderr).strip())
        return 128 - ended.returncode if ended.returncode < 0 else ended.returncode or int(bool(points))
    if row["claim"] == "voronoi":
        path.with_suffix(".qvoronoi").write_text(ended.stdout)
        return 0
    rows = ended.stdout.splitlines()
    numbered = [f"{i} {row}" for i, row in enumerate(rows[1:1 + int(rows[0])])]
    path.with_suffix(".ele").write_text("\n".join([f"{rows[0]} {len(numbered[0].split()) - 1 if numbered else len(points[0]) + 1} 0", *numbered]) + "\n")
    return 0


def npm_packages(rows):
    """NAME@VERSION, as targets.tsv has them."""
    return {package for row in rows if row["from"].startswith("npm:") for package in row["from"][4:].split()}


def install_by_lock(folder):
    """All packages of package.json, by the checksums of package-lock.json. No script of theirs runs: what is hunted is a library of
    strangers, and nothing but its functions is to be called."""
    lock, installed = HERE / "package-lock.json", folder / "node_modules" / ".installed-lock.json"
    if installed.exists() and installed.read_bytes() == lock.read_bytes():
        return
    for file in (HERE / "package.json", lock):
        shutil.copy(file, folder)
    if subprocess.run(["npm", "ci", "--ignore-scripts", "--silent", "--no-audit", "--no-fund"], cwd=folder).returncode:
        print("npm did not install what package-lock.json names")
    else:
        shutil.copy(lock, installed)


def install(rows, builds):
    """What npm has, and what is built from Debian's packages or from sources that lie in BUILDS/src. A failure is told, and passed over."""
    folder = Path(builds).resolve()
    for name in ("npm", "bin", "java", "cs"):
        (folder / name).mkdir(parents=True, exist_ok=True)
    if npm_packages(rows):
        install_by_lock(folder / "npm")
    for row in rows:
        sources = row["from"].startswith("github:") and not any((folder / name).exists() for name in ("src", "rust", "go"))
        if row["build"] == "-" or sources:
            continue
        built = subprocess.run(["sh", "-c", row["build"]], cwd=folder, env={**os.environ, "HERE": str(HERE)}, capture_output=True, text=True)
        if built.returncode:
            print(f"{row['target']}: was not built: {built.stderr.strip().splitlines()[-1:]}", flush=True)


def is_here(row, builds):
    """Whether the target answers one simplex with a point in it; or whether the program is there."""
    options, command = options_and_command(row, builds)
    if options != ["--worker"]:
        return shutil.which(command[0]) is not None
    d = int(row["dimensions"].split(",")[0])
    points = [[0.0] * d, [0.25 / (k + 1) for k in range(d)], *([float(i == k) for i in range(d)] for k in range(d))]
    try:
        ended = subprocess.run(command, input=case_of(points), capture_output=True, text=True, timeout=60)
    except (OSError, subprocess.TimeoutExpired):
        return False
    return ended.returncode == 0 and bool(ended.stdout)


def is_flat(points):
    """Whether points of the plane lie on a line, exactly."""
    exact = [[Fraction(x) for x in point] for point in points]
    return not any(orientation(chosen) for chosen in itertools.combinations(exact, 3))


def is_near(points):
    """Whether a determinant of an orientation or of an in-ball test is not 0, and less than MARGIN of the extent; or the points are far away."""
    exact = [[Fraction(x) for x in point] for point in points]
    columns = list(zip(*exact))
    if max(max(c) - min(c) for c in columns) < MARGIN * max(abs(x) for c in columns for x in c):
        return True
    d = len(columns)
    for size, is_lifted in ((d + 1, False), (d + 2, True)):
        for chosen in itertools.combinations(exact, size):
            rows = [[x - y for x, y in zip(p, chosen[0])] for p in chosen[1:]]
            extent = max(abs(x) for row in rows for x in row)
            if not extent:
                return True
            rows = [[x / extent for x in row] for row in rows]
            if 0 < abs(determinant([row + [sum(x * x for x in row)] for row in rows] if is_lifted else rows)) < MARGIN:
                return True
    return False


def kind_of(finding, folder):
    """rounding, flat, near or fault; large inputs are not looked at."""
    if finding["signature"].endswith("-rounding"):
        return "rounding"
    if (folder / "minimal.poly").exists():
        return "flat" if is_flat(points_of(folder / "minimal.poly")) else "fault"
    if "points" not in finding or not (folder / "minimal.node").exists():
        return "fault"
    points = points_of(folder / "minimal.node")
    return "large" if len(points) > 14 else "near" if is_near(points) else "fault"


def families(circumspect, dimension, regime, is_of_domains):
    if is_of_domains or regime == "extreme":
        return ["--families", "all"] + ([] if is_of_domains else ["--exclude", "duplicates"])
    lists = json.loads(subprocess.run([circumspect, "generate", "--list", "--format", "json"], capture_output=True, check=True).stdout)
    names = [f["name"] for f in lists["results"][0]["points"]
             if dimension in f["dimensions"] and not f["weighted"] and not f["repeats_points"] and f["name"] not in FAR]
    modifiers = [""] if regime == "integers" else ["", "+ulp", "+moved"]
    return ["--families", ",".join(name + modifier for name in names for modifier in modifiers)]


def is_new(signature, known_ones):
    """Until 22 November 2026 runs told no rounding apart, and no exit code and no signal."""
    older = {"exit-code": "raised", "crash-SIG": "crash"}.get(signature[:9], signature.replace("-rounding", ""))
    return not known_ones & {signature, older}


def known(target, dimension):
    """The signatures that runs have shown already, of any regime."""
    return {signature.rsplit(" ", 1)[0] for run in table(RUNS, RUN_COLUMNS) if run["target"] == target and int(run["dimension"]) == dimension
            for signature in run["signatures"].split(", ") if signature}


def campaign(row, dimension, arguments):
    """Its JSON, or None if there is none."""
    options, command = options_and_command(row, arguments.builds)
    is_of_domains = row["claim"] not in POINT_CLAIMS
    folder = Path(arguments.output).resolve() / f"{row['target']}-{dimension}d-{arguments.regime}"
    if not arguments.go_on:
        shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True, exist_ok=True)
    words = [arguments.circumspect, "campaign", "--go-on", *families(arguments.circumspect, dimension, arguments.regime, is_of_domains), *options, "--claim", row["claim"], "--dimension", str(dimension), "--seed", str(arguments.seed),
             "--time", arguments.time, "--minimize-time", "20s", "--jobs", str(arguments.jobs), "--output", str(folder), "--format", "json"]
    words += [] if is_of_domains else ["--full-dimension"]
    words += ["--mesh", "x.off", "--fill", "hull"] if row["claim"] == "cdt" else []
    bits = {"single": 20}.get(row["numbers"], 10 if arguments.regime == "integers" else None)
    words += ["--extreme"] if arguments.regime == "extreme" else ["--integers", str(bits)] if bits else []
    words += ["--limit-memory", "0"] if Path(command[0]).name in VIRTUAL_MACHINES else []
    ended = subprocess.run([*words, "--", *command], stdout=subprocess.PIPE, cwd=HERE.parent)
    if ended.returncode not in (0, 1):
        return None
    return json.loads(ended.stdout)["results"][0], folder


def hunt(row, dimension, arguments):
    """The line of runs.tsv, and the signatures that are new; None if the campaign ended otherwise than by its time."""
    made = campaign(row, dimension, arguments)
    if made is None:
        return None
    result, folder = made
    counts = {}
    for family in result["families"].values():
        for what, count in family.items():
            counts[what] = counts.get(what, 0) + count
    signatures = {f["signature"]: f["count"] for f in result["findings"]}
    before = known(row["target"], dimension)
    new = set()
    for finding in sorted(result["findings"], key=lambda one: -one["count"]):
        where = Path(finding["folder"])
        kind = kind_of(finding, where)
        if kind != "flat" and is_new(finding["signature"], before):
            new.add(finding["signature"])
        told = " NEW" if finding["signature"] in new else ""
        print(f"  {finding['signature']} {finding['count']} times, {finding['minimal_points']} points, {kind}{told}: {where}")
    date = subprocess.run(["date", "-u", "+%F"], capture_output=True, text=True).stdout.strip()
    run = dict(target=row["target"], dimension=dimension, regime=arguments.regime, date=date, seconds=round(result["seconds"]),
               cases=result["judged"], holds=counts.get("holds", 0), refused=counts.get("refused", 0),
               signatures=", ".join(f"{name} {count}" for name, count in sorted(signatures.items(), key=lambda one: -one[1])))
    print("\t".join(str(run[column]) for column in RUN_COLUMNS), flush=True)
    return run, new


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("target", nargs="*", help="names of targets.tsv")
    parser.add_argument("--all", action="store_true", help="all targets that answer here")
    parser.add_argument("--install", action="store_true", help="install and build them first")
    parser.add_argument("--builds", required=True, help="the folder where libraries were installed or built")
    parser.add_argument("--output", default="hunt", help="the folder for the campaigns")
    parser.add_argument("--time", default="1m", help="of each campaign, a quarter of it for making small")
    parser.add_argument("--regime", choices=["sane", "integers", "extreme"], default="sane",
                        help="what users have; integers of ten bits; or any exponent")
    parser.add_argument("--dimension", type=int, help="of all that the target takes by default")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--go-on", action="store_true", help="with the campaign that is in the folder")
    parser.add_argument("--record", action="store_true", help="add the run to runs.tsv")
    parser.add_argument("--on", help="answer this .node file alone, with an .ele file beside it; or this .case file of a domain, or the file of one that the program reads")
    parser.add_argument("--arguments", help="with --on: those of the program, in one word, instead of those in targets.tsv")
    parser.add_argument("--circumspect", default=os.environ.get("CIRCUMSPECT", str(HERE.parent / "build/release/bin/circumspect")))
    arguments = parser.parse_args()
    unknown = set(arguments.target) - {row["target"] for row in targets()}
    if unknown or not (arguments.target or arguments.all or arguments.install):
        parser.error(f"expected names of {HERE / 'targets.tsv'}, --all or --install, found {', '.join(unknown) or 'none of them'}")
    chosen = [row for row in targets() if not arguments.target or row["target"] in arguments.target]
    if arguments.install:
        install(chosen, arguments.builds)
    if arguments.on:
        return answer_once(chosen[0], arguments.builds, arguments.on, arguments.arguments)
    new, ran = 0, 0
    for row in chosen:
        if not is_here(row, arguments.builds):
            print(f"{row['target']}: passed over, it does not answer here ({row['from']})", flush=True)
            continue
        for dimension in [arguments.dimension] if arguments.dimension else map(int, row["dimensions"].split(",")):
            made = hunt(row, dimension, arguments)
            if made is None:
                continue
            ran += 1
            new += len(made[1])
            if arguments.record:
                with RUNS.open("a") as file:
                    file.write("\t".join(str(made[0][column]) for column in RUN_COLUMNS) + "\n")
    print(f"{ran} campaigns, {new} new signatures")
    return 3 if not ran else int(new > 0)


if __name__ == "__main__":
    sys.exit(main())
