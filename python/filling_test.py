"""Which part of a domain is filled, and which of its polygons are joined, as in the command. Run by pytest."""
import decimal
import json
import pathlib
import subprocess
import types
from fractions import Fraction

import numpy as np
import pytest

import circumspect
from circumspect.domains import with_cells_of
from circumspect import _core

COMMAND = pathlib.Path(_core.__file__).resolve().parents[2] / "bin" / "circumspect"  # of the same build
# Three nested squares; the second has the opposite orientation.
RINGS = [[x, y] for r in (6, 4, 2) for x, y in ((-r, -r), (r, -r), (r, r), (-r, r))]
LOOPS = [[0, 1], [1, 2], [2, 3], [3, 0], [4, 7], [7, 6], [6, 5], [5, 4], [8, 9], [9, 10], [10, 11], [11, 8]]
CUBE = [[x, y, z] for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
QUADS = [[0, 1, 2, 3], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]
HALVES = [half for a, b, c, d in QUADS for half in ([a, b, c], [a, c, d])]


def filled_area(domain):
    """The area of its triangulation, which the judge finds right."""
    built = circumspect.constrained_delaunay(domain)
    cells = types.SimpleNamespace(points=domain.points, cells_dict={"triangle": built.simplices, "line": built.edges})
    verdict = circumspect.check(cells, domain=domain)
    assert verdict and verdict.claim == "cdt"
    corners = domain.points[built.simplices]
    return np.abs(np.linalg.det(corners[:, 1:] - corners[:, :1])).sum() / 2


@pytest.mark.parametrize("options, area", [
    ({}, 144), ({"kind": "enclosed"}, 144), ({"kind": "hull"}, 144),
    ({"kind": "even-odd"}, 144 - 64 + 16), ({"kind": "winding"}, 144 - 64 + 16),
    ({"regions": [[0, 0]]}, 16), ({"regions": [[5, 0], [3, 0]]}, 144 - 16),
    ({"kind": "enclosed", "regions": [[Fraction(11, 2), Fraction(1, 3)]]}, 144 - 64),
    ({"kind": "even-odd", "holes": [[0, 0]]}, 144 - 64)])
def test_what_is_filled(options, area, tmp_path):
    domain = circumspect.Domain(RINGS, LOOPS, **options)
    assert filled_area(domain) == pytest.approx(area)
    assert filled_area(circumspect.domains.domain_of({"points": RINGS, "segments": LOOPS, **options})) == pytest.approx(area)
    if not COMMAND.exists():
        return
    # The command and the package judge the same mesh of the same domain, and a mesh of the whole,
    # alike.
    plain = circumspect.Domain(RINGS, LOOPS, kind="enclosed")
    (tmp_path / "d.poly").write_text(_core.poly_text(plain.lists()), encoding="utf-8")
    (tmp_path / "d.node").write_text("".join([f"{len(RINGS)} 2\n", *(f"{i} {x} {y}\n" for i, (x, y) in enumerate(RINGS))]),
                                     encoding="utf-8")
    said = [f"--fill={options['kind']}"] if options.get("kind") else []
    said += [f"--{name[:-1]}={','.join(map(str, map(float, seed)))}" for name in ("regions", "holes")
             for seed in options.get(name, ()) if not isinstance(seed[0], Fraction)]
    if any(isinstance(x, Fraction) for seed in options.get("regions", ()) for x in seed):
        said.append("--region=5.5,0.25")
    for meshed in (domain, plain):
        rows = circumspect.constrained_delaunay(meshed).simplices
        (tmp_path / "d.ele").write_text(
            "".join([f"{len(rows)} 3\n", *(f"{i} {a} {b} {c}\n" for i, (a, b, c) in enumerate(rows))]), encoding="utf-8")
        told = subprocess.run([COMMAND, "check", tmp_path / "d.ele", "--domain", tmp_path / "d.poly", *said],
                              capture_output=True, text=True, check=False)
        verdict = circumspect.check(RINGS, rows, domain=domain)
        assert told.returncode == (0 if verdict else 1), told.stderr
        rules = verdict.rules or {"holds:": 1}
        assert set(rules) <= set(told.stdout.splitlines()[-1].split())


def test_walls_that_wind_two_ways_are_told():
    turned = [*LOOPS[:3], [0, 3], *LOOPS[4:]]
    with pytest.raises(circumspect.InputError, match="turned against others: winding needs to know"):
        filled_area(circumspect.Domain(RINGS, turned, kind="winding"))
    assert filled_area(circumspect.Domain(RINGS, turned, kind="even-odd")) == pytest.approx(96)


@pytest.mark.parametrize("options, error, message", [
    ({"kind": "odd"}, ValueError, "the kind 'enclosed', 'hull', 'even-odd', 'winding' or None, found 'odd'"),
    ({"regions": [[9, 9]]}, circumspect.InputError, "region 0 in something enclosed, found it in nothing enclosed"),
    ({"regions": [[0, 0], [6, 0]]}, circumspect.InputError, "region 1 in something enclosed, found it on a wall"),
    ({"regions": [[0, 0]], "kind": "even-odd"}, ValueError, "regions of what is enclosed, found them beside another kind"),
    ({"regions": [[0, 0]], "kind": "hull"}, ValueError, "found them beside another kind"),
    ({"regions": [[0, 0, 0]]}, ValueError, r"regions of shape \(h, 2\), found \(1, 3\)")])
def test_what_is_wrong_is_refused(options, error, message):
    with pytest.raises(error, match=message):
        circumspect.constrained_delaunay(circumspect.Domain(RINGS, LOOPS, **options))


def test_polygons_of_one_plane_are_joined():
    cut = circumspect.Domain(CUBE, polygons=HALVES)
    whole = circumspect.Domain(CUBE, polygons=HALVES, merge_coplanar=True)
    assert len(whole.polygons) == 12 and whole.merge_coplanar
    with pytest.raises(circumspect.NoTriangulation):
        circumspect.constrained_delaunay(cut)
    built = circumspect.constrained_delaunay(whole).simplices
    assert circumspect.check(CUBE, built, domain=whole).claim == "cdt"
    assert "domain.segment-missing" in circumspect.check(CUBE, built, domain=cut).rules
    # A polygon is named by its place in the domain's list, from 0, and a joined one by that of its
    # first part.
    edges = [[row[i], row[i + 1]] for row in QUADS for i in (-1, 0, 1, 2)]
    missing = circumspect.check(types.SimpleNamespace(points=CUBE, cells_dict={"tetra": built[1:], "line": edges}),
                                domain=whole)
    assert "domain.polygon-not-tiled" in missing.rules and "polygon 0, joined of 2" in str(missing)
    quads = circumspect.check(CUBE, built, domain=circumspect.Domain(CUBE, polygons=QUADS[:-1], kind="hull"))
    assert quads


def test_campaigns_say_which_domains_they_take():
    for options in ({"kind": "even-odd"}, {"regions": [[0, 0]]}):
        with pytest.raises(ValueError, match="fills all that it encloses"):
            circumspect.minimize(lambda domain: [], circumspect.Domain(RINGS, LOOPS, **options))
    fewer = circumspect.domains.with_cells_of(circumspect.Domain(RINGS, LOOPS, kind="even-odd"), range(8), [])
    assert filled_area(fewer) == pytest.approx(80)


# A square of 16 with a hole of 4, in which an island of 1 lies, and a square beside it that has an
# edge in common with it: as rings of polygons.
OUTLINE, HOLE = [[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]], [[1, 1], [1, 3], [3, 3], [3, 1]]
ISLAND, BESIDE = [[1.5, 1.5], [2.5, 1.5], [2.5, 2.5], [1.5, 2.5]], [[4, 0], [5, 0], [5, 4], [4, 4]]
SEVERAL = [[OUTLINE, HOLE], [ISLAND], [BESIDE]]
WKT = ("SRID=4326;MULTIPOLYGON (((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 3, 3 3, 3 1)),\n"
       " ((1.5 1.5, 2.5 1.5, 2.5 2.5, 1.5 2.5)), ((4 0, 5 0, 5 4, 4 4)))")
COLLECTION = {"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {"type": ["none"]}, "geometry": {"type": "MultiPolygon", "coordinates": SEVERAL}},
    {"type": "Feature", "geometry": None}]}


