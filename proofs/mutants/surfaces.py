"""Certificates and refutations of surfaces: of the claim surface-delaunay."""


def edges_of(triangles):
    """All edges, by triangle and vertex opposite, so that the same stand side by side."""
    def key(edge):
        t, i = edge
        others = sorted(triangles[t][:i] + triangles[t][i + 1:])
        return others + [triangles[t][i]]
    return sorted(((t, i) for t in range(len(triangles)) for i in range(3)), key=key)


def surface(points, triangles, edges=None):
    """Vertices are numbered from 1."""
    edges = edges or edges_of(triangles)
    stands = {edge: k for k, edge in enumerate(edges, 1)}
    lines = [f"circumspect-certificate 1 surface-delaunay {len(points[0])}", "scale 1 2", f"points {len(points)}"]
    lines += [" ".join(map(str, point)) + f"  {v}" for v, point in enumerate(points)]
    lines.append(f"triangles {len(triangles)}")
    lines += [" ".join(map(str, row)) + "  " + " ".join(str(stands[(t, i)]) for i in range(3)) for t, row in enumerate(triangles)]
    lines.append(f"edges {len(edges)}")
    lines += [f"{t + 1} {i}" for t, i in edges]
    return "\n".join([*lines, "end"]) + "\n"


def refuted(points, rows, because, claim="surface-delaunay", rule="surface.edge-not-delaunay"):
    """Entries of rows are numbered from 1."""
    lines = [f"circumspect-refutation 2 {claim} {len(points[0])} {rule}", "scale 1 2", f"points {len(points)}"]
    lines += [" ".join(map(str, point)) + f"  {v}" for v, point in enumerate(points)]
    lines.append(f"simplices {len(rows)}")
    lines += [" ".join(map(str, [len(row), *row])) for row in rows]
    return "\n".join([*lines, "because " + " ".join(map(str, because)), "end"]) + "\n"


HINGE = surface([(0, 0, 0), (0, 0, 4), (0, 4, 0), (4, 0, 0)], [[1, 4, 3], [1, 4, 2]])
# The angles opposite the edge of both have a sum of two right angles; or of more.
SQUARE = [(0, 0), (0, 3000), (3000, 0), (3000, 3000)]
BY_A_HAIR = [(0, 0), (0, 3000), (2999, 3000), (3000, 0)]
WIDE = [(0, 0), (4, -1), (4, 1), (8, 0)], [[1, 2, 4], [1, 4, 3]]
# Three triangles with one edge: nothing is asked of it.
PAGES = [(0, 0, 0), (4, -1, 0), (4, 0, 1), (4, 1, 0), (8, 0, 0)], [[1, 5, 4], [1, 5, 3], [2, 1, 5]]


def files():
    def changed(name, answer, line, other):
        assert line + "\n" in HINGE, line
        return name, HINGE.replace(line + "\n", other, 1), answer

    yield "surface--hinge", HINGE, "verified: surface-delaunay, 4 points, 2 triangles"
    yield "surface--square", surface(SQUARE, [[1, 2, 3], [2, 3, 4]]), "verified: surface-delaunay, 4 points, 2 triangles"
    yield "surface--pages", surface(*PAGES), "verified: surface-delaunay, 5 points, 3 triangles"
    yield "edge-delaunay", surface(*WIDE), "rejected: edge-delaunay, edge 3"
    yield "edge-delaunay--by-a-hair", surface(BY_A_HAIR, [[1, 2, 4], [2, 4, 3]]), "rejected: edge-delaunay, edge 4"
    for k, kept in enumerate(([0, 1], [0, 2], [1, 2])):
        yield f"edge-delaunay--two-pages-{k}", surface(PAGES[0], [PAGES[1][t] for t in kept]), "rejected: edge-delaunay, edge "
    # The two edges that are one, apart; and a triangle that is listed twice.
    apart = edges_of(WIDE[1])
    apart = [apart[2], *apart[:2], *apart[3:]]
    yield "edges-increasing", surface(*WIDE, apart), "rejected: edges-increasing, edge 1"
    yield "edges-increasing--listed-twice", surface(PAGES[0], [[1, 5, 4], [5, 4, 1]]), "rejected: edges-increasing, edge 1"
    yield changed("edge-listed", "rejected: edge-listed, simplex 1", "1 4 3  6 2 4", "1 4 3  6 2 3\n")
    yield "edge-listed--of-nothing", HINGE.replace("edges 6", "edges 7").replace("end\n", "9 0\nend\n"), "rejected: edge-listed, edge 7"
    yield "edge-listed--no-vertex", HINGE.replace("edges 6", "edges 7").replace("end\n", "1 3\nend\n"), "rejected: edge-listed, edge 7"
    yield "simplex-proper--surface", surface([(0, 0, 0), (1, 1, 1), (2, 2, 2)], [[1, 2, 3]]), "rejected: simplex-proper, simplex 1"
    yield changed("vertex-known--surface", "rejected: vertex-known, simplex 1", "1 4 3  6 2 4", "1 4 9  6 2 4\n")
    yield changed("points-increasing--surface", "rejected: points-increasing, point 1", "0 0 4  1", "0 0 0  1\n")
    yield changed("scale--surface", "rejected: scale", "scale 1 2", "scale 0 2\n")
    yield "simplex-listed--no-triangle", "circumspect-certificate 1 surface-delaunay 3\nscale 1 1\npoints 0\ntriangles 0\nedges 0\nend\n", \
        "rejected: simplex-listed"
    yield from refutations()


def refutations():
    rule = "surface.edge-not-delaunay"
    shown, not_shown = f"verified: not surface-delaunay, {rule}", f"rejected: the evidence does not show {rule}"
    yield f"{rule}--shown", refuted(*WIDE, [1, 1, 2, 2]), shown
    yield f"{rule}--shown--by-a-hair", refuted(BY_A_HAIR, [[1, 2, 4], [2, 4, 3]], [1, 0, 2, 2]), shown
    # Beside rows that are no triangles, and a point that is listed twice.
    yield f"{rule}--shown--among-others", refuted([*WIDE[0], (8, 0)], [[1, 2, 4], [], [5, 3, 1], [1, 1, 9], [4]], [1, 1, 3, 1]), shown
    yield f"{rule}--not-shown--two-right-angles", refuted(SQUARE, [[1, 2, 3], [2, 3, 4]], [1, 0, 2, 2]), not_shown
    yield f"{rule}--not-shown--of-three", refuted(*PAGES, [1, 2, 2, 2]), not_shown
    third = [*WIDE[0], (0, 0), (8, 0), (4, 9)], [*WIDE[1], [5, 7, 6]]
    yield f"{rule}--not-shown--of-three-by-place", refuted(*third, [1, 1, 2, 2]), not_shown
    yield f"{rule}--not-shown--another-edge", refuted(*WIDE, [1, 0, 2, 2]), not_shown
    yield f"{rule}--not-shown--one-triangle", refuted(*WIDE, [1, 1, 1, 1]), not_shown
    yield f"{rule}--not-shown--flat", refuted([(0, 0), (4, 0), (4, 1), (8, 0)], WIDE[1], [1, 1, 2, 2]), not_shown
    yield f"{rule}--not-shown--no-triangle", refuted(*WIDE, [1, 1, 3, 2]), not_shown
    yield f"{rule}--not-shown--no-vertex", refuted(*WIDE, [1, 3, 2, 2]), not_shown
