"""Piecewise linear complexes, written to corpus/domains/*.poly: python3 corpus/make/make.py

All coordinates are doubles, so that every program reads the same points.
"""
from dataclasses import dataclass, field
from fractions import Fraction

import files


@dataclass
class Domain:
    name: str
    what: str       # which figure of the book, or why it is nasty
    points: list
    facets: list    # in space: [(lines, points in holes)]; in the plane: segments
    holes: list = field(default_factory=list)
    # For Gmsh, which wants to be told the volumes: each a list of shells, a shell a list of facets.
    # None: one volume bounded by every facet, with `inside` embedded in it. Nothing: not for Gmsh.
    rooms: list = None
    inside: list = ()


def box(low, high):
    points = [(high[0] if i & 1 else low[0], high[1] if i & 2 else low[1], high[2] if i & 4 else low[2])
              for i in range(8)]
    return points, [(0, 1, 3, 2), (4, 5, 7, 6), (0, 1, 5, 4), (2, 3, 7, 6), (0, 2, 6, 4), (1, 3, 7, 5)]


def facets(polygons):
    return [([polygon], []) for polygon in polygons]


def joined(*parts):
    """Points and polygons of several complexes in one."""
    points, polygons = [], []
    for some_points, some_polygons in parts:
        polygons += [tuple(v + len(points) for v in p) for p in some_polygons]
        points += some_points
    return points, polygons


def prism(outline, low, high):
    n = len(outline)
    points = [(x, y, z) for z in (low, high) for x, y in outline]
    return points, [tuple(range(n)), tuple(range(n, 2 * n)),
                    *((i, (i + 1) % n, (i + 1) % n + n, i + n) for i in range(n))]


def schonhardt():
    points = [(10, 0, 0), (-5, 9, 0), (-5, -9, 0), (9, 5, 10), (-9, 5, 10), (0, -10, 10)]
    sides = [t for i in range(3) for j in [(i + 1) % 3] for t in [(i, j, j + 3), (i, j + 3, i + 3)]]
    return points, [(0, 1, 2), (3, 4, 5), *sides]


def prism_on_a_sphere():
    """A twisted prism with an apex below its open floor, all at distance 65 from the origin."""
    points = [(65, 0, 0), (-33, 56, 0), (-33, -56, 0), (24, 7, 60), (-20, 15, 60), (-7, -24, 60), (0, 0, -65)]
    sides = [t for i in range(3) for j in [(i + 1) % 3] for t in [(i, j, j + 3), (i, j + 3, i + 3), (i, j, 6)]]
    return points, [(3, 4, 5), *sides]


def chazelle(notches, places=None):
    """Wedges cut out of a box from below and from above; their edges lie on z = xy and just above it.

    They stand at 1, 2, ... notches, or at some of these places only.
    """
    side = notches + 1
    places = places or range(1, side)
    floor, ceiling, gap = Fraction(-1), Fraction(side * side + 1), Fraction(1, 8)
    steepness = 1
    while steepness < 4 * (side * side + 2):
        steepness *= 2
    points, _ = box((0, 0, floor), (side, side, ceiling))
    polygons = []

    def wedge(i, height, base, place):
        rims = []
        for along in (0, side):
            half = abs(height(along) - base) / steepness
            for offset, z in ((-half, base), (0, height(along)), (half, base)):
                points.append(place(i + offset, along, z))
            rims.append([len(points) - 3, len(points) - 2, len(points) - 1])
        return rims

    below = [wedge(i, lambda y: Fraction(i * y), floor, lambda x, y, z: (x, y, z)) for i in places]
    above = [wedge(j, lambda x: j * x + gap, ceiling, lambda y, x, z: (x, y, z)) for j in places]
    for wedges, (a, b, c, d) in ((below, (0, 2, 1, 3)), (above, (4, 5, 6, 7))):
        for near, far in wedges:
            polygons += [(a, b, far[0], near[0]), (near[0], far[0], far[1], near[1]),
                         (near[2], far[2], far[1], near[1])]
            a, b = near[2], far[2]
        polygons.append((a, b, d, c))
    for end, (a, b, c, d) in ((0, (0, 1, 5, 4)), (1, (2, 3, 7, 6))):
        polygons.append((a, *(v for rims in below for v in rims[end]), b, c, d))
    for end, (a, b, c, d) in ((0, (4, 6, 2, 0)), (1, (5, 7, 3, 1))):
        polygons.append((a, *(v for rims in above for v in rims[end]), b, c, d))
    return points, polygons


