"""Refutations of claims about domains for make.py: for each rule evidence that shows it, and evidence that does not."""

import copy

from domains import NOTCH_AND_HOLE, NOTCHED, NOTCHED_MESH, NOTCHED_SEGMENTS, domain_text, plane_domain, polygon_text, \
    space_domain


def refutations_of_domains():
    """Meshes of a square with a diagonal, and what is wrong with them, right or not."""
    square = [(0, 0), (4, 0), (4, 4), (0, 4), (2, 1), (2, 2), (1, 3)]
    fan = [[1, 2, 5], [2, 3, 5], [3, 4, 5], [4, 1, 5]]
    crossed = [[1, 2, 3], [1, 2, 4]]
    pair = [[1, 2, 3], [1, 3, 7]]
    corners = square[:4]
    sides = [(1, 2), (2, 3), (3, 4), (1, 4), (1, 3)]
    cases = [
        ("domain.segment-missing", "cdt", fan, "5 4 4 2", True, ""),
        ("domain.segment-missing", "cdt", fan, "1 4 0 2", False, "--an-edge"),
        ("domain.segment-missing", "cdt", fan, "5 1 0 1", False, "--off-the-segment"),
        ("domain.segment-missing", "cdt", fan, "5 0 0 1", False, "--its-end"),
        ("domain.segment-missing", "cdt", fan, "5 0 0 0", False, "--no-point"),
        ("domain.segment-missing", "cdt", fan, "6 4 4 2", False, "--no-segment"),
        ("domain.segment-missing", "cdt", fan + [[1, 2]], "5 4 4 2", False, "--not-all-triangles"),
        ("domain.vertex-in-edge", "steiner-cdt", [[1, 2, 3], [1, 4, 6]], "2 2 1 0 2 5", True, ""),
        ("domain.vertex-in-edge", "steiner-cdt", [[1, 2, 3], [1, 4, 6]], "2 2 1 0 2 1", False, "--another-segment"),
        ("domain.vertex-in-edge", "steiner-cdt", [[1, 2, 3], [1, 4, 6]], "2 2 1 0 1 5", False, "--another-edge"),
        ("domain.vertex-in-edge", "steiner-cdt", [[1, 2, 3], [1, 4, 6]], "2 0 1 0 2 5", False, "--its-end"),
        ("domain.vertex-in-edge", "steiner-cdt", [[1, 2, 3], [1, 4, 6]], "2 2 2 0 2 5", False, "--an-end-of-the-edge"),
        ("domain.vertex-in-edge", "steiner-cdt", [[1, 2, 3, 4], [1, 4, 6]], "2 2 1 0 2 5", False, "--four-vertices"),
        ("domain.vertex-missing", "steiner-cdt", [[1, 2, 3]], "4", True, ""),
        ("domain.vertex-missing", "steiner-cdt", [[1, 2, 3]], "3", False, ""),
        ("domain.vertex-missing", "steiner-cdt", [[1, 2, 3]], "5", False, "--no-vertex"),
        ("domain.steiner-forbidden", "plc-triangulation", fan, "1 2", True, ""),
        ("domain.steiner-forbidden", "plc-triangulation", fan, "1 1", False, ""),
        ("domain.steiner-forbidden", "steiner-triangulation", fan, "1 2", False, "--allowed"),
        ("simplex.wrong-dimension", "steiner-cdt", fan + [[1, 2, 3, 4]], "5", True, "--of-a-domain"),
        ("simplex.wrong-dimension", "steiner-cdt", fan + [[]], "5", True, "--of-a-domain--no-vertex"),
        # An edge among the triangles may dangle.
        ("simplex.wrong-dimension", "steiner-cdt", fan + [[1, 2]], "5", False, "--of-a-domain--an-edge"),
        ("simplex.wrong-dimension", "steiner-cdt", fan + [[1, 2]], "4", False, "--of-a-domain"),
        ("triangulation.unknown-vertex", "cdt", [[1, 2, 9]], "1 2", True, "--of-a-domain"),
        ("triangulation.unknown-vertex", "cdt", [[1, 2, 9]], "1 1", False, "--of-a-domain"),
        ("simplex.repeated-vertex", "cdt", [[1, 2, 1]], "1 0 2", True, "--of-a-domain"),
        ("simplex.repeated-vertex", "cdt", [[1, 2, 1]], "1 0 1", False, "--of-a-domain"),
        ("simplex.degenerate", "steiner-triangulation", [[1, 3, 6]], "1", True, "--of-a-domain"),
        ("simplex.degenerate", "steiner-triangulation", [[1, 3, 7]], "1", False, "--of-a-domain"),
        ("complex.duplicate-simplex", "cdt", [[1, 2, 3], [3, 1, 2]], "1 2", True, "--of-a-domain"),
        ("complex.duplicate-simplex", "cdt", fan, "1 2", False, "--of-a-domain"),
        ("complex.facet-overused", "cdt", [[1, 2, 3], [1, 2, 4], [1, 2, 5]], "1 2 2 2 3 2", False, "--of-a-domain"),
        ("triangulation.covered-twice", "steiner-cdt", crossed, "1 2 4 1 2", True, "--of-a-domain"),
        ("triangulation.covered-twice", "steiner-cdt", crossed, "1 2 2 2 1", False, "--of-a-domain"),
        ("delaunay.vertex-in-ball", "conforming-delaunay", pair, "1 7", True, "--of-a-domain"),
        ("delaunay.vertex-in-ball", "steiner-cdt", pair, "1 7", False, "--of-a-domain"),
        ("complex.overlap", "steiner-cdt", crossed, "1 2 4 1 2", True, "--of-a-domain"),
        ("complex.overlap", "steiner-cdt", crossed, "1 2 0 0 1", False, "--of-a-domain"),
        ("delaunay.facet-not-local", "conforming-delaunay", pair, "1 1 2 2", True, "--of-a-domain"),
        ("delaunay.facet-not-local", "steiner-cdt", pair, "1 1 2 2", False, "--of-a-domain"),
        ("triangulation.hull-not-convex", "steiner-cdt", fan[:3], "1 1 4", False, "--of-a-domain"),
    ]
    for rule, claim, simplices, because, is_shown, why in cases:
        lines = ["circumspect-refutation 2 %s 2 %s" % (claim, rule), "scale 1 2", "points %d" % len(square)]
        lines += ["%d %d %d" % (*p, v) for v, p in enumerate(square)]
        lines += ["simplices %d" % len(simplices)]
        lines += [" ".join(map(str, [len(row)] + row)) for row in simplices]
        lines += ["spans 1 2 3", "vertices %d" % len(corners)] + ["%d %d" % p for p in corners]
        lines += ["segments %d" % len(sides)] + ["%d %d" % s for s in sides]
        yield "%s--%s%s" % (rule, "shown" if is_shown else "not-shown", why), \
            "\n".join(lines + ["because " + because, "end"]) + "\n", \
            "verified: not %s, %s; domain: 4 vertices, 5 segments" % (claim, rule) if is_shown else \
            "rejected: the evidence does not show " + rule


