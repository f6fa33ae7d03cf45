#!/usr/bin/env python3
"""Runs the command again and again, and makes one of its system calls fail each time, in the manner of SQLite's tests.

    failing_calls.py COMMAND CORPUS                   every call of every run in RUNS, for some minutes
    failing_calls.py COMMAND CORPUS --slice           some of them, a few seconds
    failing_calls.py COMMAND CORPUS --only RUN.GROUP  those whose names begin so, such as certify.write

The n-th call of a group fails, for n = 1, 2, 3, ... until there is no n-th; of allocations a sample does. Then:

  - the command ends by itself, in time, with an exit code of its own, and no signal ends it;
  - where it gives an answer, this is the one of an undisturbed run, and so is each byte that it wrote;
  - where it gives none, it says why in one line for each file, and an output has all its bytes, or its former ones, or is not there;
  - of unfinished files, scratch folders and processes nothing is left.

A small campaign is also killed (kill -9) at each of its writes, half of which is then done, and at each rename and fsync. It goes on
when it is begun again, and ends as one that nobody killed; no process is left.

It prints each breach, with the command that shows it again, and a table of how the runs ended.
"""
import argparse
import errno
import os
import pathlib
import platform
import random
import re
import shlex
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time

import hostile_programs

TIME_LIMIT = 60
FOR_EVER = 10 ** 9
# Group of calls (failing_calls.c lists them), error, and whether all from the n-th on fail, as on a
# disk that is full.
FAILURES = [
    ("open", "EMFILE", False), ("open", "EMFILE", True), ("open", "EIO", False), ("read", "EIO", False),
    ("read", "EINTR", False), ("write", "ENOSPC", False), ("write", "ENOSPC", True), ("write", "EIO", False),
    ("write", "EINTR", False), ("stat", "EIO", False), ("seek", "EIO", False), ("sync", "EIO", False),
    ("name", "ENOSPC", False), ("name", "EIO", True), ("remove", "EIO", False), ("folder", "EIO", False),
    ("close", "EIO", False), ("map", "ENOMEM", False), ("map", "ENOMEM", True), ("pipe", "EMFILE", False),
    ("process", "EAGAIN", False), ("process", "EAGAIN", True), ("memory", "ENOMEM", False),
    ("memory", "ENOMEM", True)]
SLICE = {("open", "EMFILE", False), ("write", "ENOSPC", False), ("name", "ENOSPC", False), ("close", "EIO", False),
         ("map", "ENOMEM", True), ("process", "EAGAIN", True), ("memory", "ENOMEM", False)}


class Run:
    """One way to run the command: its arguments, the files that it writes, and which failures the slice tries."""

    def __init__(self, name, arguments, outputs=(), in_slice=()):
        self.name, self.arguments, self.outputs, self.in_slice = name, arguments, outputs, in_slice


CAMPAIGN = ["campaign", "--cases", "0", "--corpus", "OUT/corpus", "--jobs", "1", "--minimize-runs", "3", "--output",
            "OUT/campaign", "--"]
WORKER = ("while read n rest; do while [ $n -gt 0 ]; do read point; n=$((n-1)); done; "
          "printf '4\\n0 1 2 4\\n0 1 3 4\\n0 2 3 4\\n1 2 3 4\\n'; done")
