#!/usr/bin/env python3
"""Holds the sources to the architecture and the style; see ARCHITECTURE.md for the reasons.

    tidy/tidy.py                         check everything, one line for each fault
    tidy/tidy.py --list PATTERN...       the names of the project's files that match
"""

import fnmatch
import os
import re
import sys

# Which folders a folder may include directly; through them it sees what they see. The lines
# `circumspect_layer(...)` in CMakeLists.txt say the same to the linker.
COMMAND_FOLDERS = ["command", *("command/" + room for room in [
    "build", "campaign", "check", "compare", "generate", "input", "inspect", "options", "output", "pages", "rule"])]
COMMAND = ["construct", "reference", "reference/optimality", "reference/constrained", "reference/existence",
           "oracle/certificate", "oracle/judge/domain", "oracle/judge/within", "oracle/judge", "oracle/judge/cause",
           "oracle/distributed", "oracle/picture", "inputs/triangulated", "fuzz/campaign", *COMMAND_FOLDERS]
ARROWS = {
    "platform": [],
    **{"platform/" + system: ["platform", "platform/posix"] for system in ["posix", "linux", "macos", "windows"]},
    "kernel/exact": [],
    "kernel/boxes": ["kernel/exact"],
    "kernel/predicates": ["kernel/exact"],
    "kernel/complex": ["kernel/predicates"],
    "kernel/piecewise_linear": ["kernel/complex", "kernel/boxes"],
    "reference/delaunay": ["kernel/complex"],
    "reference/optimality": ["reference/delaunay"],
    "reference/constrained": ["reference/delaunay", "kernel/piecewise_linear"],
    "reference/existence": ["kernel/piecewise_linear", "platform"],
    "reference": ["reference/constrained"],
    "include/circumspect": [],
    "inputs": ["kernel/piecewise_linear", "include/circumspect"],
    "inputs/triangulated": ["reference/delaunay", "inputs"],
    "oracle/domain": ["kernel/piecewise_linear"],
    "oracle/model": ["kernel/piecewise_linear"],
    "oracle/formats/bytes": ["oracle/model", "platform"],
    "oracle/formats": ["oracle/formats/bytes"],
    "oracle/judge/definition": ["oracle/model"],
    "oracle/judge/complex": ["oracle/judge/definition", "oracle/judge/fast/predicates"],
    "oracle/judge/convex_hull": ["oracle/judge/complex"],
    "oracle/judge/surface": ["oracle/judge/complex"],
    "oracle/judge/voronoi": ["oracle/judge/definition"],
    "oracle/judge/conditions": [],
    "oracle/judge/points": ["oracle/judge/definition", "oracle/judge/conditions"],
    "oracle/judge/periodic": ["oracle/judge/points"],
    "oracle/judge/domain": ["oracle/judge/points", "oracle/judge/convex_hull", "oracle/judge/surface",
                            "oracle/judge/voronoi", "oracle/judge/fast"],
    "oracle/judge/within": ["oracle/judge/domain", "oracle/domain"],
    "oracle/judge/fast/predicates": ["kernel/exact"],
    "oracle/judge/fast": ["oracle/judge/fast/predicates", "kernel/boxes", "oracle/judge/conditions", "platform"],
    "construct": ["oracle/judge/fast", "oracle/model", "reference"],
    "oracle/judge/quality": ["oracle/judge/within"],
    "oracle/judge": ["oracle/judge/quality", "oracle/judge/periodic"],
    "oracle/distributed": ["oracle/judge", "oracle/report", "oracle/formats"],
    "oracle/judge/cause": ["oracle/judge", "oracle/report"],
    "oracle/judge/arrays": ["oracle/judge", "oracle/report", "include/circumspect"],
    "oracle/certificate": ["oracle/judge/domain"],
    "oracle/picture": ["oracle/report"],
    "oracle/report": ["oracle/judge/points"],
    "fuzz/process": [],
    "fuzz/campaign": ["oracle/judge", "oracle/domain", "fuzz/process", "oracle/report", "oracle/formats", "inputs"],
    "fuzz/harness": ["oracle/judge/arrays", "inputs"],
    "c": ["construct", "reference", "oracle/certificate", "oracle/judge/within", "oracle/judge/cause", "oracle/picture",
          "inputs/triangulated"],
    "js": ["c"],
    "python": ["c", "fuzz/harness", "fuzz/campaign"],
    "fuzz/targets": ["reference/constrained", "oracle/judge/domain", "fuzz/harness"],
    **{folder: COMMAND for folder in COMMAND_FOLDERS},
    "command/mpi": COMMAND,
    "command/web": ["command/check"],
    "command/without_linux": ["command", "command/check"],
    "properties/arguments": ["inputs/triangulated"],
    "properties/mutations": ["oracle/model", "inputs"],
    "properties/faulty": ["reference/constrained", "fuzz/campaign", "inputs/triangulated"],
    "properties/adapters": ["include/circumspect"],
    "properties": ["construct", "reference/optimality", "reference/constrained", "reference/existence",
                   "oracle/certificate", "oracle/judge/domain", "oracle/report",
                   "properties/arguments", "properties/mutations",
                   "properties/faulty", "properties/adapters", "fuzz/harness", "oracle/distributed"],
    "corpus": ["reference/delaunay", "oracle/certificate", "oracle/report", "oracle/formats", "oracle/judge/within",
               "fuzz/harness"],
    "proofs": ["oracle/certificate", "oracle/judge/points", "oracle/formats", "reference/delaunay",
               "properties/arguments", "properties/mutations", "corpus"],
    "bench": ["reference/constrained", "oracle/report", "fuzz/harness", "fuzz/campaign"],
}
# The one header by which these folders may ask the book for a construction, so that none of them depends on an
# algorithm of it: what shows a mesh to be wrong must not be what built it.
CONSTRUCTIONS = "reference/constructions.hpp"
BY_CONSTRUCTIONS = ["oracle", "c", "python", "include", "fuzz/harness"]
# What a test beside its layer may include on top of what the layer may.
TESTS_ALSO = ["inputs", "properties/arguments", "oracle/formats",
              "oracle/judge/domain"]  # its judge_exactly, which holds the lemmas to the definitions

