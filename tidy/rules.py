"""The two tables of identifiers: the rules that a mesh can break, and what can be wrong with a domain."""
import ast
import collections
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parent.parent
RULES = "oracle/model/rules.def"
BREACHES = "kernel/piecewise_linear/breaches.def"
Rule = collections.namedtuple("Rule", "number name identifier stage of mark meaning sentence theorem unproved")
Breach = collections.namedtuple("Breach", "number name identifier meaning witness")


def rows(path, macro, kind, root=ROOT):
    """The rows of a table, as they stand there. ValueError if one has another number of columns."""
    text = re.sub(r"^//.*$", "", (root / path).read_text(encoding="utf-8"), flags=re.MULTILINE)
    found = []
    for row in re.findall(rf'^{macro}\(((?:"(?:[^"\\]|\\.)*"|[^")])*)\)$', text, re.MULTILINE):
        columns = re.findall(r'"(?:[^"\\]|\\.)*"|[^\s,]+', row)
        values = [ast.literal_eval(one) if one[0] == '"' or one.isdigit() else one for one in columns]
        if len(values) != len(kind._fields):
            raise ValueError(f"{path}: expected {len(kind._fields)} columns in the row of {values[0]}, found {len(values)}")
        found.append(kind(*values))
    return found


def of_meshes(root=ROOT):
    return rows(RULES, "RULE", Rule, root)


def of_domains(root=ROOT):
    return rows(BREACHES, "BREACH", Breach, root)
