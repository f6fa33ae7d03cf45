"""Draws what certificates are about: point sets and domains of `circumspect generate`, lattices; and breaks the meshes of them."""
import collections
import itertools
import pathlib
import shutil
from fractions import Fraction

FAMILIES = {
    "domain": ("planar-segments", "planar-grid", "furnished-boxes", "delaunay-polyhedra", "protected-solids", "glued-tetrahedra",
               "coplanar-cells", "protected-polygons", "planar-segments+rotated", "delaunay-polyhedra+ulp", "planar-grid+moved"),
    "impossible": ("twisted-prisms", "glued-tetrahedra", "named-complexes", "twisted-prisms+rotated"),
    "alone": ("uniform", "integers", "grid", "cube", "circle", "sphere", "clusters", "pyramid"),
    "hulls": ("uniform", "integers", "grid", "cube", "circle", "sphere", "clusters", "pyramid"),
    "flats": ("integers", "grid"),
    "surfaces": ("uniform", "integers", "grid", "cube", "sphere", "clusters", "pyramid"),
    "points": ("uniform", "integers", "grid", "cube", "circle", "sphere", "clusters", "pyramid", "small-weights", "submerged")}
DIMENSIONS = {"flats": (2,), "surfaces": (3,)}
PERIODIC = pathlib.Path(__file__).resolve().parent.parent / "corpus" / "periodic"
LATTICES = {"plane": "4,0,0,4", "skew": "5,1,-1,4", "space": "4,0,0,0,4,0,0,0,4", "cubes": "1,0,0,0,1,0,0,0,1"}


def drawn(programs, kind, folder, number, dice):
    """A point set or a domain, if the family has one of this seed."""
    family = dice.choice(FAMILIES[kind])
    of_points = kind not in ("domain", "impossible")
    path = folder / ("mesh.node" if of_points else "domain.poly")
    dimension = ["--dimension", dice.choice(DIMENSIONS.get(kind, (2, 3)))] if of_points else []
    ended = programs.run("generate", family, "--points", dice.randint(6, 10), "--seed", number, *dimension, "-o", path, "--quiet")
    return path if ended.returncode == 0 else None


def repeated(folder, dice):
    """A mesh that a lattice repeats, of the corpus or of one point in the plane; and the lattice, as the option says it."""
    mesh = folder / "mesh.ele"
    if dice.randrange(2):
        name = dice.choice(sorted(LATTICES))
        for ending in (".node", ".ele"):
            shutil.copy(PERIODIC / (name + ending), mesh.with_suffix(ending))
        return mesh, LATTICES[name]
    a, b = ([dice.randint(-9, 9), dice.randint(-9, 9)] for _ in range(2))
    if a[0] * b[1] == a[1] * b[0]:
        a, b = [5, 1], [-1, 4]
    # Shorter and shorter, until a, b and a + b are the shortest vectors of the lattice.
    while True:
        k = round(Fraction(sum(x * y for x, y in zip(a, b)), sum(x * x for x in a)))
        b = [y - k * x for x, y in zip(a, b)]
        if sum(y * y for y in b) >= sum(x * x for x in a):
            break
        a, b = b, a
    if sum(x * y for x, y in zip(a, b)) > 0:
        b = [-y for y in b]
    write_rows(mesh.with_suffix(".node"), [1, 2, 0], [[0, dice.randint(-9, 9), f"{dice.randint(-9, 9)}/4"]])
    write_rows(mesh, [2, 3, 6], [[0, 0, 0, 0, 0, 0, 1, 0, 1, 1], [1, 0, 0, 0, 0, 0, 1, 1, 0, 1]])
    return mesh, ",".join(map(str, [*a, *b]))


def rows_of(path):
    """The header and the rows of a file, as words."""
    header, *rows = [line.split() for line in path.read_text().splitlines() if line and not line.startswith("#")]
    return header, rows


def write_rows(path, header, rows):
    path.write_text("\n".join(" ".join(map(str, row)) for row in [header, *rows]) + "\n")


def tilted(points, dice):
    """Moves points of the plane into a plane of space, along one of the axes; or some onto a line."""
    header, rows = rows_of(points)
    if dice.randrange(3) == 0:
        direction = [dice.randrange(-2, 3), dice.randrange(1, 3), dice.randrange(-2, 3)]
        for row, along in zip(rows, dice.sample(range(40), len(rows))):
            row[1:3] = [along * x for x in direction]
    else:
        a, b, axis = dice.randrange(-2, 3), dice.randrange(-2, 3), dice.randrange(3)
        for row in rows:
            unseen = a * Fraction(row[1]) + b * Fraction(row[2])
            row[1:3] = [*row[1:1 + axis], unseen, *row[1 + axis:3]]
    write_rows(points, [header[0], 3, 0, 0], [row[:4] for row in rows])


