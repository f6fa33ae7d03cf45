"""Certificates about domains for make.py: sound ones, and mutants that break one condition each."""

import copy

from honest import certificate, flat, text as mesh_text


def part_text(p):
    """The roles, segments, holes and marks of a certificate about a domain."""
    lines = []
    for name in ["roles", "segments", "holes", "marks"]:
        lines.append("%s %d" % (name, len(p[name])))
        lines += [" ".join(map(str, flat(row))) for row in p[name]]
    return lines


def polygon_text(f):
    lines = [" ".join(map(str, flat(["polygon", f["plane"]])))]
    lines += mesh_text(f["mesh"]).split("\n")[1:-2] + part_text(f["part"])
    for name in ["above", "tiles", "seeds"]:
        lines.append("%s %d" % (name, len(f[name])))
        lines += [" ".join(map(str, flat(row) if isinstance(row, list) else [row])) for row in f[name]]
    return lines


def domain_text(c):
    lines = mesh_text(c["mesh"]).split("\n")[1:-2]
    lines.insert(0, "circumspect-certificate 1 %s %d %s" % (c["claim"], c["mesh"]["d"], c["kind"]))
    lines += part_text(c["part"])
    if c["mesh"]["d"] == 3:
        lines.append("polygons %d" % len(c["polygons"]))
        for f in c["polygons"]:
            lines += polygon_text(f)
    return "\n".join(lines + ["end"]) + "\n"


def part(mesh, kept, corners, chains, walls, holes=(), weights=None):
    """What a certificate about a domain says beside its mesh. `kept` are the first simplices of the
    mesh; `corners` and `chains` name points by their labels; `walls` says which facets, by their
    labels, are part of which wall; `holes` are simplices with a point and a denominator."""
    d = mesh["d"]
    label = [row[4] for row in mesh["points"]]
    number = {v: k + 1 for k, v in enumerate(label)}
    simplices = [row[0] for row in mesh["simplices"]]

    def with_vertices(vs):
        return next((t for t in range(kept) if set(vs) <= set(simplices[t])), 0)

    def flag(t, i):
        facet = frozenset(label[v - 1] for k, v in enumerate(simplices[t]) if k != i)
        return list(walls[facet]) if facet in walls else "-"

    def link(u, v):
        t = with_vertices([number[u], number[v]])
        off = [i for i, x in enumerate(simplices[t]) if x not in (number[u], number[v])]
        return [number[v], t + 1, off[0]]

    flags = [[flag(t, i) for i in range(d + 1)] for t in range(len(simplices))]
    ways = {}
    for h, (t, _, _) in enumerate(holes):
        ways[t - 1] = ["hole", h + 1, 1]
    for t in range(kept, len(simplices)):
        for i, wall in enumerate(mesh["simplices"][t][1]):
            if wall[0] == "-" and flags[t][i] == "-":
                ways.setdefault(t, ["out", i, 1])
    for rank in range(2, len(simplices) + 2):
        for t in [t for t in range(kept, len(simplices)) if t not in ways]:
            for i, wall in enumerate(mesh["simplices"][t][1]):
                if wall[0] != "-" and flags[t][i] == "-" and ways.get(wall[0] - 1, [0, 0, rank])[2] < rank:
                    ways.setdefault(t, ["across", i, rank])
    return {
        "roles": [[with_vertices([number[v]]) + 1] if v in corners
                  else ["-"] + (weights or {}).get(v, []) for v in label],
        "segments": [[number[c[0]]] + [link(u, v) for u, v in zip(c, c[1:])] for c in chains],
        "holes": [list(h) for h in holes],
        "marks": [["+" if t < kept else "-", flags[t]] + ([] if t < kept else ways.get(t, ["out", 0, 1]))
                  for t in range(len(simplices))],
    }


def plane_domain(claim, kind, points, simplices, kept, corners, chains, holes=()):
    """A domain in the plane: the walls are the links of the segments."""
    mesh = certificate("delaunay" if claim == "conforming-delaunay" else "triangulation",
                       points, simplices)
    walls = {frozenset(e): (k + 1, 1) for k, c in enumerate(chains) for e in zip(c, c[1:])}
    return {"claim": claim, "kind": kind, "mesh": mesh,
            "part": part(mesh, kept, corners, chains, walls if kind == "enclosed" else {}, holes)}


