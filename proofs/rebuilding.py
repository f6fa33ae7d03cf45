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
        # The middle of the first simplex: w times its coordinates, in lowest terms.
        sums = [sum(xs) for xs in zip(*self.corner_places(0))]
        w = (d + 1) // math.gcd(d + 1, *sums)
        sample = [x * w // (d + 1) for x in sums]

        def wall(t, i):
            if (t, i) in across:
                return [across[t, i][0] + 1, across[t, i][1]]
            return ["-", hull.index((t, i)) + 1]

        def away(t):
            places = [[x * w for x in place] for place in self.corner_places(t)]
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
        lines += [["sample", 1, *sample, w]]
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


class Listed:
    """The points and simplices of a certificate that has no mesh of a hull; `of_simplices` names the section of these."""
    of_simplices = "simplices"

    def __init__(self, text):
        self.lines = [line.split() for line in text.splitlines()]
        heads = {line[0]: i for i, line in reversed(list(enumerate(self.lines))) if len(line) in (2, 3) and re.fullmatch("[a-z]+", line[0])}
        self.heads = heads
        self.points, self.simplices = (Section(self.lines, heads[name]) for name in ("points", self.of_simplices))
        self.d = int(self.lines[0][3])

    def replace(self, section, rows):
        """Writes the rows of a section anew, of whatever number."""
        at = section.begin - 1
        self.lines[at:section.end] = [[section.name, len(rows), *self.lines[at][2:]], *rows]

    def written(self):
        return "\n".join(" ".join(map(str, line)) for line in self.lines) + "\n"

    def vary(self, rows, dice, corners, points):
        """Another vertex, a simplex left out, listed twice or with a vertex of another, or a point that moves."""
        t, how = dice.randrange(len(rows)), dice.randrange(6)
        place = dice.randrange(corners)
        if how == 0:
            rows[t][place] = str(dice.randint(1, len(points)))
        elif how == 1 and len(rows) > 1:
            del rows[t]
        elif how == 2:
            rows.append(list(rows[t]))
        elif how == 3:
            u = dice.randrange(len(rows))
            rows[t][place], rows[u][place] = rows[u][place], rows[t][place]
        else:
            row, axis = dice.choice(points), dice.randrange(self.d)
            row[axis] = str(int(row[axis]) + dice.choice((-1, 1)) * (1 if how == 4 else 1 << dice.randrange(40)))


class Alone(Listed):
    """Of the claim `complex`: the points' own simplices and the order are made anew; pads and planes stay."""

    def altered(self, dice):
        corners = int(self.lines[self.heads["simplices"]][2])
        rows, points = [list(row) for row in self.simplices.rows], [list(row) for row in self.points.rows]
        order = [int(row[0]) - 1 for row in Section(self.lines, self.heads["order"]).rows]
        kept = {id(row): old for old, row in enumerate(rows)}
        self.vary(rows, dice, corners, points)
        new = {old: i for i, row in enumerate(rows) if (old := kept.get(id(row))) is not None}
        order = [new[old] for old in order if old in new] + [i for i, row in enumerate(rows) if id(row) not in kept]
        place = {t: i for i, t in enumerate(order)}
        pads = corners + 1 + (self.d + 1 - corners) * self.d
        for t, row in enumerate(rows):
            row[corners] = str(place[t] + 1)
            planes = [row[i:i + self.d + 2] for i in range(pads, len(row), self.d + 2)]
            row[pads:] = [x for u, *plane in planes if int(u) - 1 in new for x in (str(new[int(u) - 1] + 1), *plane)]
        for v, row in enumerate(points):
            own = next(((t, each[:corners].index(str(v + 1))) for t, each in enumerate(rows) if str(v + 1) in each[:corners]), (0, 0))
            row[self.d:self.d + 2] = [own[0] + 1, own[1]]
        self.replace(Section(self.lines, self.heads["order"]), [[t + 1] for t in order])
        self.replace(self.simplices, rows)
        self.replace(self.points, points)
        return self.written()


class Surface(Listed):
    """Of the claim `surface-delaunay`: the edges are put in order anew."""
    of_simplices = "triangles"

    def altered(self, dice):
        rows, points = [row[:3] for row in self.simplices.rows], [list(row) for row in self.points.rows]
        self.vary(rows, dice, 3, points)
        corners = [[int(v) for v in row] for row in rows]
        edges = sorted((*sorted(row[:i] + row[i + 1:]), row[i], t, i) for t, row in enumerate(corners) for i in range(3))
        place = {edge[3:]: at + 1 for at, edge in enumerate(edges)}
        self.replace(Section(self.lines, self.heads["edges"]), [[t + 1, i] for *_, t, i in edges])
        self.replace(self.simplices, [[*row, *(place[t, i] for i in range(3))] for t, row in enumerate(rows)])
        self.replace(self.points, points)
        return self.written()


class Cells(Listed):
    """Of the claim `periodic-delaunay`: the dual vectors, the links and the sample point are made anew."""
    of_simplices = "cells"

    def __init__(self, text):
        super().__init__(text)
        d = self.d
        self.lattice = Section(self.lines, self.heads["lattice"])
        self.basis = [[int(x) for x in row] for row in self.lattice.rows]
        self.place = [[int(x) for x in row[:d]] for row in self.points.rows]
        # Of each corner the point, from 0, and its offset.
        self.corners = [[(int(row[i]) - 1, tuple(map(int, row[i + 1:i + 1 + d]))) for i in range(0, (d + 1) ** 2, d + 1)]
                        for row in self.simplices.rows]

    def files(self, node, ele):
        """The points and cells as files of their user."""
        unit = Fraction(*map(int, self.lines[1][1:3]))
        labels = [row[-1] for row in self.points.rows]
        order = sorted(range(len(labels)), key=lambda v: int(labels[v]))
        rows = [[labels[v], *(unit * x for x in self.place[v])] for v in order]
        node.write_text("\n".join(" ".join(map(str, row)) for row in [[len(rows), self.d, 0], *rows]) + "\n")
        cells = [[t, *(labels[v] for v, _ in row), *(x for _, offset in row for x in offset)] for t, row in enumerate(self.corners)]
        header = [len(cells), self.d + 1, self.d * (self.d + 1)]
        ele.write_text("\n".join(" ".join(map(str, row)) for row in [header, *cells]) + "\n")

    def vary_cells(self, dice):
        t, i, axis = dice.randrange(len(self.corners)), dice.randrange(self.d + 1), dice.randrange(self.d)
        how, step = dice.randrange(8), dice.choice((-1, 1))
        v, offset = self.corners[t][i]
        if how == 0:
            self.corners[t][i] = (dice.randrange(len(self.place)), offset)
        elif how == 1:
            self.corners[t][i] = (v, tuple(x + step * (a == axis) for a, x in enumerate(offset)))
        elif how == 2 and len(self.corners) > 1:
            del self.corners[t]
        elif how == 3:  # the same cell, in another place
            self.corners.append([(w, tuple(x + step * (a == axis) for a, x in enumerate(o))) for w, o in self.corners[t]])
        elif how == 7:  # two sheets
            self.corners += [list(row) for row in self.corners]
        elif how == 4:
            self.basis[dice.randrange(self.d)][axis] += step * dice.choice((1, 1 << dice.randrange(12)))
        else:
            self.place[v][axis] += step * (1 if how == 5 else 1 << dice.randrange(12))

    def where(self, t):
        return [[x + sum(o * b[a] for o, b in zip(offset, self.basis)) for a, x in enumerate(self.place[v])]
                for v, offset in self.corners[t]]

    def links(self):
        """Across each facet the cell that has it, too; if there is none, the cell itself."""
        across, facets = {}, {}
        for t, row in enumerate(self.corners):
            for i in range(self.d + 1):
                rest = sorted(row[:i] + row[i + 1:])
                first = rest[0][1]
                shape = tuple((v, tuple(x - y for x, y in zip(o, first))) for v, o in rest)
                facets.setdefault(shape, []).append((t, i, first))
        for same in facets.values():
            for (t, i, o), (u, j, p) in zip(same[::2], same[1::2]):
                across[t, i] = (u, j, [x - y for x, y in zip(o, p)])
                across[u, j] = (t, i, [y - x for x, y in zip(o, p)])
        return across

    def altered(self, dice):
        self.vary_cells(dice)
        d, det = self.d, determinant(self.basis)
        if det == 0:
            return None
        dual = [[determinant([row if k != a else [int(c == b) for c in range(d)] for k, row in enumerate(self.basis)])
                 * (1 if det > 0 else -1) for b in range(d)] for a in range(d)]
        across = self.links()
        homes = {}
        for t, row in enumerate(self.corners):
            for i, (v, _) in enumerate(row):
                homes.setdefault(v, (t + 1, i))
        rows = []
        for t, row in enumerate(self.corners):
            links = [across.get((t, i), (t, i, [0] * d)) for i in range(d + 1)]
            rows.append([*(x for v, o in row for x in (v + 1, *o)), *(x for u, j, o in links for x in (u + 1, j, *o))])
        sample = [sum(xs) for xs in zip(*self.where(0))]
        points = [[*place, *homes.get(v, (1, 0)), row[-1]] for v, (place, row) in enumerate(zip(self.place, self.points.rows))]
        self.lines[-2] = ["sample", 1, *sample, d + 1]
        self.replace(self.simplices, rows)
        self.replace(self.points, points)
        self.lines[self.heads["factor"]][1] = abs(det)
        self.replace(Section(self.lines, self.heads["dual"]), dual)
        self.replace(self.lattice, self.basis)
        return self.written()


def filled_gap(text):
    """The refutation of a hull, with the facet that is missing where it looks; none, if it is another one."""
    lines = text.splitlines()
    if not lines[0].startswith("circumspect-refutation 2 convex-hull ") or not lines[0].endswith(" hull.uncovered"):
        return None
    d, at = int(lines[0].split()[3]), next(i for i, line in enumerate(lines) if line.startswith("simplices "))
    facet = next(line for line in lines if line.startswith("because ")).split()[1:1 + d]
    lines[at:at + 1] = [f"simplices {int(lines[at].split()[1]) + 1}", f"{d}  {' '.join(facet)}"]
    return "\n".join(lines) + "\n"


def files_of_cells(file, stem):
    """The mesh of a certificate that a lattice repeats, as files MESH.node and MESH.ele; none, if it cannot be read."""
    own = [stem.with_suffix(".node"), stem.with_suffix(".ele")]
    try:
        Cells(file.read_text()).files(*own)
    except (KeyError, ValueError, IndexError, ZeroDivisionError):
        return None
    return own


def rebuilt(text, dice):
    """The certificate with another mesh, if it has one."""
    if text.startswith("circumspect-refutation"):
        return filled_gap(text)
    other = {"complex": Alone, "surface-delaunay": Surface, "periodic-delaunay": Cells}.get(text.split(None, 3)[2])
    try:
        if other is not None:
            return other(text).altered(dice)
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
        elif how == 2 and mesh.marks is None:  # one simplex twice, or all of them
            mesh.corners += [list(row) for row in (mesh.corners if dice.randrange(2) else [mesh.corners[t]])]
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
