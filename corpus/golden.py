#!/usr/bin/env python3
"""Golden bytes: what the command prints of every file of the corpus, and its exit codes.

    golden.py COMMAND             compare with golden.tsv; exit 1 and name what differs
    golden.py COMMAND --update    write golden.tsv
    golden.py COMMAND --one-in 8  compare one row in eight

CIRCUMSPECT_ONE_INPUT_IN=4 in the environment, as `make test` has it, compares one JSON report in four, and all texts but the two
that take longest.

A row is a command line, run in the folder of the corpus; its exit code; the first 16 digits of the SHA-256 of what
it printed on standard output and error; and its last line, so that a reader sees what has changed. A change of
the inside of the program leaves every row as it is. A change of a message changes rows on purpose: read
the difference before you commit it.
"""
import argparse
import concurrent.futures
import hashlib
import os
import pathlib
import shlex
import subprocess
import sys

CORPUS = pathlib.Path(__file__).resolve().parent
TABLE = CORPUS / "golden.tsv"
FAMILIES = ["uniform", "grid", "sphere+ulp", "submerged", "duplicates", "mixed-exponents"]
# Without these limits seven inputs would take as long as all others together: the command searches
# for a triangulation of the domains, and in the point sets for a sphere through too many points.
# The row of figure-4-13-chazelle-2.poly has no limit and searches to the end.
LIMITED = {"domains/landscape.poly": " --search-vertices 50",
           "domains/figure-4-13-chazelle-3.poly": " --search-vertices 20",
           "domains/chazelle-outer-notches.poly": " --search-vertices 20",
           "accept/weighted-random.node": " --subsets 5000",
           "accept/rotated-grid.node": " --subsets 5000",
           "accept/grid-one-ulp.node": " --subsets 5000",
           "accept/clusters.node": " --subsets 5000"}
# A seventh of the time of all others together. `corpus_test` asks for their verdicts, too.
SLOW = ["check peers/cgal/rotated-grid-3d--inexact-kernel.ele --claim delaunay", "inspect domains/figure-4-13-chazelle-2.poly"]
DOMAIN_FAMILIES = ["protected-solids", "planar-segments", "furnished-boxes", "named-complexes"]


def rows(table):
    for line in (CORPUS / table).read_text(encoding="utf-8").splitlines():
        if line and not line.startswith("#"):
            yield line.split("\t")


def names(folder, *endings):
    return sorted(path.relative_to(CORPUS).as_posix() for path in (CORPUS / folder).iterdir()
                  if path.suffix in endings)


def in_both_formats(line):
    return [line, line + " --format json"]


def is_json_of_check(line):
    return line.startswith("check ") and line.endswith("json")


def command_lines():
    """Every command line, in the order of the table."""
    lines = []
    for mesh, claim, _ in rows("expected.tsv"):
        lines += in_both_formats(f"check {mesh} --claim {claim}")
    for mesh, domain, claim, _ in (row[:4] for row in rows("domains/expected.tsv")):
        lines += in_both_formats(f"check domains/{mesh} --domain domains/{domain} --claim {claim}")
    for cells, sites, options, _, _ in rows("voronoi/expected.tsv"):
        lines += in_both_formats(f"check voronoi/{cells} --points voronoi/{sites} --claim voronoi {options}".strip())
    for mesh, options, _, _ in rows("periodic/expected.tsv"):
        lines += in_both_formats(f"check periodic/{mesh} --claim periodic-delaunay {options}")
    for row in rows("findings/expected.tsv"):
        (claim, *kind), points, mesh = row[1].split(), row[3], row[4]
        if mesh == "-":
            continue
        about = f" --domain findings/{points} --domain-kind {kind[0]}" if kind else f" --points findings/{points}"
        if claim == "voronoi":
            about = f" --points findings/{points} --within {kind[0]}"
        lines += in_both_formats(f"check findings/{mesh}{about} --claim {claim}")
    for arguments, _, _ in rows("domains/written/written.tsv"):
        words = [f"domains/{word}" if word.startswith("written/") else word for word in arguments.split()]
        lines += in_both_formats("check " + " ".join(words))
    for domain, _ in rows("domains/invalid.tsv"):
        lines += in_both_formats(f"inspect domains/{domain}")
    for domain in names("domains", ".poly"):
        lines.append(f"inspect {domain}" + LIMITED.get(domain, ""))
    for path in names("malformed", ".ele", ".mesh", ".off", ".json", ".qhull-i"):
        lines.append(f"check {path}")
    for path in names("malformed", ".poly", ".smesh", ".stl", ".ply"):
        lines.append(f"inspect {path}")
    for path in names("accept", ".node"):
        lines += [f"inspect {path}" + LIMITED.get(path, ""), f"build delaunay {path} --format json"]
    for family in FAMILIES + DOMAIN_FAMILIES:
        lines.append(f"generate {family} --seed 1")
    return list(dict.fromkeys(lines))


def row_of(command, line):
    run = subprocess.run([command, *shlex.split(line)], cwd=CORPUS, capture_output=True, check=False,
                         stdin=subprocess.DEVNULL)
    digest = hashlib.sha256(run.stdout + b"\0" + run.stderr).hexdigest()[:16]
    printed = (run.stdout + run.stderr).decode("utf-8", "replace").splitlines()
    last = printed[-1] if printed and not line.endswith("--format json") else ""
    return "\t".join([line, str(run.returncode), digest, last.replace("\t", " ")[:200]])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("command", type=os.path.abspath)
    parser.add_argument("--update", action="store_true")
    parser.add_argument("--one-in", type=int, default=1, metavar="N")
    options = parser.parse_args()
    one_in = 1 if options.update else int(os.environ.get("CIRCUMSPECT_ONE_INPUT_IN", "1"))
    lines = [line for i, line in enumerate(command_lines())
             if one_in == 1 or (line not in SLOW and (not is_json_of_check(line) or i // 2 % one_in == 0))]
    if not options.update:
        lines = lines[::options.one_in]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        found = list(pool.map(lambda line: row_of(options.command, line), lines))
    if options.update:
        TABLE.write_text("\n".join(found) + "\n", encoding="utf-8")
        return 0
    expected = {line.split("\t")[0]: line for line in TABLE.read_text(encoding="utf-8").splitlines()}
    for left_out in set(command_lines()) - set(lines):
        expected.pop(left_out, None)
    different = [(expected.pop(row.split("\t")[0], "no row"), row) for row in found]
    different = [pair for pair in different if pair[0] != pair[1]] + [(row, "no run") for row in expected.values()]
    for was, now in different[:20]:
        print(f"expected {was}\nfound    {now}")
    print(f"golden: {len(found)} command lines, {len(different)} differ"
          + ("; golden.py COMMAND --update writes them anew" if different else ""))
    return 1 if different else 0


if __name__ == "__main__":
    sys.exit(main())
