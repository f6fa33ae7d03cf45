"""Certificates and refutations of meshes that a lattice repeats: of the claim periodic-delaunay."""


def dual_of(lattice):
    if len(lattice) == 2:
        (a, b), (c, e) = lattice
        rows = [(e, -c), (-b, a)]
    else:
        def cross(u, v):
            return tuple(u[i - 2] * v[i - 1] - u[i - 1] * v[i - 2] for i in range(3))
        rows = [cross(lattice[i - 2], lattice[i - 1]) for i in range(3)]
    factor = sum(x * y for x, y in zip(rows[0], lattice[0]))
    return [[x if factor > 0 else -x for x in row] for row in rows], abs(factor)


def less(o, p):
    return tuple(x - y for x, y in zip(o, p))


def links_of(cells):
    """Of each facet the other cell that has it, the place opposite and the offset; the facet itself if no other has it."""
    places = {}
    for t, cell in enumerate(cells):
        for i in range(len(cell)):
            facet = sorted(cell[:i] + cell[i + 1:])
            first = facet[0][1]
            name = tuple((v, less(o, first)) for v, o in facet)
            places.setdefault(name, []).append((t, i, first))
    links = {}
    for uses in places.values():
        for k, (t, i, first) in enumerate(uses):
            u, j, other = uses[k ^ 1] if (k ^ 1) < len(uses) else uses[0]
            links[t, i] = (u + 1, j, less(first, other))
    return links


def numbers(*rows):
    return " ".join(str(x) for row in rows for x in (row if isinstance(row, (tuple, list)) else [row]))


def mesh(first, lattice, points, cells, reach, of_point, of_cell):
    rows, factor = dual_of(lattice)
    d = len(lattice)
    lines = [first, "scale 1 2", f"lattice {d}", *map(numbers, lattice), f"dual {d}", *map(numbers, rows), f"factor {factor}",
             "reach " + numbers(list(reach)), f"points {len(points)}"]
    lines += [numbers(point, of_point(v), v + 7) for v, point in enumerate(points)]
    lines.append(f"cells {len(cells)}")
    lines += [numbers(*(x for v, o in cell for x in (v, o)), *of_cell(t)) for t, cell in enumerate(cells)]
    return lines


def certificate(lattice, points, cells, sample, links=None, reach=range(-3, 4)):
    """Corners are (number of the point from 1, offset); links may replace some of the right ones."""
    links = {**links_of(cells), **(links or {})}

    def home(v):
        return next(((t + 1, i) for t, cell in enumerate(cells) for i, (w, _) in enumerate(cell) if w == v + 1), (1, 0))

    lines = mesh(f"circumspect-certificate 1 periodic-delaunay {len(lattice)}", lattice, points, cells, reach, home,
                 lambda t: [x for i in range(len(cells[t])) for x in links[t, i]])
    return "\n".join([*lines, "sample " + numbers(*sample), "end"]) + "\n"


def refuted(rule, lattice, points, cells, because, reach=range(-3, 4)):
    lines = mesh(f"circumspect-refutation 2 periodic-delaunay {len(lattice)} {rule}", lattice, points, cells, reach,
                 lambda v: (), lambda t: ())
    return "\n".join([*lines, "because " + numbers(*because), "end"]) + "\n"


def moved(cell, way):
    return [(v, tuple(x + y for x, y in zip(o, way))) for v, o in cell]


SQUARE = [(4, 0), (0, 4)]
# A square, cut along a diagonal, and along the other.
LOWER, UPPER = [(1, (0, 0)), (1, (1, 0)), (1, (1, 1))], [(1, (0, 0)), (1, (1, 1)), (1, (0, 1))]
LEFT, RIGHT = [(1, (0, 0)), (1, (1, 0)), (1, (0, 1))], [(1, (1, 1)), (1, (0, 1)), (1, (1, 0))]
ONE = [(1, 2)]
INSIDE = [1, (4, 3), 1]  # of LOWER
# A parallelogram, whose longer diagonal is not Delaunay.
SKEW = [(4, 0), (2, 4)]
CUBE = [(4, 0, 0), (0, 4, 0), (0, 0, 4)]


def cubes():
    """The cube cut along its diagonal."""
    cells = []
    for order in ((0, 1, 2), (0, 2, 1), (1, 0, 2), (1, 2, 0), (2, 0, 1), (2, 1, 0)):
        at, cell = [0, 0, 0], [(1, (0, 0, 0))]
        for axis in order:
            at[axis] = 1
            cell.append((1, tuple(at)))
        cells.append(cell)
    return cells


