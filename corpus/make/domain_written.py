"""Small surfaces as programs write them, and meshes of them that lack or have what programs leave out or add: coplanar
triangles that are one polygon to the mesher, hollows, what dangles, labels of cells, rounded coordinates.

They stand in corpus/domains/written/, with the command lines and verdicts in written.tsv: the arguments of
`circumspect check`, the verdict (`holds`, the rules that are broken, or `input`), and what is shown. Rows that somebody wrote
there by hand, of surfaces that are not made here, stay as they are.
"""
import itertools

from files import CORPUS, number, write_ele, write_node

FOLDER = CORPUS / "domains" / "written"
ROWS = []


def row(arguments, verdict, what):
    ROWS.append((arguments, verdict, what))


# Meshes: cells of a grid, each cut into six tetrahedra around its diagonal (H. Kuhn), which is
# Delaunay.

def grid(ticks, inside):
    """Points and tetrahedra of the cells (x, y, z) for which inside(x, y, z) holds; `ticks` along each axis."""
    points, number_of, cells = [], {}, []

    def vertex(at):
        if at not in number_of:
            number_of[at] = len(points)
            points.append(tuple(ticks[a][i] for a, i in enumerate(at)))
        return number_of[at]

    for cell in itertools.product(*(range(len(t) - 1) for t in reversed(ticks))):
        cell = cell[::-1]
        if not inside(*cell):
            continue
        for axes in itertools.permutations(range(len(ticks))):
            at, simplex = list(cell), [vertex(cell)]
            for axis in axes:
                at[axis] += 1
                simplex.append(vertex(tuple(at)))
            cells.append(simplex)
    return points, cells


def everything(*_):
    return True


def write_mesh(name, points, cells, faces=None):
    dimension = len(points[0])
    write_node(FOLDER / f"{name}.node", points, dimension)
    write_ele(FOLDER / f"{name}.ele", cells, dimension + 1)
    if faces:
        lines = [f"{len(faces)} 0"] + [" ".join(str(x) for x in (i + 1, *(v + 1 for v in f))) for i, f in enumerate(faces)]
        (FOLDER / f"{name}.face").write_text("\n".join(lines) + "\n")


def write_medit(name, points, cells, labels):
    lines = ["MeshVersionFormatted 2", "Dimension 3", f"Vertices {len(points)}"]
    lines += [" ".join(map(number, p)) + " 0" for p in points]
    lines += [f"Tetrahedra {len(cells)}"]
    lines += [" ".join(str(v + 1) for v in t) + f" {label}" for t, label in zip(cells, labels)]
    (FOLDER / f"{name}.mesh").write_text("\n".join([*lines, "End"]) + "\n")


def write_gmsh(name, points, cells, groups):
    """Version 4.1 in text: a volume for each physical group, coordinates of 16 digits as Gmsh writes them."""
    volumes = sorted(set(groups))
    lines = ["$MeshFormat", "4.1 0 8", "$EndMeshFormat", "$Entities", f"0 0 0 {len(volumes)}"]
    lines += [f"{i + 1} 0 0 0 1 1 1 1 {group} 0" for i, group in enumerate(volumes)]
    lines += ["$EndEntities", "$Nodes", f"1 {len(points)} 1 {len(points)}", f"3 1 0 {len(points)}"]
    lines += [str(i + 1) for i in range(len(points))] + [" ".join(f"{x:.16g}" for x in p) for p in points]
    lines += ["$EndNodes", "$Elements", f"{len(volumes)} {len(cells)} 1 {len(cells)}"]
    tag = 0
    for i, group in enumerate(volumes):
        own = [t for t, g in zip(cells, groups) if g == group]
        lines.append(f"3 {i + 1} 4 {len(own)}")
        for t in own:
            tag += 1
            lines.append(" ".join(str(x) for x in (tag, *(v + 1 for v in t))))
    (FOLDER / f"{name}.msh").write_text("\n".join([*lines, "$EndElements"]) + "\n")


def box(low, high):
    return [(x, y, z) for z in (low, high) for y in (low, high) for x in (low, high)]