def let_dangle(domain, dice):
    """Adds to a domain, beyond all of it, a segment or in space a triangle at one of its vertices, or a vertex alone."""
    lines = [line.split() for line in domain.read_text().splitlines() if line and not line.startswith("#")]
    count, dimension = int(lines[0][0]), int(lines[0][1])
    if count == 0:
        return
    first = int(lines[1][0])
    points = [[Fraction(x) for x in row[1:1 + dimension]] for row in lines[1:1 + count]]
    at = max(range(count), key=lambda v: points[v])
    steps = [[dice.randint(1, 4), *(dice.randint(-2, 2) for _ in range(dimension - 1))] for _ in range(2)]
    ends = [[x + y for x, y in zip(points[at], step)] for step in steps]
    how = dice.choice(("vertex", "segment", "segment", "triangle"))
    if how != "triangle" or dimension == 2 or ends[0] == ends[1]:
        del ends[1:]
    rest = lines[1 + count:]
    added = [at + first, *range(first + count, first + count + len(ends))]
    face = [] if how == "vertex" else [["1", "0"], [len(added), *added]] if dimension == 3 else [[int(rest[0][0]) + first, *added]]
    place = 1 + facet_rows(rest, dimension)
    rest[0][0] = str(int(rest[0][0]) + (how != "vertex"))
    header = [str(count + len(ends)), *lines[0][1:]]
    filler = lines[1][1 + dimension:]
    new = [[first + count + i, *end, *filler] for i, end in enumerate(ends)]
    rows = [header, *lines[1:1 + count], *new, *rest[:place], *face, *rest[place:]]
    domain.write_text("\n".join(" ".join(map(str, row)) for row in rows) + "\n")


def facet_rows(rest, dimension):
    """How many rows of a .poly file the segments are or, in space, the facets."""
    if dimension == 2:
        return int(rest[0][0])
    row = 1
    for _ in range(int(rest[0][0])):
        lines, holes = int(rest[row][0]), int(rest[row][1]) if len(rest[row]) > 1 else 0
        row += 1 + lines + holes
    return row - 1


def leave_facets(mesh):
    """Of a triangulation leaves the facets that are in one simplex; says how many vertices each has."""
    _, rows = rows_of(mesh)
    facets = collections.Counter(facet for row in rows for facet in itertools.combinations(sorted(row[1:], key=int), len(row) - 2))
    hull = [facet for facet, count in facets.items() if count == 1]
    corners = len(hull[0]) if hull else 2
    write_rows(mesh, [len(hull), corners], [[i, *facet] for i, facet in enumerate(hull)])
    return corners


def list_as_cycle(mesh):
    """Lists the hull of points in the plane as its vertices, each the first of an edge to the next."""
    _, rows = rows_of(mesh)
    beside = collections.defaultdict(list)
    for _, v, w in rows:
        beside[v].append(w)
        beside[w].append(v)
    cycle = [rows[0][1]]
    while len(cycle) < len(rows):
        further = [v for v in beside[cycle[-1]] if v not in cycle]
        cycle.append(further[0])
    write_rows(mesh, [len(rows), 1], [[i, v] for i, v in enumerate(cycle)])


def broken(mesh, dice, how):
    """Changes one thing about the simplices of an .ele file: one is left out, twice there, or has another vertex or one of another."""
    header, rows = rows_of(mesh)
    if not rows:
        return
    row = dice.randrange(len(rows))
    corners = int(header[1])
    vertices = sorted({vertex for each in rows for vertex in each[1:1 + corners]})
    if how == 0:
        del rows[row]
    elif how == 1:
        rows.append(rows[row])
    elif how == 2:
        column = dice.randrange(1, len(rows[row]))
        rows[row][column] = dice.choice(vertices if column <= corners else ("-1", "0", "1"))
    else:
        other = dice.randrange(len(rows))
        i, j = dice.randrange(1, corners + 1), dice.randrange(1, corners + 1)
        rows[row][i], rows[other][j] = rows[other][j], rows[row][i]
    first = int(rows[0][0]) if rows else 0
    write_rows(mesh, [len(rows), *header[1:]], [[first + i, *each[1:]] for i, each in enumerate(rows)])
