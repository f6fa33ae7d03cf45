#!/usr/bin/python3
"""Looks at the findings of corpus/findings once more, by rational arithmetic and definitions alone, with nothing of Circumspect.

    by_hand.py [NAME ...]      one line for each finding that it cannot confirm; exit code 1 if there is one

Each rule that expected.tsv names is asked of the stored mesh in the plainest way there is: every simplex, every pair, every point.
"""
import itertools
import sys
from collections import Counter
from fractions import Fraction
from pathlib import Path

FINDINGS = Path(__file__).resolve().parents[1] / "corpus" / "findings"


def determinant(rows):
    """By the first column; these are small."""
    if not rows:
        return Fraction(1)
    return sum((-1) ** i * row[0] * determinant([other[1:] for k, other in enumerate(rows) if k != i])
               for i, row in enumerate(rows) if row[0])


def orientation(points):
    return determinant([[x - y for x, y in zip(p, points[0])] for p in points[1:]])


def in_ball(simplex, point):
    """Positive if the point lies strictly inside the circumball of the simplex."""
    rows = [[x - y for x, y in zip(p, point)] for p in simplex]
    sign = determinant([row + [sum(x * x for x in row)] for row in rows]) * orientation(simplex)
    return sign if len(point) % 2 == 0 else -sign


def axes(one, other):
    """Normals, one of which separates two convex bodies whose interiors do not meet."""
    if len(one[0]) == 2:
        for body in (one, other):
            for p, q in itertools.combinations(body, 2):
                yield [p[1] - q[1], q[0] - p[0]]
        return
    edges = [[[x - y for x, y in zip(p, q)] for p, q in itertools.combinations(body, 2)] for body in (one, other)]
    for u, v in [*itertools.combinations(edges[0], 2), *itertools.combinations(edges[1], 2), *itertools.product(*edges)]:
        yield [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]


def interiors_meet(one, other):
    for axis in axes(one, other):
        if not any(axis):
            continue
        a, b = ([sum(x * y for x, y in zip(axis, p)) for p in body] for body in (one, other))
        if max(a) <= min(b) or max(b) <= min(a):
            return False
    return True


def contains(simplex, point):
    """In the closed simplex."""
    whole = orientation(simplex)
    parts = [orientation(simplex[:k] + [point] + simplex[k + 1:]) for k in range(len(simplex))]
    return whole != 0 and all(part * whole >= 0 for part in parts)


def edges_meet(one, other):
    """In more than ends of theirs: they cross, or have a piece in common."""
    sides = [orientation([*one, p]) for p in other], [orientation([*other, p]) for p in one]
    if any(sides[0]):
        return all(a * b < 0 for a, b in sides)
    one, other = sorted(one), sorted(other)
    return max(one[0], other[0]) < min(one[1], other[1])


def triangles_meet(one, other):
    """In space, in more than what they have in common: an edge of one goes through the other, or both are in one plane and overlap there."""
    if any(orientation([*one, p]) for p in other):
        return any(crosses(edge, b) for a, b in ((one, other), (other, one)) for edge in itertools.combinations(a, 2))
    u, v = ([x - y for x, y in zip(p, one[0])] for p in one[1:])
    axis = next(k for k in range(3) if u[k - 2] * v[k - 1] != u[k - 1] * v[k - 2])
    return interiors_meet(*([p[:axis] + p[axis + 1:] for p in body] for body in (one, other)))


def crosses(edge, triangle):
    """Goes an edge through the inside of a triangle?"""
    p, q = edge
    around = [orientation([p, q, a, b]) for a, b in zip(triangle, triangle[1:] + triangle[:1])]
    return orientation([*triangle, p]) * orientation([*triangle, q]) < 0 and (min(around) > 0 or max(around) < 0)


def is_hull_broken(rule, points, facets):
    """Of a list of facets: edges in the plane, triangles in space."""
    if rule == "triangulation.unknown-vertex":
        return any(v >= len(points) for f in facets for v in f)
    if rule == "hull.facet-not-supporting":
        sides = [[orientation([points[v] for v in f] + [p]) for p in points] for f in facets]
        return any(min(side) < 0 < max(side) for side in sides)
    if rule == "simplex.repeated-vertex":
        return any(len(set(f)) < len(f) for f in facets)
    if rule == "simplex.wrong-dimension":
        return any(len(f) != len(points[0]) for f in facets)
    if rule == "simplex.degenerate":
        bodies = [[points[v] for v in f] for f in facets]
        return any(all(orientation(body + [p]) == 0 for p in points) for body in bodies)
    if rule == "complex.duplicate-simplex":
        return len({tuple(sorted(f)) for f in facets}) < len(facets)
    if rule == "complex.overlap":  # of edges in the plane, or of triangles in space
        meet = edges_meet if len(points[0]) == 2 else triangles_meet
        return any(meet(*([points[v] for v in f] for f in pair)) for pair in itertools.combinations(facets, 2))
    assert rule == "hull.uncovered", rule
    ridges = Counter(ridge for f in facets for ridge in itertools.combinations(sorted(f), len(points[0]) - 1))
    return not facets or any(count == 1 for count in ridges.values())