# Counterclockwise seen from outside.
SQUARES = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]


def in_triangles(squares):
    """Cut across the diagonals that the tetrahedra of a grid have not: those through neither 0 nor 7."""
    triangles = []
    for s in squares:
        i = next(i for i in range(4) if s[i] % 8 in (0, 7))
        s = s[i:] + s[:i]
        triangles += [(s[0], s[1], s[3]), (s[1], s[2], s[3])]
    return triangles


def shifted(faces, by, inward=False):
    return [tuple(v + by for v in (reversed(f) if inward else f)) for f in faces]


def write_off(name, points, faces):
    lines = ["OFF", f"{len(points)} {len(faces)} 0", *(" ".join(map(number, p)) for p in points)]
    (FOLDER / f"{name}.off").write_text("\n".join([*lines, *(" ".join(map(str, (len(f), *f))) for f in faces)]) + "\n")


def write_poly(name, points, facets, segments=()):
    """Each facet one polygon; segments are facets of two corners."""
    lines = [f"{len(points)} 3 0 0", *(f"{i + 1} " + " ".join(map(number, p)) for i, p in enumerate(points))]
    lines += [f"{len(facets) + len(segments)} 0"]
    for f in [*facets, *segments]:
        lines += ["1", " ".join(str(x) for x in (len(f), *(v + 1 for v in f)))]
    (FOLDER / f"{name}.poly").write_text("\n".join([*lines, "0"]) + "\n")


def cell_faces(inside, size):
    """The outside of some cells of a grid: squares by their corners, counterclockwise seen from outside."""
    for cell in itertools.product(range(size), repeat=3):
        if not inside(*cell):
            continue
        for axis in range(3):
            for side in (0, 1):
                beside = list(cell)
                beside[axis] += 2 * side - 1
                if all(0 <= b < size for b in beside) and inside(*beside):
                    continue
                a, b = [(1, 2), (2, 0), (0, 1)][axis]
                square = []
                for u, v in [(0, 0), (1, 0), (1, 1), (0, 1)]:
                    corner = list(cell)
                    corner[axis] += side
                    corner[a] += u
                    corner[b] += v
                    square.append(tuple(corner))
                yield square if side else square[::-1]


NINE = [(0, 9)] * 3
THREE = [(0, 3, 6, 9)] * 3


def merged():
    points, cells = grid(NINE, everything)
    write_mesh("cube", points, cells)
    write_off("cube-in-triangles", box(0, 9), in_triangles(SQUARES))
    cube = "written/cube.ele --domain written/cube-in-triangles.off"
    row(cube, "domain.segment-missing", "a cube of twelve triangles, and a mesh with the other diagonals, as tetgen -p makes it")
    row(f"{cube} --merge-coplanar", "holds", "the same for the cube of six squares")
    row(f"{cube} --merge-coplanar --claim cdt --within 0", "holds", "the same within 0")
    points, cells = grid(THREE, everything)
    inner = next(i for i, t in enumerate(cells) if all(0 < x < 9 for v in t for x in points[v]))
    write_mesh("cube-with-gap", points, cells[:inner] + cells[inner + 1:])
    row("written/cube-with-gap.ele --domain written/cube-in-triangles.off --merge-coplanar",
        "domain.uncovered", "joining polygons hides nothing: a tetrahedron is missing")
    write_poly("cube-with-seam", box(0, 9), in_triangles(SQUARES), [(1, 2)])
    row("written/cube.ele --domain written/cube-with-seam.poly --merge-coplanar", "domain.segment-missing",
        "a diagonal that is listed as a segment is one")

    ring = lambda x, y, z: (x, y) != (1, 1)
    points, cells = grid([(0, 3, 6, 9), (0, 3, 6, 9), (0, 3)], ring)
    write_mesh("ring", points, cells)
    corners, faces = [], []
    place = lambda p: corners.index(p) if p in corners else corners.append(p) or len(corners) - 1
    for square in cell_faces(lambda x, y, z: ring(x, y, z) and z == 0, 3):
        a, b, c, d = (place(tuple(3 * x for x in p)) for p in square)
        faces += [(a, b, c), (a, c, d)]
    write_off("ring-in-triangles", corners, faces)
    row("written/ring.ele --domain written/ring-in-triangles.off --merge-coplanar", "holds",
        "a frame whose floor and ceiling become polygons with holes; the vertices between stay")
    filled, more = grid([(0, 3, 6, 9), (0, 3, 6, 9), (0, 3)], everything)
    write_mesh("ring-filled", filled, more)
    row("written/ring-filled.ele --domain written/ring-in-triangles.off --merge-coplanar", "domain.outside",
        "the hole of the joined polygons is one: here it is meshed")


