"""Exact geometry for making corpus entries: integers only, no rounding anywhere.

A point is a tuple of numbers (int, float or Fraction); a float stands for exactly the rational it stores.
Nothing here is fast, and nothing here is part of what ships.
"""
from fractions import Fraction
from itertools import combinations
from math import lcm


def integers(points):
    """The points scaled by one common factor so that all coordinates are integers."""
    rational = [[Fraction(x) for x in p] for p in points]
    scale = lcm(*(x.denominator for p in rational for x in p)) if rational else 1
    return [tuple(int(x * scale) for x in p) for p in rational]


def determinant(rows):
    """Bareiss elimination: every division is exact."""
    m = [list(r) for r in rows]
    n, sign, previous = len(m), 1, 1
    for c in range(n - 1):
        pivot = next((r for r in range(c, n) if m[r][c] != 0), None)
        if pivot is None:
            return 0
        if pivot != c:
            m[c], m[pivot], sign = m[pivot], m[c], -sign
        for r in range(c + 1, n):
            for j in range(c + 1, n):
                m[r][j] = (m[r][j] * m[c][c] - m[r][c] * m[c][j]) // previous
        previous = m[c][c]
    return sign * m[-1][-1] if n else 1


def sign(x):
    return (x > 0) - (x < 0)


def spanning_columns(points):
    """k coordinates that are affine coordinates of the points' affine hull (k its dimension)."""
    if not points:
        return []
    rows = [[Fraction(x - y) for x, y in zip(p, points[0])] for p in points[1:]]
    columns, start = [], 0
    for c in range(len(points[0])):
        pivot = next((r for r in range(start, len(rows)) if rows[r][c] != 0), None)
        if pivot is None:
            continue
        rows[start], rows[pivot] = rows[pivot], rows[start]
        for r in range(start + 1, len(rows)):
            f = rows[r][c] / rows[start][c]
            if f:
                rows[r] = [x - f * y for x, y in zip(rows[r], rows[start])]
        columns.append(c)
        start += 1
    return columns


class PointSet:
    """Points, flattened to the k coordinates of their affine hull, with the full |p|^2 as height.

    Another strictly convex height makes other, non-Delaunay triangulations that use every point.
    """

    def __init__(self, points, height=lambda p: sum(x * x for x in p)):
        self.original = integers(points)
        self.columns = spanning_columns(self.original)
        self.k = len(self.columns) if points else -1
        self.flat = [tuple(p[c] for c in self.columns) for p in self.original]
        self.height = [height(p) for p in self.original]
        order = sorted(range(len(points)), key=lambda i: self.original[i])
        self.rank = {i: r for r, i in enumerate(order)}

    def orientation(self, vertices):
        """Sign of det[p_0 - p_k; ...; p_{k-1} - p_k]."""
        *rest, last = (self.flat[v] for v in vertices)
        return sign(determinant([[x - y for x, y in zip(p, last)] for p in rest]))

    def in_ball(self, simplex, q, perturbed=False):
        """Positive iff q lies strictly inside the circumball; perturbed: never 0 for a non-degenerate simplex and q not in it."""
        side = self.orientation(simplex)
        rows = [tuple(x - y for x, y in zip(self.flat[v], self.flat[q])) for v in simplex]
        lifted = [self.height[v] - self.height[q] for v in simplex]
        value = sign(determinant([r + (h,) for r, h in zip(rows, lifted)])) * side
        if value or not perturbed:
            return value
        # Weights: the height of the lexicographically first point sinks most, then that of the
        # second ...
        for v in sorted([*simplex, q], key=self.rank.get):
            if v == q:
                return 1  # q sinks below the witness plane
            others = [q if w == v else w for w in simplex]
            coefficient = self.orientation(others) * side
            if coefficient:  # v sinks; q then lies on the side of the plane that its barycentric weight at v tells
                return -coefficient
        return 0


def canonical_delaunay(points):
    """The Delaunay triangulation under the canonical perturbation (pulling by lexicographic order)."""
    return regular_triangulation(PointSet(points))


def regular_triangulation(s):
    """The lower hull of the points lifted to their heights, projected; by gift-wrapping."""
    if s.k <= 0:
        return [(0,)] if s.k == 0 else []
    seed = frozenset(first_simplex(s))
    simplices, finished = {seed}, set()
    unfinished = {seed - {v}: v for v in seed}  # a facet, and the vertex that already stands behind it
    while unfinished:
        facet, behind = unfinished.popitem()
        finished.add(facet)
        apex = gift_wrap(s, sorted(facet), behind)
        if apex is None:
            continue
        simplices.add(facet | {apex})
        for v in facet:
            other = facet - {v} | {apex}
            if other in unfinished:
                del unfinished[other]
                finished.add(other)
            else:
                assert other not in finished
                unfinished[other] = v
    return [oriented(s, t) for t in sorted(tuple(sorted(t)) for t in simplices)]


def gift_wrap(s, facet, behind):
    """The vertex in front of the facet (on the side away from `behind`) that finishes it; None on the hull."""
    back, apex = s.orientation([*facet, behind]), None
    for v in range(len(s.original)):
        if v not in facet and s.orientation([*facet, v]) == -back:
            if apex is None or s.in_ball([*facet, apex], v, True) > 0:
                apex = v
    return apex


def first_simplex(s):
    """Any simplex whose perturbed open circumball is empty; tries near neighbours of point 0 first."""
    far = lambda i: sum((x - y) ** 2 for x, y in zip(s.original[i], s.original[0]))
    near = sorted(range(1, len(s.original)), key=far)
    for reach in range(s.k, len(near) + 1):
        for rest in combinations(near[:reach - 1], s.k - 1):
            simplex = (0, *rest, near[reach - 1])
            if s.orientation(simplex) and all(v in simplex or s.in_ball(simplex, v, True) < 0 for v in near):
                return simplex
    raise AssertionError("no first simplex")


def oriented(s, simplex):
    """The simplex, positively oriented."""
    t = tuple(simplex)
    return t if s.orientation(t) > 0 or len(t) < 2 else (t[1], t[0], *t[2:])