def is_broken(rule, points, simplices):
    size = len(points[0]) + 1
    facets = Counter(facet for s in simplices for facet in itertools.combinations(sorted(s), size - 1))
    boundary = [facet for facet, count in facets.items() if count == 1]
    if rule == "triangulation.unknown-vertex":
        return any(v >= len(points) for s in simplices for v in s)
    if rule == "simplex.repeated-vertex":
        return any(len(set(s)) < size for s in simplices)
    if rule == "triangulation.unused-point":
        return set(range(len(points))) != {v for s in simplices for v in s}
    if rule == "complex.duplicate-simplex":
        return len({tuple(sorted(s)) for s in simplices}) < len(simplices)
    if rule == "complex.facet-overused":
        return max(facets.values()) > 2
    if rule == "triangulation.hull-not-closed":
        ridges = Counter(ridge for facet in boundary for ridge in itertools.combinations(facet, size - 2))
        return any(count != 2 for count in ridges.values())
    bodies = [[points[v] for v in s] for s in simplices]
    if rule == "simplex.degenerate":
        return any(orientation(body) == 0 for body in bodies)
    if rule in ("complex.overlap", "triangulation.covered-twice"):
        sound = [(s, body) for s, body in zip(simplices, bodies) if orientation(body) != 0]
        return any(interiors_meet(a, b) or any(contains(a, points[v]) for v in set(t) - set(s)) or
                   any(contains(b, points[v]) for v in set(s) - set(t))
                   for (s, a), (t, b) in itertools.combinations(sound, 2))
    if rule == "triangulation.hull-not-convex":
        for facet in boundary:
            own = next(v for s in simplices if set(facet) < set(s) for v in s if v not in facet)
            side = orientation([points[v] for v in (*facet, own)])
            if any(orientation([points[v] for v in facet] + [p]) * side < 0 for p in points):
                return True
        return False
    assert rule == "delaunay.facet-not-local", rule
    return any(len(set(s) & set(t)) == size - 1 and in_ball(a, points[(set(t) - set(s)).pop()]) > 0
               for (s, a), (t, _) in itertools.permutations(zip(simplices, bodies), 2))


def cut(polygon, normal, offset):
    """What of a convex polygon has normal·x <= offset."""
    kept = []
    for p, q in zip(polygon, polygon[1:] + polygon[:1]):
        a, b = (sum(n * x for n, x in zip(normal, r)) - offset for r in (p, q))
        kept += [p] * (a <= 0)
        if a * b < 0:
            kept.append([x + a / (a - b) * (y - x) for x, y in zip(p, q)])
    return kept


def squared_distance(point, polygon):
    """From a convex polygon whose corners are in their order; 0 inside."""
    sides = [orientation([p, q, point]) for p, q in zip(polygon, polygon[1:] + polygon[:1])]
    if len(polygon) > 2 and (min(sides) >= 0 or max(sides) <= 0):
        return 0
    least = []
    for p, q in zip(polygon, polygon[1:] + polygon[:1]):
        along, off = [y - x for x, y in zip(p, q)], [y - x for x, y in zip(p, point)]
        length = sum(x * x for x in along)
        t = min(max(sum(x * y for x, y in zip(along, off)) / length, 0), 1) if length else 0
        least.append(sum((y - t * x) ** 2 for x, y in zip(along, off)))
    return min(least)


def is_diagram_broken(rule, sites, path, within):
    """Of cells in the plane that are clipped at the box of the sites, enlarged by half its longest side; a point is enlarged by 1."""
    rows = [line.split() for line in path.read_text().splitlines()]
    vertices = [[Fraction(float(x)) for x in row] for row in rows[2:2 + int(rows[1][0])]]
    cells = [[vertices[int(v)] for v in row[1:]] for row in rows[2 + len(vertices):2 + len(vertices) + len(sites)]]
    if rule == "voronoi.cell-missing":
        return any(not cell for cell in cells)
    assert rule == "voronoi.cell-differs", rule
    low, high = ([f(axis) for axis in zip(*sites)] for f in (min, max))
    side = max(h - l for l, h in zip(low, high))
    (x0, y0), (x1, y1) = ([x + sign * (side / 2 or 1) for x in corner] for sign, corner in ((-1, low), (1, high)))
    for site, cell in zip(sites, cells):
        exact = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]]
        for other in sites:
            if other != site:
                exact = cut(exact, [2 * (y - x) for x, y in zip(site, other)], sum(y * y - x * x for x, y in zip(site, other)))
        if cell and max([squared_distance(p, cell) for p in exact] + [squared_distance(p, exact) for p in cell]) > (within * side) ** 2:
            return True
    return False


def numbers(path):
    lines = [line.split() for line in path.read_text().splitlines()]
    return lines[1:1 + int(lines[0][0])], lines[0]


def main(names):
    rows = [line.split("\t") for line in (FINDINGS / "expected.tsv").read_text().splitlines()]
    rows = [row for row in rows if row[5].startswith("hunt.py ") and row[1].split()[0] in ("delaunay", "convex-hull", "voronoi") and row[4] != "-" and (not names or row[0] in names)]
    wrong = 0
    for name, claim, rule, points, mesh, _ in rows:
        given, header = numbers(FINDINGS / points)
        points = [[Fraction(float(x)) for x in line[1:1 + int(header[1])]] for line in given]
        if claim.startswith("voronoi "):
            if not is_diagram_broken(rule, points, FINDINGS / mesh, Fraction(claim.split()[1].rstrip("x"))):
                wrong += 1
                print(f"{name}: {rule} is not broken")
            continue
        simplices = [list(map(int, line[1:])) for line in numbers(FINDINGS / mesh)[0]]
        if not (is_hull_broken if claim == "convex-hull" else is_broken)(rule, points, simplices):
            wrong += 1
            print(f"{name}: {rule} is not broken")
    print(f"by hand: {len(rows) - wrong} of {len(rows)} findings confirmed")
    return 1 if wrong or not rows else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
