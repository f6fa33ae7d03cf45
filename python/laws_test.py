"""Laws of the package circumspect: no number, cell or option is lost on the way to the judge, whatever form it comes in. Run by pytest."""
import copy
import decimal
import inspect
import itertools
import types
from fractions import Fraction

import numpy as np
import pytest

import circumspect
from circumspect.meshes import guarded, mesh_of, with_faces

CUBE = [[x, y, z] for z in (0, 4) for x, y in ((0, 0), (4, 0), (4, 4), (0, 4))]
QUADS = [[0, 1, 2, 3], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]
POINTS = circumspect.generate("uniform", dimension=3, points=12, seed=1)
SIMPLICES = circumspect.delaunay(POINTS)


def neighbors_of(simplices):
    """The simplex opposite each vertex."""
    facets = {}
    for s, row in enumerate(np.asarray(simplices).tolist()):
        for place in range(len(row)):
            facets.setdefault(frozenset(row[:place] + row[place + 1:]), []).append((s, place))
    across = np.full(np.shape(simplices), -1)
    for (s, i), (t, j) in (pair for pair in facets.values() if len(pair) == 2):
        across[s, i], across[t, j] = t, s
    return across


def test_a_number_is_the_same_in_every_place_of_a_list():
    """2^53 + 1 is not a double: beside floats, integers and fractions, in any row, it stays what it is."""
    big = 2**53
    rows = [[big, 0], [big + 2, 0], [big + 1, 0]]
    for beside in (0, 0.0, np.float64(0), Fraction(0)):
        for order in itertools.permutations(range(3)):
            points = [[rows[i][0], beside] for i in order]
            place = [order.index(i) for i in range(3)]
            negative = [[-x, y] for x, y in points]
            of_integers = [np.array(some) for some in (points, negative) if isinstance(beside, int)]
            for given in (points, negative, *of_integers):
                assert circumspect.check(given, [[place[0], place[2]], [place[2], place[1]]])
                assert not circumspect.check(given, [[place[0], place[1]]])


@pytest.mark.parametrize("kinds", itertools.product([np.int32, np.int64, np.uint32, np.int8], repeat=2))
def test_neighbors_are_judged_in_every_width(kinds):
    simplices, across = SIMPLICES, neighbors_of(SIMPLICES)
    if np.dtype(kinds[1]).kind == "u":
        across = np.where(across < 0, 2**32 - 1, across)  # names no simplex: wrong, and not overlooked
    verdict = circumspect.check(POINTS, simplices.astype(kinds[0]), neighbors=across.astype(kinds[1]))
    assert bool(verdict) == (np.dtype(kinds[1]).kind == "i"), verdict
    wrong = across.copy()
    wrong[0] = wrong[0][[1, 0, 2, 3]]
    if wrong[0].tolist() != across[0].tolist():
        assert not circumspect.check(POINTS, simplices.astype(kinds[0]), neighbors=wrong.astype(kinds[1]))


def test_neighbors_of_a_mesh_count_and_those_that_are_given_count_more():
    right = neighbors_of(SIMPLICES)
    wrong = right.copy()
    wrong[0] = np.roll(wrong[0], 1)
    for own, given in ((right, wrong), (wrong, right)):
        mesh = types.SimpleNamespace(points=POINTS, simplices=SIMPLICES, neighbors=own)
        assert bool(circumspect.check(mesh)) == (own is right)
        assert bool(circumspect.check(mesh, neighbors=given)) == (given is right)


@pytest.mark.parametrize("claim", ["complex", "convex-hull", "surface-delaunay"])
def test_neighbors_are_refused_where_nothing_judges_them(claim):
    with pytest.raises(ValueError, match=f"expected no neighbors beside the claim {claim}"):
        circumspect.check(POINTS, SIMPLICES, claim, neighbors=neighbors_of(SIMPLICES))