RUNS = [
    Run("check", ["check", "CORPUS/peers/tetgen/cube-3d.1.ele"]),
    Run("check-wrong", ["check", "CORPUS/peers/tetgen/hunted-tetgen-covered-twice-3d.1.ele", "--format", "json"],
        in_slice=SLICE),
    Run("check-html", ["check", "CORPUS/peers/tetgen/hunted-tetgen-covered-twice-3d.1.ele", "--html", "OUT/page.html"],
        ["page.html"]),
    Run("check-domain", ["check", "CORPUS/domains/tetgen/two-rooms.1.ele", "--domain", "CORPUS/domains/two-rooms.poly"]),
    Run("certify", ["certify", "CORPUS/peers/tetgen/cube-3d.1.ele", "-o", "OUT/certificate"], ["certificate"],
        in_slice=SLICE),
    Run("build", ["build", "delaunay", "CORPUS/peers/inputs/flat-faces-3d.node", "-o", "OUT/x.1.ele"],
        ["x.1.ele"]),
    Run("compare", ["compare", "CORPUS/peers/cgal/flat-faces-3d.ele", "CORPUS/peers/tetgen/flat-faces-3d.1.ele"]),
    Run("inspect", ["inspect", "CORPUS/peers/inputs/flat-faces-3d.node"]),
    Run("inspect-domain", ["inspect", "CORPUS/domains/two-rooms.poly"]),
    Run("generate", ["generate", "sphere+ulp", "--seed", "7", "--count", "2", "-o", "OUT/drawn"],
        ["drawn/sphere+ulp-7.node", "drawn/sphere+ulp-8.node"]),
    Run("campaign", CAMPAIGN + ["/bin/sh", "-c", 'cp "$2" "$1"', "{points}", "{mesh}", "OUT/five.ele"],
        in_slice={("read", "EIO", False)}),
    # It goes on with the journal of a campaign that has ended, whose lines it must not lose.
    Run("campaign-again", CAMPAIGN + ["/bin/sh", "-c", "exit 9", "sh", "{points}", "{mesh}"],
        in_slice={("read", "EIO", False)}),
    Run("campaign-worker", CAMPAIGN[:1] + ["--worker"] + CAMPAIGN[1:] + ["/bin/sh", "-c", WORKER]),
    Run("campaign-finding", CAMPAIGN + ["/bin/sh", "-c", "exit 9", "sh", "{points}", "{mesh}"],
        in_slice={("pipe", "EMFILE", False)})]
# At which calls a campaign is killed; 0 is not an error.
KILLS = [("write", None, False), ("name", None, False), ("sync", None, False)]
BEFORE = b"what was there before\n"


