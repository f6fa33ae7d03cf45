#!/usr/bin/env python3
"""Holds the pages of docs/rules to the tables of rules and breaches, and to the corpus.

    rule_pages.py COMMAND      what is not as it should be, one line each; exit 1 if there is something

Each rule and each breach has a page, and each page its rule. The page has its number, its sections in their order, an example
that breaks this rule and nothing else, and a link to what stands behind it; and `circumspect rule` prints it. A property requires
each rule of a mesh alone, of hulls, surfaces, diagrams and quality to come up. Meshes that a lattice repeats break rules of
others: that of their judges requires each of these, and corpus/periodic has a mesh that breaks it.
"""
import json
import pathlib
import re
import shlex
import subprocess
import sys

import rules

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDER = ROOT / "docs" / "rules"
SECTIONS = ["An example", "What usually causes it", "How to mend it", "What stands behind it"]
OF = {"kPoints": "meshes of points", "kDomains": "meshes of a domain", "kBoth": "meshes of points or of a domain"}
BREACHES_BEHIND = "theory/decisions.md#piecewise-linear-complexes"
# Readers of files refuse these, so that no file shows them.
OF_ARRAYS = {"plc.index-out-of-range", "plc.degenerate-segment"}
EXAMPLE = re.compile(r"^\$ circumspect (.*)$", re.MULTILINE)
OPTIONS = (ROOT / "docs" / "command-line.md").read_text(encoding="utf-8")
# Of these each rule is named in a property, those of quality as the rows of measures(), one after the other.
OF_PROPERTIES = {"complex", "hull", "surface", "voronoi", "quality"}
PROPERTIES = [*sorted((ROOT / "properties").glob("*_property.cpp")), ROOT / "oracle" / "model" / "measure.cpp"]
# Where the rules are named that a mesh breaks which a lattice repeats; a definition names the ball itself, where its lemma names
# a facet.
OF_PERIODIC = [ROOT / "oracle" / "judge" / name for name in ("periodic/judge_periodic.cpp", "points/simplices.cpp")]
LEAST, MOST = 20, 45  # lines without what the example prints


def facts(entry):
    """The line below the heading."""
    if isinstance(entry, rules.Breach):
        return f"Breach {entry.number} of Definition 4.3, found when a domain is read."
    return f"Rule {entry.number}, judged of {OF[entry.of]}, at the stage *{entry.stage[1:].lower()}*."


def faults_of_text(entry, text):
    """What is wrong with the words of a page."""
    lines = text.splitlines()
    if lines[:3] != [f"# {entry.identifier}", "", facts(entry)]:
        yield f"expected the heading '# {entry.identifier}', an empty line and '{facts(entry)}', found {lines[:3]}"
    found = re.findall(r"^## (.*)$", text, re.MULTILINE)
    if found != SECTIONS:
        yield f"expected the sections {SECTIONS}, found {found}"
    for section in re.split(r"^## .*$", text, flags=re.MULTILINE)[1:]:
        if not section.strip():
            yield "a section is empty"
    behind = getattr(entry, "theorem", BREACHES_BEHIND)
    if f"](../{behind})" not in text:
        yield f"expected a link to {behind}, found none"
    image = f"](../images/rules/{entry.identifier}.svg)"
    if (image in text) != (entry.identifier not in OF_ARRAYS):
        yield f"expected {'no image' if entry.identifier in OF_ARRAYS else 'the image ' + image[2:-1]}"
    if not EXAMPLE.search(text):
        yield "expected an example behind '$ circumspect', found none"
    for path in re.findall(r"`(corpus/[^`]*)`", text):
        if not (ROOT / path).exists():
            yield f"expected a file of the corpus, found {path}"
    for option in re.findall(r"`(--[a-z-]+)", text):
        if not re.search(rf"^  (-\w,)?{option}\b", OPTIONS, re.MULTILINE):
            yield f"expected an option of the command, found {option}"
    length = len(re.sub(r"^```.*?^```$", "", text, flags=re.MULTILINE | re.DOTALL).splitlines())
    if not LEAST <= length <= MOST:
        yield f"expected {LEAST} to {MOST} lines beside the example, found {length}"