def dangling_text(pads, dangling):
    """Triangles and edges, each with the numbers of the pads that make it a simplex."""
    return ["pads %d" % len(pads)] + [" ".join(map(str, pad)) for pad in pads] + ["dangling %d" % len(dangling)] + \
        [" ".join(map(str, [len(own), *own, *added])) for own, added in dangling]


def refutations_where_something_dangles():
    """The square again, with some edges listed beside the triangles; the pads are counted on from 8."""
    shown, beside = True, False
    square = [(0, 0), (4, 0), (4, 4), (0, 4), (2, 1), (2, 2), (1, 3)]
    fan, half, both = [[1, 2, 5], [2, 3, 5], [3, 4, 5], [4, 1, 5]], [[1, 2, 3]], [[1, 2, 3], [1, 3, 4]]
    left, down = [(-1, 0)], [(1, 2)]
    cases = [
        ("domain.vertex-missing", "cdt", half, left, [3, 5], "4", shown, ""),
        ("domain.vertex-missing", "cdt", half, left, [1, 4], "4", beside, ""),
        ("domain.segment-missing", "cdt", fan, left, [1, 7], "5 4 4 2", shown, ""),
        ("domain.segment-missing", "cdt", fan, left, [1, 3], "5 4 4 2", beside, ""),
        ("domain.segment-missing", "cdt", fan, [], [1, 7], "5 4 4 2", beside, "--no-pad"),
        ("domain.steiner-forbidden", "cdt", both, left, [1, 5], "3 1", shown, ""),
        ("domain.steiner-forbidden", "cdt", both, left, [1, 5], "3 0", beside, ""),
        ("domain.steiner-forbidden", "cdt", both, left, [1, 5], "3 2", beside, "--a-pad"),
        ("domain.vertex-in-edge", "cdt", [[4, 6, 7]], left, [1, 3], "1 1 2 0 1 5", shown, ""),
        ("domain.vertex-in-edge", "cdt", [[4, 6, 7]], left, [1, 3], "1 2 2 0 1 5", beside, ""),
        ("domain.vertex-in-edge", "cdt", [[4, 6, 7]], left, [1, 3], "1 1 2 0 2 5", beside, "--a-pad"),
        ("delaunay.no-empty-ball", "conforming-delaunay", [[5, 7, 2]], left, [1, 3], "2 2 -7 -5 5 8 7 4", shown, ""),
        ("delaunay.no-empty-ball", "conforming-delaunay", [[1, 3, 6]], left, [2, 7], "2 2 -1 -2 6 3", shown, "--in-the-edge"),
        ("delaunay.no-empty-ball", "conforming-delaunay", [[5, 6, 7]], left, [1, 3], "2 2 -3 -3 2 2 7 4", shown, "--of-the-domain"),
        ("delaunay.no-empty-ball", "conforming-delaunay", [[5, 6, 7]], left, [1, 6], "2 2 0 -4 2 2 4 2", beside, "--outside"),
        ("delaunay.no-empty-ball", "steiner-cdt", [[5, 7, 2]], left, [1, 3], "2 2 -7 -5 5 8 7 4", beside, "--not-claimed"),
        ("delaunay.no-empty-ball", "conforming-delaunay", [[5, 7, 2], [1, 3, 2]], left, [1, 3], "3 2 -7 -5 5 8 7 4", beside, "--a-facet"),
        ("delaunay.no-empty-ball", "conforming-delaunay", [[5, 1, 2]], left, [1, 4], "2 2 -7 -5 5 8 7 4", beside, "--no-vertex"),
        ("delaunay.no-empty-ball", "conforming-delaunay", [[5, 6, 2]], left, [1, 3], "2 2 -7 -5 5 8 7 4", beside, "--a-point-alone"),
        ("delaunay.no-empty-ball", "conforming-delaunay", [[7, 2, 1]], left, [5, 6], "2 2 0 3 7 -2 2 -1", beside, "--beyond-all-balls"),
        ("delaunay.no-empty-ball", "conforming-delaunay", [[5, 7, 2]], left, [1, 3], "2 2 -7 -4 5 8 7 4", beside, "--another-sum"),
        ("delaunay.no-empty-ball", "conforming-delaunay", [[5, 7, 2]], left, [1, 3], "2 2 -6 -6 5 8 7 4", beside, "--another-point"),
        ("delaunay.no-empty-ball", "conforming-delaunay", [[5, 7, 2]], left, [1, 3], "2 2 -6 -6 5 12", beside, "--one-coordinate"),
        ("delaunay.no-empty-ball", "conforming-delaunay", [[2, 4, 5]], left, [1, 3], "2 2 -1 -1 2 1 4 1", beside, "--on-it"),
        ("delaunay.no-empty-ball", "conforming-delaunay", [[1, 3, 2]], left, [5, 7], "1 2 -1 -2 6 3", beside, "--of-a-simplex"),
        ("complex.overlap", "steiner-cdt", half, down, [7, 2], "1 2 5 3 2", shown, ""),
        ("complex.overlap", "steiner-cdt", half, down, [7, 2], "1 2 4 3 2", beside, "--off-the-edge"),
        ("complex.overlap", "steiner-cdt", half, down, [1, 3], "1 2 1 1 1", beside, "--a-common-face"),
        ("complex.overlap", "steiner-cdt", half, [(5, -1)], [7, 2], "1 2 5 3 2", beside, "--in-a-line"),
        ("delaunay.vertex-in-ball", "conforming-delaunay", half, left, [3, 7], "1 7", shown, ""),
        ("delaunay.vertex-in-ball", "conforming-delaunay", [[1, 3, 7]], left, [3, 4], "1 2", shown, "--of-the-domain"),
        ("delaunay.vertex-in-ball", "conforming-delaunay", half, left, [3, 4], "1 7", beside, "--no-vertex"),
        ("delaunay.vertex-in-ball", "conforming-delaunay", half, left, [3, 4], "1 4", beside, "--on-it"),
        ("delaunay.vertex-in-ball", "steiner-cdt", half, left, [3, 7], "1 7", beside, "--not-claimed"),
    ]
    for rule, claim, simplices, pads, edge, because, is_shown, why in cases:
        lines = ["circumspect-refutation 2 %s 2 %s" % (claim, rule), "scale 1 2", "points 7"]
        lines += ["%d %d %d" % (*p, v) for v, p in enumerate(square)]
        lines += ["simplices %d" % len(simplices)] + [" ".join(map(str, [len(row)] + row)) for row in simplices]
        lines += ["spans 1 2 3"] + dangling_text(pads, [(edge, [8])])
        lines += ["vertices 4"] + ["%d %d" % p for p in square[:4]]
        lines += ["segments 5", "1 2", "2 3", "3 4", "1 4", "1 3"]
        yield "%s--%s--dangling%s" % (rule, "shown" if is_shown else "not-shown", why), \
            "\n".join(lines + ["because " + because, "end"]) + "\n", \
            "verified: not %s, %s; 1 dangling face; domain: 4 vertices, 5 segments" % (claim, rule) if is_shown else \
            "rejected: the evidence does not show " + rule
    points = [(-4, 0), (4, 0), (0, 1), (0, -1), (0, 4)]
    rhombus = (points[:4], [(1, 3), (2, 3), (2, 4), (1, 4)], [], [])
    long, half = [[1, 2, 3], [2, 1, 4]], [[1, 2, 3]]
    cases = [
        ("domain.uncovered", half, (-5, 0), [1, 4], "segment 3 4 -1 2", shown, ""),
        ("domain.uncovered", half, (5, 0), [2, 4], "segment 3 4 -1 2", beside, "--covered"),
        ("domain.uncovered", half, (9, 0), [1, 4], "segment 3 4 -1 2", beside, "--beneath-a-pad"),
        ("domain.outside", long, (4, 1), [2, 5], "3 2 2 1 0 beyond 1 4 4", shown, ""),
        ("domain.outside", long, (4, 1), [2, 5], "3 6 3 2 0 beyond 1 4 4", beside, "--off-the-edge"),
        ("cdt.facet-not-local", long, (-5, 0), [3, 5], "1 2 2 2 0 0 1", beside, ""),
    ]
    for rule, simplices, pad, edge, because, is_shown, why in cases:
        yield "%s--%s--dangling%s" % (rule, "shown" if is_shown else "not-shown", why), \
            whole_text("steiner-cdt", 2, rule, "enclosed", points, simplices, rhombus, because,
                       dangling_text([pad], [(edge, [6])])), \
            "verified: not steiner-cdt, %s; 1 dangling face; domain: enclosed, 4 vertices" % rule if is_shown else \
            "rejected: the evidence does not show " + rule
    solid = [(0, 0, 0), (0, 0, 9), (0, 9, 0), (9, 0, 0)]
    floor = space_domain("steiner-triangulation", "enclosed", solid, [(0, 1, 2, 3)], 1, [(0, 2, 3)], [])["polygons"]
    for triangle, is_shown in [([1, 3, 2], True), ([1, 3, 4], False)]:
        yield "domain.polygon-not-tiled--%s--dangling" % ("shown" if is_shown else "not-shown"), \
            whole_text("cdt", 3, "domain.polygon-not-tiled", "enclosed", solid + [(1, 1, 0)], [[1, 4, 5, 2]],
                       (solid, [(1, 3), (3, 4), (1, 4)], [], floor), "1 1 3 3 0 1",
                       dangling_text([(-1, 0, -1)], [(triangle, [6])])), \
            "verified: not cdt, domain.polygon-not-tiled; 1 dangling face; domain: enclosed, 4 vertices" if is_shown else \
            "rejected: the evidence does not show domain.polygon-not-tiled"
    for why, edge in [("too-large", [1, 3, 4]), ("of-a-pad", [1, 6])]:
        yield "malformed--dangling--" + why, \
            whole_text("cdt", 2, "domain.uncovered", "enclosed", points, half, rhombus, "segment 3 4 -1 2",
                       dangling_text([(-5, 0)], [(edge, [6] if len(edge) < 3 else [])])), "malformed: "


