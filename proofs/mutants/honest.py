"""Certificates that are as honest as their meshes: what make.py and domains.py begin with."""

import math
from fractions import Fraction


def determinant(rows):
    if not rows:
        return 1
    return sum((-1) ** i * rows[0][i] * determinant([r[:i] + r[i + 1:] for r in rows[1:]])
               for i in range(len(rows)))


def orientation(points):
    last = points[-1]
    return determinant([[x - y for x, y in zip(p, last)] for p in points[:-1]])


def side(points, i, q):
    """The orientation with point i replaced by q."""
    return orientation(points[:i] + [q] + points[i + 1:])


def pair_up(places):
    """Which place is matched with which: those in which the same face stands, two and two."""
    across = {}
    for where in places.values():
        for a, b in zip(where[::2], where[1::2]):
            across[a], across[b] = b, a
    return across


def certificate(claim, points, simplices, weights=None, start=0, sample=None, glue=lambda f: True):
    """The parts of a certificate; `glue` says which facets are matched where two simplices meet."""
    d = len(points[0])
    order = sorted(range(len(points)), key=lambda v: points[v])
    number = {v: k for k, v in enumerate(order)}
    place = [points[v] for v in order]
    simplices = [[number[v] for v in s] for s in simplices]
    for s in simplices:
        if orientation([place[v] for v in s]) < 0:
            s[0], s[1] = s[1], s[0]
    facets = {}
    for t, s in enumerate(simplices):
        for i in range(d + 1):
            facet = frozenset(s) - {s[i]}
            key = facet if glue({order[v] for v in facet}) else (t, i)
            facets.setdefault(key, []).append((t, i))
    across = pair_up(facets)
    hull = [(t, i) for t in range(len(simplices)) for i in range(d + 1) if (t, i) not in across]
    ridges = {}
    for h, (t, i) in enumerate(hull):
        face = simplices[t][:i] + simplices[t][i + 1:]
        for a in range(d):
            ridges.setdefault(frozenset(face) - {face[a]}, []).append((h, a))
    beyond = pair_up(ridges)
    if sample is None:
        corners = [place[v] for v in simplices[start]]
        sample = [Fraction(sum(xs), d + 1) for xs in zip(*corners)]
    w = math.lcm(*(x.denominator for x in map(Fraction, sample)))

    def away(t, s):
        corners = [place[v] for v in s]
        outer = [i for i in range(d + 1) if side(corners, i, sample) < 0]
        return "-" if t == start else outer[0] if outer else 0

    def home(v):
        return next(((t + 1, simplices[t].index(v)) for t in reversed(range(len(simplices)))
                     if v in simplices[t]), (1, 0))

    return {
        "claim": claim, "d": d, "scale": [1, 1],
        "points": [[list(place[v]), [weights[order[v]]] if weights else [], *home(v), order[v]]
                   for v in range(len(points))],
        "simplices": [[[v + 1 for v in s],
                       [[across[t, i][0] + 1, across[t, i][1]] if (t, i) in across
                        else ["-", hull.index((t, i)) + 1] for i in range(d + 1)],
                       away(t, s)] for t, s in enumerate(simplices)],
        "hull": [[t + 1, i, [[beyond[h, a][0] + 1, beyond[h, a][1]] if (h, a) in beyond else [1, 0]
                             for a in range(d)]] for h, (t, i) in enumerate(hull)],
        "sample": [start + 1, [int(x * w) for x in map(Fraction, sample)], w],
    }


def flat(thing):
    return [x for part in thing for x in flat(part)] if isinstance(thing, list) else [thing]


def text(c):
    lines = ["circumspect-certificate 1 %s %d%s" % (c["claim"], c["d"], c.get("standing", "")),
             " ".join(map(str, ["scale"] + c["scale"]))]
    for name in ["points", "simplices", "hull"]:
        lines.append("%s %d" % (name, len(c[name])))
        lines += [" ".join(map(str, flat(row))) for row in c[name]]
    lines.append(" ".join(map(str, flat(["sample", c["sample"]]))))
    return "\n".join(lines + ["end"]) + "\n"
