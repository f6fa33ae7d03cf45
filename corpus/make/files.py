"""What an entry is, and how it is written to files."""
from dataclasses import dataclass, field
from pathlib import Path

CORPUS = Path(__file__).resolve().parent.parent


@dataclass
class Entry:
    path: str          # below corpus/, without extension
    what: str          # which figure of the book, or why it is nasty
    points: list
    simplices: list
    claims: list       # [(claim, verdict)]; a verdict is "holds" or rule ids, comma-separated and sorted
    base: int = 1      # the first index
    form: str = "ele"  # ele (with .node), off, qhull (points, with the simplices in .qhull-i), json
    neighbors: list = None  # for a .neigh file: see neighbor_rows
    listed: list = field(default_factory=list)  # triangles and edges beside the simplices: see write_listed
    weights: list = None   # the first attribute of the .node file, as tetgen -w reads it
    marks: int = 0     # boundary markers 0, 1, 2 ... in the .node file, to be skipped by readers

    @property
    def mesh(self):
        return self.path + {"ele": ".ele", "off": ".off", "qhull": ".qhull-i", "json": ".json"}[self.form]


def number(x):
    """The shortest decimal from which strtod gives the same double; integers and fractions as they are."""
    return str(int(x)) if isinstance(x, float) and x.is_integer() and abs(x) < 1e16 else str(x)


def write_node(path, points, dimension, base=1, marks=0, weights=None):
    lines = [f"{len(points)} {dimension} {int(weights is not None)} {int(marks > 0)}"]
    for i, p in enumerate(points):
        weight = [number(weights[i])] if weights else []
        mark = [str(i % marks)] if marks else []
        lines.append(" ".join([str(i + base), *map(number, p), *weight, *mark]))
    path.write_text("\n".join(lines) + "\n")


def write_ele(path, simplices, columns, base=1):
    lines = [f"{len(simplices)} {columns} 0"]
    lines += [" ".join(str(x) for x in (i + base, *(v + base for v in t))) for i, t in enumerate(simplices)]
    path.write_text("\n".join(lines) + "\n")


def write_listed(stem, faces, base=1):
    """Triangles for the .face file, edges for the .edge file."""
    for size, extension in ((3, ".face"), (2, ".edge")):
        rows = [f for f in faces if len(f) == size]
        if rows:
            lines = [f"{len(rows)} 0", *(" ".join(str(x) for x in (i, *(v + base for v in f))) for i, f in enumerate(rows, base))]
            stem.with_name(stem.name + extension).write_text("\n".join(lines) + "\n")


def neighbor_rows(simplices):
    """For vertex i of each simplex, the simplex across the facet opposite it; None on the boundary."""
    facets = {}
    for i, t in enumerate(simplices):
        for v in t:
            facets.setdefault(frozenset(t) - {v}, []).append(i)
    across = lambda i, t, v: next((j for j in facets[frozenset(t) - {v}] if j != i), None)
    return [[across(i, t, v) for v in t] for i, t in enumerate(simplices)]


def write_neigh(path, rows, base=1):
    lines = [f"{len(rows)} {len(rows[0])}"]
    lines += [" ".join(str(-1 if x is None else x + base) for x in (i, *row)) for i, row in enumerate(rows)]
    path.write_text("\n".join(lines) + "\n")


def write_off(path, points, simplices):
    lines = ["OFF", f"{len(points)} {len(simplices)} 0"]
    lines += [" ".join(map(number, p)) for p in points]
    lines += [" ".join(map(str, (len(t), *t))) for t in simplices]
    path.write_text("\n".join(lines) + "\n")


def write_qhull_points(path, points, dimension):
    lines = [str(dimension), str(len(points)), *(" ".join(map(number, p)) for p in points)]
    path.write_text("\n".join(lines) + "\n")


def write_qhull_simplices(path, simplices):
    path.write_text("\n".join([str(len(simplices)), *(" ".join(map(str, t)) for t in simplices)]) + "\n")


def write_json(path, points, simplices, dimension, base=0):
    """Coordinates exactly: doubles in hexadecimal, fractions as they are."""
    coordinate = lambda x: f'"{x.hex() if isinstance(x, float) else x}"'
    row = lambda values: "[" + ", ".join(values) + "]"
    lines = [f'{{"circumspect": 1, "dimension": {dimension}, "first_index": {base},', '"points": [']
    lines += [",\n".join(row(map(coordinate, p)) for p in points) + "],", '"simplices": [']
    lines += [",\n".join(row(str(v + base) for v in t) for t in simplices) + "]}"]
    path.write_text("\n".join(lines) + "\n")


def write(entry, dimension=3):
    stem, points, simplices = CORPUS / entry.path, entry.points, entry.simplices
    dimension = len(points[0]) if points else dimension
    columns = len(simplices[0]) if simplices else dimension + 1
    stem.parent.mkdir(parents=True, exist_ok=True)
    named = lambda extension: stem.with_name(stem.name + extension)
    if entry.form == "ele":
        write_node(named(".node"), points, dimension, entry.base, entry.marks, entry.weights)
        write_ele(named(".ele"), simplices, columns, entry.base)
        write_listed(stem, entry.listed, entry.base)
        if entry.neighbors:
            write_neigh(named(".neigh"), entry.neighbors, entry.base)
    elif entry.form == "off":
        write_off(named(".off"), points, simplices)
    elif entry.form == "qhull":
        write_qhull_points(named(".qhull"), points, dimension)
        write_qhull_simplices(named(".qhull-i"), simplices)
    elif entry.form == "json":
        write_json(named(".json"), points, simplices, dimension, entry.base)
    else:
        raise ValueError(entry.form)