@pytest.mark.parametrize("shape, area", [
    (OUTLINE, 16), (np.array(OUTLINE), 16), ([OUTLINE, HOLE], 12), ([np.array(OUTLINE), np.array(HOLE)], 12), (SEVERAL, 17),
    (WKT, 17), (WKT.lower(), 17), (COLLECTION, 17), (json.dumps(COLLECTION), 17), (types.SimpleNamespace(
        __geo_interface__={"type": "Polygon", "coordinates": (tuple(map(tuple, OUTLINE)), tuple(map(tuple, HOLE)))}), 12),
    ([OUTLINE, HOLE, ISLAND], 13), ([OUTLINE, OUTLINE, HOLE, BESIDE], 8), ([[[*p, 7] for p in ring] for ring in (OUTLINE, HOLE)], 12),
    ("POLYGON Z ((0 0 1, 4 0 1, 0 4 1, 0 0 1)) POLYGONZM((4 0 1 8, 4 4 1 9, 0 4 1 8))", 16),
    ("TRIANGLE ((0 0, 4 0, 0 4, 0 0)) TIN (((4 0, 4 4, 0 4, 4 0)))", 16),
    ("GEOMETRYCOLLECTION (POLYGON ((0 0, 4 0, 4 4)), LINESTRING (0 0, 0 4), MULTIPOINT ((3 1), (3 2)), POINT EMPTY)", 8)])
