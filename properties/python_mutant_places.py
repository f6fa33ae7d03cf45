"""Where generated_mutants.py may break a source of the Python package: Python's own parser finds the places.

A mutant changes a comparison, `and` or `or`, a sum to a difference, a sign, `not`, an integer, True to False, or the order of two
arguments; or it leaves out a named argument, a statement, or what an `if` does.
"""
import ast
import io
import re
import tokenize

from mutant_places import NEVER, NOTHING, ROOT, SYMMETRIC, Mutant

NO_ARGUMENT = "not given"
OTHER = {"Lt": ["<=", ">="], "LtE": ["<", ">"], "Gt": [">=", "<="], "GtE": [">", "<"], "Eq": ["!="], "NotEq": ["=="],
         "Is": ["is not"], "IsNot": ["is"], "In": ["not in"], "NotIn": ["in"]}
COMPARISON = re.compile(r"not\s+in\b|is\s+not\b|in\b|is\b|[<>]=?|[=!]=")
# What their arguments are in another order is another question, which raises an exception at once.
CALLED = SYMMETRIC | {"isinstance", "issubclass", "getattr", "hasattr", "map", "zip"}
# What a module does when it is imported no test of pytest has by itself.
ASKED = """import atexit
import os
import sys

ACTIVE = int(os.environ.get("CIRCUMSPECT_MUTANT", "0"))
reached = set()


def circumspect_mutated(number):
    imports = sys._getframe(1).f_code.co_name == "<module>"
    reached.add((number, "" if imports else os.environ.get("PYTEST_CURRENT_TEST", "")))
    return number == ACTIVE


def write_reached():
    with open(os.environ["CIRCUMSPECT_REACHED"], "a") as file:
        file.write("".join(f"{number} {test}\\n" for number, test in reached))


if "CIRCUMSPECT_REACHED" in os.environ:
    atexit.register(write_reached)
else:
    def circumspect_mutated(number):
        return number == ACTIVE
"""


class PythonMutant(Mutant):
    """An expression of Python asks in its way."""

    def asked(self, expression):
        text = {NOTHING: "None", NEVER: "False"}.get(self.other, self.text)
        return f"(({text}) if circumspect_mutated({self.number}) else ({expression}))"


