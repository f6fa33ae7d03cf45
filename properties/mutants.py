#!/usr/bin/env python3
"""Mutants of predicates, checkers, readers and the fast judge: does a test notice each of them?

    mutants.py --check                    every line of mutants.tsv still applies to the sources
    mutants.py WORK_FOLDER [NAME...]      compiles them, runs the tests; exit 1 and the names of those that survive
    mutants.py WORK_FOLDER --sources      writes the sources with all mutants in them, and no more

A row of mutants.tsv has a name, a file, a piece of one of its lines in which «» encloses an expression, the
expression that takes its place, a test program, and the sources of it whose tests are to fail (the ends of their
names; `*`: all but those for soaking). Only tests of `make test` count.

All mutants are compiled at once: where the expression stood, the sources in WORK_FOLDER ask the number
`circumspect_mutant`, which the environment CIRCUMSPECT_MUTANT gives, which of the two to take. So the programs are
built once, and each mutant costs a run of its tests. A test that crashes or does not end has noticed it too.
"""
import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
TABLE = "properties/mutants.tsv"
# Every layer that has mutants links this file.
HOME = "kernel/exact/number.cpp"
DECLARATION = "extern int circumspect_mutant;\n"
DEFINITION = """
#include <cstdlib>
int circumspect_mutant = std::getenv("CIRCUMSPECT_MUTANT") == nullptr ? 0 : std::atoi(std::getenv("CIRCUMSPECT_MUTANT"));
"""
SECONDS = 120
AS_IN_THE_MAKEFILE = {"RC_PARAMS": "seed=20260101", "CIRCUMSPECT_ONE_INPUT_IN": "4"}
sys.path.insert(0, str(ROOT / "tidy"))
sys.dont_write_bytecode = True
import tidy  # noqa: E402: the list of the project's files


class Mutant:
    def __init__(self, number, row):
        self.number = number
        self.name, self.file, line, self.replacement, self.program, sources = row
        self.before, self.expression, self.after = re.fullmatch("(.*)«(.+)»(.*)", line).groups()
        self.sources = sources.split(",")

    def original(self):
        return self.before + self.expression + self.after

    def choice(self):
        return (f"{self.before}(circumspect_mutant == {self.number} ? ({self.replacement}) : ({self.expression}))"
                f"{self.after}")

    def filter(self):
        if self.sources == ["*"]:
            return ["--source-file-exclude=*_soak_*"]
        return ["--source-file=" + ",".join(f"*/{source}.cpp" for source in self.sources)]


def read_table():
    rows = [line.split("\t") for line in (ROOT / TABLE).read_text(encoding="utf-8").splitlines()
            if line and not line.startswith("#")]
    return [Mutant(number, row) for number, row in enumerate(rows, 1)]


def folders():
    """The folder whose tests a program runs, for the programs of the layers."""
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    return {f"{layer}_test": folder for layer, folder in re.findall(r"circumspect_layer\((\w+)\s+([\w/]+)", text)}


def faults(mutants):
    """What is wrong with the table, a line each."""
    folder_of = folders()
    sources = {path.stem for folder in ROOT.iterdir() if folder.is_dir() and not folder.name.startswith((".", "build"))
               for path in folder.rglob("*.cpp")}
    names = [mutant.name for mutant in mutants]
    for mutant in mutants:
        where = f"{TABLE}: {mutant.name}"
        if names.count(mutant.name) > 1:
            yield f"{where}: expected a name of its own"
        if not (ROOT / mutant.file).is_file():
            yield f"{where}: expected a file, found no {mutant.file}"
            continue
        text = (ROOT / mutant.file).read_text(encoding="utf-8")
        found = text.count(mutant.original())
        if found != 1:
            yield (f"{where}: expected its line once in {mutant.file}, found it {found} times; "
                   f"write anew what stands there now: {mutant.original()}")
        for source in mutant.sources:
            if source != "*" and source not in sources:
                yield f"{where}: expected a test, found no {source}.cpp"
            elif source != "*" and mutant.program in folder_of:
                folder = folder_of[mutant.program]
                if not (ROOT / folder / f"{source}.cpp").is_file():
                    yield f"{where}: expected a test of {mutant.program}, found no {source}.cpp in {folder}"
            if "_soak_" in source:
                yield f"{where}: expected a test of `make test`, found {source}"


def write_if_new(path, text):
    """Files that stay as they are keep their time, so that they are not compiled again."""
    if not path.is_file() or path.read_text(encoding="utf-8") != text:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")


def write_sources(work, mutants):
    for name in tidy.files(str(ROOT)):
        target = work / name
        if any(mutant.file == name for mutant in mutants) or name == HOME:
            text = (ROOT / name).read_text(encoding="utf-8")
            for mutant in mutants:
                if mutant.file == name:
                    text = text.replace(mutant.original(), mutant.choice())
            write_if_new(target, DECLARATION + text + (DEFINITION if name == HOME else ""))
        elif not target.is_file() or target.read_bytes() != (ROOT / name).read_bytes():
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(ROOT / name, target)
            shutil.copymode(ROOT / name, target)


def build(work, mutants):
    subprocess.run(["cmake", "-DCIRCUMSPECT_QUICK_BUILD=ON", "-DCIRCUMSPECT_BUILD_TESTS=ON",
                    "--preset", "release"],
                   cwd=work, check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", "--preset", "release", "--target",
                    *sorted({mutant.program for mutant in mutants})], cwd=work, check=True)


def passes(work, mutant, number):
    environment = {**AS_IN_THE_MAKEFILE, **os.environ, "CIRCUMSPECT_MUTANT": str(number)}
    try:
        run = subprocess.run([work / "build/release/tests" / mutant.program, *mutant.filter(), "--abort-after=1"],
                             cwd=work, env=environment, timeout=SECONDS, check=False, capture_output=True, text=True,
                             errors="replace")
    except subprocess.TimeoutExpired:
        return False
    if number == 0 and re.search(r"test cases: +0 ", run.stdout):
        sys.exit(f"{TABLE}: {mutant.name}: expected tests of {mutant.program}, found none in {mutant.sources}")
    return run.returncode == 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("work", nargs="?", type=pathlib.Path)
    parser.add_argument("names", nargs="*")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--sources", action="store_true")
    options = parser.parse_args()
    mutants = read_table()
    wrong = list(faults(mutants))
    print("\n".join([*wrong, f"mutants: {len(mutants)}, {len(wrong)} faults"]))
    if wrong or options.check:
        return 1 if wrong else 0
    if options.work is None:
        parser.error("expected a folder to compile them in, such as build/mutants")
    work = options.work.resolve()
    write_sources(work, mutants)
    if options.sources:
        return 0
    chosen = [mutant for mutant in mutants if not options.names or mutant.name in options.names]
    build(work, chosen)
    survivors, sound = [], set()
    for mutant in chosen:
        tests = (mutant.program, *mutant.sources)
        if tests not in sound and not passes(work, mutant, 0):
            sys.exit(f"mutants: the tests {mutant.sources} of {mutant.program} fail without a mutant")
        sound.add(tests)
        started = time.monotonic()
        survives = passes(work, mutant, mutant.number)
        print(f"{'SURVIVES' if survives else 'killed':8}  {time.monotonic() - started:5.1f} s  {mutant.name}", flush=True)
        survivors += [mutant.name] if survives else []
    print(f"mutants: {len(chosen) - len(survivors)} of {len(chosen)} killed"
          + (": " + ", ".join(survivors) + " survive" if survivors else ""))
    return 1 if survivors else 0


if __name__ == "__main__":
    sys.exit(main())