def test_cells_of_every_dimension_arrive():
    """A loose segment and a loose triangle have to be listed; so one that is lost is missed."""
    domain = circumspect.Domain([*CUBE, [9, 0, 0], [9, 4, 0], [9, 0, 4], [12, 0, 0], [12, 4, 0]], segments=[[11, 12]],
                                polygons=[*QUADS, [8, 9, 10]], kind="enclosed")
    built = circumspect.constrained_delaunay(domain)
    cells = {"tetra": built.simplices, "triangle": built.triangles, "line": built.edges}
    mesh = types.SimpleNamespace(points=domain.points, cells_dict=cells)
    assert len(built.triangles) and len(built.edges) and circumspect.check(mesh, domain=domain)
    for left_out in cells:
        less = types.SimpleNamespace(points=domain.points, cells_dict={k: rows for k, rows in cells.items() if k != left_out})
        assert not circumspect.check(less, domain=domain), left_out
    # In whatever order they are listed.
    turned = types.SimpleNamespace(points=domain.points, cells_dict=dict(reversed(cells.items())))
    assert circumspect.check(turned, domain=domain)


def test_edges_beside_triangles_arrive():
    square = [[0, 0], [4, 0], [4, 4], [0, 4], [9, 0], [9, 4]]
    domain = circumspect.Domain(square, [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5]])
    cells = {"triangle": [[0, 1, 2], [0, 2, 3]], "line": [[4, 5]]}
    assert circumspect.check(types.SimpleNamespace(points=square, cells_dict=cells), domain=domain)
    assert not circumspect.check(types.SimpleNamespace(points=square, cells_dict={"triangle": cells["triangle"]}), domain=domain)


def test_segments_are_resolved_beside_every_other_option():
    points, crossing = [[0, 0], [4, 0], [4, 4], [0, 4]], [[0, 1], [1, 2], [2, 3], [3, 0], [0, 2], [1, 3]]
    fan = [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]]
    edges = [*crossing[:4], [0, 4], [1, 4], [2, 4], [3, 4]]
    for options, filled in (({}, fan), ({"holes": [[2, 1]]}, fan[1:]), ({"regions": [[2, 1]]}, fan[:1]), ({"kind": "even-odd"}, fan)):
        domain = circumspect.Domain(points, crossing, resolve=True, **options)
        for triangles in (fan, filled):
            cells = {"triangle": triangles, "line": edges}
            verdict = circumspect.check(types.SimpleNamespace(points=[*points, [2, 2]], cells_dict=cells), domain=domain)
            assert bool(verdict) == (triangles == filled), options


@pytest.mark.parametrize("count", [0, 3, 5])
def test_each_point_has_one_weight(count):
    points, simplices = [[0, 0], [4, 0], [0, 4], [4, 4]], [[0, 1, 2], [1, 3, 2]]
    assert circumspect.check(points, simplices, "weighted-delaunay", weights=[0, 0, 0, 0])
    for ask in (lambda weights: circumspect.check(points, simplices, "weighted-delaunay", weights=weights),
                lambda weights: circumspect.delaunay(points, weights)):
        with pytest.raises(ValueError, match=f"one weight a point, 4, found {count}"):
            ask(np.zeros(count))


def test_what_is_not_known_and_what_is_not_so_are_told_apart():
    square, other = [[0, 0], [1, 0], [1, 1], [0, 1]], [[[0, 1, 2], [0, 2, 3]], [[0, 1, 3], [1, 2, 3]]]
    assert sorted(circumspect.check(square, halves).canonical for halves in other) == [False, True]
    assert [circumspect.check(square, halves).unique for halves in other] == [False, False]
    for halves in other:
        verdict = circumspect.check(square, halves, "triangulation")
        assert verdict.canonical is None and verdict.unique is None
    assert circumspect.check(square, other[0][:1]).canonical is None


