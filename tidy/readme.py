#!/usr/bin/env python3
"""Holds README.md to the truth: every `$ circumspect …` in it is run, and its output compared.

    readme.py COMMAND            compare; exit 1 and show the difference if they differ
    readme.py COMMAND --update   write the outputs into README.md
"""
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
    ("| rule | what is wrong |", ROOT / "oracle" / "rule.cpp", r"RuleEntry\{Rule"),
    ("| breach | what is wrong |", ROOT / "reference" / "piecewise_linear" / "breach.cpp",
     r"\{BreachKind"),
]
# How the names of files begin that the examples write.
SCRATCH = ("reference", "proof", "drawn")


def output_of(command, line, folder):
    """What the command prints, stdout and stderr, run at the root; files it writes are in the folder."""
    words = shlex.split(line)[1:]
    words = [f"{folder}/{word}" if word.startswith(SCRATCH) else word for word in words]
    run = subprocess.run([command, *words], cwd=ROOT, text=True, capture_output=True, check=False)
    return (run.stdout + run.stderr).replace(f"{folder}/", "").splitlines()


def with_outputs(command, text, folder):
    """The text, with the lines behind each `$ circumspect …` replaced by what it prints."""
    lines = []
    in_block = shown = False
    for line in text.splitlines():
        if line.startswith("```"):
            in_block, shown = not in_block, False
        elif in_block and line.startswith("$ circumspect "):
            lines += [line, *output_of(command, line[2:], folder)]
            shown = True
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
    command = str(pathlib.Path(sys.argv[1]).resolve())
    text = README.read_text(encoding="utf-8")
    with tempfile.TemporaryDirectory() as folder:
        true_text = with_tables(with_outputs(command, text, folder))
    if "--update" in sys.argv[2:]:
        README.write_text(true_text, encoding="utf-8")
        return 0
    difference = list(difflib.unified_diff(text.splitlines(), true_text.splitlines(), "README.md",
                                           "what the command prints", lineterm=""))
    print("\n".join(difference) if difference else "README.md shows what the command prints")
    return 1 if difference else 0


if __name__ == "__main__":
    sys.exit(main())
