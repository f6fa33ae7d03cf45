#!/usr/bin/env python3
"""A soak for as long as one likes: every property and every soak test, each on inputs that no run has seen before,
until the minutes are over. One that fails is not run again; the others go on.

    properties/soak.py BUILD_FOLDER [MINUTES]        by default 30; `make soak` builds first

What runs are the tests that ctest labels `property` or `soak`, as many at a time as there are processors. Programs
that try inputs one by one share the time: each is told its seconds (CIRCUMSPECT_SECONDS, `has_time` in
properties/arguments/run.hpp), begins with another of its test cases each time, and says how many of its inputs it
tried. These are doctest's and those with the label `timed`. The others run whole, or not at all: the totals know how
long they took the last time, and those run, the shortest first, that together take no more than half of the time. What is left of
the time begins another round of the first kind.

When the time is up, the tests that are running are stopped and count as cut off, neither passed nor failed. So does one that
has taken three times its share before, or the time that is known of it: the others have their turn. A property may
insist that some kind of input occurs (`occurs` in run.hpp). That is a fact about the fixed inputs of `make test`;
CIRCUMSPECT_SOAK in the environment takes the question back.

A table at the end says what each test did; properties/soak.tsv has the totals of all soaks.

Exit 0: the time is up and nothing failed. Exit 1: something failed; its output, its seed and the command that repeats it are
printed. Exit 2: wrong usage, nothing to run. Exit 130: interrupted.

`ctest --preset soak` runs each soak test once instead, at its full length.
"""

import dataclasses
import json
import os
import pathlib
import re
import shlex
import signal
import subprocess
import sys
import tempfile
import time

TOTALS = pathlib.Path(__file__).with_name("soak.tsv")
HEADER = "# What all soaks did: test, runs, inputs, faults, seconds that it takes whole"
# Of the time that is left, what the programs of a round are told to take: they end a little late.
SHARE = 0.9
# How often it says what it has done so far: so many times, and at most once a minute.
PROGRESS_LINES = 20
# After so many times its share, and no fewer seconds, a program is cut off.
PATIENCE = 3
LEAST_PATIENCE = 2.0


@dataclasses.dataclass
class Test:
    name: str
    command: list
    environment: dict
    folder: str
    limit: float  # seconds after which it hangs
    skipped: int | None  # the exit code that says so
    processors: int
    divisible: bool
    runs: int = 0
    seconds: float = 0.0
    tried: int = 0
    asked: int = 0
    said: str = ""


@dataclasses.dataclass
class Run:
    test: Test
    process: subprocess.Popen
    seed: int
    begun: float
    cut_at: float  # when it has had far more than its share
    log: pathlib.Path


def is_doctest(command):
    return pathlib.Path(command[0]).parent.name == "tests"


def tests_of(build):
    """The properties and soak tests of a build folder, as ctest lists them."""
    listed = subprocess.run(["ctest", "--test-dir", build, "--show-only=json-v1", "-L", "^(property|soak)$"],
                            capture_output=True, text=True, check=True).stdout
    tests = []
    for one in json.loads(listed)["tests"]:
        facts = {fact["name"]: fact["value"] for fact in one.get("properties", [])}
        if "command" not in one or facts.get("DISABLED"):
            continue
        # The limits of ctest are for a quarter of the inputs; here all are tried.
        tests.append(Test(name=one["name"], command=one["command"],
                          environment=dict(line.split("=", 1) for line in facts.get("ENVIRONMENT", [])),
                          folder=facts.get("WORKING_DIRECTORY", build), limit=4 * facts.get("TIMEOUT", 1500),
                          skipped=facts.get("SKIP_RETURN_CODE"), processors=facts.get("PROCESSORS", 1),
                          divisible="timed" in facts["LABELS"] or is_doctest(one["command"])))
    return tests


def read_totals(path):
    """The rows of the totals by test: runs, inputs, faults, seconds."""
    if not path.exists():
        return {}
    rows = (line.split("\t") for line in path.read_text().splitlines() if line and not line.startswith("#"))
    return {name: [int(number) for number in numbers] for name, *numbers in rows}


def write_totals(path, totals):
    lines = [HEADER] + ["\t".join([name, *map(str, totals[name])]) for name in sorted(totals)]
    beside = path.with_suffix(".new")
    beside.write_text("\n".join(lines) + "\n")
    beside.replace(path)


