#!/usr/bin/env python3
"""Holds README.md to the truth: every `$ circumspect …` in it is run, and its output compared.

    readme.py COMMAND [--verified PROGRAM]            compare; exit 1 and show the difference
    readme.py COMMAND [--verified PROGRAM] --update   write the outputs into README.md

PROGRAM is circumspect-verified; without it, what it printed stays as it is.
"""
import argparse
import difflib
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
README = ROOT / "README.md"
# The header of a table of identifiers, the source that has them, and how an entry of it begins.
TABLES = [
    ("| rule | what is wrong |", ROOT / "oracle" / "model" / "rule.cpp", r"RuleEntry\{Rule"),
    ("| breach | what is wrong |", ROOT / "reference" / "kernel" / "piecewise_linear" / "breach.cpp",
     r"\{BreachKind"),
]
# How the names of files begin that the examples write.
SCRATCH = ("reference", "proof", "drawn", "certificate")


def output_of(programs, line, folder):
    """What the command prints, stdout and stderr, run at the root; files it writes are in the folder."""
    name, *words = shlex.split(line)
    command = programs[name]
    words = [f"{folder}/{word}" if word.startswith(SCRATCH) else word for word in words]
    run = subprocess.run([command, *words], cwd=ROOT, text=True, capture_output=True, check=False)
    return (run.stdout + run.stderr).replace(f"{folder}/", "").splitlines()


def with_outputs(programs, text, folder):
    """The text, with the lines behind each `$ PROGRAM …` replaced by what it prints."""
    lines = []
    in_block = shown = False
    for line in text.splitlines():
        if line.startswith("```"):
            in_block, shown = not in_block, False
        elif in_block and line.startswith("$ "):
            shown = line.split()[1] in programs
            lines += [line, *(output_of(programs, line[2:], folder) if shown else [])]
            continue
        elif shown:
            continue
        lines.append(line)
    return "\n".join(lines) + "\n"


def table(header, path, entry):
    """The identifiers and their meanings as the source has them."""
    source = re.sub(r'"\s*\n\s*"', "", path.read_text(encoding="utf-8"))
    entries = re.findall(entry + r'::\w+,\s*"([^"]+)",\s*"([^"]+)"\}', source)
    return [header, "| --- | --- |",
            *(f"| `{identifier}` | {meaning} |" for identifier, meaning in entries)]


def with_tables(text):
    """The text with the tables of identifiers brought up to date."""
    tables = {header: table(header, path, entry) for header, path, entry in TABLES}
    lines, inside = [], False
    for line in text.splitlines():
        if line in tables:
            inside = True
            lines += tables[line]
        elif not (inside and line.startswith("|")):
            inside = False
            lines.append(line)
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("command", type=pathlib.Path)
    parser.add_argument("--verified", type=pathlib.Path)
    parser.add_argument("--update", action="store_true")
    options = parser.parse_args()
    programs = {"circumspect": options.command, "circumspect-verified": options.verified}
    programs = {name: str(path.resolve()) for name, path in programs.items() if path}
    text = README.read_text(encoding="utf-8")
    with tempfile.TemporaryDirectory() as folder:
        true_text = with_tables(with_outputs(programs, text, folder))
    if options.update:
        README.write_text(true_text, encoding="utf-8")
        return 0
    difference = list(difflib.unified_diff(text.splitlines(), true_text.splitlines(), "README.md",
                                           "what the command prints", lineterm=""))
    print("\n".join(difference) if difference else "README.md shows what the command prints")
    return 1 if difference else 0


if __name__ == "__main__":
    sys.exit(main())
