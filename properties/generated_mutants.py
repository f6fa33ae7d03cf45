#!/usr/bin/env python3
"""Mutants of the deciding code that nobody thought of: is each of them noticed by `make test`?

    generated_mutants.py --check              every row of generated_mutants.tsv still applies to the sources
    generated_mutants.py --untried            names the files that have changed since their mutants were tried
    generated_mutants.py WORK_FOLDER          makes them, compiles them, runs the tests; prints the table of docs/mutants.md,
                                              and one by operators; writes mutants_noticed.tsv, a row a file
    generated_mutants.py WORK_FOLDER --sources   writes the sources with all mutants in them, and no more
    generated_mutants.py WORK_FOLDER --table     prints the table of the last time, and those that survive
    ... --rest, or --again                    goes on from it: with those that it did not reach, or those that survived without a reason
    ... --count 3000 --seed 20260101          how many of all there are, and which
    ... --files PATTERN                       only those of files whose names match this
    ... --changed                             only those of files that have changed since, or were never tried
    ... --only TEXT                           only the mutants whose description has this text
    ... --tests PATTERN --seconds 20          which tests; a mutant survives those that together take so long

mutant_places.py says what a mutant changes in C++, python_mutant_places.py and ocaml_mutant_places.py in the Python package and the
readers of certificates. The ones to try are those whose description has the lowest hash values, so that
a change of one line leaves the choice of all others as it was.

All mutants are compiled at once, as in mutants.py. First each test is run without a mutant and writes down which mutants it
comes across; then each mutant is tried on these tests, until one fails, crashes or does not end. The tests that noticed most
mutants of its file come first, of the others the quickest.
A mutant that survives and is not in generated_mutants.tsv, with the reason why it changes no answer, is a failure; so is
one that is in it and is killed. Ctrl-C ends it with the table of those that were tried; --rest tries the others.
"""
import argparse
import collections
import concurrent.futures
import hashlib
import inspect
import json
import os
import pathlib
import pickle
import re
import shutil
import signal
import subprocess
import sys
import time

from mutant_places import NEVER, NOTHING
from mutants import AS_IN_THE_MAKEFILE, ROOT
from mutated_sources import (ALL_TARGETS, FOR_OTHER_LANGUAGES, OTHER_LANGUAGES, VERIFIED, build, number, places_of,
                             write_sources)
from python_mutant_places import NO_ARGUMENT

# Those of the command, of the corpus and of the pages take seconds for each mutant that survives.
NEAR_TESTS = "^(kernel|oracle|properties)/"
NEAR_TESTS_OF = {"the Python package": "^python/", "readers of certificates": "^(proofs/|verified_)"}
MEMORY = 8 << 30
TABLE = "properties/generated_mutants.tsv"
NOTICED = ROOT / "properties/mutants_noticed.tsv"
# What decides: predicates, definitions, checkers, engine, readers.
GROUPS = {"predicates": ["kernel/predicates/*.cpp", "kernel/exact/linear_algebra.cpp"],
          "definitions": ["oracle/judge/definition/*.cpp"],
          "exact checkers": ["oracle/judge/*.cpp", "oracle/judge/conditions/*.hpp", "oracle/judge/points/*.cpp",
                             "oracle/judge/domain/*.[ch]pp"],
          "other claims": ["oracle/judge/complex/*.cpp", "oracle/judge/convex_hull/*.cpp", "oracle/judge/surface/*.cpp",
                           "oracle/judge/voronoi/*.cpp", "oracle/judge/quality/*.[ch]pp", "oracle/judge/cause/*.cpp",
                           "oracle/judge/periodic/*.cpp"],
          "ranks": ["oracle/distributed/*.[ch]pp"],
          "beyond rounding": ["oracle/judge/within/*.[ch]pp", "oracle/domain/*.cpp"],
          "fast judge": ["oracle/judge/fast/*.[ch]pp", "oracle/judge/fast/predicates/*.[ch]pp"],
          "readers": ["oracle/formats/*.[ch]pp", "oracle/formats/bytes/*.[ch]pp"],
          "the Python package": ["python/circumspect/*.py"],
          "readers of certificates": ["proofs/ocaml/*.ml"]}
# Writers, pictures, what only says something in words, and programs for tests decide nothing.
NOT_MUTATED = re.compile(r".*_test\.[ch]pp|oracle/formats/bytes/unfinished_file\..*|oracle/judge/verdict_of_faults\..*"
                         r"|python/circumspect/drawing\.py|proofs/ocaml/(quick_test|answers)\.ml")


def group_of(file):
    return next(group for group, patterns in GROUPS.items()
                if any(pathlib.PurePath(file).match(p) and len(pathlib.PurePath(p).parts) == len(pathlib.PurePath(file).parts)
                       for p in patterns))


