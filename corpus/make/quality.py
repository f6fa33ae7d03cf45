"""Meshes with a simplex that does not keep what is required of its shape, and no other fault."""
from exact import canonical_delaunay
from reject import reject

HOUSE = [(0, 0), (10, 0), (10, 8), (0, 8), (5, 1)]                                  # a thin triangle below
PYRAMIDS = [(0, 0, 0), (10, 0, 0), (5, 9, 0), (5, 3, 1), (5, 3, -60)]                # a flat one on a steep one


def required(measure, bound, what, points, looser):
    """A mesh that breaks the requirement, and holds without it, and with another bound."""
    rule = f"quality.{measure}"
    return reject(rule, what, points, canonical_delaunay(points),
                  claims=[(f"complex --require {measure}:{bound}", rule), ("delaunay", "holds"),
                          (f"complex --require {measure}:{looser}", "holds")])


def entries():
    thin = "a rectangle cut from a point near its lower side: the triangle below is thin"
    flat = "a flat pyramid on a triangle, above a steep one"
    yield required("min-angle", "20deg", thin, HOUSE, "11.3deg")
    yield required("max-angle", "150deg", thin, HOUSE, "157.4deg")
    yield required("area", "30", thin, HOUSE, "35")
    yield required("radius-edge", "sqrt(2)", thin, HOUSE, "sqrt(13/2)")
    yield required("aspect-ratio", "4", thin, HOUSE, "10")
    yield required("edge", "9.5", thin, HOUSE, "10")
    yield required("min-edge", "6", thin, HOUSE, "sqrt(26)")
    yield required("min-dihedral", "20deg", flat, PYRAMIDS, "1deg")
    yield required("max-dihedral", "140deg", flat, PYRAMIDS, "179deg")
    yield required("volume", "100", flat, PYRAMIDS, "900")
