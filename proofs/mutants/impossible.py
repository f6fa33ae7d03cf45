"""A domain that has no triangulation, and what does not show it: two diagonals of an octahedron that cross."""

import copy
import itertools
import math
from fractions import Fraction

from domains import part, part_text, polygon_text, space_domain, triangle_polygon
from honest import certificate, side, text as mesh_text

POINTS = [(2, 0, 0), (-2, 0, 0), (0, 2, 0), (0, -2, 0), (0, 0, 2), (0, 0, -2), (3, 3, 3), (4, 1, 1)]
SEGMENTS = [(0, 1), (2, 3)]
CANDIDATES = list(itertools.combinations(range(len(POINTS)), 4))


def determinant(u, v, w):
    return sum(u[i] * (v[(i + 1) % 3] * w[(i + 2) % 3] - v[(i + 2) % 3] * w[(i + 1) % 3]) for i in range(3))


def orientation(a, b, c, d):
    return determinant(*[[x - y for x, y in zip(p, d)] for p in (a, b, c)])


def barycentric(simplex, q):
    """The coordinates of q in a tetrahedron of points that is not flat."""
    corners = [POINTS[v] for v in simplex]
    whole = orientation(*corners)
    return [Fraction(orientation(*corners[:i], q, *corners[i + 1:]), whole) for i in range(4)]


def carrier(simplex, q):
    """The vertices with positive coordinates; nothing if q is not in the tetrahedron."""
    weights = barycentric(simplex, q)
    return {v for v, x in zip(simplex, weights) if x > 0} if min(weights) >= 0 else set()


def fate(simplex):
    if orientation(*[POINTS[v] for v in simplex]) == 0:
        return "flat"
    for v, point in enumerate(POINTS):
        if carrier(simplex, point) - {v}:
            return "vertex %d" % (v + 1)
    for number, segment in enumerate(SEGMENTS, 1):  # both have the origin in the middle
        if carrier(simplex, (0, 0, 0)) - set(segment):
            return "segment %d 0 0 0 1" % number
    return "free"


FATES = [fate(simplex) for simplex in CANDIDATES]
FREE = [k for k, word in enumerate(FATES) if word == "free"]
ORIGIN = "covers segment 1 0 0 0 1"


def number(vertices):
    return CANDIDATES.index(tuple(sorted(vertices))) + 1


def centre(vertices):
    """As the tokens of a line."""
    return " ".join(str(sum(POINTS[v][axis] for v in vertices)) for axis in range(3)) + " %d" % len(vertices)


def overlap():
    """Two candidates that may be chosen, one with the centre of a face of the other."""
    for k, n in itertools.permutations(FREE, 2):
        for size in (2, 3, 4):
            for face in itertools.combinations(CANDIDATES[k], size):
                q = [Fraction(sum(POINTS[v][axis] for v in face), size) for axis in range(3)]
                if carrier(CANDIDATES[n], q) not in (set(), set(face)):
                    return "not-both %d %d %s" % (k + 1, n + 1, centre(face))
    raise AssertionError("no candidates overlap")


def beyond(simplex, place):
    """The vertices strictly beyond a facet."""
    return [v for v, p in enumerate(POINTS) if barycentric(simplex, p)[place] < 0]


def beside(k, place):
    simplex = CANDIDATES[k]
    facet = simplex[:place] + simplex[place + 1:]
    others = [number(facet + (v,)) for v in beyond(simplex, place)]
    return " ".join(map(str, ["beside", k + 1, place, centre(facet), *others]))


# A facet inside the hull, behind which there is nothing that may be chosen; and one on the hull.
INNER = next((k, i) for k in FREE for i in range(4) if beyond(CANDIDATES[k], i) and not any(
    FATES[number(set(CANDIDATES[k]) - {CANDIDATES[k][i]} | {v}) - 1] == "free" for v in beyond(CANDIDATES[k], i)))
OUTER = next((k, i) for k in FREE for i in range(4) if not beyond(CANDIDATES[k], i))



def mesh_of_hull(points, core):
    """The simplices of the core, and around them, point by point, those that make their hull convex again."""
    simplices = list(core)
    for v in range(len(points)):
        if any(v in s for s in simplices):
            continue
        facets = {}
        for s in simplices:
            for i in range(4):
                facets.setdefault(frozenset(s) - {s[i]}, []).append((s, i))
        for where in facets.values():
            s, i = where[0]
            corners = [points[u] for u in s]
            if len(where) == 1 and side(corners, i, points[v]) * side(corners, 0, corners[0]) < 0:
                simplices.append(s[:i] + (v,) + s[i + 1:])
    return simplices


