"""A forger that knows the format: it changes the mesh of a certificate, and then writes all that points into it anew.

What is left to find is wrong in space alone. The parts that a domain adds stay as they are, but for the marks: a simplex that is no
longer kept gets a way out, and one that is kept loses its own.
"""
import math
import re
from fractions import Fraction


def determinant(rows):
    if not rows:
        return 1
    return sum((-1) ** i * rows[0][i] * determinant([row[:i] + row[i + 1:] for row in rows[1:]]) for i in range(len(rows)) if rows[0][i])


def orientation(points):
    return determinant([[x - y for x, y in zip(point, points[-1])] for point in points[:-1]])


def side(points, i, q):
    return orientation(points[:i] + [q] + points[i + 1:])


class Section:
    """`NAME COUNT` and so many lines."""

    def __init__(self, lines, at):
        self.begin, self.name = at + 1, lines[at][0]
        self.end = self.begin + int(lines[at][1])
        self.rows = lines[self.begin:self.end]


class Mesh:
    """The first mesh of a certificate, from `points` to `sample`: its rows, and what they mean."""

    def __init__(self, text):
        self.lines = [line.split() for line in text.splitlines()]
        heads = {}
        for i, line in enumerate(self.lines):
            if line and len(line) == 2 and re.fullmatch("[a-z]+", line[0]):
                heads.setdefault(line[0], i)
        self.points, self.simplices, self.hull = (Section(self.lines, heads[name]) for name in ("points", "simplices", "hull"))
        self.sample = self.hull.end
        self.d = len(self.hull.rows[0]) // 2 - 1
        # The coordinates, a weight if there is one, T, I and the label.
        self.place = [[int(x) for x in row[:self.d]] for row in self.points.rows]
        self.weight = [row[self.d:-3] for row in self.points.rows]
        self.label = [row[-1] for row in self.points.rows]
        self.corners = [[int(v) - 1 for v in row[:self.d + 1]] for row in self.simplices.rows]
        marks = heads.get("marks")
        self.marks = Section(self.lines, marks) if marks is not None else None

    def corner_places(self, t):
        return [self.place[v] for v in self.corners[t]]

    def is_sound(self):
        known = all(0 <= v < len(self.place) for row in self.corners for v in row)
        return bool(self.corners) and known and self.place == sorted(self.place)

    def written(self):
        """The text again, with all pointers of the mesh made anew."""
        d, across = self.d, {}
        for t in range(len(self.corners)):
            if orientation(self.corner_places(t)) < 0:
                self.corners[t][-2:] = self.corners[t][:-3:-1]
        uses = {}
        for t, corners in enumerate(self.corners):
            for i in range(d + 1):
                uses.setdefault(frozenset(corners[:i] + corners[i + 1:]), []).append((t, i))
        pair_up(uses, across)
        hull = [(t, i) for t in range(len(self.corners)) for i in range(d + 1) if (t, i) not in across]
        beyond, ridges = {}, {}
        for h, (t, i) in enumerate(hull):
            face = self.corners[t][:i] + self.corners[t][i + 1:]
            for a in range(d):
                ridges.setdefault(frozenset(face[:a] + face[a + 1:]), []).append((h, a))
        pair_up(ridges, beyond)
        sample = [Fraction(sum(xs), d + 1) for xs in zip(*self.corner_places(0))]
        w = math.lcm(*(x.denominator for x in sample))

        def wall(t, i):
            if (t, i) in across:
                return [across[t, i][0] + 1, across[t, i][1]]
            return ["-", hull.index((t, i)) + 1]

        def away(t):
            places = self.corner_places(t)
            outer = [i for i in range(d + 1) if side(places, i, sample) < 0]
            return "-" if t == 0 else outer[0] if outer else 0

        def home(v):
            for t, corners in enumerate(self.corners):
                if v in corners:
                    return [t + 1, corners.index(v)]
            for t in range(len(self.corners)):
                if all(side(self.corner_places(t), i, self.place[v]) >= 0 for i in range(d + 1)):
                    return [t + 1, "-"]
            return [1, 0]

        lines = self.lines[:self.points.begin - 1]
        lines += [["points", len(self.place)]]
        lines += [[*self.place[v], *self.weight[v], *home(v), self.label[v]] for v in range(len(self.place))]
        lines += [["simplices", len(self.corners)]]
        lines += [[*(v + 1 for v in corners), *(x for i in range(d + 1) for x in wall(t, i)), away(t)] for t, corners in enumerate(self.corners)]
        lines += [["hull", len(hull)]]
        lines += [[t + 1, i, *(x for a in range(d) for x in ((beyond[h, a][0] + 1, beyond[h, a][1]) if (h, a) in beyond else (1, 0)))]
                  for h, (t, i) in enumerate(hull)]
        lines += [["sample", 1, *(int(x * w) for x in sample), w]]
        rest = self.lines[self.sample + 1:]
        if self.marks is not None:
            begin = self.marks.begin - self.sample - 2
            rest[begin:begin + 1 + len(self.marks.rows)] = [["marks", len(self.marked(across))], *self.marked(across)]
        return "\n".join(" ".join(map(str, line)) for line in lines + rest) + "\n"

    def marked(self, across):
        """The marks, where each simplex that is not kept has a shortest way out through facets without a flag."""
        rows = [row[:self.d * 2 + 3] for row in self.marks.rows]
        flags = []
        for row in rows:
            tokens, found = row[1:], []
            while len(found) < self.d + 1 and tokens:
                found.append(tokens[:1] if tokens[0] == "-" else tokens[:2])
                tokens = tokens[len(found[-1]):]
            flags.append(found)
        rank, ways = {}, {}
        for t, row in enumerate(self.marks.rows[:len(self.corners)]):
            if row[0] == "-" and "hole" in row:
                rank[t], ways[t] = 1, ["hole", row[row.index("hole") + 1]]
        changed = True
        while changed:
            changed = False
            for t, row in enumerate(rows[:len(self.corners)]):
                if row[0] == "+" or t in rank or len(flags[t]) != self.d + 1:
                    continue
                for i in range(self.d + 1):
                    if flags[t][i] != ["-"]:
                        continue
                    beyond = across.get((t, i))
                    if beyond is None or beyond[0] in rank:
                        rank[t] = 1 if beyond is None else rank[beyond[0]] + 1
                        ways[t] = ["out" if beyond is None else "across", i]
                        changed = True
                        break
        return [[row[0], *(x for flag in flags[t] for x in flag), *([*ways.get(t, ["out", 0]), rank.get(t, 1)] if row[0] == "-" else [])]
                for t, row in enumerate(rows)]