def test_polygons_are_given_as_rings(shape, area, tmp_path):
    domain = circumspect.Domain.from_rings(shape)
    assert filled_area(domain) == pytest.approx(area)
    everything = circumspect.Domain.from_rings(shape, kind="enclosed")
    assert filled_area(everything) > area - 1e-9
    built = circumspect.constrained_delaunay(domain)
    if isinstance(shape, list) and not len(built.edges) and COMMAND.exists():  # the command reads them from a file
        (tmp_path / "d.json").write_text(json.dumps(shape, default=np.ndarray.tolist), encoding="utf-8")
        rows = built.simplices
        np.savez(tmp_path / "d.npz", points=np.array(domain.points, float), simplices=rows)
        told = subprocess.run([COMMAND, "check", tmp_path / "d.npz", "--domain", tmp_path / "d.json", "--claim", "cdt"],
                              capture_output=True, text=True, check=False)
        assert told.returncode == 0, told.stdout + told.stderr


def test_numbers_of_rings_are_exact():
    tenths = "POLYGON ((0.1 0, 0.3 0, 0.1 1/3))"
    assert circumspect.Domain.from_rings(tenths).points[0][0] == Fraction(0.1)
    assert circumspect.Domain.from_rings(tenths, coordinates="decimal").points[0][0] == Fraction(1, 10)
    listed = [[decimal.Decimal("0.1"), 0], [Fraction(1, 3), 0], [0, 1]]
    assert circumspect.Domain.from_rings(listed).points[:2, 0].tolist() == [Fraction(1, 10), Fraction(1, 3)]
    text = '{"type": "Polygon", "coordinates": [[[0.1, 0], [1, 0], [0, 1]]]}'
    assert circumspect.Domain.from_rings(text, coordinates="decimal").points[0][0] == Fraction(1, 10)
    # A mesh may be held against such a text; the hole is empty.
    square = "POLYGON ((0 0, 2 0, 2 2, 0 2))"
    assert circumspect.check([[0, 0], [2, 0], [2, 2], [0, 2]], [[0, 1, 2], [0, 2, 3]], domain=square).claim == "cdt"
    assert not circumspect.check([[0, 0], [2, 0], [2, 2], [0, 2]], [[0, 1, 2]], domain=square)