def files():
    square = certificate(SQUARE, ONE, [LOWER, UPPER], INSIDE)

    def changed(name, answer, line, other):
        assert line + "\n" in square, line
        return name, square.replace(line + "\n", other, 1), answer

    yield "periodic--square", square, "verified: periodic-delaunay, 1 point, 2 triangles; lattice: 2,0,0,2"
    yield "periodic--listed-elsewhere", certificate(SQUARE, ONE, [moved(LOWER, (2, -1)), UPPER], [1, (12, -1), 1]), \
        "verified: periodic-delaunay, 1 point, 2 triangles"
    yield "periodic--skew", certificate(SKEW, ONE, [LEFT, RIGHT], [1, (7, 7), 2]), "verified: periodic-delaunay, 1 point, 2 triangles"
    yield "periodic--left-handed", certificate(SQUARE[::-1], ONE, [LOWER, UPPER], [1, (2, 5), 1]), "verified: periodic-delaunay, 1 point"
    yield "periodic--cubes", certificate(CUBE, [(0, 0, 0)], cubes(), [1, (3, 2, 1), 1]), \
        "verified: periodic-delaunay, 1 point, 6 tetrahedra; lattice: 2,0,0,0,2,0,0,0,2"
    yield changed("lattice-proper", "rejected: lattice-proper", "dual 2\n4 0\n0 4", "dual 2\n4 0\n1 4\n")
    yield changed("lattice-proper--a-multiple", "rejected: lattice-proper", "factor 16", "factor 8\n")
    yield changed("lattice-proper--negative", "rejected: lattice-proper", "dual 2\n4 0\n0 4\nfactor 16", "dual 2\n-4 0\n0 -4\nfactor -16\n")
    yield changed("lattice-proper--too-few", "rejected: lattice-proper", "lattice 2\n4 0\n0 4\ndual 2\n4 0\n0 4",
                  "lattice 1\n4 0\ndual 1\n4 0\n")
    yield changed("scale--periodic", "rejected: scale", "scale 1 2", "scale 1 0\n")
    stranger = [*UPPER[:2], (2, (0, 1))]
    yield "vertex-known--periodic", certificate(SQUARE, ONE, [LOWER, UPPER, stranger], INSIDE, links_of([LOWER, UPPER])), \
        "rejected: vertex-known, simplex 3"
    flat = [(1, (0, 0)), (1, (1, 1)), (1, (2, 2))]
    yield "simplex-proper--periodic", certificate(SQUARE, ONE, [LOWER, UPPER, flat], INSIDE), "rejected: simplex-proper, simplex 3"
    yield "facet-matched--periodic", certificate(SQUARE, ONE, [LOWER, UPPER], INSIDE, {(0, 0): (2, 1, (0, 0))}), \
        "rejected: facet-matched, simplex 1, facet 0"
    yield "facet-matched--periodic--no-cell", certificate(SQUARE, ONE, [LOWER, UPPER], INSIDE, {(0, 2): (3, 0, (0, -1))}), \
        "rejected: facet-matched, simplex 1, facet 2"
    yield "facet-matched--periodic--itself", certificate(SQUARE, ONE, [LOWER], INSIDE), "rejected: facet-matched, simplex 1, facet 0"
    # Two cells on one side of the facet between them, which two others have, too.
    yield "facet-matched--periodic--one-side", certificate(SQUARE, ONE, [LOWER, LOWER, UPPER, UPPER], INSIDE), "rejected: "
    # Two cells that go back to one.
    yield "back-pointer--periodic", certificate(SQUARE, ONE, [LOWER, UPPER, UPPER], INSIDE, {
        **links_of([LOWER, UPPER]), (2, 0): (1, 2, (0, 1)), (2, 1): (1, 0, (-1, 0)), (2, 2): (1, 1, (0, 0))}), \
        "rejected: back-pointer, simplex 3, facet 0"
    yield "facet-locally-delaunay--periodic", certificate(SKEW, ONE, [LOWER, UPPER], [1, (11, 7), 3]), \
        "rejected: facet-locally-delaunay, simplex 1, facet 1"
    yield changed("sample-inside--periodic", "rejected: sample-inside", "sample 1 4 3 1", "sample 1 1 2 1\n")
    yield changed("sample-inside--periodic--denominator", "rejected: sample-inside", "sample 1 4 3 1", "sample 1 -4 -3 -1\n")
    yield changed("sample-inside--periodic--no-cell", "rejected: sample-inside", "sample 1 4 3 1", "sample 3 4 3 1\n")
    # Everything is covered twice: by a mesh and another, or by a mesh and the same, moved.
    yield "sample-outside--periodic--two-sheets", certificate(SQUARE, ONE, [LOWER, UPPER, LEFT, RIGHT], INSIDE), \
        "rejected: sample-outside, simplex 3"
    once = links_of([LOWER, UPPER])
    again = {(t + 2, i): (u + 2, j, o) for (t, i), (u, j, o) in once.items()}
    again = {(t, i): (u, j, tuple(x + (1 if (t, u) == (2, 4) else -1 if (t, u) == (3, 3) else 0) * (axis == 0) for axis, x in enumerate(o)))
             for (t, i), (u, j, o) in again.items()}
    yield "sample-outside--periodic--again", certificate(SQUARE, ONE, [LOWER, UPPER, moved(LOWER, (1, 0)), UPPER], INSIDE, {**once, **again}), \
        "rejected: sample-outside, simplex 3"
    yield changed("sample-outside--periodic--reach", "rejected: sample-outside, simplex 1", "reach -3 -2 -1 0 1 2 3", "reach 1 2\n")
    yield changed("sample-outside--periodic--reach-below", "rejected: sample-outside, simplex 1", "reach -3 -2 -1 0 1 2 3", "reach -3 -2 -1\n")
    yield changed("sample-outside--periodic--gap", "rejected: sample-outside, simplex 1", "reach -3 -2 -1 0 1 2 3", "reach -3 3\n")
    yield changed("sample-outside--periodic--nowhere", "rejected: sample-outside, simplex 1", "reach -3 -2 -1 0 1 2 3", "reach\n")
    yield "point-used--periodic", certificate(SQUARE, [*ONE, (3, 3)], [LOWER, UPPER], INSIDE), "rejected: point-used, point 2"
    yield from refutations()