def height_field(n, seed):
    """A slab whose upper side is a triangulated landscape: many small facets, no two in one plane."""
    state = seed
    points, polygons = [], []
    for y in range(n):
        for x in range(n):
            state = (state * 1103515245 + 12345) % 2**31
            points.append((x, y, Fraction(4 + state % 1000 / 250)))
    at = lambda x, y: y * n + x
    for y in range(n - 1):
        for x in range(n - 1):
            polygons += [(at(x, y), at(x + 1, y), at(x + 1, y + 1)), (at(x, y), at(x + 1, y + 1), at(x, y + 1))]
    corners = [at(0, 0), at(n - 1, 0), at(n - 1, n - 1), at(0, n - 1)]
    base = len(points)
    points += [(points[v][0], points[v][1], Fraction(0)) for v in corners]
    rims = [[at(x, 0) for x in range(n)], [at(n - 1, y) for y in range(n)],
            [at(x, n - 1) for x in reversed(range(n))], [at(0, y) for y in reversed(range(n))]]
    for i, rim in enumerate(rims):
        polygons.append((*rim, base + (i + 1) % 4, base + i))
    polygons.append(tuple(range(base, base + 4)))
    return points, polygons


def octahedral_sphere(radius, depth):
    """An octahedron, its triangles split and pushed out to a sphere's neighbourhood, on the integer grid."""
    points = [(radius, 0, 0), (-radius, 0, 0), (0, radius, 0), (0, -radius, 0), (0, 0, radius), (0, 0, -radius)]
    triangles = [(x, y, z) for x in (0, 1) for y in (2, 3) for z in (4, 5)]
    for _ in range(depth):
        middles = {}

        def middle(a, b):
            key = frozenset((a, b))
            if key not in middles:
                p = [points[a][i] + points[b][i] for i in range(3)]
                length = sum(x * x for x in p) ** 0.5
                middles[key] = len(points)
                points.append(tuple(round(x * radius / length) for x in p))
            return middles[key]

        triangles = [t for a, b, c in triangles for ab, bc, ca in [(middle(a, b), middle(b, c), middle(c, a))]
                     for t in ((a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca))]
    return points, triangles