def pair_up(places, across):
    for where in places.values():
        for a, b in zip(where[::2], where[1::2]):
            across[a], across[b] = b, a


def rebuilt(text, dice):
    """The certificate with another mesh, if it has one."""
    try:
        mesh = Mesh(text)
    except (KeyError, ValueError, IndexError):
        return None
    for _ in range(dice.choice((1, 1, 2))):
        t = dice.randrange(len(mesh.corners))
        how = dice.randrange(8)
        if how == 0:  # another vertex
            mesh.corners[t][dice.randrange(mesh.d + 1)] = dice.randrange(len(mesh.place))
        elif how == 1 and len(mesh.corners) > 1 and mesh.marks is None:
            del mesh.corners[t]
        elif how == 2 and mesh.marks is None:
            mesh.corners.append(list(mesh.corners[t]))
        elif how == 3:  # a flip of two neighbours, in the plane; in space two that are flipped to overlap
            mine = set(mesh.corners[t])
            others = [u for u, corners in enumerate(mesh.corners) if len(mine - set(corners)) == 1 == len(set(corners) - mine)]
            if others:
                u = dice.choice(others)
                (apex,), (own,) = set(mesh.corners[u]) - mine, mine - set(mesh.corners[u])
                shared = sorted(mine & set(mesh.corners[u]))
                first, second = dice.sample(shared, 2)
                mesh.corners[t][mesh.corners[t].index(first)] = apex
                mesh.corners[u][mesh.corners[u].index(second)] = own
        elif how in (4, 5):  # a point moves, where it stands in their order
            v = dice.randrange(len(mesh.place))
            axis = dice.randrange(mesh.d)
            mesh.place[v][axis] += dice.choice((-1, 1)) * (1 if how == 4 else 1 << dice.randrange(60))
            if not mesh.is_sound():
                return None
        elif how == 6 and mesh.marks is not None:
            row = dice.choice(mesh.marks.rows)
            row[0] = "-" if row[0] == "+" else "+"
        elif how == 7 and mesh.marks is not None and len(mesh.corners) > 1:  # two simplices change places
            u = dice.randrange(len(mesh.corners))
            mesh.corners[t], mesh.corners[u] = mesh.corners[u], mesh.corners[t]
    return mesh.written() if mesh.is_sound() else None