def solid():
    hollow = lambda *cell: cell != (1, 1, 1)
    write_mesh("hollow", *grid(THREE, hollow))
    write_mesh("solid", *grid(THREE, everything))
    both = box(0, 9) + box(3, 6)
    write_off("cube-in-cube", both, SQUARES + shifted(SQUARES, 8, True))
    write_off("cube-in-cube-turned-alike", both, SQUARES + shifted(SQUARES, 8))
    hollow, alike = "written/hollow.ele --domain written/cube-in-cube.off", "written/hollow.ele --domain written/cube-in-cube-turned-alike.off"
    row(hollow, "domain.uncovered", "a cube in a cube encloses the inner one as well")
    row(f"{hollow} --fill even-odd", "holds", "what is entered by an odd number of walls")
    row(f"{hollow} --fill winding", "holds", "the inner cube is turned inward")
    row(f"{hollow} --hole 4,4,4", "holds", "a point in the hollow")
    row(f"{hollow} --region 1,1,1", "holds", "a point in what is filled")
    row(f"{hollow} --region 4,4,4", "domain.outside,domain.uncovered", "a point in the hollow, for what is filled")
    row(f"{hollow} --hole 20,0,0", "domain.uncovered", "a hole in nothing enclosed is ignored, with a note")
    row(f"{hollow} --hole 3,4,4", "input", "a hole on a wall is the input's fault")
    row(f"{hollow} --region 20,0,0", "input", "a region of nothing enclosed is the input's fault")
    row(f"{alike} --fill even-odd", "holds", "how faces are turned does not matter to even-odd")
    row(f"{alike} --fill winding", "domain.uncovered", "both cubes are turned outward: the inner one is filled as well")
    row("written/solid.ele --domain written/cube-in-cube.off", "holds", "filled, with a wall inside")
    row("written/solid.ele --domain written/cube-in-cube.off --fill even-odd", "domain.outside", "the hollow is meshed")
    squares = box(0, 9)[:4] + box(3, 6)[:4]
    flat = [(x, y) for x, y, _ in squares]
    write_mesh("plane-frame", *grid(THREE[:2], lambda *cell: cell != (1, 1)))
    lines = ["8 2 0 0", *(f"{i + 1} {x} {y}" for i, (x, y) in enumerate(flat)), "8 0"]
    edges = [(1, 2), (2, 4), (4, 3), (3, 1), (5, 6), (6, 8), (8, 7), (7, 5)]
    lines += [f"{i + 1} {a} {b}" for i, (a, b) in enumerate(edges)]
    (FOLDER / "plane-squares.poly").write_text("\n".join([*lines, "0"]) + "\n")
    plane = "written/plane-frame.ele --domain written/plane-squares.poly"
    row(plane, "domain.uncovered", "in the plane: a square in a square encloses the inner one as well")
    row(f"{plane} --fill even-odd", "holds", "what is entered by an odd number of segments")
    row(f"{plane} --fill winding", "domain.uncovered", "both squares are listed counterclockwise")
    row(f"{plane} --hole 4,4", "holds", "a point in the hole of the plane")


def dangling():
    points, cells = grid(NINE, everything)
    fin = box(0, 9) + [(12, 0, 0), (12, 0, 9)]
    squares = SQUARES + [(1, 8, 9, 5)]
    write_poly("cube-with-fin", fin, squares)
    write_mesh("cube-with-fin", points + [(12, 0, 0), (12, 0, 9)], cells,
               [(points.index((9, 0, 0)), 8, 9), (points.index((9, 0, 0)), 9, points.index((9, 0, 9)))])
    row("written/cube.ele --domain written/cube-with-fin.poly", "domain.vertex-missing",
        "a polygon that bounds nothing, which a program left out: a note names it")
    row("written/cube-with-fin.ele --domain written/cube-with-fin.poly", "holds", "its triangles are in the .face file")