def space():
    points, polygons = box((0, 0, 0), (4, 4, 4))
    yield Domain("cube", "a cube: six squares", points, facets(polygons))
    yield Domain("cube-with-diagonal", "a cube with the diagonal 1 6: CDTs, and not the canonical one", points,
                 facets([*polygons, (1, 6)]), rooms=[])
    floor = points + [(8, 0, 0), (8, 4, 0)]
    yield Domain("cube-with-diagonal-and-floor", "the same on a floor that reaches out from under it, and dangles there", floor,
                 [([(0, 1, 8, 9, 3, 2), (1, 3)], []), *facets([*polygons[1:], (1, 6)])], rooms=[])
    nested = joined(box((0, 0, 0), (9, 9, 9)), box((3, 3, 3), (6, 6, 6)))
    yield Domain("cube-in-cube", "a solid cube with an internal cube", nested[0], facets(nested[1]), rooms=[[range(6), range(6, 12)], [range(6, 12)]])
    yield Domain("hollow-cube", "the same with a hole seed in the inner cube", nested[0], facets(nested[1]),
                 [(4, 4, 4)], rooms=[[range(6), range(6, 12)]])
    yield Domain("l-prism", "a prism over an L: one reflex edge", *parts(prism(
        [(0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)], 0, 3)))
    yield Domain("figure-4-10-schonhardt", "Schönhardt's polyhedron: no triangulation", *parts(schonhardt()))
    centred = schonhardt()
    yield Domain("schonhardt-with-centre", "the same with a vertex in its middle: eight tetrahedra",
                 centred[0] + [(0, 0, 5)], facets(centred[1]) + [([(6,)], [])], rooms=[])
    cap = prism_on_a_sphere()
    yield Domain("exercise-5-5-open", "a twisted prism with an apex below, on a sphere: every triangulation is a CDT",
                 *parts(cap), rooms=[])
    yield Domain("exercise-5-5-closed", "the same with one polygon more, the prism's floor: no triangulation", cap[0],
                 facets([*cap[1], (0, 1, 2)]), rooms=[])
    for notches in (1, 2, 3):
        yield Domain(f"figure-4-13-chazelle-{notches}", f"Chazelle's polyhedron with {notches} + {notches} notches",
                     *parts(chazelle(notches)))
    yield Domain("chazelle-outer-notches", "the last without the notches in the middle", *parts(chazelle(3, (1, 3))))
    segments = [((0, 1.75, 2.25), (4, 1.75, 2.25)), ((2.25, 0, 1.75), (2.25, 4, 1.75)), ((1.75, 2.25, 0), (1.75, 2.25, 4))]
    cut = points + [end for segment in segments for end in segment]
    # The segments end inside squares, which list the ends: TetGen wants that (see unlisted-vertex).
    ended = [([square, (12 + i,)], []) for i, square in enumerate(polygons[:2])]
    ended += [([square, (end,)], []) for square, end in zip(polygons[2:], (10, 11, 8, 9))]
    yield Domain("figure-4-12-three-segments", "a cube with three segments inside: no triangulation", cut,
                 ended + [([(8 + 2 * i, 9 + 2 * i)], []) for i in range(3)], rooms=[])
    yield Domain("two-segments", "the same without the third: it has one", cut[:12],
                 facets(polygons[:2]) + ended[2:] + [([(8 + 2 * i, 9 + 2 * i)], []) for i in range(2)], rooms=[])
    yield Domain("unlisted-vertex", "a tetrahedron and a vertex inside a facet that does not list it",
                 [(0, 0, 0), (4, 0, 0), (0, 4, 0), (0, 0, 4), (1, 1, 0)],
                 facets([(0, 1, 2), (0, 1, 3), (0, 2, 3), (1, 2, 3)]), rooms=[])
    tetrahedron = [(0, 0, 0), (9, 0, 0), (0, 9, 0), (0, 0, 9)]
    yield Domain("segment-listed-twice", "a tetrahedron and a segment inside it that stands in the file twice",
                 tetrahedron + [(1, 1, 1), (1, 1, 2)],
                 facets([(0, 1, 2), (0, 1, 3), (0, 2, 3), (1, 2, 3), (4, 5), (4, 5)]), rooms=[])
    large, _ = box((0, 0, 0), (8, 8, 8))
    yield Domain("one-segment", "a cube with a segment inside", large + [(6, 3, 2), (6, 5, 5)],
                 facets([*polygons, (8, 9)]), rooms=[])
    yield Domain("two-triangles", "a cube with two triangles inside, one of which hangs from a corner",
                 large + [(4, 1, 5), (1, 6, 7), (3, 2, 5), (1, 6, 1), (1, 1, 1)],
                 facets([*polygons, (0, 8, 9), (10, 11, 12)]), rooms=[])
    pyramid = [(2, 0, 0), (-1, 2, 0), (-1, -2, 0), (0, 0, 9), (0, 0, -9)]
    sides = [(i, (i + 1) % 3, apex) for i in range(3) for apex in (3, 4)]
    yield Domain("figure-4-15-encircled-segment", "a segment that three tetrahedra encircle: no CDT", pyramid,
                 facets([*sides, (3, 4)]), rooms=[])
    yield Domain("figure-4-14-occluded", "a vertex in a tetrahedron's ball, hidden behind a polygon",
                 [(0, 0, 0), (6, 0, 0), (0, 6, 0), (2, 2, 3), (2, 2, -1), (-3, -3, 0), (12, -3, 0), (-3, 12, 0)],
                 facets([(0, 1, 2), *((i, j, apex) for i, j in ((5, 6), (6, 7), (5, 7)) for apex in (3, 4))]), rooms=[[range(1, 7)]], inside=[0])
    square = points + [(1, 1, 2), (3, 1, 2), (3, 3, 2), (1, 3, 2)]
    yield Domain("internal-square", "a cube with a square that hangs free inside", square,
                 facets([*polygons, (8, 9, 10, 11)]), rooms=[[range(6)]], inside=[6])
    outside = points + [(8, 0, 0), (8, 4, 0)]
    yield Domain("dangling-square", "a cube with a square that dangles from an edge, outside", outside,
                 facets([*polygons, (1, 3, 9, 8)]), rooms=[])
    window = points + [(1, 1, 0), (3, 1, 0), (3, 3, 0), (1, 3, 0), (1, 1, 4), (3, 1, 4), (3, 3, 4), (1, 3, 4)]
    tunnel = [([polygons[0], (8, 9, 10, 11)], [(2, 2, 0)]), ([polygons[1], (12, 13, 14, 15)], [(2, 2, 4)])]
    yield Domain("tunnel", "a cube with a square tunnel: two polygons with holes", window,
                 tunnel + facets(polygons[2:] + [(8 + i, 8 + (i + 1) % 4, 12 + (i + 1) % 4, 12 + i) for i in range(4)]))
    slits = points + [(1, 1, 0), (2, 3, 0), (3, 1, 0), (2, 2, 4), (1, 2, 2)]
    yield Domain("slits", "figure 4.11: a slit, two vertices inside polygons, one in the volume", slits,
                 [([polygons[0], (8, 9), (10,)], []), ([polygons[1], (11,)], []), *facets(polygons[2:]), ([(12,)], [])], rooms=[])
    wall = joined(box((0, 0, 0), (2, 2, 2)))
    yield Domain("two-rooms", "two boxes on either side of one polygon, four coplanar ones adjacent",
                 wall[0] + [(5, 0, 0), (5, 2, 0), (5, 0, 2), (5, 2, 2)],
                 facets([*wall[1], (1, 8, 9, 3), (5, 10, 11, 7), (1, 8, 10, 5), (3, 9, 11, 7), (8, 9, 11, 10)]), rooms=[[range(6)], [[5, *range(6, 11)]]])
    yield Domain("thin-wedge", "a wedge of one part in a thousand", *parts(prism([(0, 0), (1024, 0), (1024, 1)], 0, 64)))
    yield Domain("needle", "a triangle of one part in 10^8; its two long segments come ever closer", [(0, 0, 0), (100, 0, 0),
                 (100, 1e-6, 0), (50, 50, 0), (50, -50, 0), (50, 0, 50)], facets([(0, 1, 2)]), rooms=[])
    fan = [(0, 0)] + [(256, y) for y in range(0, 9)]
    fan_points, _ = prism(fan, 0, 32)
    n = len(fan)
    yield Domain("fan-of-rooms", "eight thin rooms around one edge", fan_points,
                 facets([(0, i, i + 1) for i in range(1, n - 1)] + [(n, n + i, n + i + 1) for i in range(1, n - 1)]
                        + [(i, i + 1, n + i + 1, n + i) for i in range(1, n - 1)]
                        + [(0, i, n + i, n) for i in range(1, n)]), rooms=[])
    yield Domain("landscape", "a slab under a triangulated landscape of 72 facets", *parts(height_field(7, 5)))
    yield Domain("sphere", "128 triangles about a sphere, on the integer grid", *parts(octahedral_sphere(1000, 2)))
    twins = joined(octahedral_sphere(64, 1), [octahedral_sphere(64, 1)[0], octahedral_sphere(64, 1)[1]])
    shifted = twins[0][:18] + [(x + 128, y, z) for x, y, z in twins[0][18:]]
    touching = {p: i for i, p in reversed(list(enumerate(shifted)))}
    kept = sorted(set(touching.values()))
    number = {v: kept.index(touching[p]) for v, p in enumerate(shifted)}
    yield Domain("two-balls", "two polyhedra that touch in one vertex", [shifted[v] for v in kept],
                 facets([tuple(number[v] for v in t) for t in twins[1]]), rooms=[])


