"""Writes corpus/accept, corpus/reject, corpus/peers/inputs and the tables: python3 corpus/make/make.py

peers.sh, beside this file, writes corpus/peers/tetgen, qhull and cgal; it needs the inputs made here.
"""
import accept
import files
import reject
import tables
from inputs import inputs

entries = [*accept.entries(), *reject.entries()]
for entry in entries:
    files.write(entry)
for name, _, points in inputs():
    target = files.CORPUS / "peers/inputs" / f"{name}.node"
    target.parent.mkdir(parents=True, exist_ok=True)
    files.write_node(target, points, len(points[0]))
tables.write(entries)
