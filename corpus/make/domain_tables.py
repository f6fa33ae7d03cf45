"""Writes domains/expected.tsv, which the tests read, and domains/README.md, which people read.

The verdicts of accept/ and reject/ come with their entries. Those of tetgen/ and gmsh/ are facts about what
the programs wrote: they stand in expected.tsv and are kept. A new output gets the verdict "?", to be
replaced by hand once it is understood, with a line in domain_notes.py if it is not `holds`.
"""
from domain_notes import NOTES
from domains import domains
from files import CORPUS
from tables import cell

FOLDER = CORPUS / "domains"
SURFACES = {
    "joint": ("joint.off", "a mechanical part, 446 triangles, many of them coplanar", "libcgal-demo 5.5.1-2, `data/meshes/joint.off`, CC0 1.0"),
    "pig": ("pig.off", "a sculpture, 891 triangles", "libcgal-demo 5.5.1-2, `data/meshes/pig.off`, CC0 1.0"),
    "torus_quad": ("torus_quad.off", "a torus of 25 quadrilaterals", "libcgal-demo 5.5.1-2, `data/meshes/torus_quad.off`, CC0 1.0"),
    "shape": ("shape.stl", "a mechanical part, 494 triangles",
              "occt-misc 7.6.3+dfsg1-7, `data/stl/shape.stl`, LGPL-2.1 with OpenCASCADE exception"),
}
# What validation says of a surface; the test holds it to that.
SURFACE_VERDICTS = {"joint.off": "valid", "shape.stl": "valid", "pig.off": "plc.segment-pierces-polygon",
                    "torus_quad.off": "plc.polygon-not-planar"}

HEADER = """\
# Domains, and meshes of them

Written by `corpus/make/make.py`, except for `tetgen/` and `gmsh/`, which `corpus/make/domain_peers.sh` writes.

`expected.tsv` has for each mesh its path, the domain with options for it, the claim with further options,
and the verdict, `holds` or the set of rules that it breaks. `invalid.tsv` lists the inputs that are not piecewise
linear complexes, with the breaches of each; `circumspect check` and `inspect` end with exit code 3 on it.
`corpus/domains_test.cpp` compares the judges with both tables, by lemma and, for small meshes, by definition.

`NAME.poly` is a domain, and `NAME.geo` is the same domain for Gmsh. `accept/` and `reject/` hold meshes made by hand or by
exact integer arithmetic that shares no line with the project, each beside its own domain. The name of a file in
`reject/` is, up to `--`, a rule that it breaks; that of a file in `invalid/` is its breach. A verdict is about the first
claim that is listed.

`written/` has small surfaces as programs write them, and meshes of these, for the options that say what is meant: polygons of one
plane, hollows, dangling pieces, labels of cells, rounded coordinates. `written/written.tsv` has the arguments of `circumspect
check`, the verdict, and what the example shows; `command/check/written_command_test.cpp` runs them.

"""

PEERS_HEADER = """
## tetgen/ and gmsh/: what other programs made of the domains

With the Debian 12 packages tetgen 1.5.0-5 and gmsh 4.8.4 on amd64:

| kept as | command | claim |
| --- | --- | --- |
| `tetgen/NAME.1.*` | `tetgen -p NAME.poly` | `steiner-cdt`: the manual says constrained Delaunay, with Steiner points where needed |
| `tetgen/NAME--hull.1.*` | `tetgen -pc NAME.poly` | `steiner-cdt` of the convex hull (`--domain-kind hull`) |
| `tetgen/NAME--quality.1.*` | `tetgen -pq1.4 NAME.poly` | `steiner-cdt` |
| `tetgen/NAME--unoptimized.1.*` | `tetgen -pq1.4O0 NAME.poly` | `steiner-cdt` |
| `gmsh/NAME.mesh` | `gmsh -3 NAME.geo` | `steiner-triangulation`: no more is promised |
| `gmsh/NAME--finer.mesh` | `gmsh -3 -clmax SIZE NAME.geo` | `steiner-triangulation` |
| `gmsh/thin-wedge--tolerance.mesh` | `gmsh -3 -setnumber Mesh.AngleToleranceFacetOverlap 0.001` | `steiner-triangulation` |

A verdict is about the exact coordinates that were written. A Steiner point that is rounded off its segment breaks
`domain.segment-missing`: the mesh has a domain that is not the one that was given to the program. The reader of the
mesh decides whether that matters.
"""

FAULTS = """
## Faults that were reduced

**TetGen 1.5.0 aborts on a vertex inside a facet that does not list it.** The input is a tetrahedron and a fifth vertex inside one of
its faces; no edge or segment need end there. With a second line `1 4` in that facet it makes three
tetrahedra. Reduced by hand from `figure-4-12-three-segments.poly`, whose squares had not listed the segments' ends.

    tetgen -p corpus/domains/unlisted-vertex.poly
    tetgen.cxx:17353: bool tetgenmesh::fillregion(...): Assertion `j >= 1' failed.

Definition 4.3 makes the vertex a face of the polygon, listed or not; this project adopts it.

**TetGen 1.5.0 aborts on a segment that is listed twice in the file**, as the edges of two facets are in every file. The
input is one tetrahedron, and one segment inside it in two facets of two corners. It was found on random segments and
triangles in a cube.

    tetgen -p corpus/domains/segment-listed-twice.poly
    tetgen.cxx:15228: void tetgenmesh::delaunizesegments(): Assertion `0' failed.

**TetGen 1.5.0 aborts on two triangles in a cube.** They have 13 vertices with small integers for coordinates. The PLC is valid, and
has no constrained Delaunay triangulation without Steiner points (`inspect` proves it); `build steiner-cdt` needs two.

    tetgen -p corpus/domains/two-triangles.poly
    tetgen.cxx:16181: bool tetgenmesh::fillcavity(...): Assertion `ori != 0' failed.

In a hunt of 404 valid PLCs, random segments and triangles with small integer coordinates in a cube, `tetgen -p` made
400 meshes and aborted four times. 195 are Steiner CDTs. 205 miss segments, 752 in all, and inside each of these lies
a Steiner point that rounding moved off it, by at most 7.7e-16 (other faults are not judged then). Of 123 meshes
of `tetgen -pq1.4` of such PLCs 86 miss segments and 16 break nothing but `cdt.facet-not-local`; on 62 of the PLCs, with
`O0`, none does.

**Gmsh 4.8.4 aborts in the recovery of facets.** Reduced from `figure-4-13-chazelle-3.geo` to two notches below and two
above, 32 vertices and 18 facets. Without any one notch, or in a larger box, there is a mesh.

    gmsh -3 corpus/domains/chazelle-outer-notches.geo
    meshGRegionBoundaryRecovery.cpp:884: reconstructmesh(void*): Assertion `ge != nullptr' failed.
"""


