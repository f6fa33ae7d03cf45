"""Writes corpus/accept, corpus/reject, corpus/peers/inputs, corpus/domains and the tables: python3 corpus/make/make.py

peers.sh, beside this file, writes corpus/peers/tetgen, qhull and cgal, and domain_peers.sh writes
corpus/domains/tetgen and gmsh; they need the inputs made here.
"""
import accept
import domain_accept
import domain_invalid
import domain_meshes
import domain_reject
import domain_tables
import domain_within
import domain_written
import domains
import files
import hulls
import mesh_alone
import quality
import reject
import surfaces
import tables
import voronoi
from inputs import inputs

entries = [*accept.entries(), *reject.entries(), *mesh_alone.entries(), *hulls.entries(), *surfaces.entries(),
           *quality.entries()]
for entry in entries:
    files.write(entry)
for name, _, points in inputs():
    target = files.CORPUS / "peers/inputs" / f"{name}.node"
    target.parent.mkdir(parents=True, exist_ok=True)
    files.write_node(target, points, len(points[0]))
tables.write(entries)
voronoi.write_all()

domain_entries = [*domain_accept.entries(), *domain_reject.entries(), *domain_within.entries()]
domains.write()
domain_invalid.write()
for entry in domain_entries:
    domain_meshes.write(entry)
domain_written.write()
domain_tables.write(domain_entries, domain_invalid.entries())
