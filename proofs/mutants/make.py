#!/usr/bin/env python3
"""Writes the certificates of this folder: sound ones, and mutants that break one condition each.

    proofs/mutants/make.py FOLDER

A file's name begins with the condition of CERTIFICATE.md that it breaks; its first line is a
comment with the answer that circumspect-verified must give. Refutations are named after their rule.
Files large--… are not kept: check.sh makes them anew. The certificates of broken meshes are
as honest as can be: pointers follow the mesh, and only the mesh is wrong.
"""

import copy
import itertools
import os
import sys
from fractions import Fraction

import alone
import domain_refutations
import domains
import impossible
import lines
import periodic
import reduced
import surfaces
from honest import certificate, text as mesh_text


def text(c):
    return domains.domain_text(c) if "kind" in c else mesh_text(c)


SQUARE = [(0, 0), (4, 0), (4, 4), (0, 4), (2, 1)]
SQUARE_MESH = [(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)]
OCTAHEDRON = [(0, 0, 0), (2, 0, 0), (-2, 0, 0), (0, 2, 0), (0, -2, 0), (0, 0, 2), (0, 0, -2)]
OCTAHEDRON_MESH = [(0, x, y, z) for x in (1, 2) for y in (3, 4) for z in (5, 6)]
# A ring that winds twice around the origin; every edge from the origin is matched.
RING = [(14280, 6877), (-7858, 9854), (-4612, -5783), (3739, -1801), (1181, 5176), (-10000, 0),
        (3269, -14323)]


def ring_fan():
    return [(0, 0)] + RING, [(0, k + 1, (k + 1) % 7 + 1) for k in range(7)]


def ring_cone():
    """The fan in space: two apexes, above and below the origin, over every edge of the ring."""
    points = [(0, 0, 0), (0, 0, 9000), (0, 0, -9000)] + [(x, y, 0) for x, y in RING]
    around = [(k + 3, (k + 1) % 7 + 3) for k in range(7)]
    return points, [(0, apex, a, b) for apex in (1, 2) for a, b in around]


def swapped(c, t, i, j):
    """Vertices i and j of simplex t change places, and all that points there with them."""
    corners, walls, outer = c["simplices"][t]
    corners[i], corners[j] = corners[j], corners[i]
    walls[i], walls[j] = walls[j], walls[i]
    turn = {i: j, j: i}
    c["simplices"][t][2] = turn.get(outer, outer)
    for _, others, _ in c["simplices"]:
        for wall in others:
            if wall[0] == t + 1:
                wall[1] = turn.get(wall[1], wall[1])
    for row in c["hull"]:
        if row[0] == t + 1:
            row[1] = turn.get(row[1], row[1])
    for row in c["points"]:
        if row[2] == t + 1:
            row[3] = turn.get(row[3], row[3])
    return c


