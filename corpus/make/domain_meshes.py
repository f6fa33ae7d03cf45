"""A mesh of a domain, how it is written, and shapes that several entries are made of."""
from dataclasses import dataclass, field

import files
from domains import box, facets
from exact import PointSet, canonical_delaunay, oriented

HOLD = "holds"


@dataclass
class DomainMesh:
    path: str          # below corpus/domains/, without extension
    what: str          # why it is nasty
    points: list       # of the domain
    cells: list        # in space facets: [(lines, points in holes)]; in the plane segments
    mesh_points: list
    simplices: list
    claims: list       # [(claim with options, verdict)]
    listed: list = field(default_factory=list)  # triangles for the .face file, edges for the .edge file
    holes: list = field(default_factory=list)
    kind: str = ""     # for --domain-kind
    base: int = 0      # the first index of the mesh; that of the domain is 0


def poly(title, points, cells, holes, dimension):
    """The text of a .poly file."""
    rows = [f"# {title}", f"{len(points)} {dimension} 0 0"]
    rows += [" ".join([str(i), *map(files.number, p)]) for i, p in enumerate(points)]
    rows.append(f"{len(cells)} 0")
    for i, cell in enumerate(cells):
        if dimension == 2:
            rows.append(f"{i} {cell[0]} {cell[1]}")
            continue
        lines, seeds = cell
        rows.append(f"{len(lines)} {len(seeds)}")
        rows += [" ".join(map(str, (len(line), *line))) for line in lines]
        rows += [" ".join(map(str, (j, *seed))) for j, seed in enumerate(seeds)]
    rows.append(str(len(holes)))
    rows += [" ".join(map(str, (i, *hole))) for i, hole in enumerate(holes)]
    return "\n".join(rows) + "\n"


def write(entry):
    stem = files.CORPUS / "domains" / entry.path
    stem.parent.mkdir(parents=True, exist_ok=True)
    named = lambda extension: stem.with_name(stem.name + extension)
    dimension = len(entry.points[0])
    named(".poly").write_text(poly(entry.what, entry.points, entry.cells, entry.holes, dimension))
    files.write_node(named(".node"), entry.mesh_points, dimension, entry.base)
    files.write_ele(named(".ele"), entry.simplices, dimension + 1, entry.base)
    files.write_listed(stem, entry.listed, entry.base)


# Shapes. A cube's vertices are numbered by bits: 1 for x, 2 for y, 4 for z.

CUBE, CUBE_SQUARES = box((0, 0, 0), (4, 4, 4))
FIVE = [(0, 3, 5, 6), (0, 1, 3, 5), (0, 2, 3, 6), (0, 4, 5, 6), (3, 5, 6, 7)]
L_OUTLINE = [(0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)]
L_TRIANGLES = [(0, 1, 3), (1, 2, 3), (0, 3, 5), (3, 4, 5)]
RING = [(0, 0), (9, 0), (9, 9), (0, 9), (3, 3), (6, 3), (6, 6), (3, 6)]
RING_LINES = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4)]
RING_TRIANGLES = [(0, 1, 4), (1, 4, 5), (1, 2, 5), (2, 5, 6), (2, 3, 6), (3, 6, 7), (0, 3, 7), (0, 4, 7)]
# A flat quadrilateral: the circumdisk of either half over its long diagonal holds the other apex.
KITE = [(0, 0), (8, 0), (4, 1), (4, -1)]
KITE_OUTLINE = [(0, 2), (2, 1), (1, 3), (3, 0)]
BIPYRAMID = [(4, 0, 0), (-3, 3, 0), (-3, -3, 0), (0, 0, 5), (0, 0, -5)]
BIPYRAMID_SIDES = [(i, (i + 1) % 3, apex) for i in range(3) for apex in (3, 4)]


def cycle(n):
    return [(i, (i + 1) % n) for i in range(n)]


def prisms(triangles, points, height):
    """Right prisms over triangles of the plane, each in three tetrahedra that fit those beside it."""
    n = len(points)
    tetrahedra = []
    for t in triangles:
        a, b, c = sorted(t)
        tetrahedra += [(a, b, c, c + n), (a, b, b + n, c + n), (a, a + n, b + n, c + n)]
    return [(*p, 0) for p in points] + [(*p, height) for p in points], tetrahedra


def prism_facets(outline, n, walls=()):
    """The facets of the prism over the outline, vertices of the plane, with vertical walls inside."""
    sides = [(a, b, b + n, a + n) for a, b in [*zip(outline, outline[1:] + outline[:1]), *walls]]
    return facets([tuple(outline), tuple(v + n for v in outline), *sides])


def all_positive(points, simplices):
    s = PointSet(points)
    return [oriented(s, t) for t in simplices]


def delaunay_inside(points, is_inside):
    """The canonical Delaunay simplices whose barycentres are inside."""
    d = len(points[0])
    middle = lambda t: [sum(points[v][i] for v in t) / (d + 1) for i in range(d)]
    return [t for t in canonical_delaunay(points) if is_inside(middle(t))]
