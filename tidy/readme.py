#!/usr/bin/env python3
"""Holds README.md and the pages of docs/ to the truth: what they show is run, and its output compared.

    readme.py COMMAND [--verified PROGRAM] [--programs]            compare; exit 1 and show the difference
    readme.py COMMAND [--verified PROGRAM] [--programs] --update   write what comes out into the pages

PROGRAM is circumspect-verified; without it, what it printed stays as it is. Looked at are

- `$ circumspect …` in a block of code, run at the root;
- `/tmp/try$ …`, run by the shell in an empty folder, with --programs (these run programs of others);
- the block after `<!-- file: PATH -->`, which is that file;
- the tables of identifiers.
"""
import argparse
import concurrent.futures
import difflib
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

import rules

ROOT = pathlib.Path(__file__).resolve().parent.parent
# The header of a table of identifiers, and what stands in it.
TABLES = [("| rule | what is wrong |", rules.of_meshes), ("| breach | what is wrong |", rules.of_domains)]
# How the names of files begin that the examples write.
SCRATCH = ("reference", "proof", "drawn", "certificate", "differences")
SESSION = "/tmp/try$ "
# What differs from run to run.
SECONDS = re.compile(r"\bin \d+\.\d s$", re.MULTILINE)
# What no page shows: what a campaign says about its time while it works, and what campaigns and MPI add in a container
# without namespaces or /sys.
NARRATION = re.compile(r"^(campaign: \d|note: a supervisor contained |\[hwloc/).*\n", re.MULTILINE)
FILE = re.compile(r"<!-- file: (\S+) -->")


def pages():
    """The pages, by their paths. Those of the hunt are records of long campaigns, which findings_test judges."""
    docs = ROOT / "docs"
    return [ROOT / "README.md", *sorted(docs.rglob("*.md"))]


class Page:
    """One page, and the folders in which its examples run."""

    def __init__(self, path, programs, sessions, folder):
        self.text = path.read_text(encoding="utf-8")
        self.name = str(path.relative_to(ROOT))
        self.programs = programs
        self.sessions = sessions
        self.folder = folder
        self.session_folder = os.path.join(folder, "session")
        os.mkdir(self.session_folder)

    def true_text(self):
        """The text as it ought to be."""
        text = with_tables(with_files(self.with_outputs()))
        same = SECONDS.sub("", text) == SECONDS.sub("", self.text)
        return self.text if same else text

    def with_outputs(self):
        """The text, with the lines behind each prompt replaced by what is printed."""
        lines = []
        in_block = shown = False
        for line in self.text.splitlines():
            if line.startswith("```"):
                in_block, shown = not in_block, False
            elif in_block and line.startswith(("$ ", SESSION)):
                output = self.output_of(line)
                shown = output is not None
                lines += [line, *(output or [])]
                continue
            elif shown:
                continue
            lines.append(line)
        return "\n".join(lines) + "\n"

    def output_of(self, line):
        """What stands behind the prompt when it is run, stdout and stderr; None if it is not run."""
        if line.startswith(SESSION):
            return self.session_output(line[len(SESSION):]) if self.sessions else None
        name, *words = shlex.split(line[2:])
        if name not in self.programs:
            return None
        words = [f"{self.folder}/{word}" if word.startswith(SCRATCH) else word for word in words]
        return self.printed([self.programs[name], *words], ROOT).replace(
            f"{self.folder}/", "").splitlines()

    def session_output(self, line):
        """What the shell prints in the page's own folder, which is shown as /tmp/try."""
        printed = self.printed(["bash", "-c", line], self.session_folder)
        return NARRATION.sub("", printed).replace(self.session_folder, SESSION[:-2]).splitlines()

    def printed(self, command, where):
        path = os.path.dirname(self.programs["circumspect"]) + os.pathsep + os.environ["PATH"]
        as_root = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}  # for mpirun
        return subprocess.run(command, cwd=where, text=True, stdout=subprocess.PIPE, check=False,
                              stderr=subprocess.STDOUT, env={**os.environ, **as_root, "PATH": path},
                              timeout=300).stdout


def with_files(text):
    """The text with the blocks that are files brought up to date."""
    lines, file = [], None
    inside = False
    for line in text.splitlines():
        marked = FILE.fullmatch(line)
        if marked:
            file = ROOT / marked[1]
        elif line.startswith("```") and (file or inside):
            if not inside:
                lines += [line, *file.read_text(encoding="utf-8").splitlines()]
                file = None
                inside = True
                continue
            inside = False
        elif inside:
            continue
        lines.append(line)
    return "\n".join(lines) + "\n"


def table(header, entries):
    """The identifiers, which lead to their pages, and their meanings."""
    return [header, "| --- | --- |",
            *(f"| [`{one.identifier}`](rules/{one.identifier}.md) | {one.meaning} |" for one in entries)]


def with_tables(text):
    """The text with the tables of identifiers brought up to date."""
    tables = {header: table(header, sorted(entries(), key=lambda one: one.number)) for header, entries in TABLES}
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
    parser.add_argument("--programs", action="store_true")
    parser.add_argument("--update", action="store_true")
    options = parser.parse_args()
    programs = {"circumspect": options.command, "circumspect-verified": options.verified}
    programs = {name: str(path.resolve()) for name, path in programs.items() if path}

    def looked_at(path):
        """What is wrong with a page, as lines; an update mends it instead."""
        with tempfile.TemporaryDirectory() as folder:
            page = Page(path, programs, options.programs, folder)
            true_text = page.true_text()
        if options.update and true_text != page.text:
            path.write_text(true_text, encoding="utf-8")
            print(f"{page.name}: updated")
            return []
        return list(difflib.unified_diff(page.text.splitlines(), true_text.splitlines(), page.name,
                                         "what comes out", lineterm=""))

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        differences = [line for lines in pool.map(looked_at, pages()) for line in lines]
    print("\n".join(differences) if differences else f"{len(pages())} pages show what comes out")
    return 1 if differences else 0


if __name__ == "__main__":
    sys.exit(main())