def test_arguments_stay_what_they_are():
    """Their numbers, and whether they may be written to."""
    own = {"points": np.array(POINTS), "simplices": np.array(SIMPLICES), "neighbors": neighbors_of(SIMPLICES)}
    for writeable in (True, False):
        for array in own.values():
            array.flags.writeable = writeable
        views = {name: array[:] for name, array in own.items()}
        for arrays in (own, views):
            before = copy.deepcopy(arrays)
            for keep in (True, False):
                assert circumspect.check(arrays["points"], arrays["simplices"], neighbors=arrays["neighbors"], copy=keep)
            for name, array in arrays.items():
                assert array.flags.writeable == writeable, name
                assert array.dtype == before[name].dtype and (array == before[name]).all(), name
    shut = np.array(POINTS)
    view = shut[:]
    view.flags.writeable = False  # though its owner may be written to
    assert circumspect.check(view, SIMPLICES) and not view.flags.writeable and shut.flags.writeable


def test_every_demand_and_requirement_counts():
    square, halves = [[0, 0], [1, 0], [1, 1], [0, 1]], [[0, 1, 2], [0, 2, 3]]
    kept, broken = "min-angle:45deg", "max-angle:89deg"
    for order in ([kept, broken], [broken, kept], (broken,), broken):
        assert circumspect.check(square, halves, require=order).rules == {"quality.max-angle": 2}
    for order in (["connected", "oriented=negative"], ["oriented=negative", "connected"], "oriented=negative"):
        assert circumspect.check(square, halves, "complex", demands=order).rules == {"simplex.inverted": 2}
    turned = [halves[0], halves[1][::-1]]
    assert circumspect.check(square, turned) and not circumspect.check(square, turned, oriented=True)
    domain = circumspect.Domain(square, [[0, 1], [1, 2], [2, 3], [3, 0]])
    for within in (None, 0, Fraction(1, 10)):
        assert circumspect.check(square, halves, domain=domain, within=within, require=broken).rules == {"quality.max-angle": 2}


def test_by_definition_is_another_way_to_the_same_answer():
    for simplices in (SIMPLICES, SIMPLICES[1:]):
        ways = [circumspect.check(POINTS, simplices, by=by).to_dict() for by in ("lemma", "definition")]
        assert ways[0]["verdict"] == ways[1]["verdict"]
        assert ways[0].get("by") != ways[1].get("by") or ways[0].get("course") != ways[1].get("course")


def test_a_height_is_left_out_only_if_all_points_have_it():
    square, halves = [[0, 0], [1, 0], [1, 1], [0, 1]], [[0, 1, 2], [0, 2, 3]]
    domain = circumspect.Domain(square, [[0, 1], [1, 2], [2, 3], [3, 0]])
    assert circumspect.check([[*p, 0.5] for p in square], halves, domain=domain)
    for lifted in range(4):
        points = [[*p, 0.5 + (i == lifted)] for i, p in enumerate(square)]
        try:
            assert not circumspect.check(points, halves, domain=domain)
        except ValueError:
            pass  # of another dimension than the domain


def test_a_mesh_is_compared_by_its_own_weights():
    """A point that is too light is not a vertex: so these are weights of meshes whose points are the same."""
    points, light, heavy = [[0, 0], [4, 0], [0, 4], [1, 1]], [0, 0, 0, -100], [0, 0, 0, 0]
    a, b = circumspect.delaunay(points, light), circumspect.delaunay(points, heavy)
    assert circumspect.compare((points, a), (points, a), weights=(light, light))
    assert not circumspect.compare((points, a), (points, b), weights=(light, heavy))
    assert not circumspect.compare((points, a), (points, a), weights=(light, heavy))


def test_indices_without_a_sign_are_what_they_are():
    for kind, index in ((np.uint32, 2**32 - 1), (np.uint64, 2**64 - 1), (np.uint64, 2**63 - 1)):
        wrong = np.array([[0, 1, index]], dtype=kind)
        try:
            assert "triangulation.unknown-vertex" in circumspect.check(POINTS[:4, :2], wrong).rules
        except ValueError as error:
            assert "64 bits" in str(error) and index >= 2**63