def refutations():
    claim = "periodic-delaunay"
    flat = [(1, (0, 0)), (1, (1, 1)), (1, (2, 2))]
    two = [LOWER, UPPER]
    sheets = [*two, LEFT, RIGHT]
    beside = [*ONE, (3, 3)]
    opened, place = next(at for at, (u, j, _) in links_of(cubes()[1:]).items() if at == (u - 1, j))
    large = [(1, (0, 0)), (1, (2, 0)), (1, (0, 2))]
    for rule, name, lattice, points, cells, because, reach in (
            ("simplex.degenerate", "shown", SQUARE, ONE, [LOWER, flat], [2], [0]),
            ("simplex.degenerate", "not-shown", SQUARE, ONE, [LOWER, flat], [1], [0]),
            ("complex.duplicate-simplex", "shown", SQUARE, ONE, [*two, moved(LOWER, (1, 0))], [1, 3, (-1, 0)], [0]),
            ("complex.duplicate-simplex", "not-shown--itself", SQUARE, ONE, two, [1, 1, (0, 0)], [0]),
            ("complex.duplicate-simplex", "not-shown--elsewhere", SQUARE, ONE, [*two, moved(LOWER, (1, 0))], [1, 3, (1, 0)], [0]),
            ("complex.duplicate-simplex", "not-shown--another", SQUARE, ONE, two, [1, 2, (0, 0)], [0]),
            ("complex.not-closed", "shown", SQUARE, ONE, [LOWER], [1, 0], range(-2, 3)),
            ("complex.not-closed", "shown--in-space", CUBE, [(0, 0, 0)], cubes()[1:], [opened + 1, place], range(-2, 3)),
            ("complex.not-closed", "not-shown", SQUARE, ONE, two, [1, 0], range(-2, 3)),
            ("complex.not-closed", "not-shown--too-near", SQUARE, ONE, [LOWER], [1, 0], [0]),
            ("complex.not-closed", "not-shown--twice", SQUARE, ONE, [LOWER, moved(LOWER, (1, 0))], [1, 0], range(-3, 4)),
            ("complex.not-closed", "not-shown--no-facet", SQUARE, ONE, [LOWER], [1, 3], range(-2, 3)),
            ("triangulation.covered-twice", "shown", SQUARE, ONE, sheets, [1, 4, (0, 0), (4, 3), 1], [0]),
            ("triangulation.covered-twice", "shown--itself-moved", SQUARE, ONE, [large], [1, 1, (1, 0), (6, 3), 1], [0]),
            ("triangulation.covered-twice", "not-shown--itself", SQUARE, ONE, two, [1, 1, (0, 0), (4, 3), 1], [0]),
            ("triangulation.covered-twice", "not-shown--on-an-edge", SQUARE, ONE, two, [1, 2, (0, 0), (3, 4), 1], [0]),
            ("triangulation.covered-twice", "not-shown--elsewhere", SQUARE, ONE, sheets, [1, 4, (1, 0), (4, 3), 1], [0]),
            ("triangulation.unused-point", "shown", SQUARE, beside, two, [2], range(-2, 3)),
            ("triangulation.unused-point", "not-shown", SQUARE, beside, two, [1], range(-2, 3)),
            ("triangulation.unused-point", "not-shown--moved", SQUARE, [*ONE, (5, -2)], two, [2], range(-2, 3)),
            ("triangulation.unused-point", "not-shown--too-near", SQUARE, [*ONE, (5, -2)], two, [2], [0]),
            ("delaunay.vertex-in-ball", "shown", SKEW, ONE, two, [1, 1, (0, 1)], [0]),
            ("delaunay.vertex-in-ball", "not-shown--on-it", SQUARE, ONE, two, [1, 1, (0, 1)], [0]),
            ("delaunay.vertex-in-ball", "not-shown--elsewhere", SKEW, ONE, two, [1, 1, (0, 2)], [0])):
        answer = f"verified: not {claim}, {rule}; lattice: " if name.startswith("shown") else f"rejected: the evidence does not show {rule}"
        yield f"{rule}--{name.replace('shown', 'shown--periodic')}", refuted(rule, lattice, points, cells, because, reach), answer