def files():
    plane = certificate("delaunay", SQUARE, SQUARE_MESH)
    space = certificate("delaunay", OCTAHEDRON, OCTAHEDRON_MESH)
    weighted = certificate("weighted-delaunay", SQUARE, SQUARE_MESH[:0] + [(0, 1, 2), (0, 2, 3)],
                           weights=[0, 0, 0, 0, -50])
    inside = next(k for k, row in enumerate(weighted["points"]) if row[4] == 4)
    weighted["points"][inside][2:4] = [1, "-"]
    yield "sound--plane", plane, "verified: delaunay, 5 points, 4 triangles"
    yield "sound--space", space, "verified: delaunay, 7 points, 8 tetrahedra"
    yield "sound--weighted", weighted, "verified: weighted-delaunay, 5 points, 2 triangles"
    huge = certificate("delaunay", [tuple(x * 10 ** 400 for x in p) for p in OCTAHEDRON],
                       OCTAHEDRON_MESH)
    yield "sound--huge-coordinates", huge, "verified: delaunay, 7 points, 8 tetrahedra"

    def mutant(base, change, answer, name=None):
        c = copy.deepcopy(base)
        change(c)
        return name or answer.split(",")[0], c, "rejected: " + answer

    def put(*path):
        *path, key, value = path

        def change(c):
            for step in path:
                c = c[step]
            c[key] = value
        return change

    yield mutant(space, put("points", 3, 4, space["points"][5][4]), "labels-different")
    yield mutant(space, put("scale", 1, 0), "scale")
    yield mutant(space, put("scale", 0, -1), "scale", "scale--negative")
    twice = certificate("delaunay", SQUARE + [(4, 4)], SQUARE_MESH)
    yield "points-increasing--duplicate", twice, "rejected: points-increasing, point 5"
    unused = certificate("delaunay", SQUARE + [(1, 1)], SQUARE_MESH)
    yield "point-used", unused, "rejected: point-used, point 3"
    yield mutant(weighted, put("points", inside, 2, 2), "point-used, point 3",
                 "point-used--in-another-simplex")
    yield mutant(weighted, put("points", inside, 1, [50]), "point-used, point 3",
                 "point-used--below-the-witness-plane")
    elsewhere = certificate("delaunay", SQUARE, SQUARE_MESH, start=2)
    yield mutant(elsewhere, put("simplices", 0, 0, 1, 9), "vertex-known, simplex 1")
    elsewhere = certificate("delaunay", OCTAHEDRON, OCTAHEDRON_MESH, start=7)
    yield "simplex-positive", swapped(elsewhere, 0, 1, 2), \
        "rejected: simplex-positive, simplex 1"
    collinear = certificate("triangulation", SQUARE[:4] + [(2, 0)],
                            [(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)], start=1)
    yield "simplex-positive--flat", collinear, "rejected: simplex-positive, simplex 1"
    wall = next(i for i, f in enumerate(space["simplices"][0][1]) if f[0] != "-")
    wrong = [space["simplices"][0][1][wall][0] % 8 + 1, space["simplices"][0][1][wall][1]]
    yield mutant(space, put("simplices", 0, 1, wall, wrong), "facet-matched, simplex 1, facet %d"
                 % wall, "facet-matched--wrong-neighbour")
    u, j = space["simplices"][0][1][wall]
    yield mutant(space, put("simplices", u - 1, 1, j, [u % 8 + 1, 0]),
                 "back-pointer, simplex 1, facet %d" % wall)
    outer = next(i for i, f in enumerate(space["simplices"][0][1]) if f[0] == "-")
    yield mutant(space, put("simplices", 0, 1, outer, ["-", 2]),
                 "hull-pointer, simplex 1, facet %d" % outer)
    missing = copy.deepcopy(space)
    missing["hull"].pop()
    yield "hull-pointer--missing-hull-facet", missing, \
        "rejected: hull-pointer, simplex 8, facet %d" % \
        next(i for i, f in enumerate(space["simplices"][7][1]) if f[0] == "-")
    extra = copy.deepcopy(space)
    extra["hull"].append([1, wall, extra["hull"][0][2]])
    yield "hull-pointer--facet-that-is-matched", extra, "rejected: hull-pointer, hull facet 9"
    g, b = space["hull"][0][2][0]
    yield mutant(space, put("hull", 0, 2, 0, [g % 8 + 1, b]), "ridge-matched, hull facet 1, ridge 0")
    yield mutant(space, put("hull", g - 1, 2, b, [g % 8 + 1, 0]),
                 "ridge-back-pointer, hull facet 1, ridge 0")
    yield from broken_meshes(plane, space)
    yield from standings()
    yield from domains.domains(mutant, put, SQUARE, SQUARE_MESH)