class Torture:
    """Runs of the command in one folder, which is empty before each."""

    def __init__(self, command, corpus, folder):
        self.command, self.corpus, self.folder = command, corpus, folder
        self.out, self.scratch, self.count = folder / "out", folder / "scratch", folder / "count"
        self.library, self.journal = folder / "failing_calls.so", b""
        source = pathlib.Path(__file__).with_suffix(".c")
        subprocess.run(["cc", "-O1", "-shared", "-fPIC", "-Wall", "-o", self.library, source], check=True)

    def arguments(self, run):
        return [self.command] + [word.replace("CORPUS/", f"{self.corpus}/").replace("OUT/", f"{self.out}/")
                                 for word in run.arguments]

    def environment(self, failure, first):
        group, error, all_from = failure
        last = FOR_EVER if all_from else first
        number = getattr(errno, error) if error else 0
        return {"FAILING_CALL": f"{group} {first} {last} {number}", "FAILING_COUNT": str(self.count),
                "LD_PRELOAD": str(self.library), "TMPDIR": str(self.scratch)}

    def prepare(self, run):
        for folder in (self.out, self.scratch):
            shutil.rmtree(folder, ignore_errors=True)
            folder.mkdir()
        self.count.write_bytes(bytes(8))
        if run.name.startswith("campaign"):
            (self.out / "corpus").mkdir()
            (self.out / "corpus" / "five.node").write_text(
                "5 3 0 0\n0 0 0 0\n1 4 0 0\n2 0 4 0\n3 0 0 4\n4 1 1 1\n", encoding="utf-8")
            if run.name == "campaign-again":
                subprocess.run(self.arguments(run), capture_output=True, check=False, timeout=TIME_LIMIT,
                               env={**os.environ, "TMPDIR": str(self.scratch)})
                self.journal = (self.out / "campaign" / "journal.tsv").read_bytes()
            (self.out / "five.ele").write_text("4 4 0\n0 0 1 2 4\n1 0 1 3 4\n2 0 2 3 4\n3 1 2 3 4\n", encoding="utf-8")

    def run(self, run, failure, first, before=False):
        """The exit code, what was printed, the outputs and the count of calls; before: outputs are there already."""
        self.prepare(run)
        for output in run.outputs if before else ():
            (self.out / output).parent.mkdir(exist_ok=True)
            (self.out / output).write_bytes(BEFORE)
        try:
            done = subprocess.run(self.arguments(run), capture_output=True, timeout=TIME_LIMIT, check=False,
                                  stdin=subprocess.DEVNULL,
                                  env={**os.environ, **self.environment(failure, first)})
        except subprocess.TimeoutExpired:
            return None, b"", b"", {}, FOR_EVER
        outputs = {name: (self.out / name).read_bytes() if (self.out / name).is_file() else None
                   for name in run.outputs}
        if run.name.startswith("campaign"):
            found = self.out / "campaign" / "findings"
            outputs["findings"] = sorted(path.name for path in found.iterdir()) if found.is_dir() else []
            if run.name == "campaign-again":
                journal = self.out / "campaign" / "journal.tsv"
                outputs["journal"] = b"" if journal.read_bytes().startswith(self.journal) else journal.read_bytes()
            # How long it took differs, and a campaign may say that it had to do without a
            # namespace.
            done.stdout = re.sub(rb"in [0-9.]+ (s|min)|note: a supervisor contained[^\n]*\n", b"", done.stdout)
            done.stderr = re.sub(rb"^campaign: .*\n", b"", done.stderr, flags=re.MULTILINE)  # progress
        return done.returncode, done.stdout, done.stderr, outputs, struct.unpack("q", self.count.read_bytes())[0]

    def left(self, failure):
        """What a run left behind that it should not."""
        paths = [path for path in self.out.rglob("*") if "unfinished" in path.name] + list(self.scratch.iterdir())
        faults = ["left processes " + " ".join(hostile_programs.processes_in(str(self.folder)))]
        faults = [] if faults[0] == "left processes " else faults
        # What cannot be removed stays, and a folder that cannot be opened cannot be emptied; to
        # open one takes memory.
        if failure[0] in ("remove", "memory") or (failure[0] == "open" and failure[2]):
            paths = [path for path in paths if failure[0] != "remove" and not path.name.startswith("circumspect-campaign-")]
        if paths:
            faults.append("left " + " ".join(str(path.relative_to(self.folder)) for path in paths))
        return faults

    def faults(self, run, failure, undisturbed, ended):
        """What is wrong with a run one of whose calls failed."""
        code, out, err, outputs, _ = ended
        if code is None:
            return ["did not end"]
        if code not in range(6):
            return [f"ended with {code}: {err[-300:].decode(errors='replace')}"]
        faults = self.left(failure)
        if code in (0, 1):
            if code != undisturbed[0]:
                faults.append(f"exit code {code} is not {undisturbed[0]}")
            # A finding that could not be run or read again is told with its larger input.
            last = -1 if run.name in ("campaign-finding", "campaign-again") else None
            if out.splitlines()[last:] != undisturbed[1].splitlines()[last:]:
                faults.append("answered, and printed something else: " + out[-300:].decode(errors="replace"))
            if outputs != undisturbed[3]:
                faults.append("answered, and wrote something else: " + repr(outputs)[:300])
            return faults
        lines = err.decode(errors="replace").splitlines()
        told = [line for line in lines if line.startswith("circumspect: ") and "internal error" not in line]
        if not lines or told != lines or len(lines) > 2:  # compare has two inputs, and an output and stdout may fail
            faults.append(f"exit code {code}, and not one line for each file that says why: {lines}")
        for name, output in outputs.items():
            if name == "journal" and output:
                faults.append("the journal lost what was in it")
            elif name == "findings" and not set(output) <= set(undisturbed[3][name]):
                faults.append(f"found {output}")
            elif name not in ("findings", "journal") and output not in (None, BEFORE, undisturbed[3][name]):
                faults.append(f"{name} has {len(output)} bytes, and is not the whole output")
        return faults


def findings(torture):
    """What a campaign found, and with which input."""
    folder = torture.out / "campaign" / "findings"
    return {path.name: (path / "minimal.node").read_bytes() for path in sorted(folder.iterdir())} if folder.is_dir() else {}


def faults_after_kill(torture, run, undisturbed, found):
    """What is wrong when the campaign that was killed is begun again."""
    for _ in range(100):  # what looks after the program ends it, once nobody looks after it
        if not hostile_programs.processes_in(str(torture.folder)):
            break
        time.sleep(0.05)
    faults = ["left processes"] if hostile_programs.processes_in(str(torture.folder)) else []
    again = subprocess.run(torture.arguments(run), capture_output=True, timeout=TIME_LIMIT, check=False,
                           stdin=subprocess.DEVNULL, env={**os.environ, "TMPDIR": str(torture.scratch)})
    if again.returncode != undisturbed[0]:
        faults.append(f"then ended with {again.returncode}: {again.stderr[-300:].decode(errors='replace')}")
    elif again.stdout.splitlines()[-1:] != undisturbed[1].splitlines()[-1:]:
        faults.append("then said something else: " + again.stdout[-300:].decode(errors="replace"))
    if findings(torture) != found:
        faults.append(f"then found {sorted(findings(torture))}, not {sorted(found)}, or with another input")
    return faults


