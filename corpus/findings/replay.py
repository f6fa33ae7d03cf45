#!/usr/bin/env python3
"""Runs the programs of Debian again on the inputs on which they were wrong, and judges what they write:

    replay.py CIRCUMSPECT FOLDER...     looks for programs in the folders, and then where the shell does

Of each row of expected.tsv the program has to break the same rule first, or to end in the same way. A program that is not there, or is
of another version, is passed over, and said. Exit code 0: all that ran did as before; 1: some did not; 77: none could be run.
"""
import os
import shutil
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
PACKAGES = {"tetgen": ("tetgen", "1.5.0-5"), "qdelaunay": ("qhull-bin", "2020.2-5"), "gmsh": ("gmsh", "4.8.4+ds2-3"),
            "checked_by": ("libcgal-dev", "5.5.1-2")}
# What it does depends on what lay in the memory before: hunt/pages/gmsh.md.
NOT_EVERY_TIME = {"gmsh-hxt-vertex-zero"}
HANG_SECONDS = 2  # of processor time; a clock on the wall would call a loaded machine a hang


def version_of(package):
    said = subprocess.run(["dpkg-query", "-W", "-f", "${Version}", package], capture_output=True, text=True)
    return said.stdout.strip() if said.returncode == 0 else ""


def why_not(program):
    """Why the program is passed over; empty if it is not."""
    package, expected = PACKAGES[program]
    if shutil.which(program) is None:
        return f"expected {program} of the package {package}, found none"
    found = version_of(package)
    return "" if found == expected else f"expected {package} {expected}, found {found or 'no such package'}"


def outcome(row, work, circumspect):
    """The signature of what the program does now."""
    name, claim, _, points, mesh, command = row
    for path in HERE.glob(Path(points).stem + ".*"):
        shutil.copy(path, work)
    if mesh != "-" and " -rCC " not in command:
        (work / mesh).unlink(missing_ok=True)
    limits = f"ulimit -v 4194304; ulimit -c 0; ulimit -t {HANG_SECONDS}; exec {command}"
    ended = subprocess.run(["sh", "-c", limits], cwd=work, capture_output=True, timeout=120).returncode
    if ended in (-signal.SIGXCPU, -signal.SIGKILL):
        return "hang"
    if ended < 0:
        return "crash-" + signal.Signals(-ended).name
    if ended > 0:
        return f"exit-code-{ended}"
    if mesh == "-" or not (work / mesh).exists():
        return "no-mesh"
    claim, *kind = claim.split()
    of = ["--points", points] if claim == "delaunay" else ["--domain", points, "--domain-kind", (kind or ["enclosed"])[0]]
    said = subprocess.run([circumspect, "check", mesh, "--claim", claim, *of], cwd=work, capture_output=True, text=True)
    verdict = (said.stdout.splitlines() or [""])[-1].split()  # fails: CLAIM MESH RULE ...
    return verdict[3] if verdict[:1] == ["fails:"] else f"{' '.join(verdict)}{said.stderr}"


def main():
    circumspect, *folders = sys.argv[1:]
    os.environ["PATH"] = os.pathsep.join([*folders, os.environ["PATH"]])
    ran, passed_over, changed = 0, {}, []
    for line in (HERE / "expected.tsv").read_text().splitlines():
        row = line.split("\t")
        program = next(word for word in row[5].split() if "=" not in word)
        if program not in PACKAGES or row[0] in NOT_EVERY_TIME:
            continue
        reason = passed_over.get(program) if program in passed_over else why_not(program)
        passed_over[program] = reason
        if reason:
            continue
        ran += 1
        with tempfile.TemporaryDirectory() as work:
            now = outcome(row, Path(work), circumspect)
        if now != row[2]:
            changed.append(f"{row[0]}: expected {row[2]}, found {now}: {row[5]}")
    for reason in filter(None, passed_over.values()):
        print(reason)
    print("\n".join([*changed, f"{ran} findings run again, {len(changed)} changed"]))
    return 77 if ran == 0 else int(bool(changed))


if __name__ == "__main__":
    sys.exit(main())