# Programs apart, which call other libraries and nothing of ours: only the style rules hold there.
APART = ["corpus/make", "examples", "fuzz/adapters", "hunt"]

# Where CGAL may be included, apart from files named *_cgal_test.cpp.
# CGAL knows our Rational by the name that GMP gives it.
CGAL_FILES = ["kernel/predicates/intersection.cpp"]
CGAL_FOLDERS = ["bench", "properties/adapters"]
# Filters: their doubles are those of boxes rounded outward, and say only where exact tests look first.
FLOATING_FILES = ["kernel/piecewise_linear/cell_index.hpp",
                  "kernel/piecewise_linear/cell_index.cpp"]
NUMBER_LIBRARY_FOLDERS = ["kernel/exact", "bench"]
# The vector algebra: everything else asks these for a cross product.
CROSS_PRODUCT_FILES = ["kernel/exact/point.cpp", "kernel/exact/triple.hpp"]

# What `make web` compiles against libc++ 14, which has no algorithms of ranges.
WEB_FOLDERS = ["kernel", "construct", "reference", "oracle", "inputs", "command"]

LONGEST_FILE, LONG_FILE = 450, 400
LONGEST_FUNCTION = 60  # a screen; a table that a function returns is read row by row, and may be longer
WIDEST_COMMENT = 100
VAGUE_NAMES = ["util", "helper", "manager", "common", "misc"]
CPP = (".hpp", ".cpp", ".h")
SCRIPTS = (".js", ".mjs")
SOURCES = CPP + SCRIPTS + (".py", ".sh", ".cmake", "CMakeLists.txt")

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
NUMBER_LIBRARY = re.compile(r"\b(mp[zqf]_\w+|mpfr_\w+|__gmp\w+|gmp_\w+)|<(gmp|gmpxx|mpfr)\.h>")
RANGES = re.compile(r"\bstd::(ranges|views)::")
FLOATING = re.compile(r"\b(float|double)\b")
# A coordinate such as a[1], a.at[axes[0]] or a.x, and a difference of two; the places are the groups.
COORDINATE = r"\b[A-Za-z_]\w*(?:\.at)?(?:\[(?:[^\[\]\n]|\[\w+\])+\]|\.[xyz]\b)"
FACTOR = rf"({COORDINATE}|\({COORDINATE}\s-\s{COORDINATE}\))"
CROSSWISE = re.compile(rf"{FACTOR}\s+\*\s+{FACTOR}(?:\s+[-<>]\s+|\s+==\s+|,\s+){FACTOR}\s+\*\s+{FACTOR}")
PLACE = re.compile(r"\[(?:[^\[\]]|\[\w+\])+\]|\.[xyz]\b")
BANNER = re.compile(r"\s*(//|#|/\*|\(\*) ?(-{3,} .*-{3,}|-{8,} ?\w|─{2,} .*─{2,})")
COMMENT = {".py": "#", ".sh": "#", ".cmake": "#", "CMakeLists.txt": "#", **dict.fromkeys(CPP + SCRIPTS, "//")}
NO_FUNCTION = re.compile(r"(template *<.*>)?\s*(inline )?(namespace|class|struct|enum|union|extern)\b")
LONG = re.compile(r"\blong \w+ = (?:[0-9]'?){11,};")
# std::minmax, or a reference to what std::max and its like return, of what a call made: it is gone at the end of the line.
OF_CALLS = r"\((?!\{)[^;{}]*\w\([^;{}]*\);"
DANGLING = re.compile(r"\bauto(?: \w+| ?&&? ?\w+| ?&{0,2} ?\[[^\]]*\]) = std::(?:ranges::)?minmax" + OF_CALLS +
                      r"|\bauto ?&&? ?\w+ = std::(?:ranges::)?(?:min|max|clamp)" + OF_CALLS)