def mesh(change=lambda m: None, chains=((0, 8, 1), (2, 8, 3)), corners=range(8)):
    """A mesh of the domain, in which the diagonals meet in a vertex."""
    points = POINTS + [(0, 0, 0)]
    core = [(8, x, y, z) for x in (0, 1) for y in (2, 3) for z in (4, 5)]
    made = certificate("triangulation", points, mesh_of_hull(points, core))
    made["scale"] = [1, 2]
    number = {row[4]: k + 1 for k, row in enumerate(made["points"])}
    m = {"mesh": made, "part": part(made, len(made["simplices"]), set(corners), list(chains), {},
                                    weights={8: [[1, number[0]], [1, number[1]]]}), "polygons": []}
    change(m)
    return m


def body_text(m):
    lines = mesh_text(m["mesh"]).split("\n")[1:-2] + part_text(m["part"]) + ["polygons %d" % len(m["polygons"])]
    return lines + [line for f in m["polygons"] for line in polygon_text(f)]


SOUND = {"scale": "1 2", "segments": SEGMENTS, "holes": [], "candidates": FATES,
         "clauses": [beside(*INNER), "covers vertex 7", overlap(), ORIGIN],
         "steps": ["-%d 0 1" % (INNER[0] + 1), "0 4"], "mesh": [mesh()]}

# A triangle in space, which dangles: it has a triangulation, though no tetrahedron covers any of
# it. The mesh is one of a tetrahedron with this facet.
TETRAHEDRON = [(0, 0, 0), (0, 3, 0), (3, 0, 0), (9, 9, 9)]
AROUND = space_domain("steiner-triangulation", "enclosed", TETRAHEDRON, [(0, 1, 2, 3)], 1,
                      list(itertools.combinations(range(4), 3)), list(itertools.combinations(range(4), 2)))
ONE_TRIANGLE = {"kind": "enclosed", "scale": "1 1", "vertices": TETRAHEDRON[:3], "segments": [(0, 1), (0, 2), (1, 2)], "holes": [],
                "polygons": [triangle_polygon(AROUND["mesh"], TETRAHEDRON, (0, 1, 2))], "mesh": [AROUND],
                "candidates": [], "clauses": ["covers vertex 1"], "steps": ["0 1"]}


def many_covers(vertices=24, covers=2500):
    """A small file that asks for much: of these points, on a curve, any four may be chosen, and each clause lists a sixth of them."""
    points = [(t, t ** 2, t ** 3) for t in range(1, vertices + 1)]
    made = certificate("triangulation", points, mesh_of_hull(points, [(0, 1, 2, 3)]))
    body = {"mesh": made, "part": part(made, len(made["simplices"]), set(range(vertices)), [], {}), "polygons": []}
    return {"scale": "1 1", "vertices": points, "segments": [], "holes": [], "mesh": [body],
            "candidates": ["free"] * math.comb(vertices, 4), "clauses": ["covers vertex 1"] * covers, "steps": ["0 1"]}


def text(c):
    vertices, polygons = c.get("vertices", POINTS), c.get("polygons", [])
    lines = ["circumspect-impossibility 2 %s 3 %s" % (c.get("claim", "plc-triangulation"), c.get("kind", "hull")), "scale " + c["scale"],
             "vertices %d" % len(vertices), *(" ".join(map(str, p)) for p in vertices),
             "segments %d" % len(c["segments"]), *("%d %d" % (a + 1, b + 1) for a, b in c["segments"]),
             "holes %d" % len(c["holes"]), *c["holes"], "polygons %d" % len(polygons)]
    lines += [line for f in polygons for line in polygon_text(f)] + ["mesh"] + body_text(c["mesh"][0])
    for section in ("candidates", "clauses", "steps"):
        lines += ["%s %d" % (section, len(c[section])), *c[section]]
    return "\n".join(lines + ["end"]) + "\n"