@pytest.mark.parametrize("shape, message", [
    ("[" * 100000, "too deep in one another"), ('{"type": "GeometryCollection", "geometries": [' * 50000, "too deep in one another"),
    ("GEOMETRYCOLLECTION (POINT (0 0)", "'\\)' after a collection"), ("POINT Z (1 2)", "expected 3 coordinates of a position"),
    ("POLYGON ((0 0, 4 0, 4 4)", "line 1 of WKT: expected ',' or '\\)', found the end"),
    ("POLYGON (0 0, 4 0, 4 4)", r"expected '\(' or EMPTY, found '0'"),
    ("\nCIRCULARSTRING (0 0, 1 1, 2 0)", "line 2 of WKT: expected a geometry of straight lines"),
    ("POLYGON ((0 0, 4 x, 4 4))", "expected a number, found 'x'"), ("POLYGON ((0 0, 4, 4 4))", "2 or 3 coordinates"),
    ("POLYGON EMPTY", "expected polygons, lines or points, found none"), ([[0, 0], [1, 0]], "at least 3 points, found 2"),
    ([0, 1, 2], "found lists of depth 1"), ({"type": "Topology"}, "found 'Topology'"), ([[0, 0], [1, 0, 0], [0, 1]], "expected 2 coordinates"),
    ({"type": "Polygon"}, "the key 'coordinates'"), ([[[0, 0, 0], [1, 0, 0], [0, 1, 1]], [[0, 0, 0]] * 3], "at least 3 points, found 1"),
    ([[[0, 0, 0], [9, 0, 0], [0, 9, 1]], [[1, 1, 0], [2, 1, 0], [1, 2, 0]]], "polygons of one ring where the third coordinate differs")])
def test_rings_that_are_none_are_refused(shape, message):
    with pytest.raises(ValueError, match=message):
        circumspect.Domain.from_rings(shape)


def test_positions_stay_and_options_are_spelled():
    text = "GEOMETRYCOLLECTION Z (POLYGON Z ((0 0 1, 4 0 1, 4 4 1)), MULTIPOINT Z ((3 1 1), (3 2 1)))"
    assert circumspect.Domain.from_rings(text).size() == "5 points, 0 segments, 1 polygon"
    with pytest.raises(ValueError, match="expected coordinates='double' or coordinates='decimal', found 'decimals'"):
        circumspect.Domain.from_rings(OUTLINE, coordinates="decimals")


def test_a_list_that_holds_itself_is_refused():
    ring: list = []
    ring.append(ring)
    with pytest.raises(ValueError, match="found lists of depth 5"):
        circumspect.Domain.from_rings(ring)


def test_what_is_untidy_is_resolved_if_asked():
    crossed = circumspect.Domain([[0, 0], [4, 0], [4, 4], [0, 4]], [[0, 1], [1, 2], [2, 3], [3, 0], [0, 2], [1, 3]], resolve=True)
    mesh = [[0, 0], [4, 0], [4, 4], [0, 4], [2, 2]], [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]]
    assert circumspect.check(*mesh, domain=crossed).claim == "cdt"
    missing = circumspect.check([[0, 0], [4, 0], [4, 4], [0, 4]], [[0, 1, 2], [0, 2, 3]], domain=crossed)
    assert missing.rules.get("domain.vertex-missing") == 1 and "domain-vertex 4" in str(missing)
    with pytest.raises(circumspect.InputError, match="plc.crossing-segments"):
        circumspect.check(*mesh, domain={"points": crossed.points, "segments": crossed.segments})
    # A bow tie covers both of its wings, and nothing else.
    tie = circumspect.Domain.from_rings([[0, 0], [2, 2], [2, 0], [0, 2]], resolve=True)
    wings = [[0, 0], [2, 2], [2, 0], [0, 2], [1, 1]]
    assert circumspect.check(wings, [[0, 4, 3], [1, 4, 2]], domain=tie)
    assert "domain.outside" in circumspect.check(wings, [[0, 4, 3], [1, 4, 2], [0, 2, 4]], domain=tie).rules