def broken_meshes(plane, space):
    dart = [(-1, 0), (6, -3), (1, 0), (6, 3)]
    reflex = certificate("triangulation", dart, [(0, 1, 2), (0, 2, 3)],
                         sample=[0, Fraction(-1, 10)])
    yield "hull-locally-convex", reflex, "rejected: hull-locally-convex"
    pyramid = [(0, 0, 0), (8, 0, 0), (0, 8, 0), (0, 0, 8), (3, 3, 3)]
    dented = certificate("triangulation", pyramid + [(1, 1, 1)],
                         [(0, 1, 2, 5), (0, 1, 3, 5), (0, 2, 3, 5), (1, 2, 4, 5), (1, 3, 4, 5),
                          (2, 3, 4, 5)])
    yield "sound--tetrahedron-with-a-bump", dented, \
        "verified: triangulation, 6 points, 6 tetrahedra"
    dent = [(8, 0, 0), (0, 8, 0), (0, 0, 8), (2, 2, 2), (0, 0, 0), (1, 1, 1)]
    dented = certificate("triangulation", dent,
                         [(4, 0, 1, 5), (4, 0, 2, 5), (4, 1, 2, 5), (0, 1, 3, 5), (0, 2, 3, 5),
                          (1, 2, 3, 5)])
    yield "hull-locally-convex--dent", dented, "rejected: hull-locally-convex"
    outside = certificate("delaunay", SQUARE, SQUARE_MESH, sample=[3, 2])
    yield "sample-inside", outside, "rejected: sample-inside"
    nested = SQUARE[:3] + [(2, 1), (3, 1), (3, 2)]
    for start, name in (0, "outer"), (1, "inner"):
        twice = certificate("triangulation", nested, [(0, 1, 2), (3, 4, 5)], start=start,
                            sample=[Fraction(8, 3), Fraction(4, 3)])
        yield "sample-outside--covered-twice-from-the-%s" % name, twice, "rejected: sample-outside"
    for name, mesh, o in ("the-plane", ring_fan(), [64, 167]), ("space", ring_cone(), [64, 167, 9]):
        winding = certificate("triangulation", *mesh, sample=o)
        yield "sample-outside--doubly-winding-fan-in-%s" % name, winding, \
            "rejected: sample-outside"
    points, fan = ring_fan()
    winding = certificate("triangulation", points, fan, sample=[Fraction(12000), Fraction(6000)])
    yield "sample-inside-hull--doubly-winding-fan", winding, "rejected: sample-inside-hull"
    slit = certificate("delaunay", OCTAHEDRON, OCTAHEDRON_MESH,
                       glue=lambda facet: facet != {0, 1, 3})
    yield "sample-inside-hull--facet-folded-in-its-plane", slit, "rejected: sample-inside-hull"
    apart = certificate("triangulation", SQUARE[:3] + [(9, 9), (10, 9), (10, 10)],
                        [(0, 1, 2), (3, 4, 5)])
    yield "sample-inside-hull--two-pieces", apart, "rejected: sample-inside-hull"
    flipped = certificate("delaunay", [(0, 0), (6, 0), (7, 2), (0, 2)], [(0, 1, 2), (0, 2, 3)])
    yield "facet-locally-delaunay--plane", flipped, "rejected: facet-locally-delaunay"
    # A square of side 10^81; but one vertex is a unit inside the circle of the others, or outside.
    for unit, name, answer in (1, "facet-locally-delaunay--by-a-unit", "rejected: facet-locally-delaunay"), \
            (-1, "sound--by-a-unit", "verified: delaunay, 4 points, 2 triangles"):
        square = certificate("delaunay", [(unit, unit), (10 ** 81, 0), (10 ** 81, 10 ** 81), (0, 10 ** 81)],
                             [(0, 1, 3), (1, 2, 3)])
        yield name, square, answer
    bipyramid = [(10, 0, 0), (-5, 9, 0), (-5, -9, 0), (0, 0, 1), (0, 0, -1)]
    flat_pair = certificate("delaunay", bipyramid, [(0, 1, 2, 3), (0, 1, 2, 4)])
    yield "facet-locally-delaunay--space", flat_pair, "rejected: facet-locally-delaunay"
    heavy = certificate("weighted-delaunay", SQUARE, SQUARE_MESH, weights=[0, 0, 0, 0, -50])
    yield "facet-locally-delaunay--submerged-vertex", heavy, "rejected: facet-locally-delaunay"


