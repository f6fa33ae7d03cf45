"""Certificates and refutations of meshes alone: of the claim complex."""

# Two triangles that meet in the point (2, 2): only the line x = 2 parts them.
BOW_TIE = """circumspect-certificate 1 complex 2
scale 1 1
points 5
0 0  1 0 0
0 4  1 1 1
2 2  1 2 2
4 0  2 0 3
4 4  2 1 4
simplices 2 3
1 2 3  1  2 -1 0 -2
4 5 3  2
order 2
1
2
end
"""
# Two triangles in space with a common edge, one of them upright; a point beside each makes it a
# tetrahedron.
HINGE = """circumspect-certificate 1 complex 3
scale 1 2
points 4
0 0 0  1 0 1
0 0 4  2 2 2
0 4 0  1 2 3
4 0 0  1 1 4
simplices 2 3
1 4 3  2  0 0 1
1 4 2  1  0 1 0
order 2
2
1
end
"""


def certificates():
    def changed(name, answer, *changes, base=BOW_TIE):
        text = base
        for line, other in changes:
            assert line + "\n" in text, line
            text = text.replace(line + "\n", other)
        return f"{name}", text, answer

    yield "complex--bow-tie", BOW_TIE, "verified: complex, 5 points, 2 triangles"
    yield "complex--hinge", HINGE, "verified: complex, 4 points, 2 triangles"
    yield changed("scale--alone", "rejected: scale", ("scale 1 1", "scale 1 0\n"))
    yield changed("points-increasing--alone", "rejected: points-increasing, point 1", ("0 4  1 1 1", "0 0  1 1 1\n"))
    yield changed("point-used--alone", "rejected: point-used, point 5", ("4 4  2 1 4", "4 4  2 0 4\n"))
    # A point that is no vertex, and says so.
    unused = [("points 5", "points 6\n"), ("4 4  2 1 4", "4 4  2 1 4\n5 0  1 - 5\n")]
    some_unused = BOW_TIE.replace("complex 2\n", "complex 2 unused\n")
    yield changed("complex--some-unused", "verified: complex, 6 points, 2 triangles, 1 unused", *unused, base=some_unused)
    yield changed("complex--some-unused--none", "verified: complex, 5 points, 2 triangles, 0 unused", base=some_unused)
    yield changed("point-used--unused", "rejected: point-used, point 6", *unused)
    yield changed("point-used--some-unused", "rejected: point-used, point 5", ("4 4  2 1 4", "4 4  2 0 4\n"), base=some_unused)
    yield changed("simplices-parted--some-unused", "rejected: simplices-parted", ("1 2 3  1  2 -1 0 -2", "1 2 3  1\n"), base=some_unused)
    yield changed("vertex-known--alone", "rejected: vertex-known, simplex 2", ("4 5 3  2", "4 5 9  2\n"))
    yield changed("simplex-proper", "rejected: simplex-proper, simplex 1", ("0 4  1 1 1", "1 1  1 1 1\n"))
    yield changed("simplex-proper--pad-in-its-plane", "rejected: simplex-proper, simplex 1", ("1 4 3  2  0 0 1", "1 4 3  2  1 1 0\n"),
                  base=HINGE)
    yield changed("simplex-listed", "rejected: simplex-listed, simplex 2", ("1\n2", "1\n1\n"))
    yield changed("simplex-listed--nowhere", "rejected: simplex-listed, simplex 2", ("4 5 3  2", "4 5 3  3\n"))
    yield changed("simplices-parted", "rejected: simplices-parted", ("1 2 3  1  2 -1 0 -2", "1 2 3  1\n"))
    yield changed("simplices-parted--beside", "rejected: simplices-parted", ("1 2 3  1  2 -1 0 -2", "1 2 3  1  2 -1 0 -1\n"))
    yield changed("simplices-parted--from-another", "rejected: simplices-parted", ("1 2 3  1  2 -1 0 -2", "1 2 3  1  1 -1 0 -2\n"))
    # The line of nothing parts all, and so does a line of another space.
    yield changed("simplices-parted--by-nothing", "rejected: simplices-parted", ("1 2 3  1  2 -1 0 -2", "1 2 3  1  2 0 0 0\n"))
    yield changed("simplices-parted--overlap", "rejected: simplices-parted", ("2 2  1 2 2", "3 2  1 2 2\n"),
                  ("4 0  2 0 3", "4 0  2 0 3\n"), ("4 5 3  2", "4 5 1  2\n"))
    yield "simplices-parted--listed-twice", BOW_TIE.replace("points 5", "points 3").replace("4 0  2 0 3\n4 4  2 1 4\n", "") \
        .replace("4 5 3  2", "3 1 2  2"), "rejected: simplices-parted"
    yield "simplex-listed--none", "circumspect-certificate 1 complex 2\nscale 1 1\npoints 0\nsimplices 0 3\norder 0\nend\n", \
        "rejected: simplex-listed"
    yield changed("malformed--alone-of-too-many", "malformed: ", ("simplices 2 3", "simplices 2 4\n"))


def refutations():
    points = [(0, 0), (4, 0), (4, 4), (0, 4), (2, 1), (2, 2), (4, 4)]
    halves = [[1, 2, 4], [6, 3, 2]]
    cases = [  # rule, simplices, evidence, evidence that fails
        ("triangulation.unknown-vertex", [[1, 2, -7]], "1 2", "1 1"),
        ("simplex.repeated-vertex", [[1, 2, 1]], "1 0 2", "1 0 1"),
        ("simplex.degenerate", [[1, 3, 6], [1, 2, 5]], "1", "2"),
        ("complex.duplicate-simplex", [[1, 2, 5], [5, 1, 2]], "1 2", "1 1"),
        ("complex.facet-overused", [[1, 2, 3], [1, 2, 4], [1, 2, 5]], None, "1 2 2 2 3 2"),
        ("complex.overlap", [[1, 2, 3], [1, 2, 4]], "1 2 4 1 2", "1 2 0 0 1"),
        ("triangulation.unused-point", halves, "5", "4"),
        ("triangulation.hull-not-convex", halves[:1], None, "1 0 3"),
        ("complex.hanging-vertex", halves, "1 2 2 2 1", "2 1 2 2 1"),
        ("complex.faces-cross", [[1, 3, 2], [2, 4, 5]], "1 2 2 2 1", "1 2 0 0 1"),
        ("complex.faces-cross", halves, None, "1 2 2 2 1", "--a-vertex-hangs"),
        ("complex.hanging-vertex", [[1, 2, 6], [6, 3, 2]], None, "1 2 2 2 1", "--a-common-vertex"),
        ("complex.points-equal", halves, "3 7", "1 2"),
        ("complex.points-equal", halves, None, "3 3", "--one-point"),
    ]
    for rule, simplices, shows, fails, *why in cases:
        lines = [f"circumspect-refutation 2 complex 2 {rule}", "scale 1 1", f"points {len(points)}"]
        lines += [f"{x} {y} {v}" for v, (x, y) in enumerate(points)]
        lines += [f"simplices {len(simplices)}", *(" ".join(map(str, [len(row), *row])) for row in simplices), "spans 1 2 3"]
        for name, evidence, answer in (("shown", shows, f"verified: not complex, {rule}"),
                                       ("not-shown", fails, f"rejected: the evidence does not show {rule}")):
            if evidence:
                yield f"{rule}--{name}--alone{''.join(why)}", "\n".join([*lines, "because " + evidence, "end"]) + "\n", answer


def files():
    yield from certificates()
    yield from refutations()
