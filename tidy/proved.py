#!/usr/bin/env python3
"""Every rule of the program and every claim is among what is proved, or among what is said not to be: docs/certificates.md has the tables.

    proved.py             what is not as it should be, one line each; exit 1 if there is something

    proved.py --update    write the table of rules anew

Every notion of the files of definitions in proofs/, which MainTheorems.v is stated in, is in docs/theory/definitions.md, and rules are in
the words of the program there.

A rule is proved of points or of domains if proofs/mutants/ has a refutation that circumspect-verified must accept.
"""
import pathlib
import re
import sys

from rules import RULES, of_meshes

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = "docs/certificates.md"
OCAML = ROOT / "proofs" / "ocaml"
HEADER = "| rule | of points | of domains |"
CLAIMS = "| claim | that it holds | that it does not | what is not proved |"
OF_POINTS = {"triangulation", "delaunay", "weighted-delaunay"}
REFUTED_ALONE = {"convex-hull": "verified_not_hull", "surface-delaunay": "verified_not_surface", "periodic-delaunay": "verified_not_periodic"}
TABLE = {one.identifier: one for one in sorted(of_meshes(), key=lambda one: one.number)}


def text(path):
    return (ROOT / path).read_text(encoding="utf-8")


def rules():
    """The one vocabulary."""
    return list(TABLE)


def shown():
    """The theorems of each rule, of points and of domains, by the refutations that must be accepted."""
    theorems = {}
    for path in sorted((ROOT / "proofs" / "mutants").glob("*--shown*.cert")):
        words = next(line for line in path.read_text(encoding="utf-8").splitlines() if line[0] != "#").split()
        claim, rule, kind = words[2], words[4], words[5:]
        rule = {"domain.uncovered-inside": "domain.uncovered"}.get(rule, rule)
        if kind == ["flat"]:
            theorems.setdefault((rule, "points"), set()).add("verified_not_flat")
        elif claim in REFUTED_ALONE:
            theorems.setdefault((rule, "points"), set()).add(REFUTED_ALONE[claim])
        elif claim in OF_POINTS:
            theorems.setdefault((rule, "points"), set()).add("verified_rule")
        elif claim == "complex":
            theorems.setdefault((rule, "points"), set()).add("verified_not_complex")
        else:
            theorem = "verified_whole_domain_rule" if kind else "verified_domain_rule"
            theorems.setdefault((rule, "domains"), set()).add(theorem)
    return theorems


def is_judged(rule, of):
    return TABLE[rule].of in ("kBoth", "kDomains" if of == "domains" else "kPoints")


def cell(rule, of, theorems):
    if not is_judged(rule, of):
        return "–"
    return ", ".join(f"`{name}`" for name in sorted(theorems.get((rule, of), ()))) or f"no: {TABLE[rule].unproved}"


def rows(theorems):
    return [f"| `{rule}` | {cell(rule, 'points', theorems)} | {cell(rule, 'domains', theorems)} |" for rule in rules()]


def table(lines, header):
    """Where the rows of the table with this header begin and end."""
    begin = end = lines.index(header) + 2
    while end < len(lines) and lines[end].startswith("|"):
        end += 1
    return begin, end


def failing_rows():
    """What the corpus says fails: the rules, and of what, without options that nothing is proved of."""
    for path, of in (("corpus/expected.tsv", "points"), ("corpus/domains/expected.tsv", "domains")):
        for line in text(path).splitlines():
            fields = line.split("\t")
            if fields[-1] != "holds" and "--within" not in line:
                yield from ((rule, of) for rule in fields[-1].split(",") if rule in rules())


def faults_of_rules(theorems):
    named = set(re.findall(r'"([a-z]+\.[a-z-]+)"', text("proofs/MainTheorems.v")))
    for rule in rules():
        lacking = [of for of in ("points", "domains") if is_judged(rule, of) and (rule, of) not in theorems]
        for of in ("points", "domains"):
            if (rule, of) in theorems and not is_judged(rule, of):
                yield f"{RULES}: {rule} is not judged of {of}, and a refutation in proofs/mutants/ is accepted"
        if lacking and not TABLE[rule].unproved:
            yield f"{RULES}: {rule} of {' and of '.join(lacking)} is to be proved (a refutation in proofs/mutants/ is accepted), or to say why not"
        if not lacking and TABLE[rule].unproved:
            yield f"{RULES}: {rule} is proved, and its row says why not"
        if (rule in named) != any((rule, of) in theorems for of in ("points", "domains")):
            yield f"proofs/MainTheorems.v: {rule} is to be named if and only if a refutation in proofs/mutants/ names it"
    for rule in sorted(named - set(rules())):
        yield f"proofs/MainTheorems.v: {rule} is not a rule of {RULES}"
    for rule, of in sorted({row for row in failing_rows() if not is_judged(*row)}):
        yield f"{RULES}: {rule} is judged of {of}: the corpus has such a mesh"


# Which theorem says that a rule is broken, and which one names the rules.
NAMED_BY = {"verified_rule": "rules_of_points", "verified_domain_rule": "rules_of_domains", "verified_whole_domain_rule": "rules_of_whole_domains",
            "verified_not_complex": "rules_of_complexes", "verified_not_hull": "rules_of_hulls", "verified_not_flat": "rules_of_flats",
            "verified_not_periodic": "rules_of_periodic"}


def faults_of_theorems(theorems):
    """Each theorem about rules names those of which a refutation is accepted, one by one."""
    source = text("proofs/MainTheorems.v")
    for theorem, of_names in NAMED_BY.items():
        statement = source.split(f"Theorem {of_names} ", 1)[1].split("Proof.", 1)[0]
        named = {name for names in re.findall(r'"([a-z. -]+)"', statement) for name in names.split(" or ")}
        accepted = {rule for (rule, _), names in theorems.items() if theorem in names and rule in TABLE}
        for rule in sorted(named ^ accepted):
            yield f"proofs/MainTheorems.v: {rule} is to be in {of_names} if and only if proofs/mutants/ has a refutation by {theorem}"