def test_what_is_no_integer_is_no_index_whatever_holds_it():
    def judged(index):
        return circumspect.check(POINTS[:3, :2], np.array([[0, 1, index]], dtype=object), "triangulation")

    assert judged(2)
    for index in (True, 2.0, "2", Fraction(2), decimal.Decimal(2)):
        with pytest.raises(TypeError, match="expected integers as simplices, found other objects"):
            judged(index)
    for index in (-1, 3, 2**63 - 1, -2**63):
        assert "triangulation.unknown-vertex" in judged(index).rules
    for index in (2**63, -2**63 - 1):
        with pytest.raises(ValueError, match="simplices of 64 bits, found larger ones"):
            judged(index)
    with pytest.raises(ValueError, match=r"simplices of shape \(m, 3\), found \(0, 7\)"):
        circumspect.check(POINTS[:3, :2], np.zeros((0, 7), int))


def test_a_hull_of_a_library_is_judged_whole():
    spatial = pytest.importorskip("scipy.spatial")
    hull = spatial.ConvexHull(POINTS)
    assert circumspect.check(hull)
    for left_out in range(len(hull.simplices)):
        less = types.SimpleNamespace(**{name: getattr(hull, name) for name in ("points", "vertices", "equations", "volume")},
                                     simplices=np.delete(hull.simplices, left_out, axis=0))
        assert not circumspect.check(less)


def test_the_box_of_a_diagram_has_two_corners():
    square = [[0, 0], [4, 0], [4, 4], [0, 4]]
    cells = ([[2, 2]], [[0, -1]] * 4, [[0, 1], [1, 2], [2, 3], [3, 0]])
    assert circumspect.check_voronoi(square, *cells, box=[[-1, -1], [5, 5]])
    for box in ([[0, 0]], [[-1, -1], [5, 5], [6, 6]]):
        with pytest.raises(ValueError, match=f"a box of two corners, found {len(box)}"):
            circumspect.check_voronoi(square, *cells, box=box)


@pytest.mark.parametrize("axis", "xyz")
def test_to_drop_a_coordinate_is_to_leave_out_its_column(axis):
    points = [[0, 0, 1], [4, 1, 2], [5, 5, 0], [1, 4, 3], [2, 3, 5]]
    triangles = [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4], [0, 2, 4]]
    columns = np.delete(np.array(points), "xyz".index(axis), axis=1)
    for exact in (False, True):
        given = [[Fraction(x, 3) for x in row] for row in points] if exact else points
        left = [[Fraction(int(x), 3) for x in row] for row in columns] if exact else columns
        for options in ({}, {"demands": "oriented=positive"}):
            assert circumspect.check(given, triangles, "complex", drop=axis, **options).to_dict() == \
                circumspect.check(left, triangles, "complex", **options).to_dict()


def area_of(domain):
    """Of its triangulation."""
    corners = np.array(domain.points, dtype=float)[circumspect.constrained_delaunay(domain).simplices]
    return pytest.approx(np.abs(np.linalg.det(corners[:, 1:] - corners[:, :1])).sum() / 2)


def test_what_is_wound_around_twice_is_entered_an_even_number_of_times():
    points = [[x, y] for r in (6, 4) for x, y in ((-r, -r), (r, -r), (r, r), (-r, r))]
    loops = [[s + i, s + (i + 1) % 4] for s in (0, 4) for i in range(4)]
    areas = {"winding": 144, "even-odd": 144 - 64, "enclosed": 144, "hull": 144}
    for kind, area in areas.items():
        assert area == area_of(circumspect.Domain(points, loops, kind=kind))
    turned = loops[:4] + [edge[::-1] for edge in loops[4:]]
    assert area_of(circumspect.Domain(points, turned, kind="winding")) == 144 - 64