def test_equal_points_of_a_domain_are_merged_with_those_of_the_mesh():
    doubled = [[0, 0], [2, 0], [2, 2], [0, 2], [0, 0]]
    domain = circumspect.Domain(doubled, [[0, 1], [1, 2], [2, 3], [3, 4], [0, 4]])
    with pytest.raises(circumspect.InputError, match="plc.duplicate-vertex"):
        circumspect.check(doubled[:4], [[0, 1, 2], [0, 2, 3]], domain=domain)
    assert circumspect.check(doubled, [[0, 1, 2], [4, 2, 3]], domain=domain, duplicates="merge").claim == "cdt"
    fails = circumspect.check(doubled, [[0, 1, 2]], domain=domain, duplicates="merge")
    assert fails.rules["domain.segment-missing"] == 2


def test_a_terrain_is_seen_from_above():
    terrain = [[0, 0, 1], [4, 0, 2], [4, 4, 0], [0, 4, 3], [2, 2, 5]], [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]]
    assert not circumspect.check(*terrain) and circumspect.check(*terrain, drop="z").claim == "delaunay"
    assert not circumspect.check(*terrain, "complex", drop="y")
    exact = [[Fraction(x, 3) for x in row] for row in terrain[0]]
    assert circumspect.check(exact, terrain[1], drop="z")
    for faulty, message in (((*terrain, "w"), "found 'w'"), ((CUBE, [[0, 1, 2, 4]], "z"), "found simplices of 4 vertices"),
                            ((RINGS, [[0, 1, 2]], "x"), "3 coordinates for drop, found 2")):
        with pytest.raises(ValueError, match=message):
            circumspect.check(*faulty[:2], drop=faulty[2])


def test_a_surface_is_a_domain_by_its_triangles():
    points = [[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4], [1, 1, 1]]  # the last is a dent of the hull
    faces = [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 4], [1, 3, 4], [2, 3, 4]]
    surface = types.SimpleNamespace(vertices=np.array(points, float), faces=np.array(faces))
    cells = [[0, 1, 2, 4], [0, 1, 3, 4], [0, 2, 3, 4]]
    assert circumspect.check(points, cells, "plc-triangulation", domain=surface)
    assert not circumspect.check(points, [*cells, [1, 2, 3, 4]], "plc-triangulation", domain=surface)
    for wrong in (np.array([[0, 1, 2, 3]]), np.array([0, 1, 2])):
        with pytest.raises(ValueError, match="a surface of triangles as a domain|of shape"):
            circumspect.check(points, cells, domain=types.SimpleNamespace(vertices=surface.vertices, faces=wrong))
    for keys in ({"points": points, "hole": []}, {"segments": []}):
        with pytest.raises(ValueError, match="expected a domain with the keys"):
            circumspect.check(points, cells, domain=keys)
    for dimension in (1, 4):
        with pytest.raises(ValueError, match=f"of the plane or of space, found points of {dimension} coordinates"):
            circumspect.Domain(np.eye(dimension))


def test_a_domain_with_all_of_its_cells_is_the_same():
    square = [[0, 0], [4, 0], [4, 4], [0, 4]]
    flat = circumspect.Domain([[*p, 0] for p in square], polygons=[[0, 1, 2, 3]], holes=[], polygon_holes={0: [[5, 5, 0]]}, merge_coplanar=True)
    for domain in (flat, circumspect.Domain(square, [[0, 1]], resolve=True, regions=[[1, 1]])):
        again = with_cells_of(domain, range(len(domain.segments)), range(len(domain.polygons)))
        assert all(np.array_equal(a, b) for a, b in zip(domain.parts(), again.parts()))
    assert circumspect.Domain(square, [[0, 1]]).lists()[-1] is False and circumspect.Domain(square).lists()[-1] is True
    for options in ({"kind": "even-odd"}, {"kind": "winding"}, {"regions": [[1, 1]]}, {"merge_coplanar": True}, {"resolve": True},
                    {"polygons": [[0, 1, 2]]}):
        with pytest.raises(ValueError, match="expected a domain that fills all that it encloses"):
            circumspect.Domain(square, [[0, 1]], **options).lists()