MARK = re.compile(r"\b(TODO|FIXME|XXX|HACK)\b")
LAYER = re.compile(r"circumspect_layer\((\w+)\s+([\w/]+)([^)]*)\)")
NOT_CODE = re.compile(
    r'R"(?P<raw>[^(\s]*)\(.*?\)(?P=raw)"'  # a raw string
    r'|//[^\n]*|/\*.*?\*/'                  # comments
    r'|"(?:\\.|[^"\\\n])*"'                # a string
    r"|(?<![0-9a-fA-F])'(?:\\.|[^'\\\n])+'",  # a character, not a digit separator
    re.DOTALL,
)


def files(root):
    """Every file of the project by its path from the root, builds and hidden folders left out."""
    for folder, subfolders, names in os.walk(root):
        subfolders[:] = sorted(
            name for name in subfolders
            if not name.startswith((".", "__")) and not (folder == root and name.startswith("build"))
        )
        for name in sorted(names):
            yield os.path.relpath(os.path.join(folder, name), root).replace(os.sep, "/")


def visible_from(folder):
    """The folder itself and all that its arrows lead to."""
    seen, pending = set(), [folder]
    while pending:
        one = pending.pop()
        if one not in seen:
            seen.add(one)
            pending += ARROWS.get(one, [])
    return seen


def code_only(text):
    """The text with comments and literals blanked, includes kept, and every line in its place."""
    def blank(match):
        start = text.rfind("\n", 0, match.start()) + 1
        if match[0].startswith('"') and text[start:].lstrip(" \t").startswith("#"):
            return match[0]
        return re.sub(r"[^\n]", " ", match[0])

    return NOT_CODE.sub(blank, text)


def is_cross_product(factors):
    """Are these a, b, c, d, with a·b − c·d a cross product: two vectors at two places crosswise?"""
    places = [set(PLACE.findall(factor)) for factor in factors]
    if any(len(one) != 1 for one in places) or places[0] == places[1]:
        return False
    first, second = ([(PLACE.sub("", factor), *place) for factor, place in zip(pair, at)]
                     for pair, at in [(factors[:2], places[:2]), (factors[2:], places[2:])])
    crosswise = [(first[0][0], first[1][1]), (first[1][0], first[0][1])]
    return sorted(second) == sorted(crosswise)


def is_table(body):
    """Does a function do nothing but return rows between braces?"""
    depth = 0
    for match in re.finditer(r"[{}]", body):
        depth += 1 if match[0] == "{" else -1
        if depth == 0:
            return body.startswith("return {") and body[match.end():].strip() == ";"
    return False