def test_each_hole_of_a_polygon_is_a_hole_in_whatever_order_they_are_given():
    """A lid with two square holes, and a floor with the same: of four seeds none may be lost or exchanged."""
    def square(x, y, r, z):
        return [[x - r, y - r, z], [x + r, y - r, z], [x + r, y + r, z], [x - r, y + r, z]]

    points = [p for z in (0, 4) for x, r in ((6, 6), (3, 1), (9, 1)) for p in square(x, 6, r, z)]
    sides = [[s + i, s + (i + 1) % 4, s + (i + 1) % 4 + 12, s + i + 12] for s in (0, 4, 8) for i in range(4)]
    lids = [[list(range(s + k, s + k + 4)) for k in (0, 4, 8)] for s in (0, 12)]
    seeds = {12: [[3, 6, 0], [9, 6, 0]], 13: [[3, 6, 4], [9, 6, 4]]}
    for order in ([12, 13], [13, 12]):
        domain = circumspect.Domain(points, polygons=[*sides, *lids], polygon_holes={key: seeds[key] for key in order})
        built = circumspect.constrained_delaunay(domain).simplices
        corners = np.array(points, dtype=float)[built]
        volume = np.abs(np.linalg.det(corners[:, 1:] - corners[:, :1])).sum() / 6
        assert volume == pytest.approx((144 - 2 * 4) * 4)
        again = circumspect.Domain.of_lists(domain.lists())
        assert {key: rows.tolist() for key, rows in again.polygon_holes.items()} == {
            key: rows.tolist() for key, rows in domain.polygon_holes.items()}
    for none in (-1, 14):
        with pytest.raises(ValueError, match=f"one of 14 polygons, found {none}"):
            circumspect.Domain(points, polygons=[*sides, *lids], polygon_holes={none: [[3, 6, 0]]})


def test_a_domain_is_the_same_by_its_lists():
    for points, segments in (([[0, 0], [4, 0], [4, 4], [0, 4]], []), ([[0, 0], [4, 0], [0, 4]], [[0, 1], [1, 2], [2, 0]])):
        for kind in (None, "hull", *(["enclosed"] if segments else [])):
            domain = circumspect.Domain(points, segments, kind=kind)
            again = circumspect.Domain.of_lists(domain.lists())
            assert again.kind == ("hull" if kind == "hull" or not segments else "enclosed")
            assert area_of(again) == area_of(domain).expected
            fewer = circumspect.domains.with_cells_of(domain, range(len(segments)), [])
            assert fewer.kind == domain.kind and (fewer.points == domain.points).all()


def test_lines_of_every_form_arrive_whole():
    corners = [[0, 0], [4, 0], [4, 0], [4, 4], [0, 4], [1, 2]]
    pairs = [[0, 1], [1, 2], [2, 3], [3, 4]]
    text = ", ".join(f"{x} {y}" for x, y in corners)
    measured = ", ".join(f"{x} {y} {i}" for i, (x, y) in enumerate(corners))
    loose = {"type": "LineString", "coordinates": [[9, 9], [8, 9]]}
    line = {"type": "LineString", "coordinates": corners}
    for shape in (line, f"LINESTRING ({text})", f"LINESTRING M ({measured})", {"type": "MultiLineString", "coordinates": [corners]}):
        domain = circumspect.Domain.from_rings(shape)
        assert domain.points.tolist() == [[0, 0], [4, 0], [4, 4], [0, 4], [1, 2]] and domain.segments.tolist() == pairs
    # Vertices are numbered as they occur.
    both = circumspect.Domain.from_rings({"type": "GeometryCollection", "geometries": [line, loose]})
    assert both.points[:5].tolist() == domain.points.tolist() and both.segments.tolist() == [*pairs, [5, 6]]


def test_a_verdict_that_was_pickled_says_the_same():
    import pickle

    torn = [[0, 0], [1, 0], [1, 1], [0, 1], [0, 0], [1, 1]]
    for verdict in (circumspect.check(torn, [[0, 1, 2], [4, 5, 3]], duplicates="merge"), circumspect.check(POINTS, SIMPLICES[1:])):
        again = pickle.loads(pickle.dumps(verdict))
        assert str(again) == str(verdict) and again.notes == verdict.notes and again.to_dict() == verdict.to_dict()
        assert again.causes == verdict.to_dict().get("causes", []) and bool(again) == bool(verdict)
        listed = [(v.rule, v.face, v.vertices, v.simplices) for v in again.violations]
        assert listed == [(v["rule"], v.get("face"), v["vertices"], v["simplices"]) for v in verdict.to_dict()["violations"]]