def triangle_polygon(mesh, points, triangle, kept):
    """The polygon with these corners, which is one facet of the mesh."""
    a, b, c = (points[v] for v in triangle)
    u, v = ([x - y for x, y in zip(p, a)] for p in (b, c))
    normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
    axis = next(i for i in range(3) if normal[i])
    flat_points = [[x for i, x in enumerate(points[p]) if i != axis] for p in triangle]
    plane = certificate("triangulation", [tuple(p) for p in flat_points], [(0, 1, 2)])
    chains = [(0, 1), (1, 2), (0, 2)]
    walls = {frozenset(e): (i + 1, 1) for i, e in enumerate(chains)}
    number = {row[4]: n + 1 for n, row in enumerate(mesh["points"])}
    wanted = {number[p] for p in triangle}
    tile = next([t + 1, i] for t in range(kept) for i in range(4)
                if set(mesh["simplices"][t][0]) - {mesh["simplices"][t][0][i]} == wanted)
    return {"plane": normal + [sum(x * y for x, y in zip(normal, a)), axis], "mesh": plane,
            "part": part(plane, 1, {0, 1, 2}, chains, walls),
            "above": [[number[triangle[row[4]]]] for row in plane["points"]],
            "tiles": [tile], "seeds": []}


def space_domain(claim, kind, points, simplices, kept, triangles, chains):
    """A domain in space with triangles for polygons."""
    mesh = certificate("delaunay" if claim == "conforming-delaunay" else "triangulation",
                       points, simplices)
    walls = {frozenset(f): (k + 1, 1) for k, f in enumerate(triangles)}
    corners = {v for f in triangles for v in f}
    return {"claim": claim, "kind": kind, "mesh": mesh,
            "part": part(mesh, kept, corners, chains, walls if kind == "enclosed" else {}),
            "polygons": [triangle_polygon(mesh, points, f, kept) for f in triangles]}


# A square with a notch below and a square hole, one of its vertices on the outline.
NOTCHED = [(0, 0), (4, 2), (8, 0), (8, 8), (0, 8), (3, 4), (5, 4), (4, 6), (4, 8)]
NOTCHED_MESH = [(0, 1, 5), (1, 6, 5), (1, 2, 6), (2, 3, 6), (3, 7, 6), (3, 8, 7), (8, 4, 7), (4, 5, 7),
                (4, 0, 5)]
NOTCH_AND_HOLE = [(0, 2, 1), (5, 6, 7)]
NOTCHED_SEGMENTS = [(0, 1), (1, 2), (2, 3), (3, 8, 4), (0, 4), (5, 6), (6, 7), (5, 7)]
DENTED = [(8, 0, 0), (0, 8, 0), (0, 0, 8), (2, 2, 2), (0, 0, 0)]
DENTED_MESH = [(4, 0, 1, 3), (4, 0, 2, 3), (4, 1, 2, 3), (0, 1, 2, 3)]
DENTED_TRIANGLES = [(4, 0, 1), (4, 0, 2), (4, 1, 2), (0, 1, 3), (0, 2, 3), (1, 2, 3)]
DENTED_SEGMENTS = [(4, 0), (4, 1), (4, 2), (0, 1), (0, 2), (1, 2), (0, 3), (1, 3), (2, 3)]


