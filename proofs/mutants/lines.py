"""Certificates of points on a line and of one point, and refutations of points that do not span."""


def section(name, rows):
    return "\n".join([f"{name} {len(rows)}", *rows])


def line(points, rows, order, pads, claim="delaunay", scale="1 2"):
    """Of a certificate. Points and simplices are numbered from 1."""
    text = [f"circumspect-certificate 1 {claim} {len(points[0])} line", f"scale {scale}",
            section("points", [" ".join(map(str, p)) + f"  {v}" for v, p in enumerate(points)]),
            section("simplices", [" ".join(map(str, row)) for row in rows]), section("order", list(map(str, order))),
            section("pads", [" ".join(map(str, p)) for p in pads]), "end"]
    return "\n".join(text) + "\n"


POINTS, ROWS, ORDER, PADS = [(0, 0, 0), (1, 2, 3), (3, 6, 9), (4, 8, 12)], [[2, 1], [3, 4], [2, 3]], [1, 3, 2], [(1, 0, 0), (0, 1, 0)]


def refutation(claim, rule, points, rows, spans, pads, because):
    """Entries of rows are numbered from 1."""
    text = [f"circumspect-refutation 2 {claim} {len(points[0])} {rule} flat", "scale 1 2",
            section("points", [" ".join(map(str, p)) + f"  {v}" for v, p in enumerate(points)]),
            section("simplices", [" ".join(map(str, [len(row), *row])) for row in rows]),
            "spans " + " ".join(map(str, spans)), section("pads", [" ".join(map(str, p)) for p in pads]),
            "because " + " ".join(map(str, because)), "end"]
    return "\n".join(text) + "\n"


def certificates():
    yield "line--space", line(POINTS, ROWS, ORDER, PADS), "verified: delaunay, 4 points, 3 edges, on one line"
    yield "line--plane", line([(0, 5), (2, 5)], [[1, 2]], [1], [(0, 6)], "triangulation"), \
        "verified: triangulation, 2 points, 1 edge, on one line"
    yield "line--one-point", line([(3, 4, 5)], [[1]], [], []), "verified: delaunay, 1 point, 1 vertex, in one place"
    yield "scale--line", line(POINTS, ROWS, ORDER, PADS, scale="1 0"), "rejected: scale"
    yield "simplex-proper--line", line(POINTS, ROWS, ORDER, [(1, 0, 0), (2, 2, 3)]), "rejected: simplex-proper"
    yield "simplex-proper--line--a-pad-less", line(POINTS, ROWS, ORDER, PADS[:1]), "rejected: simplex-proper"
    moved = [*POINTS[:2], (3, 6, 8), POINTS[3]]
    yield "points-increasing--line--off-it", line(moved, ROWS, ORDER, PADS), "rejected: points-increasing, point 3"
    back = [POINTS[0], POINTS[2], POINTS[1], POINTS[3]]
    yield "points-increasing--line--back", line(back, ROWS, ORDER, PADS), "rejected: points-increasing, point 3"
    yield "points-increasing--line--twice", line([POINTS[0], POINTS[1], POINTS[1], POINTS[3]], ROWS, ORDER, PADS), \
        "rejected: points-increasing, point 3"
    yield "edge-listed--line--a-gap", line(POINTS, ROWS[:2], ORDER[:1] + [2], PADS), "rejected: edge-listed, edge 2"
    yield "edge-listed--line--of-others", line(POINTS, ROWS, [1, 2, 3], PADS), "rejected: edge-listed, edge 2"
    yield "edge-listed--line--no-simplex", line(POINTS, ROWS, [1, 3, 9], PADS), "rejected: edge-listed, edge 3"
    yield "edge-listed--line--beyond-the-end", line(POINTS, [*ROWS, [4, 5]], [*ORDER, 4], PADS), "rejected: edge-listed, edge 4"
    yield "simplex-listed--line--over-a-point", line(POINTS, [*ROWS, [1, 3]], ORDER, PADS), "rejected: simplex-listed, simplex 4"
    yield "simplex-listed--line--twice", line(POINTS, [*ROWS, [1, 2]], ORDER, PADS), "rejected: simplex-listed, simplex 4"
    yield "simplex-listed--line--no-vertex", line(POINTS, [*ROWS, [4, 5]], ORDER, PADS), "rejected: simplex-listed, simplex 4"
    yield "simplex-listed--line--no-point", "circumspect-certificate 1 delaunay 3 line\nscale 1 1\npoints 0\nsimplices 0\norder 0\npads 0\nend\n", \
        "rejected: simplex-listed"
    yield "simplex-listed--line--another-vertex", line([(3, 4, 5)], [[2]], [], []), "rejected: simplex-listed"
    yield "simplex-listed--line--one-point-twice", line([(3, 4, 5)], [[1], [1]], [], []), "rejected: simplex-listed"


