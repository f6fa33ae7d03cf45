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
    lines.insert(0, "circumspect-certificate 1 %s %d %s%s" % (
        c["claim"], c["mesh"]["d"], c["kind"],
        " plc" if "complex" in c else " dangling" if "dangling" in c else "") + (" delaunay" if "delaunay" in c else ""))
    lines += part_text(c["part"])
    if c["mesh"]["d"] == 3:
        lines.append("polygons %d" % len(c["polygons"]))
        for f in c["polygons"]:
            lines += polygon_text(f)
    if "complex" in c:
        lines += complex_text(c["complex"])
    return "\n".join(lines + ["end"]) + "\n"


def complex_text(x):
    def section(name, rows):
        return ["%s %d" % (name, len(rows))] + [" ".join(map(str, flat(row))) for row in rows]
    lines = section("faces", [row or ["-"] for row in x["faces"]]) + section("sides", x["sides"])
    for f in x["polygons"]:
        lines += section("rim", f["rim"]) + section("inside", f["inside"])
    return lines


def complex_of(c):
    """What shows that the domain is a piecewise linear complex; that it is one is not looked at."""
    def steps(segment):
        numbers = [segment[0]] + [link[0] for link in segment[1:]]
        return list(zip(numbers, numbers[1:]))

    def exposed(mesh, p, t, i):
        wall = mesh["simplices"][t - 1][1][i]
        return wall[0] == "-" or p["marks"][wall[0] - 1][0] == "-"

    def sides(mesh, p, facets):
        return "one" if exposed(mesh, p, *facets[0]) else "both"

    segments = c["part"]["segments"]
    corners = {k + 1 for k, role in enumerate(c["part"]["roles"]) if role[0] != "-"}
    holders = {}
    for k, segment in enumerate(segments):
        for u, v in steps(segment):
            holders.setdefault(frozenset([u, v]), ["segment", k + 1])
            if v not in corners:
                holders.setdefault(frozenset([v]), ["segment", k + 1])
    polygons = []
    for k, f in enumerate(c.get("polygons", [])):
        pieces = [frozenset(f["above"][v - 1][0] for v in row[0]) for row in f["mesh"]["simplices"]]
        inside = set()
        for piece in pieces[:len(f["tiles"])]:
            for bits in range(1, 8):
                face = frozenset(v for i, v in enumerate(sorted(piece)) if bits >> i & 1)
                if not (len(face) == 1 and face <= corners):
                    holder = holders.setdefault(face, ["polygon", k + 1])
                    if holder[0] == "segment":
                        inside.add(holder[1])
        rim = []
        for segment in f["part"]["segments"]:
            ends = {f["above"][segment[0] - 1][0], f["above"][segment[-1][0] - 1][0]}
            number = next((j + 1 for j, s in enumerate(segments) if {s[0], s[-1][0]} == ends), 1)
            rim.append([number, sides(f["mesh"], f["part"], [link[1:] for link in segment[1:]])])
        polygons.append({"rim": rim, "inside": [
            [j] + [next(t + 1 for t, piece in enumerate(pieces) if {u, v} <= piece)
                   for u, v in steps(segments[j - 1])] for j in sorted(inside)]})
    if c["mesh"]["d"] == 2:
        walls = [[link[1:] for link in segment[1:]] for segment in segments]
    else:
        walls = [f["tiles"] for f in c["polygons"]]
    faces = [[] for _ in c["mesh"]["points"]]
    for face, holder in holders.items():
        least, *others = sorted(face)
        faces[least - 1].append(holder + [len(others)] + others)
    return {"faces": [sorted(row) for row in faces], "polygons": polygons,
            "sides": [[sides(c["mesh"], c["part"], facets)] for facets in walls] if c["kind"] == "enclosed" else []}


def with_complex(c):
    return dict(copy.deepcopy(c), complex=complex_of(c))


def part(mesh, kept, corners, chains, walls, holes=(), weights=None):
    """What a certificate about a domain says beside its mesh. `kept` are the first simplices of the
    mesh; `corners` and `chains` name points by their labels; `walls` says which facets, by their
    labels, are in which wall; `holes` are simplices with a point and a denominator."""
    d = mesh["d"]
    label = [row[4] for row in mesh["points"]]
    number = {v: k + 1 for k, v in enumerate(label)}
    simplices = [row[0] for row in mesh["simplices"]]

    def with_vertices(vs):
        return next((t for t in range(len(simplices)) if set(vs) <= set(simplices[t])), 0)

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
            "part": part(mesh, kept, corners, chains, walls if kind == "enclosed" or claim.endswith("cdt") else {}, holes)}


def triangle_polygon(mesh, points, triangle):
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
    tile = next([t + 1, i] for t in range(len(mesh["simplices"])) for i in range(4)
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
            "polygons": [triangle_polygon(mesh, points, f) for f in triangles]}


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