def faults_of_property(entry, properties):
    """What is wrong if no property requires that the rule comes up."""
    if entry.identifier.split(".")[0] in OF_PROPERTIES and not re.search(rf"Rule::{entry.name}\b", properties):
        yield f"expected a property in properties/ that requires Rule::{entry.name} to come up, found none"


def faults_of_periodic(entries):
    """What is wrong if no property or no mesh breaks a rule that a mesh can break which a lattice repeats."""
    judges = "\n".join(path.read_text(encoding="utf-8") for path in OF_PERIODIC)
    names = set(re.findall(r"Rule::(k[A-Z]\w+)", judges))
    drawn = (ROOT / "properties" / "periodic_property.cpp").read_text(encoding="utf-8")
    table = (ROOT / "corpus" / "periodic" / "expected.tsv").read_text(encoding="utf-8")
    broken = {line.split("\t")[2] for line in table.splitlines()}
    for entry in entries:
        if entry.name not in names:
            continue
        if not re.search(rf"Rule::{entry.name}\b", drawn):
            yield f"properties/periodic_property.cpp: expected Rule::{entry.name} to be required to come up"
        if entry.identifier not in broken:
            yield f"corpus/periodic: expected a mesh that breaks {entry.identifier}, found none"


def run(command, words):
    return subprocess.run([command, *words], cwd=ROOT, capture_output=True, text=True, check=False, timeout=60)


def faults_of_example(entry, text, command):
    """What is wrong with the example: it breaks the rule, and nothing else."""
    words = shlex.split(EXAMPLE.search(text)[1])
    done = run(command, [*words, "--format", "json"])
    if entry.identifier in OF_ARRAYS:
        if done.returncode != 3:
            yield f"expected an example that a reader refuses (exit code 3), found {done.returncode}"
        return
    broken = set()
    for result in json.loads(done.stdout)["results"]:
        broken |= {one["rule"] for one in result.get("rules", []) + result.get("breaches", [])}
    if broken != {entry.identifier}:
        yield f"expected an example that breaks this rule and nothing else, found {sorted(broken)}"


def faults_of_print(entry, command):
    """What is wrong with the page in a terminal."""
    printed = run(command, ["rule", entry.identifier]).stdout
    lines = printed.splitlines()
    for expected in [entry.identifier, *SECTIONS]:
        if expected not in lines:
            yield f"circumspect rule: expected the line '{expected}', found none"
    for mark in ("](", "![", "```"):
        if mark in printed:
            yield f"circumspect rule: expected plain text, found '{mark}'"


def faults(command):
    entries = rules.of_meshes() + rules.of_domains()
    listed = {one["rule"]: one for one in json.loads(run(command, ["rule", "--format", "json"]).stdout)["results"]}
    if set(listed) != {entry.identifier for entry in entries}:
        yield f"circumspect rule: expected the rules of {rules.RULES} and {rules.BREACHES}, found {sorted(listed)}"
    yield from faults_of_periodic(entries)
    for path in sorted(FOLDER.glob("*")):
        if path.name not in {f"{entry.identifier}.md" for entry in entries}:
            yield f"docs/rules/{path.name}: there is no such rule"
    properties = "\n".join(one.read_text(encoding="utf-8") for one in PROPERTIES)
    for entry in entries:
        name = f"docs/rules/{entry.identifier}.md"
        yield from (f"{name}: {one}" for one in faults_of_property(entry, properties))
        path = FOLDER / f"{entry.identifier}.md"
        if not path.is_file():
            yield f"{name}: expected a page, found none"
            continue
        text = path.read_text(encoding="utf-8")
        found = [*faults_of_text(entry, text)]
        found = found or [*faults_of_example(entry, text, command), *faults_of_print(entry, command)]
        yield from (f"{name}: {one}" for one in found)
        one = listed.get(entry.identifier, {})
        if (one.get("number"), one.get("meaning")) != (entry.number, entry.meaning):
            yield f"circumspect rule: expected number {entry.number} and '{entry.meaning}' of {entry.identifier}"


def main(arguments):
    found = list(faults(pathlib.Path(arguments[0]).resolve()))
    print("\n".join(found) if found else "each rule has its page, and each page its rule")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