def test_what_a_comparison_finds_only_in_one_is_only_in_the_other_when_they_change_places():
    points = [[0, 0], [4, 0], [0, 4], [1, 1]]
    a, b = (points, [[0, 1, 2]]), (points[:3], [[0, 1, 2]])
    light, heavy = [0, 0, 0, -9], [0, 0, 1]
    for weights in ((None, None), (light, None), (None, heavy), (light, heavy)):
        found = circumspect.compare(a, b, weights=weights)
        swapped = circumspect.compare(b, a, weights=weights[::-1])
        assert (found.only_in_a, found.only_in_b) == (swapped.only_in_b, swapped.only_in_a)
        assert len(found.only_in_a["points"]) > 0 and bool(found) == bool(swapped)


def test_fewer_points_are_drawn_exactly_as_in_doubles():
    sizes = set()
    for seed in range(12):
        for fewer in (False, True):
            doubles = circumspect.generate("integers", dimension=2, points=12, seed=seed, fewer=fewer)
            exact = circumspect.generate("integers", dimension=2, points=12, seed=seed, fewer=fewer, exact=True)
            assert doubles.tolist() == exact.astype(float).tolist()
            sizes |= {len(doubles)} if fewer else set()
    assert min(sizes) < 8


def test_a_face_that_is_no_triangle_is_refused_wherever_it_stands():
    points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    faces = np.array([[3, 0, 1, 2], [3, 0, 1, 3], [3, 0, 2, 3], [3, 1, 2, 3]])
    assert circumspect.check(types.SimpleNamespace(points=points, faces=faces.ravel()), claim="complex")
    for place in range(4):
        other = faces.copy()
        other[place, 0] = 4
        with pytest.raises(ValueError, match="a surface of triangles, found other faces"):
            circumspect.check(types.SimpleNamespace(points=points, faces=other.ravel()), claim="complex")


def test_edges_stay_where_a_coordinate_is_dropped():
    flat, heights = [[0, 0], [4, 0], [4, 4], [0, 4], [9, 0], [9, 4]], [1, 5, 2, 7, 3, 9]
    domain = circumspect.Domain(flat, [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5]])
    cells = {"triangle": [[0, 1, 2], [0, 2, 3]], "line": [[4, 5]]}
    lifted = types.SimpleNamespace(points=[[*row, z] for row, z in zip(flat, heights)], cells_dict=cells)
    assert circumspect.check(lifted, domain=domain, drop="z")
    assert circumspect.check(types.SimpleNamespace(points=flat, cells_dict=cells), domain=domain)


def test_what_is_certified_is_what_was_judged():
    points, light, heavy = [[0, 0], [4, 0], [5, 5], [0, 4]], [0, 0, 0, 0], [9, 0, 9, 0]
    for simplices in ([[0, 1, 2], [0, 2, 3]], [[0, 1, 3], [1, 2, 3]]):
        for weights in (light, heavy):
            holds = circumspect.check(points, simplices, "weighted-delaunay", weights=weights)
            document = circumspect.certify(points, simplices, "weighted-delaunay", weights=weights)
            assert document.startswith("circumspect-certificate" if holds else "circumspect-refutation")


def test_a_site_without_a_region_has_no_cell():
    """SciPy gives it the region -1, which is not the last of its list."""
    square, regions = [[0, 0], [4, 0], [4, 4], [0, 4]], [[], [0, -1]]
    for missing in range(4):
        diagram = types.SimpleNamespace(points=square, vertices=[[2, 2]], regions=regions, ridge_points=[[0, 1], [1, 2], [2, 3], [3, 0]],
                                        point_region=[-1 if site == missing else 1 for site in range(4)])
        assert circumspect.check_voronoi(diagram).rules == {"voronoi.cell-missing": 1}
    diagram.point_region = [1, 1, 1, 1]
    assert circumspect.check_voronoi(diagram)