# A triangle with a whip, and a tetrahedron with a fin, which is on the hull.
WHIP = [(0, 0), (4, 0), (0, 4), (6, 6), (5, 3)]
WHIP_MESH = [(0, 1, 2), (1, 4, 2), (4, 3, 2)]
WHIP_SEGMENTS = [(0, 1), (1, 2), (0, 2), (1, 4, 3)]
FIN = [(0, 0, 0), (8, 0, 0), (0, 8, 0), (0, 0, 8), (9, 9, 9)]
FIN_TRIANGLES = [(0, 1, 2), (0, 1, 3), (0, 2, 3), (1, 2, 3), (1, 2, 4)]
FIN_SEGMENTS = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3), (1, 4), (2, 4)]


def where_something_dangles():
    """Domains with a segment or a polygon that is in no kept simplex."""
    def whip(claim, corners):
        return dict(plane_domain(claim, "enclosed", WHIP, WHIP_MESH, 1, corners, WHIP_SEGMENTS), dangling=True)
    steiner, of_corners = whip("steiner-triangulation", {0, 1, 2, 3}), whip("cdt", {0, 1, 2, 3, 4})
    yield "sound--whip", steiner, "verified: steiner-triangulation, 5 points, 1 triangle; 2 dangling faces; domain: enclosed, 4 vertices, 4 segments"
    yield "sound--whip--cdt", of_corners, "verified: cdt, 5 points, 1 triangle; 2 dangling faces; domain: enclosed, 5 vertices, 4 segments"
    yield "vertices-of-domain--whip", dict(steiner, claim="cdt"), "rejected: vertices-of-domain, segment 4"
    solid = {name: value for name, value in steiner.items() if name != "dangling"}
    yield "role-shown--whip", solid, "rejected: role-shown, point 5"
    yield "mark-consistent--whip--hull", dict(steiner, kind="hull"), "rejected: mark-consistent"
    bare = copy.deepcopy(steiner)
    bare["part"]["marks"][1][1] = ["-"] * 3
    yield "segment-linked--whip--no-wall", bare, "rejected: segment-linked, segment"
    crooked = copy.deepcopy(steiner)
    crooked["part"]["marks"][2][1] = [[1, 1] if flag == "-" else flag for flag in crooked["part"]["marks"][2][1]]
    yield "mark-consistent--whip--on-one-side", crooked, "rejected: mark-consistent, simplex 2, facet 0"
    fin = dict(space_domain("steiner-triangulation", "enclosed", FIN, [(0, 1, 2, 3), (1, 2, 3, 4)], 1, FIN_TRIANGLES, FIN_SEGMENTS),
               dangling=True)
    yield "sound--fin", fin, \
        "verified: steiner-triangulation, 5 points, 1 tetrahedron; 1 dangling face; domain: enclosed, 5 vertices, 8 segments, 5 polygons"
    yield "polygon-tiled--fin--a-triangle-of-a-cdt", dict(fin, claim="steiner-cdt"), "rejected: polygon-tiled, polygon 5"
    # But where all of the mesh is Delaunay, so is the triangle.
    shown = dict(fin, claim="steiner-cdt", delaunay=True)
    yield "sound--fin--cdt", shown, \
        "verified: steiner-cdt, 5 points, 1 tetrahedron; 1 dangling face; domain: enclosed, 5 vertices, 8 segments, 5 polygons"
    near = dict(space_domain("steiner-cdt", "enclosed", [*FIN[:4], (3, 3, 3)], [(0, 1, 2, 3), (1, 2, 3, 4)], 1, FIN_TRIANGLES, FIN_SEGMENTS),
                dangling=True, delaunay=True)
    yield "facet-locally-delaunay--fin--cdt", near, "rejected: facet-locally-delaunay"
    elsewhere = copy.deepcopy(fin)
    elsewhere["polygons"][4]["tiles"] = elsewhere["polygons"][3]["tiles"]
    yield "polygon-tiled--fin--elsewhere", elsewhere, "rejected: polygon-tiled, polygon 5"