def labelled():
    ell = lambda x, y, z: (x, y) != (1, 1)
    points, cells = grid([(0, 4, 8), (0, 4, 8), (0, 4)], everything)
    inside = lambda t: not all(points[v][0] >= 4 and points[v][1] >= 4 for v in t)
    labels = [int(inside(t)) for t in cells]
    corners = [(0, 0), (8, 0), (8, 4), (4, 4), (4, 8), (0, 8)]
    prism = [(*p, z) for z in (0, 4) for p in corners]
    walls = [tuple(reversed(range(6))), tuple(range(6, 12)), *((i, (i + 1) % 6, (i + 1) % 6 + 6, i + 6) for i in range(6))]
    write_poly("ell", prism, walls)
    write_medit("ell-in-hull", points, cells, labels)
    ell = "written/ell-in-hull.mesh --domain written/ell.poly"
    row(ell, "domain.outside", "a mesh of the convex hull, as CGAL writes it, with label 0 outside the domain")
    row(f"{ell} --keep-label 1", "holds", "the cells with label 1")
    row(f"{ell} --keep-label 7", "input", "a label that no cell has")
    row(f"{ell} --keep-label 0 --keep-label 1", "domain.outside", "both labels")
    write_gmsh("ell-in-groups", points, cells, [10 * label + 10 for label in labels])
    ell = "written/ell-in-groups.msh --domain written/ell.poly"
    row(ell, "domain.outside", "the same in the physical groups of a .msh of version 4.1")
    row(f"{ell} --keep-label 20", "holds", "the group of the domain")
    row("written/cube.ele --domain written/cube-in-triangles.off --keep-label 1", "input", "cells without labels")


def write_rooms(name, regions):
    """Two rooms of the plane, 4 by 8, and what bounds the triangles in each: rows "x y attribute [bound]"."""
    points = [(0, 0), (4, 0), (8, 0), (0, 8), (4, 8), (8, 8)]
    edges = [(1, 2), (2, 3), (4, 5), (5, 6), (1, 4), (2, 5), (3, 6)]
    lines = [f"{len(points)} 2 0 0", *(f"{i + 1} {x} {y}" for i, (x, y) in enumerate(points)), f"{len(edges)} 0"]
    lines += [f"{i + 1} {a} {b}" for i, (a, b) in enumerate(edges)]
    lines += ["0", str(len(regions)), *(f"{i + 1} {region}" for i, region in enumerate(regions))]
    (FOLDER / f"{name}.poly").write_text("\n".join(lines) + "\n")