def files():
    return sorted({str(path.relative_to(ROOT)) for patterns in GROUPS.values() for p in patterns for path in ROOT.glob(p)
                   if not NOT_MUTATED.fullmatch(str(path.relative_to(ROOT)))})


def near_tests(file):
    """A pattern of the names of the tests that are tried on its mutants."""
    return NEAR_TESTS_OF.get(group_of(file), NEAR_TESTS)


def chosen(all_mutants, seed, count):
    """In an order that has nothing to do with where they are."""
    def rank(mutant):
        return hashlib.sha256("\t".join([str(seed), *mutant.key()]).encode()).digest()
    return sorted(all_mutants, key=rank)[:count]


class Test:
    def __init__(self, work, description):
        self.name, self.command = description["name"], list(description["command"])
        values = {p["name"]: p["value"] for p in description["properties"]}
        self.labels = values.get("LABELS", [])
        self.folder = values.get("WORKING_DIRECTORY", str(work))
        self.environment = dict(pair.split("=", 1) for pair in values.get("ENVIRONMENT", []))
        if any(word.startswith("--source-file") for word in self.command):
            self.command.append("--abort-after=1")
        if "pytest" in self.command:
            self.command.append("-x")
        self.seconds, self.reached = 0.0, {}

    def of_pytest(self, number):
        """The command, for those of a file of pytest that come across this mutant."""
        functions = self.reached.get(number, set())
        if not functions or "" in functions:
            return self.command
        return [each for word in self.command
                for each in ([f"{word}::{name}" for name in sorted(functions)] if word.endswith("_test.py") else [word])]

    def passes(self, number, limit, reached=None):
        environment = {**os.environ, **AS_IN_THE_MAKEFILE, **self.environment,
                       "CIRCUMSPECT_MUTANT": str(number)}
        if reached is not None:
            environment["CIRCUMSPECT_REACHED"] = str(reached)
        with subprocess.Popen(["prlimit", f"--as={MEMORY}", *self.of_pytest(number)], cwd=self.folder, env=environment,
                              stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                              start_new_session=True) as process:
            try:
                return process.wait(limit) == 0
            except subprocess.TimeoutExpired:
                return False
            finally:
                try:
                    os.killpg(process.pid, signal.SIGKILL)
                except ProcessLookupError:
                    pass


def tests_of(work, targets, patterns):
    """Those whose name one of the patterns fits."""
    listed = json.loads(subprocess.run(["ctest", "--test-dir", "build/release", "--show-only=json-v1"], cwd=work, check=True,
                                       capture_output=True, text=True).stdout)["tests"]
    # `make -C proofs mutants`, which `make test` runs before the others, and its first part.
    listed += [{"name": "proofs/mutants", "properties": [],
                "command": [str(work / name) for name in ("proofs/mutants/check.sh", VERIFIED, "build/proofs/quick-test")]},
               {"name": "proofs/quick-test", "properties": [], "command": [str(work / "build/proofs/quick-test")]}]
    tests = [Test(work, description) for description in listed if "command" in description]
    return [test for test in tests if not {"soak", "slow"} & set(test.labels) and any(re.search(p, test.name) for p in patterns)
            and (targets == ALL_TARGETS or any(pathlib.PurePath(word).name in targets for word in test.command))]


def record(work, tests):
    """Runs each test without a mutant; leaves out those that come across none."""
    folder = work / "build/reached_mutants"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)

    def run(test):
        reached = folder / test.name.replace("/", ":")
        started = time.monotonic()
        if not (test.passes(0, 3600, reached) or test.passes(0, 3600, reached)):  # a busy machine may be too slow for one
            print(f"left out, since it fails without a mutant: {test.name}", flush=True)
        elif reached.is_file():
            test.seconds = time.monotonic() - started
            for number, _, name in (line.partition(" ") for line in reached.read_text().splitlines()):
                test.reached.setdefault(int(number), set()).add(re.sub(r"^.*?::|\[.*| \(.*", "", name))

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        list(pool.map(run, tests))
    return sorted((test for test in tests if test.reached), key=lambda test: test.seconds)


def killer(mutant, tests, noticed, most):
    """The name of the first test that notices it, or None if none does of those that take `most` seconds together.
    `noticed`: how many mutants of a file each test has noticed so far."""
    def cost(test):
        return (test.seconds + 0.01) / (1 + 10 * noticed[mutant.file, test.name])
    left = most
    for test in sorted((test for test in tests if mutant.number in test.reached), key=cost):
        if left < test.seconds:
            continue
        left -= test.seconds
        if not test.passes(mutant.number, 10 + 5 * test.seconds):
            noticed[mutant.file, test.name] += 1
            return test.name
    return None


def digest(file):
    """Of what is not a comment."""
    text = (ROOT / file).read_text(encoding="utf-8")
    language = places_of(file)
    known = language.without_comments(text) if language in OTHER_LANGUAGES.values() else re.sub(r"\s*//[^\n]*|\s+", " ", text)
    return hashlib.sha256(known.encode()).hexdigest()[:12]