class Soak:
    def __init__(self, build, seconds, totals, processors):
        self.build = build
        self.processors = processors
        self.totals = totals
        self.begun = time.monotonic()
        self.ends = self.begun + seconds
        self.interval = min(60, seconds / PROGRESS_LINES)
        self.ended = 0
        self.tests = tests_of(build)
        self.running = []
        self.failed = False
        whole = [t for t in self.tests if not t.divisible]
        room = seconds * processors / 2
        self.trial = min(60, room / max(1, len(whole)))
        whole.sort(key=self.seconds_of)
        self.waiting = []
        for test in whole:
            room -= self.seconds_of(test)
            if room > -0.001:
                self.waiting.append(test)
            else:
                needed = 1 + int(2 * sum(map(self.seconds_of, self.waiting + [test])) / processors / 60)
                test.said = f"left out: it takes {self.seconds_of(test):.0f} s, for which MINUTES={needed} has room"
        # Those first that need several processors: they would wait for one that is late.
        self.divisible = sorted((t for t in self.tests if t.divisible), key=lambda t: -t.processors)
        self.waiting = self.divisible + self.waiting

    def seconds_of(self, test):
        """Seconds that it took when it last ran whole. A new one is tried."""
        return self.totals.get(test.name, [0, 0, 0, 0])[3] or self.trial

    def left(self):
        return self.ends - time.monotonic()

    def share_of(self, test):
        """Seconds for this test, when those that wait with it have theirs and the others run whole."""
        whole = sum(self.seconds_of(t) * t.processors for t in self.waiting if not t.divisible)
        sharing = sum(t.processors for t in self.waiting + [test] if t.divisible)
        return (self.left() * self.processors - whole) / max(sharing, self.processors)

    def start(self, test, folder):
        seed = int.from_bytes(os.urandom(8), "little")
        environment = {**os.environ, "TMPDIR": folder, **test.environment, "CIRCUMSPECT_SOAK": "1",
                       "RC_PARAMS": f"seed={seed}"}
        command = list(test.command)
        begun, share = time.monotonic(), self.share_of(test)
        if test.divisible:
            environment["CIRCUMSPECT_SECONDS"] = str(max(1, int(SHARE * share)))
        if is_doctest(command):
            command += ["--order-by=rand", f"--rand-seed={seed % 2**31}"]
        log = pathlib.Path(folder) / f"{seed} {test.name.replace('/', ':')}"
        with log.open("wb") as output:
            process = subprocess.Popen(["nice", *command], cwd=test.folder, env=environment, stdin=subprocess.DEVNULL,
                                       stdout=output, stderr=subprocess.STDOUT, start_new_session=True)
        patience = max(LEAST_PATIENCE, PATIENCE * (share if test.divisible else self.seconds_of(test)))
        self.running.append(Run(test, process, seed, begun, begun + patience, log))

    def has_room_for(self, test):
        busy = sum(run.test.processors for run in self.running)
        return busy == 0 or busy + test.processors <= self.processors

    def end(self, run, is_cut=False):
        """One test has ended, by itself or as the time is up. Adds it up; prints it if it failed."""
        test, code = run.test, run.process.returncode
        seconds = time.monotonic() - run.begun
        output = run.log.read_text(errors="replace")
        inputs = [(int(a), int(b)) for a, b in re.findall(r"^inputs: (\d+) of (\d+)$", output, re.MULTILINE)]
        test.runs += 1
        self.ended += 1
        test.seconds += seconds
        test.tried += sum(tried for tried, _ in inputs)
        test.asked += sum(asked for _, asked in inputs)
        why = ""
        if is_cut:
            test.said = test.said or "cut off"
        elif code == test.skipped:
            test.said = "skipped"
        elif seconds > test.limit:
            why = "ran out of time"
        elif code != 0:
            why = f"exit code {code}"
        elif re.search(r"test cases: +0 ", output):
            why = "ran no test case"
        row = self.totals.setdefault(test.name, [0, 0, 0, 0])
        row[0] += 1
        row[1] += sum(tried for tried, _ in inputs)
        row[2] += bool(why)
        if not test.divisible and is_cut:
            row[3] = max(row[3], round(2 * seconds))
        elif not test.divisible and not why and code != test.skipped:
            row[3] = round(seconds)
        if why:
            self.failed = True
            test.said = "FAILED"
            self.divisible = [other for other in self.divisible if other is not test]
            self.waiting = [other for other in self.waiting if other is not test]
            print(output)
            print(f"\nsoak: FAILED: {test.name}, {why}, seed {run.seed}")
            print(f"soak: again: CIRCUMSPECT_SOAK=1 RC_PARAMS=seed={run.seed} ctest --test-dir {shlex.quote(self.build)} "
                  f"-R '^{test.name}$' --output-on-failure", flush=True)
        run.log.unlink()

    def stop(self, run):
        """Ends one that is running, with all that it has started."""
        was_over = run.process.poll() is not None
        if not was_over:
            os.killpg(run.process.pid, signal.SIGTERM)
            try:
                run.process.wait(10)
            except subprocess.TimeoutExpired:
                os.killpg(run.process.pid, signal.SIGKILL)
                run.process.wait()
        self.running.remove(run)
        self.end(run, is_cut=not was_over)

    def say_how_far(self):
        done, whole = time.monotonic() - self.begun, self.ends - self.begun
        running = ", ".join(run.test.name for run in self.running)
        print(f"soak: {done / 60:.1f} of {whole / 60:g} minutes, {self.ended} runs; now {running}", flush=True)

    def go(self, folder):
        says_at = self.begun + self.interval
        while self.left() > 0:
            if time.monotonic() >= says_at:
                self.say_how_far()
                says_at += self.interval
            if not self.waiting:
                self.waiting = list(self.divisible)
            while self.waiting and self.has_room_for(self.waiting[0]):
                self.start(self.waiting.pop(0), folder)
            time.sleep(0.02)
            for run in list(self.running):
                if run.process.poll() is None and time.monotonic() - run.begun > run.test.limit:
                    os.killpg(run.process.pid, signal.SIGKILL)
                    run.process.wait()
                if run.process.poll() is not None:
                    self.running.remove(run)
                    self.end(run)
                elif time.monotonic() > run.cut_at:
                    self.stop(run)
            if not self.waiting and not self.running and not self.divisible:
                return

    def table(self):
        width = max(len(test.name) for test in self.tests)
        for test in self.tests:
            told = [f"{test.runs} run{'' if test.runs == 1 else 's'}", f"{test.seconds:.0f} s"] if test.runs else []
            if test.asked:
                told.append(f"{test.tried} of {test.asked} inputs")
            told.append(test.said if test.said or test.runs else "not reached")
            yield f"  {test.name:{width}}  " + ", ".join(part for part in told if part)