def parts(complex_):
    return complex_[0], facets(complex_[1])


def plane():
    ring = [(0, 0), (9, 0), (9, 9), (0, 9), (3, 3), (6, 3), (6, 6), (3, 6)]
    loops = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4)]
    yield Domain("plane-ring", "a square with a square hole", ring, loops, [(4, 4)])
    yield Domain("plane-square-in-square", "the same, filled", ring, loops)
    yield Domain("plane-slits", "slits, a dangling segment, an isolated vertex",
                 [(0, 0), (8, 0), (8, 8), (0, 8), (2, 2), (6, 3), (2, 6), (12, 8), (4, 5), (4, 4)],
                 [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (2, 7)])
    comb = [(0, 0)] + [p for i in range(6) for p in ((4 * i + 1, 32), (4 * i + 3, 1))] + [(24, 0)]
    yield Domain("plane-comb", "six teeth, sharp at their tips", comb,
                 [(i, (i + 1) % len(comb)) for i in range(len(comb))])


def domains():
    return [*space(), *plane()]


def poly(domain):
    dimension = len(domain.points[0])
    rows = [f"# {domain.name}: {domain.what}", f"{len(domain.points)} {dimension} 0 0"]
    rows += [" ".join([str(i), *(files.number(float(x)) for x in p)]) for i, p in enumerate(domain.points)]
    rows.append(f"{len(domain.facets)} 0")
    for i, facet in enumerate(domain.facets):
        if dimension == 2:
            rows.append(f"{i} {facet[0]} {facet[1]}")
            continue
        lines, holes = facet
        rows.append(f"{len(lines)} {len(holes)}")
        rows += [" ".join(map(str, (len(line), *line))) for line in lines]
        rows += [" ".join(map(str, (j, *hole))) for j, hole in enumerate(holes)]
    rows.append(str(len(domain.holes)))
    rows += [" ".join(map(str, (i, *hole))) for i, hole in enumerate(domain.holes)]
    return "\n".join(rows) + "\n"


