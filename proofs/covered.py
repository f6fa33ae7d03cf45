#!/usr/bin/env python3
"""Counts the rows of the corpus that check decides, and of how many circumspect-verified says the same.

    proofs/covered.py CIRCUMSPECT CIRCUMSPECT_VERIFIED              tries all, and compares those without a certificate with the page
    proofs/covered.py CIRCUMSPECT CIRCUMSPECT_VERIFIED --update     the same, and writes the table and the numbers of the page anew
    proofs/covered.py CIRCUMSPECT CIRCUMSPECT_VERIFIED --listed     tries those alone that the page lists, and counts the others

Left out are rows about how simplices are listed or what is demanded beyond a claim (--neighbors, --oriented, --structure ..). The page
is docs/certificates.md; it names each row that has neither certificate nor refutation, and why. Exit code 1: a row is verified to be
what check says it is not, or certify writes a file that is not verified, or the page says something else.
"""
import collections
import difflib
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

CORPUS = pathlib.Path(__file__).resolve().parent.parent / "corpus"
PAGE = CORPUS.parent / "docs" / "certificates.md"
NUMBERS = re.compile(r"Of \d+ rows of the corpus that `check` decides, \d+ have")
HEADER = "| row of `corpus/` | verdict | why it has no certificate or refutation |\n| --- | --- | --- |"
OF_LISTS = ("--neighbors", "--oriented", "--require", "--manifold", "--connected", "--closed", "--faces", "--allow", "--only-extreme",
            "--all-boundary-points", "--structure")


def rows():
    """The words after `check`, the claim, and what is expected."""
    for line in (CORPUS / "expected.tsv").read_text().splitlines():
        mesh, claim, verdict = line.split("\t")
        yield [*mesh.split(), "--claim", *shlex.split(claim)], verdict
    for line in (CORPUS / "domains" / "expected.tsv").read_text().splitlines():
        mesh, domain, claim, verdict = line.split("\t")[:4]
        domain, *more = domain.split()
        yield [f"domains/{mesh}", "--domain", f"domains/{domain}", *more, "--claim", *shlex.split(claim)], verdict
    for line in (CORPUS / "periodic" / "expected.tsv").read_text().splitlines():
        if line and not line.startswith("#"):
            mesh, options, verdict = line.split("\t")[:3]
            yield [f"periodic/{mesh}", "--claim", "periodic-delaunay", *options.split()], verdict
    for line in (CORPUS / "voronoi" / "expected.tsv").read_text().splitlines():
        if line and not line.startswith("#"):
            mesh, points, options, verdict = line.split("\t")[:4]
            yield [f"voronoi/{mesh}", "--points", f"voronoi/{points}", "--claim", "voronoi", *options.split()], verdict


def is_decided(words):
    return not any(word.split("=")[0] in OF_LISTS for word in words)


def reason(message):
    """Why there is no certificate, in the words of certify, but for its options."""
    message = re.sub(r"^circumspect( certify)?: ([\w./-]+\.[\w-]+: )?", "", message.strip().splitlines()[0] if message.strip() else "no message")
    option = re.match("expected one of its options, found (--[a-z-]+)", message)
    return f"nothing is proved of `{option[1]}`" if option else message.removeprefix("there is no certificate of this mesh: ")


def tried(circumspect, verified, words, verdict, file):
    """Why the row has no certificate or refutation; or what is wrong with it."""
    made = subprocess.run([circumspect, "certify", *words, "-o", file, "--quiet"], cwd=CORPUS, capture_output=True, text=True)
    if made.returncode not in (0, 1):
        return reason(made.stderr), None
    line = subprocess.run([verified, file], capture_output=True, text=True).stdout.strip()
    stated = re.match("verified: (not )?", line)
    is_so = stated is not None and (stated[1] is None) == (verdict == "holds")
    return None, None if is_so else f"{' '.join(words)}: expected {verdict}, found {line}"


def table_row(words, verdict, why):
    return f"| `{' '.join(words)}` | {'holds' if verdict == 'holds' else 'fails'} | {why} |"


def page_of(page, total, lacking):
    """The page with these numbers and this table."""
    page = NUMBERS.sub(f"Of {total} rows of the corpus that `check` decides, {total - len(lacking)} have", page)
    begin = page.index(HEADER) + len(HEADER)
    end = page.index("\n\n", begin)
    return page[:begin] + "".join(f"\n{row}" for row in lacking) + page[end:]


def listed_rows(page):
    """The first cell of each row of the table."""
    begin = page.index(HEADER) + len(HEADER)
    return set(re.findall("^\\| `([^`]+)`", page[begin:page.index("\n\n", begin)], re.MULTILINE))


def main():
    circumspect, verified = (str(pathlib.Path(path).resolve()) for path in sys.argv[1:3])
    page = PAGE.read_text(encoding="utf-8")
    decided = [(words, verdict) for words, verdict in rows() if is_decided(words)]
    listed = listed_rows(page)
    covered, uncovered, lacking, wrong = collections.Counter(), collections.Counter(), [], []
    with tempfile.TemporaryDirectory() as folder:
        for words, verdict in decided:
            if "--listed" in sys.argv[3:] and " ".join(words) not in listed:
                continue
            why, fault = tried(circumspect, verified, words, verdict, f"{folder}/certificate")
            wrong += [fault] if fault else []
            lacking += [table_row(words, verdict, why)] if why else []
            key = (words[words.index("--claim") + 1], "--within" in words, verdict == "holds")
            (uncovered if why else covered)[key] += 1
    for key in sorted({*covered, *uncovered}):
        claim, within, holds = key
        print(f"{claim}{' --within' if within else ''} {'holds' if holds else 'fails'}: {covered[key]} of {covered[key] + uncovered[key]} rows verified")
    found = page_of(page, len(decided), lacking)
    if "--update" in sys.argv[3:]:
        PAGE.write_text(found, encoding="utf-8")
    elif found != page:
        changes = difflib.unified_diff(page.splitlines(), found.splitlines(), "docs/certificates.md", "as it is", lineterm="", n=0)
        wrong.append("\n".join(["run proofs/covered.py CIRCUMSPECT CIRCUMSPECT_VERIFIED --update:", *changes]))
    print(f"{len(decided) - len(lacking)} of {len(decided)} rows have a verified certificate or refutation")
    print("\n".join(wrong), file=sys.stderr, end="\n" if wrong else "")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