def faults_of_trust(lines):
    """What extraction replaces is among what is trusted, and so are as many lines of OCaml as there are."""
    begin = lines.index("## What is trusted")
    trusted = "\n".join(lines[begin:lines.index("## Check it yourself")])
    replacing = {name.lower() for name in re.findall(r'"(?:\()?([A-Z][a-z]+)\.', text("proofs/Extraction.v"))} & {path.stem for path in OCAML.glob("*.ml")}
    for name in sorted(replacing - {"big"}):  # which is Zarith's
        if f"`{name}.ml`" not in trusted:
            yield f"{PAGE}: {name}.ml replaces what is proved, and is not among what is trusted"
    count = sum(len(path.read_text(encoding="utf-8").splitlines()) for path in OCAML.glob("*.ml") if path.stem not in {*replacing, "quick_test", "answers"})
    if f"the {count // 100 * 100:,} lines" not in trusted:
        yield f"{PAGE}: proofs/ocaml has {count} lines that are trusted, and the page says another number"


def faults_of_claims(lines):
    claims = set(re.search(r"--claim ([a-z|-]+)", text("docs/command-line.md"))[1].split("|"))
    begin, end = table(lines, CLAIMS)
    listed = set(re.findall(r"`([a-z-]+)`", " ".join(line.split("|")[1] for line in lines[begin:end])))
    if listed != claims:
        yield f"{PAGE}: the table has the claims {sorted(listed)}, and check {sorted(claims)}"
    theorems = set(re.findall(r"^Theorem (\w+)", text("proofs/MainTheorems.v"), re.MULTILINE))
    used = set(re.findall(r"`(\w+_\w+|verified)`", "\n".join(lines)))
    for name in sorted(used - theorems):
        yield f"{PAGE}: proofs/MainTheorems.v has no theorem {name}"
    for name in sorted(theorems - used):
        yield f"{PAGE}: no table has the theorem {name}"


DEFINITIONS = ("Definitions", "Domains", "DomainRules", "Complexes", "Hulls", "Flats", "Surfaces", "Periodic")
# What an honest certificate is; of its notions only those that the main theorems name.
OF_COMPLETENESS = "completeness/Honest"


def without_comments(source):
    return re.sub(r"\(\*.*?\*\)", "", source, flags=re.DOTALL)


def notions():
    """All that is defined in the files of definitions, but for the records of what stands in a file, which are in no section."""
    named = set(re.findall(r"\w+", without_comments(text("proofs/MainTheorems.v"))))
    for name in (*DEFINITIONS, OF_COMPLETENESS):
        depth = 0
        for line in without_comments(text(f"proofs/{name}.v")).splitlines():
            depth += line.startswith("Section ") - line.startswith("End ")
            found = re.match(r"(Definition|Fixpoint|Inductive|Record) (\w+)", line)
            if found and (found[1] in ("Definition", "Fixpoint") or depth > 0) and (name != OF_COMPLETENESS or found[2] in named):
                yield found[2]


def faults_of_imports():
    """The main theorems are stated in notions of the page and in functions that are extracted."""
    def imported(path):
        source = without_comments(text(path))
        return {name for names in re.findall(r"From Circumspect Require (?:Import |Export )?([\w\s]+)\.", source) for name in names.split()}
    files = {path.stem: path.relative_to(ROOT) for path in (ROOT / "proofs").glob("**/*.v")}
    program, further = set(), imported("proofs/Extraction.v")
    while further:
        program |= further
        further = {name for one in further for name in imported(files[one])} - program
    source = without_comments(text("proofs/MainTheorems.v"))
    stated = {name for names in re.findall(r"From Circumspect Require Import ([\w\s]+)\.", source) for name in names.split()}
    for name in sorted(stated - program - {path.split("/")[-1] for path in (*DEFINITIONS, OF_COMPLETENESS)}):
        yield f"proofs/MainTheorems.v: {name} is neither of the program nor a file whose notions stand in docs/theory/definitions.md"


def faults_of_notions():
    page = "docs/theory/definitions.md"
    listed = [name for line in text(page).splitlines() if line.startswith("| `")
              for name in re.findall(r"`(\w+)`", line.split("|")[1])]
    for name in sorted(set(notions()) - set(listed)):
        yield f"{page}: the notion {name} is left out"
    for name in sorted(set(listed) - set(notions())):
        yield f"{page}: {name} is not a notion of the definitions in proofs/"
    for name, meaning in re.findall(r"^\| `[^|]*\| `([a-z]+\.[a-z-]+)`: ([^|]*) \|", text(page), re.MULTILINE):
        if name not in TABLE or TABLE[name].meaning != meaning:
            yield f"{page}: the words of {name} are not those of {RULES}"


def main(arguments):
    lines = text(PAGE).splitlines()
    theorems = shown()
    begin, end = table(lines, HEADER)
    if arguments == ["--update"]:
        lines[begin:end] = rows(theorems)
        (ROOT / PAGE).write_text("\n".join(lines) + "\n", encoding="utf-8")
    found = [*faults_of_rules(theorems), *faults_of_claims(lines), *faults_of_notions(), *faults_of_imports(), *faults_of_theorems(theorems),
             *faults_of_trust(lines)]
    if lines[begin:end] != rows(theorems) and not arguments:
        found.append(f"{PAGE}: the table of rules is another: run tidy/proved.py --update")
    print("\n".join(found) if found else "every rule and every claim is proved, or said not to be")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