def refutations():
    """For each rule: the name, what is changed of a good refutation, and whether it is accepted."""
    def answers(rule, claim, points, rows, spans, pads, because, changes):
        good = dict(claim=claim, rule=rule, points=points, rows=rows, spans=spans, pads=pads, because=because)
        yield f"{rule}--shown--flat", refutation(**good), f"verified: not {claim}, {rule}"
        for name, change in changes.items():
            yield f"{rule}--not-shown--flat--{name}", refutation(**{**good, **change}), f"rejected: the evidence does not show {rule}"

    square = [(0, 0, 0), (4, 0, 4), (4, 4, 8), (0, 4, 4)]
    yield from answers("simplex.wrong-dimension", "delaunay", square, [[1, 2, 3], [1, 2, 3, 4]], [1, 2, 3], [(0, 0, 1)], [2], {
        "of-as-many": dict(because=[1]), "no-simplex": dict(because=[3]),
        # As if the points were on a line.
        "spans-too-little": dict(spans=[1, 2], pads=[(0, 0, 1), (0, 1, 0)], because=[1]),
        "a-pad-less": dict(pads=[]), "a-pad-among-them": dict(pads=[(4, 4, 8)]),
        "a-basis-of-a-line": dict(points=[(0, 0, 0), (4, 0, 4), (8, 0, 8), (0, 4, 4)]),
        "a-point-off-it": dict(points=[*square[:3], (0, 4, 5)]), "no-point": dict(spans=[1, 2, 9])})
    yield from answers("triangulation.unused-point", "triangulation", [(0, 0), (1, 1), (2, 2)], [[1, 3]], [1, 3], [(0, 1)], [2], {
        "used": dict(because=[3]), "used-elsewhere": dict(points=[(0, 0), (0, 0), (2, 2)]), "no-point": dict(because=[4])})
    # The third point is beyond the end of the first edge.
    gap = [(0, 0, 0), (1, 2, 3), (3, 6, 9), (4, 8, 12)]
    yield from answers("triangulation.hull-not-convex", "delaunay", gap, [[1, 2], [3, 4]], [1, 4], PADS, [1, 0, 3], {
        "its-own-side": dict(because=[1, 1, 3]), "on-it": dict(because=[1, 0, 2]), "no-gap": dict(rows=[[1, 2], [2, 3], [3, 4]]),
        "listed-in-a-triangle": dict(rows=[[1, 2], [2, 3, 4]]), "no-edge": dict(rows=[[1, 2, 9], [3, 4]]),
        "no-entry": dict(because=[1, 2, 3]), "no-simplex": dict(because=[3, 0, 3]), "no-point": dict(because=[1, 0, 5]),
        "a-point-twice": dict(rows=[[2, 2], [3, 4]]),
        "of-a-plane": dict(points=square, rows=[[1, 2], [3, 4]], spans=[1, 2, 3], pads=[(0, 0, 1)]),
        "a-point-off-it": dict(points=[*gap[:3], (4, 8, 11)], spans=[1, 3])})
    yield "triangulation.hull-not-convex--shown--flat--listed-again", \
        refutation("triangulation", "triangulation.hull-not-convex", [(0, 0), (1, 1), (2, 2)], [[1, 2], [2, 1]], [1, 3], [(0, 1)], [2, 1, 3]), \
        "verified: not triangulation, triangulation.hull-not-convex"
    rhombus = [(0, 0, 0), (2, -1, 2), (4, 0, 4), (2, 1, 2)]
    yield from answers("delaunay.vertex-in-ball", "delaunay", rhombus, [[1, 2, 3], [3, 4, 1], [1, 2]], [1, 2, 3], [(0, 0, 1)],
                       [1, 4, -1, 1, -1, 1], {
        "on-it": dict(points=[(0, 0, 0), (4, 0, 4), (4, 4, 4), (0, 4, 0)]),
        "another-sum": dict(because=[1, 4, -1, 1, -1, 2]), "the-other-sign": dict(because=[1, 4, 1, -1, 1, -1]),
        "an-edge": dict(because=[3, 4, -1, 1, -1, 1]), "no-vertex": dict(because=[1, 5, -1, 1, -1, 1]),
        "not-claimed": dict(claim="triangulation")})


def files():
    yield from certificates()
    yield from refutations()
