#!/usr/bin/env python3
"""What the tables of the hunt say together.

    summary.py                  the numbers that hunt/pages/README.md has at its top
    summary.py --check          compares them with it, and the tables with each other: exit code 1 if they differ (a test runs this)
    summary.py --update         writes them there, and into each page the runs of its targets from runs.tsv
    summary.py --issue NAME     a report for the authors of the library, from the entry of the finding and its files
"""
import json
import re
import sys
from collections import Counter
from pathlib import Path
from statistics import median

from hunt import HERE, POINT_CLAIMS, RUNS, RUN_COLUMNS, npm_packages, table, targets

ROOT = HERE.parent
PAGES = ROOT / "hunt" / "pages"
EXPECTED = ROOT / "corpus" / "findings" / "expected.tsv"
ENTRY = re.compile(r"\| \[([\w-]+)\]\(([\w.-]+)\.md#([\w-]+)\) \| (.*?) \| `(.*?)` \| (\d+) \| (.*?) \|")
RUNS_HEAD = ["| run | date | cases | holds | fails by | time |", "| --- | --- | --- | --- | --- | --- |"]
# What these do depends on more than their input; their entries say so.
NOT_EVERY_TIME = {"miconvexhull-not-delaunay-2d", "gts-dies", "gts-exception", "gts-flat", "gts-hang", "gts-not-delaunay", "gts-overlap"}
GOALS = (("libraries with a page", 25), ("languages", 8), ("distinct faults", 40), ("of these in the newest version", 15),
         ("points of a minimal input, median, at most", 6))


def entries():
    """The rows of the table at the end of hunt/pages/README.md: name, page, library, signature, points, kind."""
    found = []
    for line in (PAGES / "README.md").read_text().splitlines():
        if row := ENTRY.match(line):
            name, page, _, library, signature, points, kind = row.groups()
            found.append(dict(name=name, page=page, library=library, signature=signature, points=int(points), kind=kind))
    return found


def is_fault(entry):
    """Also if it is gone in a newer version, which its kind says then."""
    return entry["kind"].startswith("fault")


def expected():
    lines = [line.split("\t") for line in EXPECTED.read_text().splitlines()]
    return {line[0]: dict(zip(("name", "claim", "signature", "input", "mesh", "command"), line)) for line in lines}


def target_of(row):
    """The target that shows a finding of expected.tsv, or an empty string if it is a program of Debian."""
    words = row["command"].split()
    return words[1] if words[0] == "hunt.py" else ""


def numbers():
    """A library counts once, with and without segments, and so does a fault of one signature on one library. Limitations are not faults."""
    of = {row["target"]: {**row, "library": row["library"].split(", ")[0]} for row in targets()}
    hunted = {run["target"] for run in table(RUNS, RUN_COLUMNS)}
    with_page = {row["library"] for row in of.values() if row["target"] in hunted and (PAGES / f"{row['page']}.md").exists()}
    languages = {language for row in of.values() if row["library"] in with_page for language in row["language"].split(", ")}
    rows = expected()
    faults = [entry | of[target_of(rows[entry["name"]])] for entry in entries() if is_fault(entry)]
    distinct = {(fault["library"], fault["signature"]) for fault in faults}
    newest = {(fault["library"], fault["signature"]) for fault in faults
              if fault["kind"] == "fault" and not fault["from"].startswith("debian:")}
    return dict(zip((name for name, _ in GOALS),
                    (len(with_page), len(languages), len(distinct), len(newest), int(median(fault["points"] for fault in faults)))))


def lines_of_numbers():
    made = numbers()
    return ["| what | number | goal |", "| --- | --- | --- |",
            *(f"| {name} | {made[name]} | {goal} |" for name, goal in GOALS)]


def row_of_run(run, claim):
    where = "plane" if run["dimension"] == "2" else "space"
    where = where if claim in POINT_CLAIMS else f"claim `{claim}`" + (" of the hull" if claim == "cdt" else "")
    regime = {"sane": "", "integers": ", integers", "extreme": ", any exponent"}[run["regime"]]
    counts = [one.rsplit(" ", 1) for one in run["signatures"].split(", ") if one]
    what = ", ".join(f"`{name}` {count}" for name, count in counts) or "nothing"
    refused = f"; {int(run['refused']):,} refused" if run["refused"] != "0" else ""
    return f"| {run['target']}, {where}{regime} | {run['date']} | {int(run['cases']):,} | {int(run['holds']):,} | {what}{refused} | {run['seconds']} s |"


def with_runs(text, page):
    """The page, with the runs of its targets where its first table of runs stands."""
    claims = {row["target"]: row["claim"] for row in targets() if row["page"] == page}
    rows = [row_of_run(run, claims[run["target"]]) for run in table(RUNS, RUN_COLUMNS) if run["target"] in claims]
    lines = text.split("\n")
    start = next((i for i, line in enumerate(lines) if line.startswith("| run |")), None)
    if start is None or not rows:
        return text
    end = start
    while lines[end].startswith("|"):
        end += 1
    return "\n".join([*lines[:start], *RUNS_HEAD, *rows, *lines[end:]])