def whole_text(claim, d, rule, kind, points, simplices, domain, because, dangling=()):
    """A refutation that speaks of the whole domain: vertices, segments, hole points, polygons."""
    lines = ["circumspect-refutation 2 %s %d %s %s" % (claim, d, rule, kind), "scale 1 1", "points %d" % len(points)]
    lines += [" ".join(map(str, [*p, v])) for v, p in enumerate(points)]
    lines += ["simplices %d" % len(simplices)] + [" ".join(map(str, [len(row)] + row)) for row in simplices]
    lines += ["spans " + " ".join(map(str, range(1, d + 2))), *dangling]
    for name, rows in zip(["vertices", "segments", "holes"], domain):
        lines += ["%s %d" % (name, len(rows))] + [" ".join(map(str, row)) for row in rows]
    lines += ["polygons %d" % len(domain[3])]
    for f in domain[3]:
        lines += polygon_text(f)
    return "\n".join(lines + ["because " + because, "end"]) + "\n"


def refutations_by_the_whole_domain():
    """Meshes of a rhombus and of a tetrahedron, and what is wrong with them, right or not."""
    points = [(-4, 0), (4, 0), (0, 1), (0, -1), (0, 4)]
    corners, sides = points[:4], [(1, 3), (2, 3), (2, 4), (1, 4)]
    rhombus = (corners, sides, [], [])
    walled = (corners, sides + [(1, 2)], [], [])
    hollow = (corners, sides, [(0, 0, 1)], [])
    long, short, half, astray = [[1, 2, 3], [2, 1, 4]], [[1, 3, 4], [2, 3, 4]], [[1, 2, 3]], [[1, 2, 3], [3, 5, 2]]
    planes = "-1 -1 -1 1 -1 -1 -1 4 -4 1 4 -4"
    few = "-1 -1 -1 1 -1 -1 -1 4 -4"
    cases = [
        ("cdt.facet-not-local", "cdt", long, rhombus, "1 2 2 2 0 0 1", True, ""),
        ("cdt.facet-not-local", "steiner-cdt", long, rhombus, "2 2 1 2 1 0 3", True, "--from-the-other"),
        ("cdt.facet-not-local", "cdt", long, walled, "1 2 2 2 0 0 1", False, "--in-a-wall"),
        ("cdt.facet-not-local", "cdt", long, rhombus, "1 2 2 2 0 1 3", False, "--off-the-facet"),
        ("cdt.facet-not-local", "cdt", long, rhombus, "1 2 2 2 4 0 1", False, "--its-end"),
        ("cdt.facet-not-local", "cdt", short, rhombus, "1 0 2 0 0 0 1", False, "--it-is"),
        ("cdt.facet-not-local", "plc-triangulation", long, rhombus, "1 2 2 2 0 0 1", False, "--not-claimed"),
        ("cdt.facet-not-local", "cdt", long, rhombus, "1 3 2 2 0 0 1", False, "--no-facet"),
        ("cdt.visible-vertex-in-ball", "cdt", long, rhombus, "1 4 0 1 3 " + planes, True, ""),
        ("cdt.visible-vertex-in-ball", "cdt", long, rhombus, "1 4 0 1 3 " + few, False, "--a-segment-in-the-way"),
        ("cdt.visible-vertex-in-ball", "cdt", long, walled, "1 4 0 1 3 " + planes, False, "--behind-a-wall"),
        ("cdt.visible-vertex-in-ball", "cdt", long, rhombus, "1 4 0 0 1 " + planes, False, "--from-the-facet"),
        ("cdt.visible-vertex-in-ball", "cdt", long, rhombus, "1 3 0 1 3 " + planes, False, "--its-own-vertex"),
        ("cdt.visible-vertex-in-ball", "plc-triangulation", long, rhombus, "1 4 0 1 3 " + planes, False, "--not-claimed"),
        ("cdt.visible-vertex-in-ball", "cdt", half, rhombus, "1 4 0 1 3 " + planes, False, "--no-vertex-of-the-mesh"),
        ("domain.uncovered", "plc-triangulation", half, rhombus, "segment 3 4 -1 2", True, ""),
        ("domain.uncovered", "plc-triangulation", half, rhombus, "vertex 4", True, "--a-vertex"),
        ("domain.uncovered", "plc-triangulation", half, rhombus, "segment 1 -4 1 2", False, "--covered"),
        ("domain.uncovered", "plc-triangulation", half, rhombus, "segment 3 4 1 2", False, "--off-the-segment"),
        ("domain.uncovered", "plc-triangulation", half + [[1, 2]], rhombus, "segment 3 4 -1 2", False, "--not-all-triangles"),
        ("domain.uncovered-or-outside", "plc-triangulation", half, rhombus, "1 0 1 3 0 -1 3 4 " + planes, True, ""),
        ("domain.uncovered-or-outside", "plc-triangulation", long, rhombus, "1 0 1 3 0 -1 3 4 " + planes, False, "--covered"),
        ("domain.uncovered-or-outside", "plc-triangulation", half, walled, "1 0 1 3 0 -1 3 4 " + planes, False, "--a-wall-between"),
        ("domain.uncovered-or-outside", "plc-triangulation", half, rhombus, "1 0 1 3 0 -1 3 3 " + few, False, "--a-plane-less"),
        ("domain.uncovered-or-outside", "plc-triangulation", half, rhombus, "1 0 -1 3 0 -1 3 4 " + planes, False, "--not-in-it"),
        ("domain.outside", "steiner-triangulation", astray, rhombus, "2 4 5 3 0 beyond 1 4 4", True, ""),
        ("domain.outside", "steiner-triangulation", astray, rhombus, "2 4 5 3 1 8 8 1 1 1 4 4 beyond 1 0 4", True, "--by-a-leg"),
        ("domain.outside", "steiner-triangulation", half, hollow, "1 0 1 3 1 0 0 1 4 " + planes + " hole 1", True, "--in-a-hole"),
        ("domain.outside", "steiner-triangulation", astray, rhombus, "1 0 1 3 0 beyond 1 4 4", False, "--inside"),
        ("domain.outside", "steiner-triangulation", astray, rhombus, "2 4 5 3 0 beyond 1 4 3", False, "--vertices-beyond"),
        ("domain.outside", "steiner-triangulation", astray, rhombus, "2 4 5 3 0 beyond 0 0 -1", False, "--no-plane"),
        ("domain.outside", "steiner-triangulation", astray, rhombus, "1 4 5 3 0 beyond 1 4 4", False, "--not-in-it"),
        ("domain.outside", "steiner-triangulation", astray, rhombus, "2 4 5 3 1 8 8 1 0 beyond 1 0 4", False, "--by-a-leg"),
        ("domain.outside", "steiner-triangulation", half, hollow, "1 0 1 3 1 0 0 1 4 " + planes + " hole 2", False, "--no-hole"),
        ("domain.outside", "steiner-triangulation", half, hollow, "1 0 1 3 1 0 1 2 4 " + planes + " hole 1", False, "--beside-the-hole"),
        ("domain.outside", "steiner-triangulation", half, hollow, "1 0 1 3 1 0 0 1 3 " + few + " hole 1", False, "--a-plane-less"),
    ]
    for rule, claim, simplices, domain, because, is_shown, why in cases:
        word = "domain.uncovered or domain.outside" if rule.endswith("or-outside") else rule
        yield "%s--%s%s" % (rule, "shown" if is_shown else "not-shown", why), \
            whole_text(claim, 2, rule, "enclosed", points, simplices, domain, because), \
            "verified: not %s, %s; domain: enclosed, 4 vertices" % (claim, word) if is_shown else \
            "rejected: the evidence does not show " + word
    solid = [(0, 0, 0), (0, 0, 9), (0, 9, 0), (9, 0, 0)]
    floor = space_domain("steiner-triangulation", "enclosed", solid, [(0, 1, 2, 3)], 1, [(0, 2, 3)], [])["polygons"]
    given = (solid, [(1, 3), (3, 4), (1, 4)], [], floor)
    more = [(1, 1, 0), (1, 1, -5)]
    for name, simplices, because, is_shown in [
            ("shown", [[1, 4, 5, 2]], "1 1 3 3 0 1", True), ("shown--cut", [[2, 6, 3, 4]], "1 1 3 3 0 1", True),
            ("not-shown", [[1, 3, 4, 2]], "1 1 3 3 0 1", False), ("not-shown--off-the-plane", [[1, 4, 5, 2]], "1 1 3 3 1 1", False),
            ("not-shown--off-the-polygon", [[1, 4, 5, 2]], "1 1 9 9 0 1", False),
            ("not-shown--no-polygon", [[1, 4, 5, 2]], "2 1 3 3 0 1", False),
            ("not-shown--no-piece", [[1, 4, 5, 2]], "1 2 3 3 0 1", False)]:
        yield "domain.polygon-not-tiled--" + name, \
            whole_text("steiner-triangulation", 3, "domain.polygon-not-tiled", "enclosed", solid + more, simplices, given, because), \
            "verified: not steiner-triangulation, domain.polygon-not-tiled; domain: enclosed, 4 vertices" if is_shown else \
            "rejected: the evidence does not show domain.polygon-not-tiled"