def main(arguments):
    usage = "usage: properties/soak.py BUILD_FOLDER [MINUTES]"
    if len(arguments) not in (1, 2):
        print(f"{usage}, found {len(arguments)} arguments", file=sys.stderr)
        return 2
    build, minutes = arguments[0], arguments[1] if len(arguments) == 2 else "30"
    if not re.fullmatch(r"[0-9]+(\.[0-9]+)?", minutes) or float(minutes) == 0:
        print(f"{usage}, expected minutes, found '{minutes}'", file=sys.stderr)
        return 2
    path = pathlib.Path(os.environ.get("SOAK_TOTALS", TOTALS))
    is_build = pathlib.Path(build, "CTestTestfile.cmake").is_file()
    soak = Soak(build, 60 * float(minutes), read_totals(path), os.cpu_count()) if is_build else None
    if soak is None or not soak.tests:
        print(f"{usage}, and '{build}' holds no property and no soak test", file=sys.stderr)
        return 2
    begun = time.monotonic()
    print(f"soak: {len(soak.tests)} tests, {soak.processors} at a time, for {minutes} minutes", flush=True)
    interrupted = False
    with tempfile.TemporaryDirectory() as folder:
        try:
            signal.signal(signal.SIGTERM, signal.default_int_handler)
            soak.go(folder)
        except KeyboardInterrupt:
            interrupted = True
        for run in list(soak.running):
            soak.stop(run)
    write_totals(path, soak.totals)
    print("\n".join(soak.table()))
    ended = sum(1 for test in soak.tests if test.runs and not test.said)
    print(f"soak: {ended} of {len(soak.tests)} tests ended in their time, {sum(t.tried for t in soak.tests)} inputs, "
          f"{(time.monotonic() - begun) / 60:.1f} minutes")
    if interrupted:
        print("soak: interrupted", file=sys.stderr)
        return 130
    print("soak: something failed" if soak.failed else "soak: nothing failed")
    return 1 if soak.failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
