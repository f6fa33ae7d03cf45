"""Certificates that are those of another mesh and a little more: cones over a convex hull, and pictures of a plane."""

from honest import certificate, side, text
from surfaces import refuted

# Four corners, a point inside, and one in an edge, which are not vertices; the last is the summit.
FRAME = [(0, 0), (6, 0), (6, 6), (0, 6), (4, 1), (3, 0), (2, 2)]
FRAME_EDGES = [(0, 1), (1, 2), (2, 3), (3, 0)]
# The same with another point inside, and the summit.
DENTED = [*FRAME[:4], (3, 1), FRAME[6]]
OCTAHEDRON = [(8, 0, 0), (-8, 0, 0), (0, 8, 0), (0, -8, 0), (0, 0, 8), (0, 0, -8), (0, 2, 2)]
OCTAHEDRON_FACES = [(x, y, z) for x in (0, 1) for y in (2, 3) for z in (4, 5)]
# Where x + y = z: seen from above a square, and in truth a rhombus.
RHOMBUS = [(0, 0), (4, 0), (4, 4), (0, 4)]


def norm2(point):
    return sum(x * x for x in point)


def cones(points, simplices, weighted):
    """A certificate of simplices at the summit, the last point, which is nobody's."""
    weights = [norm2(p) - 1 for p in points[:-1]] + [norm2(points[-1])] if weighted else None
    parts = certificate("convex-hull", points, simplices, weights)
    parts["standing"] = " weighted-delaunay" if weighted else " triangulation"
    place = [row[0] for row in parts["points"]]
    used = {v for row in parts["simplices"] for v in row[0]}
    for k, row in enumerate(parts["points"], 1):
        if row[4] == len(points) - 1:
            row[4] = "-"
        if k not in used:
            row[2] = next((t for t, (corners, _, _) in enumerate(parts["simplices"], 1)
                          if all(side([place[v - 1] for v in corners], i, row[0]) >= 0 for i in range(len(corners)))), 1)
            row[3] = "-"
    return parts


def hull(points, facets, around, weighted):
    parts = cones(points, [(*facet, len(points) - 1) for facet in facets], weighted)
    return with_summit(parts, points, around)


def with_summit(parts, points, around):
    number = {tuple(row[0]): k for k, row in enumerate(parts["points"], 1)}
    summit = " ".join(str(number[points[v]]) for v in (len(points) - 1, *around))
    return text(parts).replace("\nend\n", "\nsummit %s\nend\n" % summit)


def rhombus(simplices, claim="delaunay", weigh=lambda z: -z * z, flat="flat 2 1 1 -1 0", raised=lambda x, y: x + y):
    heights = [raised(x, y) for x, y in RHOMBUS]
    weights = [weigh(z) for z in heights] if claim == "delaunay" else None
    parts = certificate(claim, RHOMBUS, simplices, weights)
    parts["d"], parts["standing"] = 3, " flat"
    unseen = [heights[row[4]] for row in parts["points"]]
    return text(parts).replace("\nend\n", "\n%s\nunseen %d\n%s\nend\n" % (flat, len(unseen), "\n".join(map(str, unseen))))