def functions(code):
    """The functions of code without comments: the line of each, how many lines it has, and whether it only returns a table."""
    code = re.sub(r"(?m)^\s*#.*$", "", code)  # directives end in no semicolon
    opened, found = [], []  # of each open brace: where it is, where what stands before it begins, and is it a function's?
    begin = 0
    for match in re.finditer(r"[{};]", code):
        if match[0] == "{":
            head = code[begin:match.start()]
            start = begin + len(head) - len(head.lstrip())
            is_function = "(" in head and not NO_FUNCTION.match(head.strip()) and not any(one[2] for one in opened)
            opened.append((match.end(), start, is_function))
        elif match[0] == "}" and opened:
            inside_of, start, is_function = opened.pop()
            if is_function:
                body = code[inside_of:match.start()].strip()
                found.append((code.count("\n", 0, start) + 1, code.count("\n", start, match.end()) + 1, is_table(body)))
        begin = match.end()
    return found


def is_test(path):
    return path.endswith(("_test.cpp", "_test.hpp", "_property.cpp", "_fuzz.cpp"))


def inside(path, folders):
    return any(path.startswith(folder + "/") for folder in folders)


class Tidy:
    """Collects the faults of one tree."""

    def __init__(self, root):
        self.root = root
        self.faults = []
        self.warnings = []

    def fault(self, path, line, rule, what_to_do):
        self.faults.append(f"{path}:{line}: {rule}: {what_to_do}")

    def run(self):
        for path in files(self.root):
            name = path.rsplit("/", 1)[-1]
            if name.endswith(SOURCES):
                with open(os.path.join(self.root, path), encoding="utf-8", newline="") as file:
                    text = file.read()
                self.name(path)
                self.layout(path, text)
                if not path.startswith("tidy/"):
                    self.comments(path, text)
                if name.endswith(CPP):
                    self.functions(path, code_only(text))
                if name.endswith(CPP) and not inside(path, APART):
                    self.folder(path)
                    self.code(path, code_only(text))
                if path == "CMakeLists.txt":
                    self.build(path, text)
        return self.faults

    def name(self, path):
        for vague in VAGUE_NAMES:
            if vague in path.lower():
                self.fault(path, 1, "name", f"'{vague}' says nothing; name what the file is about")

    def layout(self, path, text):
        lines = text.split("\n")
        count = len(lines) - 1
        if count > LONGEST_FILE:
            self.fault(path, count, "length",
                       f"{count} lines hold two ideas; split the file (at most {LONGEST_FILE} lines)")
        elif count > LONG_FILE:
            self.warnings.append(f"{path}:{count}: warning: {count} lines; consider a split")
        if text and not text.endswith("\n"):
            self.fault(path, len(lines), "whitespace", "end the last line with a newline")
        for number, line in enumerate(lines, 1):
            if "\t" in line:
                self.fault(path, number, "whitespace", "replace the tab by spaces")
            if line != line.rstrip():
                self.fault(path, number, "whitespace", "remove the space at the end of the line")
            mark = MARK.search(line)
            if mark and not path.startswith("tidy/"):
                self.fault(path, number, "mark", f"finish what {mark[1]} marks, or open an issue")

    def comments(self, path, text):
        mark = next(mark for ending, mark in COMMENT.items() if path.endswith(ending))
        for number, line in enumerate(text.split("\n"), 1):
            if BANNER.match(line):
                self.fault(path, number, "banner", "no banner replaces a file: split it by its ideas, or leave the banner out")
            if len(line) > WIDEST_COMMENT and line.lstrip().startswith(mark + " "):
                self.fault(path, number, "comment", f"end the line of a comment at {WIDEST_COMMENT} columns")

    def functions(self, path, code):
        for line, count, is_table in functions(code):
            if count > LONGEST_FUNCTION and not is_table:
                self.fault(path, line, "function", f"{count} lines are more than a screen; cut the function where "
                           f"an idea ends (at most {LONGEST_FUNCTION} lines)")

    def folder(self, path):
        folder = path.rpartition("/")[0]
        if folder not in ARROWS:
            self.fault(path, 1, "folder", f"'{folder}' is not a layer; add it to ARROWS in tidy/tidy.py")

    def code(self, path, code):
        for number, line in enumerate(code.split("\n"), 1):
            include = INCLUDE.match(line)
            if include:
                self.include(path, number, *include.groups())
            if NUMBER_LIBRARY.search(line) and not inside(path, NUMBER_LIBRARY_FOLDERS) \
                    and path not in CGAL_FILES and not path.endswith("_cgal_test.cpp"):
                self.fault(path, number, "number-library",
                           "only kernel/exact names GMP and MPFR; say Integer or Rational")
            if LONG.search(line):
                self.fault(path, number, "long", "a long has 32 bits on Windows; say std::int64_t, or Rational")
            if RANGES.search(line) and inside(path, WEB_FOLDERS) and not is_test(path):
                self.fault(path, number, "ranges",
                           "`make web` has no algorithms of ranges; give begin() and end()")
            if FLOATING.search(line) and path.startswith(("kernel/", "reference/")) \
                    and not inside(path, ["kernel/exact", "kernel/boxes"]) and not is_test(path) \
                    and path not in FLOATING_FILES:
                self.fault(path, number, "floating-point",
                           "kernel and reference compute exactly; take a Rational")

        for found in DANGLING.finditer(code):
            self.fault(path, code.count("\n", 0, found.start()) + 1, "dangling",
                       "it refers to what is gone; give std::minmax a list, and take values of std::min and std::max")
        if not is_test(path) and path not in CROSS_PRODUCT_FILES:
            for product in CROSSWISE.finditer(code):
                if is_cross_product(product.groups()):
                    self.fault(path, code.count("\n", 0, product.start()) + 1, "cross-product",
                               "call cross_product of kernel/exact/point.hpp or triple.hpp")

    def include(self, path, number, quote, target):
        if target.startswith("CGAL/"):
            if not path.endswith("_cgal_test.cpp") and path not in CGAL_FILES \
                    and not inside(path, CGAL_FOLDERS):
                self.fault(path, number, "cgal", "include CGAL only in a file named *_cgal_test.cpp")
            return
        if target.startswith("circumspect/"):
            target = "include/" + target
        layer = target.rpartition("/")[0]
        top = target.split("/")[0]
        if quote == '"' and top not in {folder.split("/")[0] for folder in ARROWS}:
            self.fault(path, number, "include",
                       f"write the path of \"{target}\" from the root of the repository, or <...>")
        elif target.startswith("reference/") and inside(path, BY_CONSTRUCTIONS) and target != CONSTRUCTIONS:
            self.fault(path, number, "constructions",
                       f"include {CONSTRUCTIONS}, which names what others may ask of the book")
        elif layer in ARROWS:
            folder = path.rpartition("/")[0]
            allowed = visible_from(folder)
            if is_test(path):
                allowed = allowed.union(*map(visible_from, TESTS_ALSO))
            if layer not in allowed:
                self.fault(path, number, "arrow", f"{folder} must not see {layer}; move what it "
                           "needs to a layer that both see")

    def build(self, path, text):
        """The arrows between the libraries are the arrows between the includes."""
        layers = [(match.start(), *match.groups()) for match in LAYER.finditer(text)]
        folder_of = {name: folder for _, name, folder, _ in layers}
        for start, name, folder, rest in layers:
            depends = re.search(r"\bDEPENDS((\s+[a-z_]\w*)*)", rest)
            linked = {folder_of.get(one, one) for one in depends[1].split()} if depends else set()
            if folder not in ARROWS or linked != set(ARROWS[folder]):
                self.fault(path, text.count("\n", 0, start) + 1, "build",
                           f"the arrows of {name} differ from ARROWS in tidy/tidy.py")


def main(arguments):
    root = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    if arguments[:1] == ["--list"]:
        for path in files(root):
            if any(fnmatch.fnmatch(path, pattern) for pattern in arguments[1:]):
                print(path)
        return 0
    tidy = Tidy(root)
    faults = tidy.run()
    print("\n".join(faults + tidy.warnings + [f"tidy: {len(faults)} faults"]))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