def test_to_assert_is_to_check_whatever_the_claim():
    square, halves = [[0, 0], [1, 0], [0, 1], [0.9, 0.9]], [[0, 1, 2], [1, 3, 2]]
    for claim in (None, "triangulation", "delaunay", "complex", "surface-delaunay"):
        for options in ({}, {"oriented": True}, {"require": "max-angle:89deg"}, {"max_errors": 1}):
            verdict = circumspect.check(square, halves, claim, **options)
            try:
                said = circumspect.assert_delaunay(square, halves, claim, **options)
            except circumspect.CheckFailed as failed:
                said = failed.verdict
            assert str(said) == str(verdict), (claim, options)


@pytest.mark.parametrize("dimension", [1, 2, 3])
def test_a_sign_is_the_same_in_every_unit_and_order(dimension):
    """Thirds are no doubles, so they take another way than integers do; an odd permutation turns an orientation round."""
    points = np.random.default_rng(dimension).integers(0, 6, (40, dimension + 2, dimension)).tolist()
    seen = set()
    for row in points:
        thirds = [[Fraction(x, 3) for x in point] for point in row]
        simplex, swapped = row[:-1], [row[1], row[0], *row[2:-1]]
        turn, side = circumspect.orient(*simplex), circumspect.in_ball(*row) if circumspect.orient(*row[:-1]) else 0
        assert circumspect.orient(*thirds[:-1]) == turn == -circumspect.orient(*swapped)
        if turn:
            assert circumspect.in_ball(*thirds) == side == circumspect.in_ball(*swapped, row[-1])
        seen |= {(turn, side)}
    assert len({turn for turn, _ in seen}) == 3 and len({side for _, side in seen}) == 3


def test_faces_that_are_given_stand_for_those_of_the_mesh():
    """Those of the mesh are all of them stray, and none of those that are given."""
    points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [9, 9, 9], [8, 9, 9], [9, 8, 9]]
    stray = {"triangle": [[4, 5, 6]], "line": [[4, 5]]}
    for own in ({}, {"triangle": stray["triangle"]}, {"line": stray["line"]}, stray):
        mesh = types.SimpleNamespace(points=points, cells_dict={"tetra": [[0, 1, 2, 3]], **own})
        for faces in ([[0, 1, 2]], [[0, 1]]):
            assert circumspect.check(mesh, claim="complex", faces=faces, demands="allow-unused")
        if own:
            assert not circumspect.check(mesh, claim="complex", demands="faces allow-unused")


def test_what_is_judged_is_no_memory_of_others(monkeypatch):
    mesh = with_faces(mesh_of(POINTS[:4], np.array([[0, 1, 2, 3]]), np.full((1, 4), -1), np.ones(4)), np.array([[0, 1, 2]]))
    for faces in (mesh, with_faces(mesh, np.array([[0, 1]]))):
        for own, copied in zip(faces.parts()[1:], guarded(faces).parts()[1:]):
            assert own is copied is None or np.array_equal(own, copied) and not np.shares_memory(own, copied)
    judged = []
    monkeypatch.setattr(circumspect, "guarded", lambda mesh: judged.append(mesh) or guarded(mesh))
    for copy_of_it in (True, False):
        circumspect.check(POINTS[:4], [[0, 1, 2, 3]], copy=copy_of_it)
        assert len(judged) == 1


def test_an_option_of_two_functions_has_one_default():
    defaults = [inspect.signature(function).parameters for function in (circumspect.check, circumspect.check_voronoi)]
    assert {name for name in defaults[0].keys() & defaults[1] if defaults[0][name].default != defaults[1][name].default} == {"within", "name"}