def files():
    frame = hull(FRAME, FRAME_EDGES, (0, 1, 3), True)
    yield "convex-hull--plane", frame, "verified: convex-hull, 6 points, 4 edges"
    octahedron = hull(OCTAHEDRON, OCTAHEDRON_FACES, (0, 1, 2, 4), False)
    turned = hull(OCTAHEDRON, OCTAHEDRON_FACES, (1, 0, 2, 4), False)
    right, wrong = (octahedron, turned) if side([OCTAHEDRON[v] for v in (0, 1, 2, 4)], 0, OCTAHEDRON[0]) > 0 else (turned, octahedron)
    yield "convex-hull--space", right, "verified: convex-hull, 6 points, 8 triangles"
    yield "summit-inside--turned", wrong, "rejected: summit-inside, point"
    yield "summit-inside--on-an-edge", hull(OCTAHEDRON, OCTAHEDRON_FACES, (0, 1, 2, 3), False), "rejected: summit-inside, point"
    yield "summit-inside--beside-itself", hull(FRAME, FRAME_EDGES, (6, 1, 3), True), "rejected: summit-inside, point"
    yield "summit-inside--outside-of-these", hull(FRAME, FRAME_EDGES, (1, 2, 4), True), "rejected: summit-inside, point"
    # From outside one sees two edges of a triangle, and not the third.
    outside = [(0, 0), (6, 0), (0, 6), (6, 6)]
    yield "summit-inside--two-edges-of-three", hull(outside, [(0, 1), (2, 0)], (0, 1, 2), False), "rejected: summit-inside, point 4"
    # A triangle without the summit is between it and an edge of the hull.
    dented = cones(DENTED, [(0, 1, 4), (0, 4, 5), (4, 1, 5), (1, 2, 5), (2, 3, 5), (3, 0, 5)], False)
    yield "cone-shown", with_summit(dented, DENTED, (0, 1, 3)), "rejected: cone-shown, simplex 1"
    beyond = [*FRAME[:4], (7, 1), *FRAME[5:]]
    yield "point-used--beyond-the-hull", hull(beyond, FRAME_EDGES, (0, 1, 3), True), "rejected: point-used, point 7"
    dent = [(0, 4), (4, 1), (1, 2), (2, 3), (3, 0)]
    yield "hull-locally-convex--hull", hull(DENTED, dent, (0, 1, 3), False), "rejected: hull-locally-convex, hull facet"
    yield "malformed--the-summit-has-a-label", frame.replace("2 2 8 4 2 -", "2 2 8 4 2 6"), "malformed: "
    yield "malformed--another-point-is-nobodys", frame.replace(" 4\n", " -\n"), "malformed: "
    right = [(0, 1, 3), (1, 2, 3)]
    wrong = [(0, 1, 2), (0, 2, 3)]
    yield "flat--delaunay", rhombus(right), "verified: delaunay, 4 points, 2 triangles, in one plane"
    yield "flat--triangulation", rhombus(wrong, "triangulation"), "verified: triangulation, 4 points, 2 triangles, in one plane"
    yield "facet-locally-delaunay--in-the-picture", rhombus(wrong, weigh=lambda z: 0), "rejected: weight-unseen, point"
    yield "facet-locally-delaunay--flat", rhombus(wrong), "rejected: facet-locally-delaunay, simplex"
    yield "weight-unseen", rhombus(right, weigh=lambda z: -z * z - 1), "rejected: weight-unseen, point 1"
    yield "point-in-plane", rhombus(right, raised=lambda x, y: x + y + x * y // 16), "rejected: point-in-plane, point 4"
    yield "point-in-plane--upright", rhombus(right, flat="flat 2 0 0 0 0"), "rejected: point-in-plane"
    yield "point-in-plane--no-such-axis", rhombus(right, flat="flat 3 1 1 -1 0"), "rejected: point-in-plane"
    yield "point-in-plane--one-more", rhombus(right).replace("unseen 4\n", "unseen 5\n0\n"), "rejected: point-in-plane, point"
    yield "point-in-plane--one-less", rhombus(right).replace("unseen 4\n0\n", "unseen 3\n"), "rejected: point-in-plane, point"
    yield "point-used--flat", rhombus(right).replace("4 4 -64  2", "4 4 -64 2").replace("4 4 -64 2 1 2", "4 4 -64 2 - 2"), "rejected: point-used, point 4"
    yield from hull_refutations()


def hull_refutations():
    claim, rule = "convex-hull", "hull.facet-not-supporting"
    shown, not_shown = f"verified: not {claim}, {rule}", f"rejected: the evidence does not show {rule}"
    square, tent = [(0, 0), (4, 0), (4, 4), (0, 4)], [(0, 0, 0), (4, 0, 0), (0, 4, 0), (0, 0, 4), (4, 4, 4), (1, 1, 2)]
    for name, points, rows, because, answer in (
            ("shown", square, [[1, 2], [1, 3], []], [2, 2, 4], shown),
            ("shown--in-space", tent, [[9], [2, 3, 4]], [2, 1, 5], shown),
            ("not-shown--on-one-side", square, [[1, 2]], [1, 3, 4], not_shown),
            ("not-shown--on-it", tent, [[2, 3, 4]], [1, 6, 5], not_shown),
            ("not-shown--a-vertex", square, [[1, 3]], [1, 3, 4], not_shown),
            ("not-shown--a-flat-facet", [(0, 0, 0), (1, 1, 1), (2, 2, 2), *tent[1:3]], [[1, 2, 3]], [1, 4, 5], not_shown),
            ("not-shown--of-more-points", square, [[1, 3, 2]], [1, 2, 4], not_shown),
            ("not-shown--no-point", square, [[1, 3]], [1, 2, 5], not_shown),
            ("not-shown--no-facet", square, [[1, 3]], [2, 2, 4], not_shown)):
        yield f"{rule}--{name}", refuted(points, rows, because, claim, rule), answer
    yield from uncovered_hulls()


def uncovered_hulls():
    """Three edges of a square, and all faces of a cube but one half of the upper face."""
    claim, rule = "convex-hull", "hull.uncovered"
    shown, not_shown = f"verified: not {claim}, {rule}", f"rejected: the evidence does not show {rule}"
    square, three = [(0, 0), (4, 0), (4, 4), (0, 4)], [[1, 2], [2, 3], [3, 4]]
    inner, cube = [*square, (1, 1)], [(x, y, z) for z in (0, 2) for y in (0, 2) for x in (0, 2)]
    sides = [[1, 2, 4], [1, 3, 4], [1, 2, 5], [2, 5, 6], [3, 4, 8], [3, 7, 8], [1, 3, 5], [3, 5, 7], [2, 4, 6], [4, 6, 8]]
    for name, points, rows, because, answer in (
            ("shown", square, three, [4, 1, 2, 0, 1, 1], shown),
            ("shown--of-no-facets", square, [], [4, 1, 2, 0, 1, 1], shown),
            ("shown--at-a-facet", square, three, [4, 1, 2, 0, 99, 25], shown),
            ("shown--in-space", cube, [*sides, [5, 6, 8]], [5, 7, 8, 1, 2, 5, 6, 3], shown),
            ("not-shown--in-a-facet", cube, [*sides, [5, 6, 8]], [5, 6, 8, 1, 5, 2, 6, 3], not_shown),
            ("not-shown--at-the-end-of-a-facet", cube, [*sides, [5, 6, 8]], [5, 7, 8, 1, 1, 1, 2, 1], not_shown),
            ("not-shown--covered", square, [*three, [4, 1]], [4, 1, 2, 0, 1, 1], not_shown),
            ("not-shown--an-end", square, three, [4, 1, 2, 0, 4, 1], not_shown),
            ("not-shown--points-beyond", square, three, [1, 3, 2, 2, 2, 1], not_shown),
            ("not-shown--inside", square, three, [4, 1, 2, 1, 1, 1], not_shown),
            ("not-shown--beside", square, three, [4, 1, 2, 0, -1, 1], not_shown),
            ("not-shown--no-denominator", square, three, [4, 1, 2, 0, 1, 0], not_shown),
            ("not-shown--on-a-line", [*square, (0, 2)], three, [4, 1, 5, 0, 1, 1], not_shown),
            ("not-shown--flat", inner, [*three, [1, 1]], [4, 1, 2, 0, 1, 1], not_shown),
            ("not-shown--a-vertex", square, [*three, [3]], [4, 1, 2, 0, 1, 1], not_shown),
            ("not-shown--unknown", square, [*three, [3, 7]], [4, 1, 2, 0, 1, 1], not_shown),
            ("not-shown--no-point", square, three, [4, 1, 9, 0, 1, 1], not_shown)):
        yield f"{rule}--{name}", refuted(points, rows, because, claim, rule), answer