def files():
    yield "sound--impossible", text(SOUND), \
        "verified: no triangulation without Steiner points; domain: hull, 8 vertices, 2 segments"
    yield "sound--impossible-cdt", text({**SOUND, "claim": "cdt"}), \
        "verified: no CDT without Steiner points; domain: hull, 8 vertices, 2 segments"

    def mutant(name, section, place, line, answer):
        c = copy.deepcopy(SOUND)
        if place is None:
            c[section] = line
        else:
            c[section][place] = line
        return name, text(c), "rejected: " + answer

    flat = FATES.index("flat")
    free = FREE[0]
    pierced = next(k for k, word in enumerate(FATES) if word.startswith("segment"))
    for why, k, line in [
            ("not-flat", free, "flat"), ("flat", flat, "free"), ("a-vertex-elsewhere", free, "segment 1 0 0 0 1"),
            ("its-own-vertex", free, "vertex %d" % (CANDIDATES[free][0] + 1)),
            ("its-own-edge", number((0, 1, 2, 4)) - 1, "segment 1 0 0 0 1"),
            ("off-the-segment", pierced, "segment 1 0 0 1 1"), ("no-segment", pierced, "segment 3 0 0 0 1"),
            ("no-point", pierced, "segment 1 0 0 0 0"), ("no-piece", pierced, "piece 1 1 0 0 0 1"),
            ("what-is-seen-from-a-triangulation", free, "sees %d %s" % (INNER[0] + 1, centre(CANDIDATES[free])))]:
        yield mutant("fate-shown--" + why, "candidates", k, line, "fate-shown, candidate %d" % (k + 1))
    both = SOUND["clauses"][2].split()
    shared = next(v for v in CANDIDATES[int(both[1]) - 1] if v in CANDIDATES[int(both[2]) - 1])
    for why, place, line in [
            ("a-shared-vertex", 2, " ".join(both[:3]) + " %d %d %d 1" % POINTS[shared]),
            ("not-free", 2, "not-both %d %d %s" % (pierced + 1, pierced + 1, " ".join(both[3:]))),
            ("the-same", 2, " ".join([both[0], both[1], both[1], *both[3:]])),
            ("on-the-hull", 0, beside(*OUTER)),
            ("no-neighbour", 0, SOUND["clauses"][0].rsplit(" ", 1)[0]),
            ("no-facet", 0, SOUND["clauses"][0].replace(" %d " % INNER[1], " 4 ", 1)),
            ("off-the-facet", 0, "beside %d %d %d %d %d 1 %s" % (
                INNER[0] + 1, INNER[1], *POINTS[0], " ".join(SOUND["clauses"][0].split()[7:]))),
            ("no-such-segment", 3, "covers segment 3 0 0 0 1"), ("no-such-vertex", 1, "covers vertex 9"),
            ("off-the-segment", 3, "covers segment 1 0 0 1 1")]:
        yield mutant("reason-shown--" + why, "clauses", place, line, "reason-shown, clause %d" % (place + 1))
    for why, steps in [("no-steps", []), ("not-empty", SOUND["steps"][:1]), ("another-clause", ["0 1"]),
                       ("not-unit", ["0 2 4"]), ("a-later-clause", ["0 5"]), ("no-hints", ["0"]),
                       ("no-such-clause", ["0 9"])]:
        yield mutant("clauses-refuted--" + why, "steps", None, steps, "clauses-refuted")
    yield "large--many-covers", text(many_covers()), "refused: "
    yield "mesh-of-the-domain--something-dangles", text(ONE_TRIANGLE), "rejected: mesh-of-the-domain"

    def another_scale(m):
        m["mesh"]["scale"] = [1, 3]

    def no_step(m):
        m["part"]["segments"][0][1][1] = next(
            t + 1 for t, row in enumerate(m["mesh"]["simplices"]) if m["part"]["segments"][0][0] not in row[0])

    for why, other in [("a-segment-less", mesh(chains=[(0, 8, 1)])), ("another-segment", mesh(chains=[(0, 8, 1), (4, 8, 5)])),
                       ("another-scale", mesh(another_scale)), ("a-vertex-more", mesh(corners=range(9)))]:
        yield mutant("mesh-of-the-domain--" + why, "mesh", 0, other, "mesh-of-the-domain")
    yield mutant("segment-linked--of-another-mesh", "mesh", 0, mesh(no_step), "segment-linked, segment 1")
    yield mutant("segment-linked--of-no-mesh", "segments", 0, (0, 8), "segment-linked, segment 1")
    yield mutant("hole-inside--of-no-mesh", "holes", None, ["0 0 0 0"], "hole-inside, hole 1")
    yield mutant("scale--of-no-mesh", "scale", None, "-1 2", "scale")
    c = copy.deepcopy(SOUND)
    c["candidates"].pop()
    yield "malformed--candidates", text(c), "malformed: "
