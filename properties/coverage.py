#!/usr/bin/env python3
"""Which lines, and which arms of conditions, the tests run: a row for each folder, and one for each file below the goals.

    properties/coverage.py BUILD_FOLDER [FILE…]      after the tests ran; `make coverage` builds, runs them, and calls this

The counts are Clang's, of what is written in the sources: both arms of each condition, wherever it is instantiated, and nothing
that the compiler adds, such as the way of an exception. BUILD_FOLDER/profiles has what each program of the tests counted. With
FILEs it prints these instead, with counts beside lines and arms.

Exit 0: `kernel` and `oracle` reach the goals. Exit 1: one does not, or nothing was counted. Exit 2: wrong usage.
"""

import collections
import json
import os
import pathlib
import subprocess
import sys

FOLDERS = ("kernel", "oracle")
GOALS = {"lines": 0.97, "branches": 0.90}


def merged(build):
    """The file of all counts."""
    profiles = sorted(build.glob("profiles/*.profraw"))
    if not profiles:
        sys.exit(f"{build}/profiles: expected *.profraw files of tests that ran, found none: `make coverage` runs them")
    out = build / "all.profdata"
    subprocess.run(["llvm-profdata", "merge", "-o", out, *profiles], check=True)
    return out


def about_programs(build):
    """Arguments that name the counts and the programs."""
    counts = merged(build)
    first, *others = (p for folder in ("bin", "tests") for p in sorted((build / folder).iterdir())
                      if p.is_file() and os.access(p, os.X_OK))
    return [f"-instr-profile={counts}", first, *(word for each in others for word in ("-object", each))]


def counted(build):
    """For each file of FOLDERS its counts: {"lines": (run, all), "branches": …}."""
    ask = ["llvm-cov", "export", "-summary-only", "-ignore-filename-regex=_test\\.[ch]pp$", *about_programs(build)]
    answer = json.loads(subprocess.run(ask, check=True, stdout=subprocess.PIPE).stdout)
    files = {}
    for each in answer["data"][0]["files"]:
        name = os.path.relpath(each["filename"])  # a compiler cache may have written it in two ways
        if name.split(os.sep)[0] in FOLDERS:
            counts = {kind: (each["summary"][kind]["covered"], each["summary"][kind]["count"]) for kind in GOALS}
            files[name] = {kind: max(counts[kind], files.get(name, counts)[kind]) for kind in GOALS}
    return files


def of_folders(files):
    """The sums of each folder, those below it included."""
    sums = collections.defaultdict(lambda: {kind: (0, 0) for kind in GOALS})
    for name, counts in files.items():
        for folder in list(pathlib.PurePath(name).parents)[:-1]:
            for kind, (run, every) in counts.items():
                before = sums[str(folder)][kind]
                sums[str(folder)][kind] = (before[0] + run, before[1] + every)
    return dict(sorted(sums.items()))


def is_below(counts):
    return any(run < GOALS[kind] * every for kind, (run, every) in counts.items())


def row(name, counts):
    cells = [cell for run, every in counts.values() for cell in (f"{every:,}", f"{100 * run / every:.1f} %" if every else "–")]
    return f"| `{name}` | " + " | ".join(cells) + " |"


def main(arguments):
    if not arguments or arguments[0].startswith("-"):
        print(__doc__.split("\n\n")[1].strip(), file=sys.stderr)
        return 2
    build = pathlib.Path(arguments[0])
    if arguments[1:]:
        return subprocess.run(["llvm-cov", "show", "-show-branches=count", *about_programs(build), *arguments[1:]]).returncode
    files = counted(build)
    folders = of_folders(files)
    head = "| lines | of them run | arms of conditions | of them taken |\n| --- | --: | --: | --: | --: |"
    print(f"| folder {head}", *(row(*each) for each in folders.items()), sep="\n")
    low = {name: counts for name, counts in files.items() if is_below(counts)}
    if low:
        print(f"\n| file below {GOALS['lines']:.0%} of lines or {GOALS['branches']:.0%} of arms {head}",
              *(row(*each) for each in sorted(low.items())), sep="\n")
    below = [name for name in FOLDERS if is_below(folders[name])]
    for name in below:
        print(f"coverage: expected {GOALS['lines']:.0%} of the lines of {name} and {GOALS['branches']:.0%} of its arms, found less",
              file=sys.stderr)
    return 1 if below else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