def refutations_of_hulls():
    """Meshes that are to fill a hull, and what is wrong with their boundaries, right or not."""
    points = [(-4, 0), (4, 0), (0, 1), (0, -1), (0, 4)]
    hull = (points, [], [], [])
    open_below, bow_tie = [[1, 3, 5], [2, 3, 5]], [[3, 1, 5], [3, 2, 4]]
    dangles = dangling_text([(-5, 0)], [([1, 4], [6])])
    cases = [
        ("convex", "plc-triangulation", "hull", open_below, "1 2 2", True, "--of-a-hull", ()),
        ("convex", "steiner-cdt", "hull", open_below, "1 2 2", True, "--of-a-hull--steiner", ()),
        ("convex", "plc-triangulation", "hull", open_below, "1 2 5", False, "--of-a-hull--its-own-side", ()),
        ("convex", "plc-triangulation", "hull", open_below, "1 1 2", False, "--of-a-hull--another-facet", ()),
        ("convex", "plc-triangulation", "hull", open_below, "1 0 2", False, "--of-a-hull--no-boundary", ()),
        ("convex", "plc-triangulation", "hull", open_below, "1 2 4", False, "--of-a-hull--no-vertex-of-the-mesh", ()),
        ("convex", "plc-triangulation", "hull", open_below, "1 2 9", False, "--of-a-hull--no-point", ()),
        ("convex", "plc-triangulation", "hull", open_below, "1 2 2", False, "--of-a-hull--dangling", dangles),
        ("convex", "plc-triangulation", "enclosed", open_below, "1 2 2", False, "--enclosed", ()),
        ("closed", "cdt", "hull", bow_tie, "1 2 1 1 2 2", True, "--of-a-hull", ()),
        ("closed", "cdt", "hull", bow_tie, "1 2 1 0 2 2", False, "--of-a-hull--another-facet", ()),
        ("closed", "cdt", "enclosed", bow_tie, "1 2 1 1 2 2", False, "--enclosed", ()),
    ]
    for what, claim, kind, simplices, because, is_shown, why, dangling in cases:
        rule = "triangulation.hull-not-" + what
        yield "%s--%s%s" % (rule, "shown" if is_shown else "not-shown", why), \
            whole_text(claim, 2, rule, kind, points, simplices, hull, because, dangling), \
            "verified: not %s, %s; domain: %s, 5 vertices" % (claim, rule, kind) if is_shown else \
            "rejected: the evidence does not show " + rule