def bounded():
    write_mesh("rooms", *grid([(0, 2, 4, 8), (0, 4, 8)], everything))  # triangles of 4 on the left, of 8 on the right
    for name, regions, verdict, what in [
            ("rooms", ["1 1 10 4", "5 1 20 8"], "holds", "each triangle is as large as its region allows"),
            ("rooms-left-finer", ["1 1 10 3.5", "5 1 20 8"], "quality.area", "the triangles on the left are too large"),
            ("rooms-right-finer", ["5 1 20 7.5"], "quality.area", "the triangles on the right are too large"),
            ("rooms-attribute", ["1 1 3.5"], "quality.area", "a region without a bound has its attribute for one"),
            ("rooms-unbounded", ["1 1 10 4", "5 1 20 -1"], "holds", "a bound that is not positive bounds nothing"),
            ("rooms-on-wall", ["4 1 10 4"], "exit code 2", "a point on a segment is in no region"),
            ("rooms-two-bounds", ["1 1 10 4", "2 1 20 5"], "exit code 2", "two bounds for one region"),
            ("rooms-none", [], "exit code 2", "no region has a bound")]:
        write_rooms(name, regions)
        row(f"written/rooms.ele --domain written/{name}.poly --require area:regions", verdict, what)
    rooms = "written/rooms.ele --domain written/rooms.poly"
    row(f"{rooms} --require area:regions --require area:7", "quality.area", "a bound for all beside those of the regions")
    row(f"{rooms} --require volume:regions", "exit code 2", "triangles have no volume")
    row(f"{rooms} --require area:regions --within 1e-9", "exit code 2", "a moved domain has no exact regions")
    row("written/rooms.ele --require area:regions", "exit code 2", "without a domain there are no regions")
    points, cells = grid([(0, 3, 6, 9), (0, 9), (0, 9)], everything)  # tetrahedra of 40.5
    write_mesh("cube-in-slices", points, cells)
    sides = [(x, y, z) for z in (0, 9) for y in (0, 9) for x in (0, 3, 9)]
    left = [(0, 3, 4, 1), (6, 7, 10, 9), (0, 1, 7, 6), (3, 9, 10, 4), (0, 6, 9, 3), (1, 4, 10, 7)]
    right = [tuple(v + 1 for v in square) for square in left]
    write_poly("cube-with-room", sides, left + [right[i] for i in (0, 1, 2, 3, 5)])
    bound = FOLDER / "cube-with-room.poly"
    bound.write_text(bound.read_text() + "2\n1 1 1 1 0 41\n2 5 1 1 0 40\n")
    row("written/cube-in-slices.ele --domain written/cube-with-room.poly --require volume:regions", "quality.volume",
        "in space: the tetrahedra of the larger room are too large")


def slanted(p):
    x, y, z = p
    return ((3 * x + y) / 7, (4 * y - x + 2 * z) / 7, (x + 5 * z) / 7)


def rounded():
    write_off("slanted-cube", [slanted(p) for p in box(0, 9)], in_triangles(SQUARES))
    half = [(0, 4.5, 9), (0, 9), (0, 9)]
    points, cells = grid(half, everything)
    write_mesh("slanted-cube", [slanted(p) for p in points], cells)
    cube = "written/slanted-cube.ele --domain written/slanted-cube.off --claim steiner-triangulation"
    row(cube, "domain.segment-missing", "a slanted cube: its corners and the middles of edges were rounded to doubles")
    row(f"{cube} --within 1e-12x", "domain.segment-missing", "within a distance the diagonals still are missing")
    row(f"{cube} --merge-coplanar --within 1e-12x", "domain.segment-missing", "rounded, no two triangles are in one plane exactly")
    row(f"{cube} --merge-coplanar 0.1deg --within 1e-12x", "holds", "joined where planes differ by little")
    row(f"{cube} --merge-coplanar 0.1deg --within 1e-18", "domain.segment-missing", "not flat enough for so small a distance")
    fourteen = [tuple(float(f"{x:.14g}") for x in slanted(p)) for p in points]
    write_gmsh("slanted-cube", fourteen, cells, [1] * len(cells))
    cube = cube.replace(".ele", ".msh")
    row(f"{cube} --merge-coplanar 0.1deg --within 1e-12x", "holds", "coordinates of 14 digits")
    write_mesh("slanted-cube-without-tetrahedron", [slanted(p) for p in points], cells[:-1])
    row("written/slanted-cube-without-tetrahedron.ele --domain written/slanted-cube.off --claim steiner-triangulation "
        "--merge-coplanar 0.1deg --within 1e-12x", "domain.polygon-not-tiled", "a tetrahedron is missing")


def write():
    FOLDER.mkdir(parents=True, exist_ok=True)
    for part in (merged, solid, dangling, labelled, bounded, rounded):
        part()
    header = "# arguments of `circumspect check`, in the folder above\tverdict\twhat is shown\n"
    table = FOLDER / "written.tsv"
    made = {arguments for arguments, _, _ in ROWS}
    by_hand = [line for line in table.read_text().splitlines() if line.split("\t")[0] not in made and not line.startswith("#")]
    table.write_text(header + "".join("\t".join(r) + "\n" for r in ROWS) + "".join(line + "\n" for line in by_hand))


if __name__ == "__main__":
    write()