def domains(mutant, put, square_points, square_mesh):
    """Domains in the plane and in space with right meshes, and what may be wrong with these."""
    def notched(claim="steiner-triangulation", kind="enclosed"):
        return plane_domain(claim, kind, NOTCHED, NOTCHED_MESH + NOTCH_AND_HOLE, 9,
                            {0, 1, 2, 3, 4, 5, 6, 7}, NOTCHED_SEGMENTS, [(11, [8, 9], 2)])
    yield from where_something_dangles()
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
    for name, inner, answer in ("wall", [(0, 2)], "verified: cdt"), \
            ("no-wall", [], "rejected: facet-locally-delaunay, simplex 1"):
        walled = plane_domain("cdt", "hull", long, [(0, 1, 2), (0, 2, 3), (3, 2, 4)], 3, {0, 1, 2, 3, 4}, inner)
        yield "facet-locally-delaunay--of-a-hull--where-there-is-%s" % name, walled, answer
        if inner:
            t, i = next((t, i) for t, mark in enumerate(walled["part"]["marks"]) for i, f in enumerate(mark[1]) if f != "-")
            yield mutant(walled, put("part", "segments", []), "wall-shown, simplex 1, facet %d" % i, "wall-shown--of-a-hull--no-segment")
            yield mutant(walled, put("part", "marks", t, 1, (i + 1) % 3, walled["part"]["marks"][t][1][i]),
                         "wall-shown, simplex 1, facet %d" % ((i + 1) % 3), "wall-shown--of-a-hull--another-facet")
            other = copy.deepcopy(walled)
            other["part"]["marks"][t][1][i] = "-"
            yield "facet-locally-delaunay--of-a-hull--flag-on-the-other-side", other, "rejected: facet-locally-delaunay, simplex 1"
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
    yield from complexes(mutant, put, sound, dented, hull)


def complexes(mutant, put, sound, dented, hull):
    """The same domains, said to be piecewise linear complexes."""
    plane = with_complex(sound)
    yield "sound--complex-in-the-plane", plane, \
        "verified: steiner-triangulation, 9 points, 9 triangles; domain: enclosed, plc, 8 vertices, 8 segments, 1 hole"
    space = with_complex(dented)
    yield "sound--complex-in-space", space, \
        "verified: plc-triangulation, 5 points, 3 tetrahedra; domain: enclosed, plc, 5 vertices, 9 segments, 6 polygons"
    yield "sound--complex-of-a-hull", with_complex(hull), \
        "verified: steiner-triangulation, 5 points, 4 triangles; domain: hull, plc, 4 vertices"
    # The vertex (4, 8), which was not a vertex of the domain, is one: inside a segment.
    inside = plane_domain("steiner-triangulation", "enclosed", NOTCHED, NOTCHED_MESH + NOTCH_AND_HOLE, 9,
                          set(range(9)), NOTCHED_SEGMENTS, [(11, [8, 9], 2)])
    yield "face-held--vertex-in-a-segment", with_complex(inside), "rejected: face-held, segment 4"
    # A segment lies on another: (3, 8) on (3, 4), whose other step is (8, 4).
    lying = plane_domain("steiner-triangulation", "enclosed", NOTCHED, NOTCHED_MESH + NOTCH_AND_HOLE, 9,
                         set(range(9)), NOTCHED_SEGMENTS + [(3, 8)], [(11, [8, 9], 2)])
    yield "face-held--segments-overlap", with_complex(lying), "rejected: face-held, segment 4"
    held = next(k for k, row in enumerate(plane["complex"]["faces"]) if row)
    yield mutant(plane, put("complex", "faces", held, 0, 1, 9), "face-held, segment 1")
    yield mutant(plane, put("complex", "faces", held, []), "face-held, segment 1", "face-held--by-nothing")
    yield mutant(plane, put("complex", "sides", 0, ["both"]), "one-sided-shown, simplex")
    yield mutant(plane, put("complex", "sides", []), "one-sided-shown, simplex", "one-sided-shown--not-at-all")
    # A polygon twice.
    twice = space_domain("plc-triangulation", "enclosed", DENTED, DENTED_MESH, 3,
                         DENTED_TRIANGLES, DENTED_SEGMENTS)
    twice["polygons"].append(copy.deepcopy(twice["polygons"][0]))
    yield "face-held--polygon-twice", with_complex(twice), "rejected: face-held, polygon 7"
    # Edges of a polygon that are not segments of the domain.
    bare = space_domain("plc-triangulation", "enclosed", DENTED, DENTED_MESH, 3, DENTED_TRIANGLES,
                        DENTED_SEGMENTS[1:])
    yield "rim-listed--no-segment", with_complex(bare), "rejected: rim-listed, polygon 1"
    yield mutant(space, put("complex", "polygons", 0, "rim", 0, 0, space["complex"]["polygons"][0]["rim"][1][0]),
                 "rim-listed, polygon 1")
    yield mutant(space, put("complex", "polygons", 2, "inside", 0, 1, 2), "segment-in-polygon, polygon 3")
    yield mutant(space, put("complex", "polygons", 2, "inside", 0, 0, 1), "segment-in-polygon, polygon 3",
                 "segment-in-polygon--another")
    yield mutant(space, put("complex", "polygons", 2, "inside", []), "face-held, polygon 3",
                 "face-held--by-a-segment-elsewhere")
    yield mutant(space, put("complex", "sides", 5, ["both"]), "one-sided-shown, simplex",
                 "one-sided-shown--of-a-polygon")
    yield mutant(space, put("complex", "polygons", 1, "rim", 0, 1, "both"), "one-sided-shown, polygon 2",
                 "one-sided-shown--of-a-rim")
