"""Writes expected.tsv, which the tests read, and PROVENANCE.md, which people read.

The verdicts of accept/ and reject/ come with their entries. Those of peers/ are facts about what the
programs wrote: they stand in expected.tsv, are kept, and are shown in PROVENANCE.md. A new output gets
the verdict "?", to be replaced by hand once it is understood. Rows of regressions/ are kept as they are.
"""
from files import CORPUS
from inputs import HUNTED, inputs

PEERS = [("tetgen", "", "TetGen"), ("qhull", "", "Qhull `Qt`"), ("qhull", "--point-at-infinity", "Qhull `Qt Qz`"),
         ("qhull", "--joggled", "Qhull `QJ`"), ("cgal", "", "CGAL"), ("cgal", "--inexact-kernel", "CGAL, inexact kernel")]

HEADER = """\
# Where the corpus comes from

A mesh is judged under a claim. `expected.tsv` says for each mesh: its path, the claim (with further
options of `circumspect check`), and the verdict, `holds` or the set of rules that it breaks; the test
`corpus_test.cpp` holds both checkers to it. This page says what each entry is and who made it. Both
tables are written by `corpus/make/make.py`.

`accept/` and `reject/` are ours: `python3 corpus/make/make.py` (Python 3.11, standard library only) writes
them, with exact integer arithmetic of its own that shares no line with the project. A file of
`reject/` is named after the one rule that it breaks, up to `--`. A verdict is of the claim `delaunay`
where no other is given.

A new case is a few lines in `make/accept.py` or `make/reject.py`, or a new `peers/inputs/NAME.node` with its
line in `make/inputs.py` and a run of `make/peers.sh`; then run `make/make.py`. A mesh that was once judged
wrongly goes to `regressions/`, which has its own list. Domains, meshes of them, and inputs that are no
piecewise linear complexes are in `domains/`: [domains/README.md](domains/README.md).

"""

PEERS_HEADER = """
## peers/: what other programs made of the same points

`corpus/make/peers.sh` ran, with the Debian 12 packages tetgen 1.5.0-5, qhull-bin 2020.2-5 and libcgal-dev
5.5.1-2 on amd64, for every input NAME of `peers/inputs/`:

| kept as | command |
| --- | --- |
| `peers/tetgen/NAME.1.ele`, `.1.node`, `.1.neigh` | `tetgen -n NAME.node` |
| `peers/qhull/NAME.qhull-i` | `qdelaunay Qt i < NAME.qhull` |
| `peers/qhull/NAME--point-at-infinity.qhull-i` | `qdelaunay Qt Qz i < NAME.qhull` |
| `peers/qhull/NAME--joggled.qhull-i` | `qdelaunay QJ i < NAME.qhull` |
| `peers/cgal/NAME.ele` | `delaunay_3 NAME.node NAME.ele` or `delaunay_2` (`make/cgal/`), the exact-predicates kernel |
| `peers/cgal/NAME--inexact-kernel.ele` | the same with `--inexact`: `Simple_cartesian<double>`, against which CGAL's manual warns |

The verdicts, of the claim `delaunay` (for TetGen, which was asked for the neighbours too, `delaunay
--neighbors`), judge what was written against the exact coordinates of the input. Qhull does not claim
more than its tolerances: with `QJ` it solves a joggled input by design, and its manual says that `Qt` may
leave flat simplices; TetGen may ignore points that are nearly duplicates. Such outputs are entries
because a reader of a mesh cannot see what its writer tolerated. "none" means that no mesh was made
(`.failed` holds the program's exit code, 124 after 10 seconds, and its complaint).

| input | what it is | """


def cell(text):
    return text.replace("|", "\\|")


def own_rows(entries, folder):
    lines = ["| entry | what it is, or why it is nasty | expected |", "| --- | --- | --- |"]
    for e in entries:
        if e.path.startswith(folder):
            verdicts = "; ".join(f"`{v}`" if c == "delaunay" else f"`{v}` ({c})" for c, v in e.claims)
            lines.append(f"| `{e.mesh}` | {cell(e.what)} | {verdicts} |")
    return lines


def peer_mesh(program, name, suffix):
    extension = {"tetgen": ".1.ele", "qhull": ".qhull-i", "cgal": ".ele"}[program]
    return f"peers/{program}/{name}{suffix}{extension}"


def peer_claim(mesh):
    """TetGen's neighbours are judged as well."""
    return "delaunay --neighbors" if mesh.startswith("peers/tetgen/") else "delaunay"


def peer_rows(rows, verdicts):
    lines = []
    for name, what, *_ in rows:
        cells = []
        for program, suffix, _ in PEERS:
            mesh = peer_mesh(program, name, suffix)
            failed = CORPUS / f"peers/{program}/{name}{suffix}.failed"
            verdict = verdicts.get(mesh, "none" if failed.exists() else "–")
            cells.append("holds" if verdict == "holds" else verdict.replace(",", ", "))
        lines.append(f"| `{name}` | {cell(what)} | " + " | ".join(cells) + " |")
    return lines


def known_rows(folder):
    table = CORPUS / "expected.tsv"
    lines = table.read_text().splitlines() if table.exists() else []
    return [line.split("\t") for line in lines if line.startswith(folder)]


def write(entries):
    named = [*((name, what) for name, what, _ in inputs()), *HUNTED]
    known = {path: verdict for path, _, verdict in known_rows("peers/")}
    meshes = [peer_mesh(program, name, suffix) for name, *_ in named for program, suffix, _ in PEERS]
    verdicts = {mesh: known.get(mesh, "?") for mesh in meshes if (CORPUS / mesh).exists()}

    rows = [(e.mesh, claim, verdict) for e in entries for claim, verdict in e.claims]
    rows += [(mesh, peer_claim(mesh), verdict) for mesh, verdict in verdicts.items()]
    rows += known_rows("regressions/")
    (CORPUS / "expected.tsv").write_text("".join("\t".join(row) + "\n" for row in rows))

    page = [HEADER + "## accept/: the claim holds\n", *own_rows(entries, "accept/"), "",
            "## reject/: exactly one rule is broken\n", *own_rows(entries, "reject/"),
            PEERS_HEADER + " | ".join(title for _, _, title in PEERS) + " |",
            "| --- | --- |" + " --- |" * len(PEERS), *peer_rows(named, verdicts)]
    (CORPUS / "PROVENANCE.md").write_text("\n".join(page) + "\n")
