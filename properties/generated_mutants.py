#!/usr/bin/env python3
"""Mutants of the deciding code that nobody thought of: is each of them noticed by `make test`?

    generated_mutants.py --check              every row of generated_mutants.tsv still applies to the sources
    generated_mutants.py WORK_FOLDER          makes them, compiles them, runs the tests; prints the table of docs/mutants.md
    generated_mutants.py WORK_FOLDER --sources   writes the sources with all mutants in them, and no more
    generated_mutants.py WORK_FOLDER --table     prints the table of the last time (--again goes on from it), and those that survive
    ... --count 700 --seed 20260101           how many of all there are, and which
    ... --only TEXT                           only the mutants whose description has this text

A mutant changes one token of one line: a comparison (`<` to `<=`, `==` to `!=` ...), `and` to `or`, a sum to a difference, a
sign, a number, or what a function returns. Clang's parser (libclang) finds the places; the ones to try are those whose
description has the lowest hash values, so that a change of one line leaves the choice of all others as it was.

All mutants are compiled at once, as in mutants.py. First each test is run without a mutant and writes down which mutants it
comes across; then each mutant is tried on these tests, the quick ones first, until one fails, crashes or does not end.
A mutant that survives and is not in generated_mutants.tsv, with the reason why it changes no answer, is a failure; so is
one that is in it and is killed.
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
import signal
import subprocess
import sys
import time

import mutants
from mutants import AS_IN_THE_MAKEFILE, ROOT

ALL_TARGETS = ["all"]
MEMORY = 8 << 30
TABLE = "properties/generated_mutants.tsv"
# What decides: predicates, checkers, engine, readers.
GROUPS = {"predicates": ["kernel/predicates/*.cpp", "kernel/exact/linear_algebra.cpp"],
          "exact checkers": ["oracle/judge/*.cpp", "oracle/judge/points/*.cpp", "oracle/judge/domain/*.[ch]pp"],
          "fast judge": ["oracle/judge/fast/*.[ch]pp", "oracle/judge/fast/predicates/*.[ch]pp"],
          "readers": ["oracle/formats/*.[ch]pp", "oracle/formats/bytes/*.[ch]pp"]}
# Writers and what only says something in words decide nothing.
NOT_MUTATED = re.compile(r".*_test\.[ch]pp|oracle/formats/bytes/unfinished_file\..*|oracle/judge/verdict_of_faults\..*")
PRELUDE = """#ifndef CIRCUMSPECT_MUTATED
#define CIRCUMSPECT_MUTATED
extern int circumspect_mutant;
extern unsigned char circumspect_reached[];
[[gnu::always_inline]] inline bool circumspect_mutated(int number) {
  circumspect_reached[number] = 1;
  return circumspect_mutant == number;
}
#endif
#line 1
"""
# A test that starts processes has several that write; each writes its lines with one call.
DEFINITION = """
#include <fcntl.h>
#include <unistd.h>
#include <cstdlib>
#include <string>
int circumspect_mutant = std::getenv("CIRCUMSPECT_MUTANT") == nullptr ? 0 : std::atoi(std::getenv("CIRCUMSPECT_MUTANT"));
unsigned char circumspect_reached[%d];
namespace {
struct ReachedMutants {
  ~ReachedMutants() {
    const char* path = std::getenv("CIRCUMSPECT_REACHED");
    if (path == nullptr) return;
    std::string text;
    for (int i = 0; i < %d; ++i) {
      if (circumspect_reached[i] != 0) text += std::to_string(i) + "\\n";
    }
    const int file = open(path, O_WRONLY | O_APPEND | O_CREAT, 0600);
    if (file < 0 || write(file, text.data(), text.size()) < 0 || close(file) < 0) _exit(99);
  }
} reached_mutants;
}  // namespace
"""
OTHER = {"<": ["<=", ">="], "<=": ["<", ">"], ">": [">=", "<="], ">=": [">", "<"], "==": ["!="], "!=": ["=="],
         "&&": ["||"], "||": ["&&"], "+": ["-"], "-": ["+"]}


class Mutant:
    """`place` and `end` enclose the expression that is asked for anew, and `text` is it when mutated; `token` (offset,
    length) is what the description encloses in «»."""

    def __init__(self, file, source, place, end, text, token, other):
        self.file, self.place, self.end, self.text = file, place, end, text
        start = source.rfind("\n", 0, token[0]) + 1
        stop = source.find("\n", token[0])
        self.line_number = source.count("\n", 0, start) + 1
        cut = token[0] + token[1]
        pieces = [piece.encode("latin-1").decode() for piece in (source[start:token[0]], source[token[0]:cut], source[cut:stop])]
        self.line = "{}«{}»{}".format(*pieces).strip()
        self.other = other
        self.kind = "number" if source[token[0]].isdigit() else source[token[0]:token[0] + token[1]]

    def key(self):
        return self.file, self.line, self.other


def outside_macros(unit, cindex, name):
    """Whether an extent has nothing to do with a macro."""
    inside = [(c.extent.start.offset, c.extent.end.offset) for c in unit.cursor.get_children()
              if c.kind == cindex.CursorKind.MACRO_INSTANTIATION and c.location.file and c.location.file.name == name]
    return lambda start, end: not any(a < end and start < b for a, b in inside)


def generated(file):
    """The mutants of a file, in the order of their places."""
    from clang import cindex
    source_bytes = (ROOT / file).read_bytes()
    # Offsets are those of bytes: the text is taken as one character a byte.
    source = source_bytes.decode("latin-1")
    K = cindex.CursorKind
    unit = cindex.Index.create().parse(
        str(ROOT / file), args=["-x", "c++", "-std=c++20", f"-I{ROOT}", f"-I{ROOT}/include", "-ferror-limit=0"],
        options=cindex.TranslationUnit.PARSE_DETAILED_PROCESSING_RECORD)
    name = str(ROOT / file)
    outside = outside_macros(unit, cindex, name)
    found = []

    def text(a, b):
        return source[a:b]

    def add(cursor, mutated, token, other):
        start, end = cursor.extent.start.offset, cursor.extent.end.offset
        # The lines that the compiler names have to stay what they are.
        if start < end and outside(start, end) and "//" not in mutated:
            found.append(Mutant(file, source, start, end, mutated.replace("\n", " "), token, other))

    def is_number(cursor):
        return cursor.type.get_canonical().kind.name in (
            "INT", "UINT", "LONG", "ULONG", "LONGLONG", "ULONGLONG", "DOUBLE", "SCHAR", "UCHAR", "SHORT", "USHORT", "CHAR_S")

    def is_bool(cursor):
        return cursor.type.get_canonical().kind.name == "BOOL"

    def constant(cursor):
        """Whether what stands here has to be known to the compiler."""
        start = cursor.extent.start.offset
        if cursor.kind in (K.STATIC_ASSERT, K.ENUM_CONSTANT_DECL, K.TEMPLATE_NON_TYPE_PARAMETER,
                           K.TEMPLATE_TYPE_PARAMETER, K.TYPE_ALIAS_DECL, K.TYPE_ALIAS_TEMPLATE_DECL,
                           K.TYPE_REF, K.TEMPLATE_REF, K.FIELD_DECL):
            return True
        if cursor.kind in (K.FUNCTION_DECL, K.CXX_METHOD, K.FUNCTION_TEMPLATE, K.VAR_DECL, K.CONSTRUCTOR):
            head = re.split(r"[({=]", text(max(0, start - 60), cursor.extent.end.offset)[min(60, start):], maxsplit=1)[0]
            return re.search(r"\bconst(expr|eval|init)\b|\bstatic const\b", head) is not None
        return False

    def binary(cursor):
        children = list(cursor.get_children())
        operands = [children[0], children[-1]]
        between = (operands[0].extent.end.offset, operands[1].extent.start.offset)
        match = re.fullmatch(r"\s*([<>=!&|+*/-]+)\s*", text(*between))
        if not match or match[1] not in OTHER:
            return
        operator, at = match[1], between[0] + match.start(1)
        if operator in ("+", "-") and not (is_number(cursor) and all(is_number(o) for o in operands)):
            return
        start, end = cursor.extent.start.offset, cursor.extent.end.offset
        for other in OTHER[operator]:
            add(cursor, text(start, at) + other + text(at + len(operator), end), (at, len(operator)), other)

    def visit(cursor, parent):
        if constant(cursor):
            return
        start, end = cursor.extent.start.offset, cursor.extent.end.offset
        children = list(cursor.get_children())
        if cursor.kind == K.IF_STMT and re.match(r"if\s+constexpr\b", text(start, end)):
            for child in children[1:]:
                visit(child, cursor)
            return
        if cursor.kind == K.CASE_STMT:
            for child in children[1:]:
                visit(child, cursor)
            return
        if cursor.kind == K.DECL_STMT and re.match(r"(static\s+)?constexpr\b", text(start, end)):
            return
        if cursor.kind == K.BINARY_OPERATOR and len(children) == 2:
            binary(cursor)
        elif cursor.kind == K.CALL_EXPR and re.match(r"operator([<>=!]=?)$", cursor.spelling) and len(children) == 3:
            binary(cursor)
        elif cursor.kind == K.UNARY_OPERATOR and len(children) == 1 and source[start] in "!-" and source[start + 1] != source[start]:
            # What `!` stands before may be of a class, and is then asked as a condition is.
            if source[start] == "!" and source[start + 1] != "=":
                add(cursor, f"!!({text(start + 1, end)})", (start, 1), "")
            elif source[start] == "-" and is_number(cursor):
                add(cursor, f"({text(start + 1, end)})", (start, 1), "")
        elif cursor.kind == K.RETURN_STMT and len(children) == 1:
            child = children[0]
            a, b = child.extent.start.offset, child.extent.end.offset
            if is_bool(child):
                add(child, f"!({text(a, b)})", (start, 6), "return !")
            elif child.type.get_canonical().kind.name == "INT" and not text(a, b).strip() == "0":
                add(child, f"-({text(a, b)})", (start, 6), "return -")
        elif cursor.kind == K.INTEGER_LITERAL and parent.kind not in (K.INIT_LIST_EXPR, K.VAR_DECL):
            number = text(start, end)
            if re.fullmatch(r"\d+", number):
                other = str(int(number) - 1) if int(number) > 1 else str(1 - int(number))
                add(cursor, other, (start, end - start), other)
        for child in children:
            visit(child, cursor)

    def top(cursor):
        for child in cursor.get_children():
            if child.location.file is None or child.location.file.name != name:
                continue
            visit(child, cursor)

    top(unit.cursor)
    unique = {}
    for mutant in sorted(found, key=lambda m: (m.place, -m.end, m.text)):
        unique.setdefault((mutant.place, mutant.end, mutant.text), mutant)
    # A line that stands twice in a file has one description: the first is the one that is tried.
    first = {}
    for mutant in unique.values():
        first.setdefault(mutant.key(), mutant)
    return list(first.values())


def group_of(file):
    return next(group for group, patterns in GROUPS.items()
                if any(pathlib.PurePath(file).match(p) and len(pathlib.PurePath(p).parts) == len(pathlib.PurePath(file).parts)
                       for p in patterns))


def files():
    return sorted({str(path.relative_to(ROOT)) for patterns in GROUPS.values() for p in patterns for path in ROOT.glob(p)
                   if not NOT_MUTATED.fullmatch(str(path.relative_to(ROOT)))})


def chosen(all_mutants, seed, count):
    def rank(mutant):
        return hashlib.sha256("\t".join([str(seed), *mutant.key()]).encode()).digest()
    return sorted(sorted(all_mutants, key=rank)[:count], key=lambda m: (m.file, m.place))


def with_mutants(source, inside, begin, end):
    """The text of [begin, end) in which each expression asks for its mutants; `inside` are those of this stretch."""
    out, at = [], begin
    while inside:
        start, stop = inside[0].place, inside[0].end
        here = [m for m in inside if (m.place, m.end) == (start, stop)]
        deeper = [m for m in inside if m.place < stop and m not in here]
        inside = [m for m in inside if m.place >= stop]
        out.append(source[at:start])
        out += [f"(circumspect_mutated({m.number}) ? ({m.text}) : " for m in here]
        out.append("(" + with_mutants(source, deeper, start, stop) + ")" + ")" * len(here))
        at = stop
    return "".join([*out, source[at:end]])


def write_sources(work, chosen_mutants):
    mutants.write_sources(work, [])
    by_file = collections.defaultdict(list)
    for mutant in chosen_mutants:
        by_file[mutant.file].append(mutant)
    for file in {*by_file, mutants.HOME}:
        source = (ROOT / file).read_bytes().decode("latin-1")
        inside = sorted(by_file[file], key=lambda m: (m.place, -m.end))
        text = PRELUDE + with_mutants(source, inside, 0, len(source)).encode("latin-1").decode()
        size = len(chosen_mutants) + 1
        mutants.write_if_new(work / file, text + (DEFINITION % (size, size) if file == mutants.HOME else ""))


def build(work, chosen_mutants, targets):
    """Compiles them, and drops those of lines that do not compile, such as arguments of templates."""
    subprocess.run(["cmake", "-DCIRCUMSPECT_QUICK_BUILD=ON", "-DCIRCUMSPECT_BUILD_TESTS=ON",
                    "-DCMAKE_COMPILE_WARNING_AS_ERROR=OFF", "--preset", "release"], cwd=work, check=True, stdout=subprocess.DEVNULL)
    while True:
        for number, mutant in enumerate(chosen_mutants, 1):
            mutant.number = number
        write_sources(work, chosen_mutants)
        run = subprocess.run(["cmake", "--build", "--preset", "release", "--target", *targets, "--", "-k", "0"],
                             cwd=work, check=False, capture_output=True, text=True, errors="replace")
        if run.returncode == 0:
            return chosen_mutants
        faulty = {(str(pathlib.PurePath(found[1]).relative_to(work)), int(found[2]))
                  for found in re.finditer(r"^(\S+?):(\d+):\d+: (?:fatal )?error", run.stdout, re.M)
                  if pathlib.PurePath(found[1]).is_relative_to(work)}
        kept = [m for m in chosen_mutants if (m.file, m.line_number) not in faulty]
        if len(kept) == len(chosen_mutants):
            sys.exit(run.stdout[-20000:] + "\ngenerated_mutants: the sources do not compile, and that is no mutant's fault")
        print(f"{len(chosen_mutants) - len(kept)} mutants do not compile", flush=True)
        chosen_mutants = kept


class Test:
    def __init__(self, work, description):
        self.name, self.command = description["name"], list(description["command"])
        values = {p["name"]: p["value"] for p in description["properties"]}
        self.labels = values.get("LABELS", [])
        self.folder = values.get("WORKING_DIRECTORY", str(work))
        self.environment = dict(pair.split("=", 1) for pair in values.get("ENVIRONMENT", []))
        if any(word.startswith("--source-file") for word in self.command):
            self.command.append("--abort-after=1")
        self.seconds, self.reached = 0.0, set()

    def passes(self, number, limit, reached=None):
        environment = {**os.environ, **AS_IN_THE_MAKEFILE, **self.environment,
                       "CIRCUMSPECT_MUTANT": str(number)}
        if reached is not None:
            environment["CIRCUMSPECT_REACHED"] = str(reached)
        with subprocess.Popen(["prlimit", f"--as={MEMORY}", *self.command], cwd=self.folder, env=environment,
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


def tests_of(work, targets, pattern):
    listed = json.loads(subprocess.run(["ctest", "--test-dir", "build/release", "--show-only=json-v1"], cwd=work, check=True,
                                       capture_output=True, text=True).stdout)["tests"]
    tests = [Test(work, description) for description in listed if "command" in description]
    return [test for test in tests if "soak" not in test.labels and re.search(pattern, test.name)
            and (targets == ALL_TARGETS or pathlib.PurePath(test.command[0]).name in targets)]


def record(work, tests):
    """Runs each test without a mutant; leaves out those that come across none."""
    for test in tests:
        reached = work / "build/reached_mutants"
        reached.unlink(missing_ok=True)
        started = time.monotonic()
        if not test.passes(0, 3600, reached):
            print(f"left out, since it fails without a mutant: {test.name}", flush=True)
            continue
        test.seconds = time.monotonic() - started
        if reached.is_file():
            test.reached = {int(line) for line in reached.read_text().splitlines()}
    return sorted((test for test in tests if test.reached), key=lambda test: test.seconds)


def killer(mutant, tests):
    """The name of the first test that notices it, or None."""
    for test in tests:
        if mutant.number in test.reached and not test.passes(mutant.number, 10 + 10 * test.seconds):
            return test.name
    return None


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


def all_of(work, names):
    """The mutants of these files. Parsing takes minutes, so they are kept in the folder, each file's by its content."""
    cache = work / "build/generated_mutants"
    cache.mkdir(parents=True, exist_ok=True)
    own = (inspect.getsource(generated) + inspect.getsource(Mutant)).encode()
    kept = {file: cache / hashlib.sha256(own + file.encode() + (ROOT / file).read_bytes()).hexdigest() for file in names}
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


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("work", nargs="?", type=pathlib.Path)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--sources", action="store_true")
    parser.add_argument("--count", type=int, default=700)
    parser.add_argument("--seed", type=int, default=20260101)
    parser.add_argument("--only", default="")
    parser.add_argument("--targets", type=lambda text: text.split(","), default=ALL_TARGETS, help="test programs, parted by commas")
    parser.add_argument("--tests", default="", help="a pattern of names of tests")
    parser.add_argument("--again", action="store_true", help="only those that survived the last time")
    parser.add_argument("--table", action="store_true")
    options = parser.parse_args()
    table = read_table()
    wrong = list(faults(table))
    print("\n".join([*wrong, f"generated mutants with a reason to survive: {len(table)}, {len(wrong)} faults"]))
    if wrong or options.check:
        return 1 if wrong else 0
    if options.work is None:
        parser.error("expected a folder to compile them in, such as build/mutants")
    work = options.work.resolve()
    results = work / "build/generated_mutants.json"
    killed = {tuple(key): name for key, name in json.loads(results.read_text())} if options.again or options.table else {}
    if options.table:
        print_table(killed, table)
        print("\n".join("\t".join(key) for key, name in killed.items() if name is None and key not in table))
        return 0
    if options.again:  # what was killed, and what did not compile, is neither looked for nor compiled again
        open_ones = {key for key, name in killed.items() if name is None and options.only in "\t".join(key)}
        tried = [m for m in all_of(work, sorted({key[0] for key in open_ones})) if m.key() in open_ones]
    else:
        tried = chosen(all_of(work, files()), options.seed, options.count)
    if options.sources:
        for number, mutant in enumerate(tried, 1):
            mutant.number = number
        write_sources(work, tried)
        return 0
    to_try = build(work, [m for m in tried if options.only in "\t".join(m.key())], options.targets)
    tests = record(work, tests_of(work, options.targets, options.tests))
    print(f"{len(to_try)} mutants, {len(tests)} tests that come across one", flush=True)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for mutant, name in zip(to_try, pool.map(lambda m: killer(m, tests), to_try)):
            killed[mutant.key()] = name
            state = f"killed by {name}" if name else "changes no answer" if mutant.key() in table else "SURVIVES"
            print("\t".join([state, f"{mutant.file}:{mutant.line_number}", mutant.line, mutant.other]), flush=True)
    results.write_text(json.dumps(list(killed.items())))
    print_table(killed, table)
    alive = [key for key, name in killed.items() if name is None and key not in table]
    for key in (wrong := [key for key, name in killed.items() if name is not None and key in table]):
        print(f"{TABLE}: expected a mutant that survives, but {killed[key]} notices it: {key[1]}")
    return 1 if alive or wrong else 0


if __name__ == "__main__":
    sys.exit(main())