def refutations_by_another_mesh():
    """A mesh of a square without one triangle, in another unit than the mesh that has it; and a mesh that lacks nothing."""
    square = [(0, 0), (4, 0), (4, 4), (0, 4), (2, 1)]
    fan = [(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)]
    whole = plane_domain("steiner-triangulation", "enclosed", square, fan, 4, {0, 1, 2, 3}, [(0, 1), (1, 2), (2, 3), (0, 3)])
    notched = plane_domain("steiner-triangulation", "enclosed", NOTCHED, NOTCHED_MESH + NOTCH_AND_HOLE, 9,
                           set(range(8)), NOTCHED_SEGMENTS, [(11, [8, 9], 2)])
    filled = copy.deepcopy(notched)
    filled["part"]["marks"][9] = ["+", filled["part"]["marks"][9][1]]
    points, lacking = [tuple(2 * x for x in p) for p in square], [fan[0], fan[1], fan[3]]
    dangles = dangling_text([(0, 9)], [([3, 4], [6])])
    cases = [
        ("", 2, points, lacking, whole, "3 2 3 1", True, ()),
        ("--dangling", 2, points, lacking, whole, "3 2 3 1", True, dangles),
        ("--no-point", 2, points, lacking, whole, "3 2 3 0", False, ()),
        ("--not-in-it", 2, points, lacking, whole, "1 2 3 1", False, ()),
        ("--no-simplex", 2, points, lacking, whole, "9 2 3 1", False, ()),
        ("--covered", 2, points, lacking, whole, "1 6 1 3", False, ()),
        ("--covered-in-this-unit", 1, points, lacking, whole, "3 2 3 1", False, ()),
        ("--not-kept", 1, NOTCHED, NOTCHED_MESH, notched, "10 12 2 3", False, ()),
        ("--no-certificate", 1, NOTCHED, NOTCHED_MESH, filled, "10 12 2 3", False, ()),
    ]
    for why, unit, points, simplices, domain, because, is_shown, dangling in cases:
        lines = ["circumspect-refutation 2 steiner-cdt 2 domain.uncovered-inside enclosed", "scale 1 %d" % unit, "points %d" % len(points)]
        lines += [" ".join(map(str, [*p, v])) for v, p in enumerate(points)]
        lines += ["simplices %d" % len(simplices)] + [" ".join(map(str, [len(row)] + [v + 1 for v in row])) for row in simplices]
        lines += ["spans 1 2 3", *dangling] + domain_text(domain).split("\n")[1:-2]
        yield "domain.uncovered--%s--inside%s" % ("shown" if is_shown else "not-shown", why), \
            "\n".join(lines + ["because " + because, "end"]) + "\n", \
            "verified: not steiner-cdt, domain.uncovered; %sdomain: enclosed, 4 vertices" % ("1 dangling face; " if dangling else "") \
            if is_shown else "rejected: the evidence does not show domain.uncovered"