def domains(mutant, put, square_points, square_mesh):
    """Domains in the plane and in space, of which the mesh is right, and what may be wrong with it."""
    def notched(claim="steiner-triangulation", kind="enclosed"):
        return plane_domain(claim, kind, NOTCHED, NOTCHED_MESH + NOTCH_AND_HOLE, 9,
                            {0, 1, 2, 3, 4, 5, 6, 7}, NOTCHED_SEGMENTS, [(11, [8, 9], 2)])
    sound = notched()
    yield "sound--domain-in-the-plane", sound, \
        "verified: steiner-triangulation, 9 points, 9 triangles; domain: enclosed, 8 vertices, " \
        "8 segments, 1 hole"
    dented = space_domain("plc-triangulation", "enclosed", DENTED, DENTED_MESH, 3, DENTED_TRIANGLES,
                          DENTED_SEGMENTS)
    yield "sound--domain-in-space", dented, \
        "verified: plc-triangulation, 5 points, 3 tetrahedra; domain: enclosed, 5 vertices, " \
        "9 segments, 6 polygons"
    square = plane_domain("conforming-delaunay", "enclosed", square_points, square_mesh, 4, {0, 1, 2, 3},
                          [(0, 1), (1, 2), (2, 3), (0, 3)])
    yield "sound--conforming-delaunay", square, "verified: conforming-delaunay, 5 points, 4 triangles"
    flipped = plane_domain("conforming-delaunay", "enclosed", [(0, 0), (6, 0), (7, 2), (0, 2)],
                           [(0, 1, 2), (0, 2, 3)], 2, {0, 1, 2, 3}, [(0, 1), (1, 2), (2, 3), (0, 3)])
    yield "facet-locally-delaunay--of-a-domain", flipped, "rejected: facet-locally-delaunay"
    yield "sound--cdt-of-a-domain", notched("steiner-cdt"), "verified: steiner-cdt, 9 points, 9 triangles"
    long = [(0, 0), (8, 0), (9, 2), (0, 2), (4, 9)]
    for name, inner, answer in ("wall", [(0, 2)], "verified: cdt"), \
            ("no-wall", [], "rejected: facet-locally-delaunay, simplex 1"):
        yield "facet-locally-delaunay--where-there-is-%s" % name, plane_domain(
            "cdt", "enclosed", long, [(0, 1, 2), (0, 2, 3), (3, 2, 4)], 3, {0, 1, 2, 3, 4},
            [(0, 1), (1, 2), (2, 4), (3, 4), (0, 3)] + inner), answer
    hull = plane_domain("steiner-triangulation", "hull", square_points, square_mesh, 4, {0, 1, 2, 3}, [])
    middle = next(k for k, row in enumerate(hull["mesh"]["points"]) if row[4] == 4)
    number = {row[4]: k + 1 for k, row in enumerate(hull["mesh"]["points"])}
    hull["part"]["roles"][middle] = ["-", 3, number[0], 3, number[1], 1, number[2], 1, number[3]]
    yield "sound--domain-hull", hull, \
        "verified: steiner-triangulation, 5 points, 4 triangles; domain: hull, 4 vertices"
    yield mutant(hull, put("part", "roles", middle, ["-", 3, number[0], 3, number[1], 1, number[2], 2,
                                                     number[3]]),
                 "role-shown, point %d" % (middle + 1), "role-shown--not-that-combination")
    yield mutant(sound, put("part", "roles", 0, [4]), "role-shown, point 1")
    yield mutant(sound, put("part", "segments", 3, 1, 1, 9), "segment-linked, segment 4")
    around = copy.deepcopy(sound)
    around["part"]["segments"][0] = around["part"]["segments"][0][:1] + \
        around["part"]["segments"][4][1:] + [[around["part"]["segments"][0][1][0], 1, 0]]
    yield "segment-linked--not-straight", around, "rejected: segment-linked, segment 1"
    yield mutant(sound, put("part", "holes", 0, 1, [8, 13]), "hole-inside, hole 1")
    yield mutant(sound, put("part", "holes", 0, 1, [8, 8]), "hole-inside, hole 1", "hole-inside--on-a-wall")
    open_wall = copy.deepcopy(dented)
    i = next(i for i, f in enumerate(open_wall["part"]["marks"][0][1]) if f != "-")
    open_wall["part"]["marks"][0][1][i] = "-"
    yield "mark-consistent", open_wall, "rejected: mark-consistent, simplex 1, facet %d" % i
    kept = copy.deepcopy(dented)
    kept["part"]["marks"][3] = ["+", kept["part"]["marks"][3][1]]
    yield "mark-consistent--kept-outside", kept, "rejected: mark-consistent, simplex 4"
    yield mutant(sound, put("part", "marks", 9, ["-", sound["part"]["marks"][9][1], "out",
                 next(i for i, f in enumerate(sound["part"]["marks"][9][1]) if f != "-"), 1]),
                 "way-out-shown, simplex 10")
    other = copy.deepcopy(sound)
    t, i = next((t, i) for t, mark in enumerate(other["part"]["marks"]) for i, f in enumerate(mark[1])
                if f != "-")
    other["part"]["marks"][t][1][i] = [other["part"]["marks"][t][1][i][0] % 8 + 1, 1]
    yield "wall-shown", other, "rejected: wall-shown, simplex %d, facet %d" % (t + 1, i)
    yield "vertices-of-domain", dict(sound, claim="plc-triangulation"), "rejected: vertices-of-domain"
    yield mutant(dented, put("polygons", 0, "plane", 3, dented["polygons"][0]["plane"][3] + 1),
                 "polygon-flat, polygon 1")
    yield mutant(dented, put("polygons", 3, "tiles", 0, dented["polygons"][4]["tiles"][0]),
                 "polygon-tiled, polygon 4")