class Places(ast.NodeVisitor):
    """Collects the mutants of a source; offsets are those of bytes."""

    def __init__(self, file, text):
        self.file, self.source, self.found = file, text.encode().decode("latin-1"), []
        self.lines = [0]
        for line in self.source.splitlines(keepends=True):
            self.lines.append(self.lines[-1] + len(line))
        self.visit(ast.parse(text))

    def bounds(self, node):
        return self.lines[node.lineno - 1] + node.col_offset, self.lines[node.end_lineno - 1] + node.end_col_offset

    def add(self, node, first, last, other, word=None):
        """`word`, or `other`, in place of what stands from first to last."""
        start, stop = self.bounds(node)
        text = self.source[start:first] + (other if word is None else word) + self.source[last:stop]
        self.found.append(PythonMutant(self.file, self.source, start, stop, text, (first, last - first), other))

    def operator(self, node, left, right, pattern, others):
        """An operator that stands between two operands."""
        begin, end = self.bounds(left)[1], self.bounds(right)[0]
        match = re.compile(pattern).search(self.source, begin, end)
        for other in others:
            self.add(node, match.start(), match.end(), other)

    def visit_Compare(self, node):
        for left, operator, right in zip([node.left, *node.comparators], node.ops, node.comparators):
            self.operator(node, left, right, COMPARISON, OTHER[type(operator).__name__])
        self.generic_visit(node)

    def visit_BoolOp(self, node):
        word, other = ("and", "or") if isinstance(node.op, ast.And) else ("or", "and")
        for left, right in zip(node.values, node.values[1:]):
            self.operator(node, left, right, rf"\b{word}\b", [other])
        self.generic_visit(node)

    def visit_BinOp(self, node):
        texts = (ast.JoinedStr, ast.List, ast.ListComp)
        of_numbers = not any(isinstance(side, texts) or isinstance(getattr(side, "value", None), str) for side in (node.left, node.right))
        if isinstance(node.op, (ast.Add, ast.Sub)) and of_numbers:
            self.operator(node, node.left, node.right, "[+-]", ["-" if isinstance(node.op, ast.Add) else "+"])
        self.generic_visit(node)

    def visit_UnaryOp(self, node):
        start, _ = self.bounds(node)
        word = {ast.Not: "not", ast.USub: "-", ast.Invert: "~"}.get(type(node.op))
        if word:
            self.add(node, start, start + len(word), "")
        self.generic_visit(node)

    def visit_Constant(self, node):
        if isinstance(node.value, bool):
            self.add(node, *self.bounds(node), str(not node.value))
        elif isinstance(node.value, int):
            self.add(node, *self.bounds(node), str(node.value - 1 if node.value > 1 else 1 - node.value))

    def condition(self, test, word):
        start, stop = self.bounds(test)
        at = self.source.rfind(word, 0, start) if word == "if" else start
        self.found.append(PythonMutant(self.file, self.source, start, stop, "", (at, 2 if word == "if" else stop - start), NEVER))

    def visit_If(self, node):
        self.condition(node.test, "if")
        self.generic_visit(node)

    visit_IfExp = visit_If

    def visit_comprehension(self, node):
        for test in node.ifs:
            self.condition(test, "if")
        self.generic_visit(node)

    def visit_Expr(self, node):
        if isinstance(node.value, ast.Call):
            start, stop = self.bounds(node)
            self.found.append(PythonMutant(self.file, self.source, start, stop, "", (start, stop - start), NOTHING))
        if not isinstance(node.value, ast.Constant):
            self.generic_visit(node)

    def visit_Call(self, node):
        for a, b in zip(node.args, node.args[1:]):
            name = getattr(node.func, "id", getattr(node.func, "attr", ""))
            if name in CALLED or any(isinstance(x, (ast.Starred, ast.Constant, ast.JoinedStr)) for x in (a, b)):
                continue
            (first, last), (again, stop) = self.bounds(a), self.bounds(b)
            source = self.source
            self.add(node, first, stop, "swapped", source[again:stop] + source[last:again] + source[first:last])
        for given in node.keywords:
            first, last = self.bounds(given)
            comma = re.compile(r"\s*,\s*").match(self.source, last)
            self.add(node, first, comma.end() if comma else last, NO_ARGUMENT, "")
        self.generic_visit(node)

    def visit_JoinedStr(self, node):
        """What is said in words; its places are not known before Python 3.12."""

    def visit_arg(self, node):
        """Annotations are no expressions that are asked for."""

    def visit_AnnAssign(self, node):
        if node.value:
            self.visit(node.value)

    def visit_FunctionDef(self, node):
        for each in (*node.decorator_list, node.args, *node.body):
            self.visit(each)

    def visit_MatchValue(self, node):
        """A pattern."""


def generated(file):
    """The mutants of a file, in the order of their places."""
    first = {}
    for mutant in Places(file, (ROOT / file).read_text(encoding="utf-8")).found:
        first.setdefault(mutant.key(), mutant)
    return sorted(first.values(), key=lambda m: (m.place, -m.end, m.text))


def without_comments(text):
    """The text without comments and empty lines; indentation stays."""
    tokens = [token for token in tokenize.generate_tokens(io.StringIO(text).readline) if token.type not in (tokenize.COMMENT, tokenize.NL)]
    return "\n".join(f"{token.type} {token.string}" for token in tokens)


def with_what_asks(text):
    """Imports it where imports are allowed, in the line of the first other statement."""
    tree = ast.parse(text)
    first = next(node for node in tree.body
                 if not isinstance(getattr(node, "value", None), ast.Constant) and getattr(node, "module", "") != "__future__")
    lines = text.splitlines(keepends=True)
    at = first.lineno - 1
    asking = "".join([*lines[:at], "from circumspect.mutated import circumspect_mutated; ", *lines[at:]])
    compile(asking, "mutants", "exec")
    return asking


def write_what_asks(work, size):
    """A module of the package."""
    del size
    (work / "python/circumspect/mutated.py").write_text(ASKED, encoding="utf-8")