def table(head, rows):
    return [f"| {' | '.join(head)} |", "|" + " --- |" * len(head), *(f"| {' | '.join(row)} |" for row in rows), ""]


def verdict_text(verdict):
    return verdict.replace(",", ", ")


def own_table(entries, folder):
    rows = []
    for e in entries:
        if not e.path.startswith(folder):
            continue
        (claim, verdict), *more = e.claims
        further = "; ".join(f"`{c}`: {verdict_text(v)}" for c, v in more)
        kind = f" --domain-kind {e.kind}" if e.kind else ""
        rows.append((f"`{e.path}.ele`{kind}", cell(e.what), f"`{claim}`: {verdict_text(verdict)}", further or "–"))
    return table(("mesh", "what it is, or why it is nasty", "claim and verdict", "other claims"), rows)


def peer_meshes():
    return sorted([*FOLDER.glob("tetgen/*.1.ele"), *FOLDER.glob("gmsh/*.mesh")])


def peer_domain(mesh):
    full = mesh.name.removesuffix(".1.ele").removesuffix(".mesh")
    name = full.split("--")[0]
    path = f"surfaces/{SURFACES[name][0]}" if name in SURFACES else f"{name}.poly"
    return path + (" --domain-kind hull" if full.endswith("--hull") else "")


def peer_rows():
    table_file = FOLDER / "expected.tsv"
    lines = [line.split("\t") for line in table_file.read_text().splitlines()] if table_file.exists() else []
    known = {line[0]: line[3] for line in lines}
    rows = []
    for mesh in peer_meshes():
        path = mesh.relative_to(FOLDER).as_posix()
        claim = "steiner-cdt" if path.startswith("tetgen/") else "steiner-triangulation"
        rows.append((path, peer_domain(mesh), claim, known.get(path, "?")))
    return rows


def counts(rows):
    """One line: how many domains, meshes, verdicts."""
    names = {row[1].split()[0] for row in rows}
    parts = []
    for program, title in (("tetgen/", "TetGen"), ("gmsh/", "Gmsh")):
        own = [row for row in rows if row[0].startswith(program)]
        held = sum(row[3] == "holds" for row in own)
        failed = len([*FOLDER.glob(f"{program}*.failed")])
        parts.append(f"{title}: {held} of {len(own)} meshes hold, {failed} inputs got no mesh")
    return f"{len(names)} domains have been judged. " + ". ".join(parts) + "."


def peer_table(rows):
    rows = [(f"`{path}`", f"`{claim}`", verdict_text(verdict), NOTES.get(path, "")) for path, _, claim, verdict in rows]
    rows += [(f"`{path}`", "–", "none", NOTES.get(path, ""))
             for path in sorted(f.relative_to(FOLDER).as_posix() for f in FOLDER.glob("*/*.failed"))]
    return table(("mesh", "claim", "verdict", "why"), rows)


def write(entries, invalid):
    own = [(f"{e.path}.ele", f"{e.path}.poly" + (f" --domain-kind {e.kind}" if e.kind else ""), claim, verdict)
           for e in entries for claim, verdict in e.claims]
    peers = peer_rows()
    (FOLDER / "expected.tsv").write_text("".join("\t".join(row) + "\n" for row in [*own, *peers]))

    breaches = [(f"invalid/{name}.poly", kinds, what) for name, what, kinds in invalid]
    surfaces = [(f"surfaces/{file}", SURFACE_VERDICTS[file]) for file, _, _ in SURFACES.values()]
    (FOLDER / "invalid.tsv").write_text("".join(f"{path}\t{kinds}\n" for path, kinds, _ in breaches)
                                        + "".join(f"{path}\t{verdict}\n" for path, verdict in surfaces))

    page = [HEADER + "## Domains\n", *table(("domain", "what it is, or why it is nasty"), [(f"`{d.name}.poly`", cell(d.what)) for d in domains()]),
            "## surfaces/: domains that others made\n",
            *table(("surface", "what it is", "from the Debian 12 package", "`circumspect inspect --domain`"),
                   [(f"`surfaces/{file}`", what, origin, SURFACE_VERDICTS[file]) for file, what, origin in SURFACES.values()]),
            "## accept/: some claim holds\n", *own_table(entries, "accept/"),
            "## reject/: wrong meshes\n", *own_table(entries, "reject/"),
            "## invalid/: not piecewise linear complexes\n",
            *table(("input", "what is wrong", "breaches"), [(f"`{path}`", cell(what), verdict_text(kinds)) for path, kinds, what in breaches]),
            PEERS_HEADER, counts(peers) + "\n", *peer_table(peers), FAULTS.strip("\n")]
    (FOLDER / "README.md").write_text("\n".join(page) + "\n")
