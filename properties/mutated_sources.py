"""All mutants in one program: the sources that ask which of them is the active one, and their compilation."""
import collections
import pathlib
import re
import subprocess
import sys

import mutant_places
import mutants
import ocaml_mutant_places
import python_mutant_places
from mutant_places import NEVER, NOTHING
from mutants import ROOT

ALL_TARGETS = ["all"]
# What the tests of the other languages start.
FOR_OTHER_LANGUAGES = ["circumspect_cli", "circumspect_python"]
VERIFIED = "build/proofs/circumspect-verified"
OTHER_LANGUAGES = {".py": python_mutant_places, ".ml": ocaml_mutant_places}
# How far from each other the lines of a statement may be.
LINES_OF_STATEMENT = 3
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


def places_of(file):
    """The module that knows the language of a file."""
    return OTHER_LANGUAGES.get(pathlib.PurePath(file).suffix, mutant_places)


def with_mutants(source, inside, begin, end):
    """The text of [begin, end) in which each expression asks for its mutants; `inside` are those of this stretch."""
    out, at = [], begin
    while inside:
        start, stop = inside[0].place, inside[0].end
        # What is left out as a whole has no value: it asks last, outside of the others.
        here = sorted((m for m in inside if (m.place, m.end) == (start, stop)), key=lambda m: m.other in (NOTHING, NEVER))
        deeper = [m for m in inside if m.place < stop and m not in here]
        inside = [m for m in inside if m.place >= stop]
        expression = with_mutants(source, deeper, start, stop)
        for mutant in here:
            expression = mutant.asked(expression)
        out += [source[at:start], expression]
        at = stop
    return "".join([*out, source[at:end]])


def write_sources(work, chosen_mutants, size):
    mutants.write_sources(work, [])
    by_file = collections.defaultdict(list)
    for mutant in chosen_mutants:
        by_file[mutant.file].append(mutant)
    languages = {places_of(file) for file in by_file}
    for file in {*by_file, *([mutants.HOME] if mutant_places in languages else [])}:
        source = (ROOT / file).read_bytes().decode("latin-1")
        inside = sorted(by_file[file], key=lambda m: (m.place, -m.end))
        text = with_mutants(source, inside, 0, len(source)).encode("latin-1").decode()
        if places_of(file) is mutant_places:
            text = PRELUDE + text + (DEFINITION % (size, size) if file == mutants.HOME else "")
        else:
            text = places_of(file).with_what_asks(text)
        mutants.write_if_new(work / file, text)
    for language in languages - {mutant_places}:
        language.write_what_asks(work, size)


def number(chosen_mutants):
    """They keep their numbers, so that files without a mutant that does not compile stay as they are. One more than the last."""
    for count, mutant in enumerate(chosen_mutants, 1):
        mutant.number = count
    return len(chosen_mutants) + 1


def compiled(work, targets, of_proofs):
    """What the compilers say if they fail, else nothing."""
    run = subprocess.run(["cmake", "--build", "--preset", "release", "--target", *targets, "--", "-k", "0"],
                         cwd=work, check=False, capture_output=True, text=True, errors="replace")
    said = "" if run.returncode == 0 else run.stdout or "the build failed"
    return said + (ocaml_mutant_places.build(work) if of_proofs else "")


def faulty_lines(said, work):
    """The files and lines that the compilers name."""
    for found in re.finditer(r"^(\S+?):(\d+):\d+: (?:fatal )?error", said, re.M):
        # A compiler cache may have made the paths relative to where the compiler runs.
        path = (work / "build/release" / found[1]).resolve()
        if path.is_relative_to(work):
            yield str(path.relative_to(work)), int(found[2])
    for found in re.finditer(r'^File "(\w+\.ml)", lines? (\d+)', said, re.M):
        yield f"proofs/ocaml/{found[1]}", int(found[2])


def build(work, chosen_mutants, targets):
    """Compiles them, and drops those of lines that do not compile, such as arguments of templates."""
    size = number(chosen_mutants)
    of_proofs = any(places_of(m.file) is ocaml_mutant_places for m in chosen_mutants)
    write_sources(work, chosen_mutants, size)  # CMake wants to see them
    subprocess.run(["cmake", "-DCIRCUMSPECT_QUICK_BUILD=ON", "-DCIRCUMSPECT_BUILD_TESTS=ON", "-DCIRCUMSPECT_BUILD_MPI=ON",
                    f"-DCIRCUMSPECT_VERIFIED={work / VERIFIED if of_proofs else ''}", "-DCMAKE_COMPILE_WARNING_AS_ERROR=OFF",
                    "--preset", "release"], cwd=work, check=True, stdout=subprocess.DEVNULL)
    while True:
        write_sources(work, chosen_mutants, size)
        said = compiled(work, targets, of_proofs)
        if not said:
            return chosen_mutants
        faulty = set(faulty_lines(said, work))
        kept = [m for m in chosen_mutants if (m.file, m.line_number) not in faulty]
        if len(kept) == len(chosen_mutants):  # a compiler may name another line of the statement
            kept = [m for m in chosen_mutants
                    if not any(m.file == file and abs(m.line_number - line) <= LINES_OF_STATEMENT for file, line in faulty)]
        if len(kept) == len(chosen_mutants):
            sys.exit(said[-20000:] + "\ngenerated_mutants: the sources do not compile, and that is not a mutant's fault")
        print(f"{len(chosen_mutants) - len(kept)} mutants do not compile", flush=True)
        chosen_mutants = kept