def refutations_of_dangling_triangles():
    """A triangle in a triangular polygon, and what one sees from it."""
    solid = [(0, 0, 0), (0, 0, 9), (0, 9, 0), (9, 0, 0)]
    floor = space_domain("steiner-triangulation", "enclosed", solid, [(0, 1, 2, 3)], 1, [(0, 2, 3)], [])["polygons"]
    points = solid + [(1, 1, 0), (3, 1, 0), (1, 3, 0), (2, 3, 0), (3, 3, 0), (7, 1, 0), (1, 7, 0), (6, 6, 0)]
    given, bare = (solid, [(1, 3), (3, 4), (1, 4)], [], floor), (solid, [], [], floor)
    twice = (solid, [(1, 3), (3, 4), (1, 4)], [], floor + floor)
    apart = [[8, 1, 2, 3], [9, 1, 2, 3], [12, 1, 2, 3]]
    small, large = [5, 6, 7], [5, 10, 11]
    two = "1 0 0 0 0 1 0 0"
    planes = two + " -1 -1 0 -9"
    sees = "4 8 1 -1 -2 2 1 5 5 0 3 0 1 "
    cases = [
        ("", "steiner-cdt", "enclosed", apart, given, small, sees + planes),
        ("--with-a-bend", "cdt", "enclosed", apart, given, small, "4 8 1 -1 -2 2 1 5 5 0 3 1 1 11 14 0 6 1 " + planes),
        ("--without-segments", "cdt", "enclosed", apart, bare, small, sees + two),
        ("--not-claimed", "plc-triangulation", "enclosed", apart, given, small, sees + planes),
        ("--of-a-hull", "steiner-cdt", "hull", apart, given, small, sees + planes),
        ("--a-segment-in-the-way", "steiner-cdt", "enclosed", apart, given, small, sees + two),
        ("--another-polygon-in-the-way", "steiner-cdt", "enclosed", apart, twice, small, sees + planes),
        ("--another-vertex", "steiner-cdt", "enclosed", apart, given, small, "4 4 1 -1 -2 2 1 5 5 0 3 0 1 " + planes),
        ("--on-its-circle", "steiner-cdt", "enclosed", apart, given, small, "4 9 1 -1 -1 1 1 5 5 0 3 0 1 " + planes),
        ("--on-its-edge", "steiner-cdt", "enclosed", apart, given, small, "4 8 1 -1 -2 2 1 2 1 0 1 0 1 " + planes),
        ("--from-elsewhere", "steiner-cdt", "enclosed", apart, given, small, "4 8 1 -1 -2 2 1 4 5 0 2 0 1 " + planes),
        ("--of-a-simplex", "steiner-cdt", "enclosed", apart[:2] + [[5, 6, 7, 2]], given, small, sees + planes),
        ("--no-polygon", "steiner-cdt", "enclosed", apart, given, small, "4 8 1 -1 -2 2 2 5 5 0 3 0 1 " + planes),
        ("--no-piece", "steiner-cdt", "enclosed", apart, given, small, "4 8 1 -1 -2 2 1 5 5 0 3 0 2 " + planes),
        ("--bent", "steiner-cdt", "enclosed", apart, given, small, "4 8 1 -1 -2 2 1 5 5 0 3 1 1 12 14 0 6 1 " + planes),
        ("--no-vertex-of-the-mesh", "steiner-cdt", "enclosed", [[1, 2, 3, 4]], given, small, "2" + sees[1:] + planes),
        ("--out-of-the-polygon", "steiner-cdt", "enclosed", apart, bare, large, "4 12 4 -5 -5 6 1 3 3 0 1 0 1 " + two),
    ]
    for number, (why, claim, kind, simplices, domain, triangle, because) in enumerate(cases):
        is_shown = number < 3
        yield "cdt.dangling-not-delaunay--%s%s" % ("shown" if is_shown else "not-shown", why), \
            whole_text(claim, 3, "cdt.dangling-not-delaunay", kind, points, simplices, domain, because,
                       dangling_text([(1, 1, -1)], [(triangle, [13])])), \
            "verified: not %s, cdt.dangling-not-delaunay; 1 dangling face; domain: enclosed, 4 vertices" % claim if is_shown else \
            "rejected: the evidence does not show cdt.dangling-not-delaunay"