def standings():
    """The only Delaunay triangulation, the canonical one, and others of points of one circle."""
    corners = [(0, 0), (4, 0), (4, 4), (0, 4)]
    rising, falling = [(0, 1, 2), (0, 2, 3)], [(0, 1, 3), (1, 2, 3)]
    # In lexicographic order the first corner is (0, 0): the canonical diagonal ends there.
    cases = [
        ("unique--sound", SQUARE, SQUARE_MESH, "unique", None, "verified"),
        ("unique", corners, rising, "unique", None, "rejected: unique, simplex 1"),
        ("canonical--sound", corners, rising, "canonical", None, "verified"),
        ("canonical--where-unique", SQUARE, SQUARE_MESH, "canonical", None, "verified"),
        ("canonical", corners, falling, "canonical", None, "rejected: canonical, simplex 1"),
    ]
    cube = [(x, y, z) for x in (0, 2) for y in (0, 2) for z in (0, 2)]
    pulled = [(0, 1, 3, 7), (0, 1, 5, 7), (0, 2, 3, 7), (0, 2, 6, 7), (0, 4, 5, 7), (0, 4, 6, 7)]
    turned = [tuple(7 - v if v in (0, 7) else v for v in s) for s in pulled]
    middle = [(0, 3, 5, 6), (0, 1, 3, 5), (0, 2, 3, 6), (0, 4, 5, 6), (3, 5, 6, 7)]
    cases += [
        ("canonical--cube", cube, pulled, "canonical", None, "verified"),
        ("canonical--cube-in-five", cube, middle, "canonical", None, "rejected: canonical, simplex"),
        ("unique--cube", cube, pulled, "unique", None, "rejected: unique, simplex"),
    ]
    # A point that is not a vertex, on the lower hull or strictly above it.
    for name, weight in ("on-the-hull", -2), ("above-the-hull", -3):
        points, lifted = [(0, 0), (2, 0), (0, 2), (1, 1)], [0, 0, 0, weight]
        c = certificate("weighted-delaunay", points, [(0, 1, 2)], weights=lifted)
        k = next(k for k, row in enumerate(c["points"]) if row[4] == 3)
        c["points"][k][2:4] = [1, "-"]
        for standing in "unique", "canonical":
            settled = dict(copy.deepcopy(c), standing=" " + standing)
            answer = "verified" if weight == -3 or standing == "canonical" else \
                "rejected: %s, point" % standing
            yield "%s--submerged-%s" % (standing, name), settled, answer
    for name, points, mesh, standing, _, answer in cases:
        yield name, dict(certificate("delaunay", points, mesh), standing=" " + standing), answer
    plain = certificate("triangulation", SQUARE, SQUARE_MESH)
    yield "unique--of-a-triangulation", dict(plain, standing=" unique"), "rejected: unique"