def overview(text):
    """The README of the findings: the numbers, and in the table of libraries the cases, minutes and entries of each page."""
    lines = text.split("\n")
    start = lines.index("| what | number | goal |")
    lines[start:start + 2 + len(GOALS)] = lines_of_numbers()
    cases, seconds = Counter(), Counter()
    of = {row["target"]: row["page"] for row in targets()}
    for run in table(RUNS, RUN_COLUMNS):
        cases[of[run["target"]]] += int(run["cases"])
        seconds[of[run["target"]]] += int(run["seconds"])
    for i, line in enumerate(lines):
        if row := re.match(r"(\| \[.*?\]\(([\w.-]+)\.md\) \| .*? \| .*? \| )[\d,]+ \| [\d.]+ \| (.*) \|$", line):
            here = [is_fault(entry) for entry in entries() if entry["page"] == row[2]]
            faults = sum(here)
            last = f"{faults} / {len(here) - faults}" if here else row[3]
            lines[i] = f"{row[1]}{cases[row[2]]:,} | {seconds[row[2]] / 60:.1f} | {last} |"
    return "\n".join(lines)


def wanted():
    """Each page, and what it should be."""
    made = {PAGES / "README.md": overview((PAGES / "README.md").read_text())}
    for page in {row["page"] for row in targets()}:
        path = PAGES / f"{page}.md"
        if path.exists():
            made[path] = with_runs(path.read_text(), page)
    return made


def faults_of_tables():
    """What the tables say otherwise than each other."""
    rows, known = expected(), {row["target"] for row in targets()}
    listed = {entry["name"]: entry for entry in entries()}
    for name, row in rows.items():
        target = target_of(row)
        if target and target not in known:
            yield f"{name}: expected a target of targets.tsv, found {target}"
        if target and name not in listed:
            yield f"{name}: expected an entry in hunt/pages/README.md, found none"
    for name, entry in listed.items():
        if name not in rows:
            yield f"{name}: expected a line in expected.tsv, found none"
        elif rows[name]["signature"] != entry["signature"]:
            yield f"{name}: expected the signature {rows[name]['signature']}, found {entry['signature']} in hunt/pages/README.md"
        if f"## {name}\n" not in (PAGES / f"{entry['page']}.md").read_text():
            yield f"{name}: expected an entry in hunt/pages/{entry['page']}.md, found none"
    lines = [line.split("\t") for line in (HERE / "everywhere.tsv").read_text().splitlines()]
    cells = {line[0]: dict(zip(lines[0], line)) for line in lines}
    for name, row in rows.items():
        cell = cells.get(row["input"], {}).get(target_of(row), row["signature"])
        if not cell.startswith(row["signature"]) and name not in NOT_EVERY_TIME:
            yield f"everywhere.tsv: {name}: expected {row['signature']}, found {cell}"
    for run in table(RUNS, RUN_COLUMNS):
        if run["target"] not in known:
            yield f"runs.tsv: expected a target of targets.tsv, found {run['target']}"
    locked = json.loads((HERE / "package-lock.json").read_text())["packages"]
    named = json.loads((HERE / "package.json").read_text())["dependencies"]
    if {f"{name}@{version}" for name, version in named.items()} != npm_packages(targets()):
        yield "package.json: expected the packages of npm that targets.tsv names, in these versions, found others"
    for name, version in named.items():
        if locked.get(f"node_modules/{name}", {}).get("version") != version:
            yield f"package-lock.json: expected {name} {version}; run npm install --package-lock-only --ignore-scripts in hunt"
    yield from (f"package-lock.json: expected a checksum of {name}" for name, one in locked.items() if name and "integrity" not in one)
    made = numbers()
    for name, goal in GOALS:
        if made[name] > goal if "at most" in name else made[name] < goal:
            yield f"{name}: expected {goal}, found {made[name]}"


def issue(name):
    """The text of a report; the entry has the call in the library's own language, the witness, and what is promised."""
    row = expected()[name]
    target = next(one for one in targets() if one["target"] == target_of(row))
    page = (PAGES / f"{target['page']}.md").read_text()
    entry = page.split(f"## {name}\n", 1)[1].split("\n## ", 1)[0].strip()
    about = page.split("\n", 1)[1].split("| run |", 1)[0].strip()
    points = (EXPECTED.parent / row["input"]).read_text().strip()
    return "\n\n".join([f"# {target['library']} {target['version']}: `{row['signature']}`", entry,
                        "## What is promised", about, "## Input (the first line counts points and coordinates)", f"```\n{points}\n```",
                        "## How it was found", f"By `circumspect campaign`, which judges in exact arithmetic; the library is from {target['from']}. "
                        f"`corpus/findings/reproduce.sh {name}` shows it again."])


def main():
    words = sys.argv[1:]
    if words[:1] == ["--issue"] and len(words) == 2 and target_of(expected().get(words[1], {"command": "-"})):
        print(issue(words[1]))
        return 0
    if words not in ([], ["--check"], ["--update"]):
        print(__doc__, file=sys.stderr)
        return 2
    if words == ["--update"]:
        for path, text in wanted().items():
            path.write_text(text)
    wrong = list(faults_of_tables())
    if words == ["--check"]:
        wrong += [f"{path.relative_to(ROOT)}: expected what hunt/summary.py --update writes, found another text"
                  for path, text in wanted().items() if path.read_text() != text]
    print("\n".join([*lines_of_numbers(), *wrong]))
    return int(bool(wrong))


if __name__ == "__main__":
    sys.exit(main())