def geo(domain):
    """The domain as a script for Gmsh; nothing for one that it is not asked for."""
    if len(domain.points[0]) == 2 or domain.rooms == []:
        return None
    edge = {}
    rows, surfaces = [], []
    rows += [f"Point({i + 1}) = {{{', '.join(files.number(float(x)) for x in p)}}};" for i, p in enumerate(domain.points)]
    for number, (lines, _) in enumerate(domain.facets, 1):
        loops = []
        for k, line in enumerate(lines):
            signed = []
            for a, b in zip(line, line[1:] + line[:1]):
                if (a, b) not in edge:
                    edge[a, b] = len(edge) // 2 + 1
                    edge[b, a] = -edge[a, b]
                    rows.append(f"Line({edge[a, b]}) = {{{a + 1}, {b + 1}}};")
                signed.append(edge[a, b])
            loops.append(100 * number + k)
            rows.append(f"Line Loop({loops[-1]}) = {{{', '.join(map(str, signed))}}};")
        rows.append(f"Plane Surface({number}) = {{{', '.join(map(str, loops))}}};")
    rooms = domain.rooms or [[range(len(domain.facets))]]
    for i, shells in enumerate(rooms, 1):
        for j, shell in enumerate(shells):
            rows.append(f"Surface Loop({100 * i + j}) = {{{', '.join(str(f + 1) for f in shell)}}};")
        rows.append(f"Volume({i}) = {{{', '.join(str(100 * i + j) for j in range(len(shells)))}}};")
    rows += [f"Surface{{{f + 1}}} In Volume{{1}};" for f in domain.inside]
    return "\n".join([*rows, "Mesh.CharacteristicLengthFactor = 1e6;", "Mesh.Optimize = 0;", ""])


def write():
    folder = files.CORPUS / "domains"
    folder.mkdir(exist_ok=True)
    for domain in domains():
        (folder / f"{domain.name}.poly").write_text(poly(domain))
        script = geo(domain)
        if script:
            (folder / f"{domain.name}.geo").write_text(script)
