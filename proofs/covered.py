#!/usr/bin/env python3
"""Counts the rows of the corpus that check decides, and of how many circumspect-verified says the same.

    proofs/covered.py CIRCUMSPECT CIRCUMSPECT_VERIFIED

Left out are rows about how simplices are listed or what is demanded beyond a claim (--neighbors, --oriented, --structure ..). It
prints how many rows of each claim have a verified certificate or refutation, and why the others have none. Exit code 1: a row is
verified to be what check says it is not, or certify writes a file that is not verified.
"""
import collections
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

CORPUS = pathlib.Path(__file__).resolve().parent.parent / "corpus"
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


def reason(message):
    """Why there is no certificate, without names and numbers."""
    message = message.strip().splitlines()[-1] if message.strip() else "no message"
    message = re.sub(r"^circumspect: |^usage: ", "", message)
    return re.sub(r"[\w./-]+\.(ele|off|obj|qhull-i|json|vtk|mesh): ", "", re.sub(r"\d+", "N", message))[:110]


def main():
    circumspect, verified = (str(pathlib.Path(path).resolve()) for path in sys.argv[1:3])
    covered, lacking, wrong = collections.Counter(), collections.defaultdict(collections.Counter), []
    with tempfile.TemporaryDirectory() as folder:
        file = f"{folder}/certificate"
        for words, verdict in rows():
            if any(word.split("=")[0] in OF_LISTS for word in words):
                continue
            claim = words[words.index("--claim") + 1]
            if "--within" in words:
                claim += " --within"
            made = subprocess.run([circumspect, "certify", *words, "-o", file, "--quiet"], cwd=CORPUS, capture_output=True, text=True)
            if made.returncode not in (0, 1):
                lacking[claim, "holds" if verdict == "holds" else "fails"][reason(made.stderr)] += 1
                continue
            line = subprocess.run([verified, file], capture_output=True, text=True).stdout.strip()
            stated = re.match("verified: (not )?", line)
            if stated is None or (stated[1] is None) != (verdict == "holds"):
                wrong.append(f"{' '.join(words)}: expected {verdict}, found {line}")
            covered[claim, "holds" if verdict == "holds" else "fails"] += 1
    for key in sorted({*covered, *lacking}):
        print(f"{' '.join(key)}: {covered[key]} of {covered[key] + lacking[key].total()} rows verified")
        for why, count in lacking[key].most_common():
            print(f"    {count} {why}")
    total = sum(covered.values())
    print(f"{total} of {total + sum(why.total() for why in lacking.values())} rows have a verified certificate or refutation")
    print("\n".join(wrong), file=sys.stderr, end="\n" if wrong else "")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