def read_noticed():
    """The rows of mutants_noticed.tsv, by their files."""
    if not NOTICED.is_file():
        return {}
    rows = [line.split("\t") for line in NOTICED.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    return {row[0]: row[1:] for row in rows}


def write_noticed(killed, table, seconds):
    """The rows of the files that were tried are new, and those of files that are gone are left out. `seconds`: of each mutant that
    was tried this time. A file of which others were tried before keeps its digest, and what they took."""
    rows = {file: row for file, row in read_noticed().items() if (ROOT / file).is_file()}
    for file in {key[0] for key in killed}:
        names = [(key, name) for key, name in killed.items() if key[0] == file]
        same = sum(name is None and key in table for key, name in names)
        most = collections.Counter(name for _, name in names if name).most_common(1)
        dead = sum(name is not None for _, name in names)
        took = sum(seconds.get(key, 0) for key, _ in names)
        before = rows.get(file) if any(key not in seconds for key, _ in names) else None
        took += int(before[5]) if before else 0
        rows[file] = [before[0] if before else digest(file), *map(str, (len(names), dead, same, len(names) - dead - same, round(took))),
                      most[0][0] if most else "-"]
    lines = ["# generated_mutants.py writes this: a file and its digest when its mutants were tried, how many, how many of them were",
             "# noticed, change no answer, survive; how many seconds the tests took; and the test that noticed most."]
    lines += ["\t".join([file, *row]) for file, row in sorted(rows.items())]
    NOTICED.write_text("\n".join(lines) + "\n", encoding="utf-8")


def changed(names):
    """Those that have changed since their mutants were tried, and those whose mutants never were."""
    known = read_noticed()
    others = [file for file in names if file in known and known[file][0] != digest(file)]
    return others, [file for file in names if file not in known]


def say_what_is_untried(names):
    others, _ = changed(names)
    if others:
        print(f"{len(others)} files that decide have changed since their mutants were tried, such as {others[0]}: "
              "make mutants-generated CHANGED=1")


def read_table():
    """Why a mutant that survives changes no answer, by its key."""
    rows = [line.split("\t") for line in (ROOT / TABLE).read_text(encoding="utf-8").splitlines()
            if line and not line.startswith("#")]
    return {tuple(row[:3]): row[3] for row in rows}


def faults(table):
    for (file, line, other), why in table.items():
        where = f"{TABLE}: {line}"
        if not (ROOT / file).is_file():
            yield f"{where}: expected a file, found no {file}"
        elif line.replace("«", "").replace("»", "") not in (ROOT / file).read_text(encoding="utf-8"):
            yield f"{where}: expected this line in {file}, found none; if it has changed, try its mutants again"
        elif not why.strip():
            yield f"{where}: expected the reason why it changes no answer"


def generated(file):
    """The mutants of a file, in the order of their places."""
    return places_of(file).generated(file)


def all_of(work, names):
    """The mutants of these files. Parsing takes minutes, so they are kept in the folder, each file's by its content."""
    cache = work / "build/generated_mutants"
    cache.mkdir(parents=True, exist_ok=True)
    def kept_as(file):
        own = inspect.getsource(places_of(file)).encode()
        return cache / hashlib.sha256(own + file.encode() + (ROOT / file).read_bytes()).hexdigest()

    kept = {file: kept_as(file) for file in names}
    missing = [file for file in kept if not kept[file].is_file()]
    # What libclang has parsed is freed when its process ends, and seldom before.
    with concurrent.futures.ProcessPoolExecutor(os.cpu_count(), max_tasks_per_child=1) as pool:
        for file, found in zip(missing, pool.map(generated, missing)):
            kept[file].write_bytes(pickle.dumps(found))
    return [mutant for file in kept for mutant in pickle.loads(kept[file].read_bytes())]


def print_table(killed, table):
    print("| the code | mutants | killed | change no answer | survive | killed of the others |")
    print("| --- | --: | --: | --: | --: | --: |")
    rows = [(group, [key for key in killed if group_of(key[0]) == group]) for group in GROUPS] + [("all", list(killed))]
    for name, of_it in rows:
        dead = sum(killed[key] is not None for key in of_it)
        same = sum(killed[key] is None and key in table for key in of_it)
        share = f"{100 * dead / (len(of_it) - same):.1f} %" if len(of_it) > same else "-"
        print(f"| {name} | {len(of_it)} | {dead} | {same} | {len(of_it) - dead - same} | {share} |")


def print_operators(killed, table):
    """What becomes of the mutants of each operator."""
    counts = collections.defaultdict(collections.Counter)
    for (file, line, other), name in killed.items():
        token = re.search("«(.*)»", line)[1]
        kind = other if other in (NOTHING, NEVER, NO_ARGUMENT, "swapped") else "number" if token[:1].isdigit() else f"{token} to {other}"
        counts[kind]["noticed" if name else "changes no answer" if (file, line, other) in table else "survives"] += 1
    for kind, of_it in sorted(counts.items()):
        print(f"{kind:24}" + ", ".join(f"{count} {what}" for what, count in sorted(of_it.items())))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("work", nargs="?", type=pathlib.Path)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--sources", action="store_true")
    parser.add_argument("--count", type=int, default=3000)
    parser.add_argument("--seed", type=int, default=20260101)
    parser.add_argument("--only", default="")
    parser.add_argument("--files", type=re.compile, default=re.compile(""))
    parser.add_argument("--changed", action="store_true")
    parser.add_argument("--targets", type=lambda text: text.split(","), default=ALL_TARGETS, help="test programs, parted by commas")
    parser.add_argument("--tests", help="a pattern of names of tests")
    parser.add_argument("--seconds", type=float, default=20)
    parser.add_argument("--untried", action="store_true")
    parser.add_argument("--again", action="store_true", help="only those that survived the last time without a reason")
    parser.add_argument("--rest", action="store_true", help="only those that were not tried the last time")
    parser.add_argument("--table", action="store_true")
    options = parser.parse_args()
    for one in (signal.SIGINT, signal.SIGTERM):  # in the background the first is ignored, by the tests that are started, too
        signal.signal(one, signal.default_int_handler)
    names = [file for file in files() if options.files.search(file)]
    if options.untried:
        return say_what_is_untried(names)
    table = read_table()
    wrong = list(faults(table))
    print("\n".join([*wrong, f"generated mutants with a reason to survive: {len(table)}, {len(wrong)} faults"]))
    if wrong or options.check:
        return 1 if wrong else 0
    if options.work is None:
        parser.error("expected a folder to compile them in, such as build/mutants")
    work = options.work.resolve()
    results = work / "build/generated_mutants.json"
    goes_on = options.again or options.rest or options.table
    killed = {tuple(key): name for key, name in json.loads(results.read_text())} if goes_on else {}
    if options.table:
        print_table(killed, table)
        print("\n".join("\t".join(key) for key, name in killed.items() if name is None and key not in table))
        return 0
    if options.again:  # what was killed, and what did not compile, is neither looked for nor compiled again
        open_ones = {key for key, name in killed.items() if name is None and key not in table and options.only in "\t".join(key)}
        tried = [m for m in all_of(work, sorted({key[0] for key in open_ones})) if m.key() in open_ones]
    else:
        tried = chosen(all_of(work, sum(changed(names), []) if options.changed else names), options.seed, options.count)
    if options.sources:
        write_sources(work, tried, number(tried))
        return 0
    if options.rest:
        tried = [m for m in tried if m.key() not in killed]
    tried = [m for m in tried if options.only in "\t".join(m.key())]
    without_cpp = all(places_of(m.file) in OTHER_LANGUAGES.values() for m in tried)
    to_try = build(work, tried, FOR_OTHER_LANGUAGES if without_cpp and options.targets == ALL_TARGETS else options.targets)
    tests = record(work, tests_of(work, options.targets, {options.tests or near_tests(m.file) for m in tried}))
    print(f"{len(to_try)} mutants, {len(tests)} tests that come across one", flush=True)
    noticed, seconds = collections.Counter(), {}

    def timed_killer(mutant):
        started = time.monotonic()
        near = [test for test in tests if re.search(options.tests or near_tests(mutant.file), test.name)]
        name = killer(mutant, near, noticed, options.seconds)
        seconds[mutant.key()] = time.monotonic() - started
        return name

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        try:
            for mutant, name in zip(to_try, pool.map(timed_killer, to_try)):
                killed[mutant.key()] = name
                state = f"killed by {name}" if name else "changes no answer" if mutant.key() in table else "SURVIVES"
                print("\t".join([state, f"{mutant.file}:{mutant.line_number}", mutant.line, mutant.other]), flush=True)
                results.write_text(json.dumps(list(killed.items())))
        except KeyboardInterrupt:  # what was tried so far is as random as the whole
            pool.shutdown(wait=False, cancel_futures=True)
            print(f"interrupted: {len(seconds)} of {len(to_try)} mutants were tried", flush=True)
    if not options.only:
        write_noticed(killed, table, seconds)
    print_table(killed, table)
    print_operators(killed, table)
    alive = [key for key, name in killed.items() if name is None and key not in table]
    for key in (wrong := [key for key, name in killed.items() if name is not None and key in table]):
        print(f"{TABLE}: expected a mutant that survives, but {killed[key]} notices it: {key[1]}")
    return 1 if alive or wrong else 0


if __name__ == "__main__":
    sys.exit(main())