def malformed():
    sound = text(certificate("delaunay", SQUARE, SQUARE_MESH))
    lines = sound.split("\n")
    yield "malformed--truncated", "\n".join(lines[:9]) + "\n", "malformed"
    yield "malformed--cut-in-a-line", sound[:len(sound) // 2 - 3], "malformed"
    yield "malformed--no-end", "\n".join(lines[:-2]) + "\n", "malformed"
    yield "malformed--huge-count", sound.replace("points 5", "points 4000000000000000000"), \
        "malformed"
    yield "malformed--count-beyond-62-bits", sound.replace("points 5", "points " + "9" * 30), \
        "malformed"
    yield "malformed--fraction", sound.replace("scale 1 1", "scale 1/2 1"), "malformed"
    yield "malformed--version", sound.replace("certificate 1", "certificate 2"), "malformed"
    yield "malformed--dimension", sound.replace("delaunay 2", "delaunay 4"), "malformed"


def refutations():
    """For each rule evidence that shows it, and evidence that does not, of meshes of one square."""
    square = [(0, 0), (4, 0), (4, 4), (0, 4), (2, 1)]
    fan = [[1, 2, 5], [2, 3, 5], [3, 4, 5], [4, 1, 5]]
    halves = [[1, 2, 3], [1, 3, 4]]
    crossed = [[1, 2, 3], [1, 2, 4]]
    hanging = [[1, 2, 4], [1, 6, 5]]
    cases = [  # rule, simplices, evidence, evidence that fails, weights, the point to leave out
        ("simplex.wrong-dimension", fan + [[1, 2]], "5", "1", None),
        ("triangulation.unknown-vertex", fan + [[1, 2, -7]], "5 2", "5 1", None),
        ("simplex.repeated-vertex", fan + [[1, 2, 1]], "5 0 2", "5 0 1", None),
        ("simplex.degenerate", [[1, 3, 6]] + fan, "1", "2", None),
        ("complex.duplicate-simplex", fan + [[5, 1, 2]], "1 5", "1 4", None),
        ("complex.facet-overused", [[1, 2, 3], [1, 2, 4], [1, 2, 5]], "1 2 2 2 3 2", "1 2 2 2 3 1",
         None),
        ("complex.overlap", crossed, "1 2 4 1 2", "1 2 0 0 1", None),
        ("triangulation.covered-twice", crossed, "1 2 4 1 2", "1 1 4 1 2", None),
        ("triangulation.covered-twice", hanging, None, "1 2 2 0 1", None, "--nothing-is"),
        ("triangulation.unused-point", halves, "5", "4", None),
        ("triangulation.unused-point", halves[:1], "4 1", "4 0", [0, 0, 0, 0, 0, 0, 0]),
        ("triangulation.hull-not-convex", fan[:3], "1 1 4", "1 2 4", None),
        ("triangulation.hull-not-closed", [fan[0], fan[2]], "1 0 1 1 2 0", "1 0 1 1 1 0", None),
        ("triangulation.hull-not-closed", fan, None, "1 2 2 2 3 2", None, "--of-a-square"),
        ("delaunay.vertex-in-ball", halves, "1 5", "1 4", None),
        ("delaunay.facet-not-local", [[1, 2, 3], [1, 3, 7]], "1 1 2 2", "1 0 2 2", None),
        ("delaunay.facet-not-local", [[1, 2, 3], [1, 2, 5]], None, "1 2 2 2", None,
         "--on-the-same-side"),
        ("weighted.point-below-plane", halves, "1 5", "1 4", [0, 0, 0, 0, 0, 0, 0]),
        ("weighted.vertex-submerged", fan, "1 2 1 2 3", "1 1 1 2 3", [0, 0, 0, 0, -50, 0, 0]),
    ]
    for rule, simplices, shows, fails, weights, *why in cases:
        claim = "weighted-delaunay" if weights else \
            "delaunay" if rule.startswith("delaunay") else "triangulation"
        points = square + [(2, 2), (1, 3)]
        lines = ["circumspect-refutation 2 %s 2 %s" % (claim, rule), "scale 1 1",
                 "points %d" % len(points)]
        lines += [" ".join(map(str, [*p, *([weights[v]] if weights else []), v]))
                  for v, p in enumerate(points)]
        lines.append("simplices %d" % len(simplices))
        lines += [" ".join(map(str, [len(row)] + row)) for row in simplices]
        if weights and not rule.startswith("weighted"):
            why = ["--weighted"]
        for name, evidence, answer in (
                ("shown", shows, "verified: not %s, %s" % (claim, rule)),
                ("not-shown", fails, "rejected: the evidence does not show " + rule)):
            if evidence:
                yield "%s--%s%s" % (rule, name, "".join(why)), \
                    "\n".join(lines + ["spans 1 2 3", "because " + evidence, "end"]) + "\n", answer
    line = "circumspect-refutation 2 delaunay 2 simplex.wrong-dimension\nscale 1 1\npoints 3\n" \
        "0 0 0\n1 0 1\n2 0 2\nsimplices 2\n2 1 2\n2 2 3\nspans 1 2 3\nbecause 1\nend\n"
    # They lie in a line and have a Delaunay triangulation, the two edges.
    yield "spans--points-of-a-line", line, "rejected: the evidence does not show"
    many = 6000
    yield "large--numbers-of-facets", \
        "circumspect-refutation 2 weighted-delaunay 2 triangulation.unused-point\nscale 1 1\npoints 4\n" \
        "0 0 0 0\n1 0 0 1\n0 1 0 2\n1 1 0 3\nsimplices %d\n%sspans 1 2 3\nbecause 4%s\nend\n" % (
            many, "3 1 2 3\n" * many, " 9999999" * many), "rejected: the evidence does not show"
    row = " ".join(["1"] * 1000000)
    yield "large--simplex-of-1000000-vertices", \
        "circumspect-refutation 2 delaunay 2 simplex.wrong-dimension\nscale 1 1\npoints 3\n" \
        "0 0 0\n1 0 1\n0 1 2\nsimplices 1\n1000000 %s\nspans 1 2 3\nbecause 1\nend\n" % row, \
        "verified: not delaunay, simplex.wrong-dimension"


def main():
    folder = sys.argv[1]
    os.makedirs(folder, exist_ok=True)
    for name, content, answer in itertools.chain(
            ((name, text(c), answer) for name, c, answer in files()), refutations(),
            domain_refutations.refutations_of_domains(), domain_refutations.refutations_by_the_whole_domain(),
            domain_refutations.refutations_where_something_dangles(), domain_refutations.refutations_of_hulls(),
            domain_refutations.refutations_by_another_mesh(), domain_refutations.refutations_of_dangling_triangles(), impossible.files(), alone.files(),
            surfaces.files(), periodic.files(), lines.files(), reduced.files(), malformed()):
        with open(os.path.join(folder, name + ".cert"), "w") as out:
            out.write("# %s\n%s" % (answer, content))


if __name__ == "__main__":
    main()