def kill(torture, slice_only):
    """Kills campaigns: how many runs, and how many breaches."""
    runs = breaches = 0
    for run in (run for run in RUNS if run.name in ("campaign", "campaign-finding")):
        for failure in KILLS:
            undisturbed = torture.run(run, failure, FOR_EVER)
            found = findings(torture)
            calls = undisturbed[4]
            for n in sorted({*range(1, calls + 1, 5 if slice_only else 1), calls} - {0}):
                ended = torture.run(run, failure, n)
                if ended[4] < n:
                    break
                faults = ["was not killed"] if ended[0] != -signal.SIGKILL else faults_after_kill(torture, run, undisturbed, found)
                runs, breaches = runs + 1, breaches + len(faults)
                if faults:
                    print(f"{run.name}: killed at call {n} of {failure[0]} of {calls}: {'; '.join(faults)}", flush=True)
    return runs, breaches


def positions(failure, calls):
    """Which calls are to fail, when an undisturbed run has so many: all of them, and of allocations a sample."""
    if failure[0] != "memory" or calls <= 150:
        return range(1, calls + 20)  # threads may make more the next time
    sample = random.Random(20260101).sample(range(31, calls + 1), 60)
    return sorted(set(range(1, 31)) | set(sample) | set(range(calls - 19, calls + 1)))


def table(ends):
    """Lines for people: how the runs ended, for each failure."""
    lines = ["| the calls | fail with | runs | same answer | 2 usage | 3 input | 4 undecided | 5 not done | breaches |",
             "| --- | --- | --: | --: | --: | --: | --: | --: | --: |"]
    for failure in FAILURES:
        codes = ends.get(failure, [])
        if codes:
            cells = [len(codes), sum(code in (0, 1) for code in codes)] + [codes.count(code) for code in (2, 3, 4, 5, -1)]
            group, error, all_from = failure
            lines.append(f"| {group} | {error}{', all from one on' if all_from else ''} | {' | '.join(map(str, cells))} |")
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command", type=os.path.abspath)
    parser.add_argument("corpus", type=os.path.abspath)
    parser.add_argument("--slice", action="store_true")
    parser.add_argument("--only", default="")
    options = parser.parse_args()
    if sys.platform != "linux" or platform.machine() != "x86_64":
        print("skipped: failing_calls.c is for Linux on x86-64")
        return 77
    begin, breaches, ends = time.time(), 0, {}
    with tempfile.TemporaryDirectory(prefix="failing-calls-") as name:
        torture = Torture(options.command, options.corpus, pathlib.Path(name))
        for run in RUNS:
            for failure in FAILURES:
                if options.slice and failure not in run.in_slice or not f"{run.name}.{failure[0]}".startswith(options.only):
                    continue
                undisturbed = torture.run(run, failure, FOR_EVER)
                if undisturbed[0] not in (0, 1) or torture.left(failure):
                    print(f"{run.name}: an undisturbed run: {undisturbed} {torture.left(failure)}")
                    return 1
                tried = list(positions(failure, undisturbed[4]))
                if options.slice and failure[0] == "memory":
                    tried = tried[:-20:10] + tried[-20::2]  # at the end, destructors ask for some
                for n in tried:
                    ended = torture.run(run, failure, n, before=n % 2 == 0)
                    if ended[4] < n:
                        break
                    faults = torture.faults(run, failure, undisturbed, ended)
                    ends.setdefault(failure, []).append(-1 if faults else ended[0])
                    breaches += len(faults)
                    if faults:
                        group, error, all_from = failure
                        print(f"{run.name}: call {n}{' and later ones' if all_from else ''} of {group} "
                              f"of {undisturbed[4]} fails with {error}: {'; '.join(faults)}", flush=True)
                        print("  " + " ".join(f"{key}={shlex.quote(value)}" for key, value
                                              in torture.environment(failure, n).items()), flush=True)
        killed, unkept = kill(torture, options.slice) if not options.only or options.only.startswith("campaign") else (0, 0)
    breaches += unkept
    print("\n".join(table(ends)))
    print(f"{killed} campaigns killed, {unkept} breaches")
    print(f"{sum(map(len, ends.values()))} runs, {breaches} breaches, {time.time() - begin:.0f} s")
    return 1 if breaches else 0


if __name__ == "__main__":
    sys.exit(main())
