"""Hulls, surfaces, Voronoi diagrams and predicates in Python."""
import decimal
from fractions import Fraction

import numpy as np
import pytest
import scipy.spatial

import circumspect

SQUARE = [[0, 0], [4, 0], [4, 4], [0, 4], [2, 0]]
POINTS = np.random.default_rng(1).random((200, 3))


def test_a_hull_of_scipy_is_judged_as_one():
    hull = scipy.spatial.ConvexHull(POINTS)
    verdict = circumspect.check(hull)
    assert verdict and verdict.claim == "convex-hull"
    assert not circumspect.check(POINTS, hull.simplices[1:], "convex-hull")
    plane = scipy.spatial.ConvexHull(POINTS[:, :2])
    assert circumspect.check(POINTS[:, :2], plane.vertices, "convex-hull")


def test_demands_are_named_as_the_options_of_the_command():
    cycle = [0, 1, 2, 3]
    assert circumspect.check(SQUARE, cycle, "convex-hull", demands=["only-extreme"])
    assert circumspect.check(SQUARE, cycle, "convex-hull", demands="all-boundary-points").rules == {"hull.boundary-point-left-out": 1}
    with pytest.raises(ValueError, match="expected demands of the claim delaunay, which has none"):
        circumspect.check(SQUARE[:3], [[0, 1, 2]], demands=["closed"])


def test_what_is_listed_beside_simplices_is_to_be_their_faces():
    points, cells = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]], [[0, 1, 2, 3], [1, 2, 3, 4]]
    assert circumspect.check(points, cells, "complex", faces=[[0, 1, 2], [4, 2, 3]])
    verdict = circumspect.check(points, cells, "complex", faces=[[0, 1, 2], [4, 2, 0]])
    assert verdict.rules == {"complex.stray-face": 1} and "index among the listed triangles: 1" in verdict.text
    assert circumspect.check(points, cells, "complex", faces=[[0, 1], [0, 4]]).rules == {"complex.stray-face": 1}
    with pytest.raises(circumspect.InputError, match="listed beside the simplices for --faces .*, found none"):
        circumspect.check(points, cells, "complex", demands=["faces"])
    with pytest.raises(circumspect.InputError, match="found none"):
        circumspect.check(points, cells, "complex", faces=[])
    with pytest.raises(ValueError, match="triangles or edges as faces, found faces of 4 vertices"):
        circumspect.check(points, cells, "complex", faces=cells)
    with pytest.raises(ValueError, match="the claim complex or a domain beside faces, found delaunay"):
        circumspect.check(points, cells, faces=[[0, 1, 2]])


def test_a_surface():
    points = [[0, 0, 0], [4, 0, 0], [2, 1, 0], [2, 0, 1]]
    assert circumspect.check(points, [[0, 1, 2], [1, 0, 3]], "surface-delaunay").rules == {"surface.edge-not-delaunay": 1}
    assert circumspect.check(points, [[2, 3, 0], [3, 2, 1]], "surface-delaunay")


@pytest.mark.parametrize("dimension", [2, 3])
def test_a_diagram_of_scipy_is_right_within_rounding(dimension):
    diagram = scipy.spatial.Voronoi(POINTS[:30 if dimension == 2 else 9, :dimension])
    assert circumspect.check_voronoi(diagram, within=1e-9)
    assert circumspect.check_voronoi(diagram, within=1e-9, structure=True).holds
    listed = diagram.ridge_vertices
    large = next(i for i, ends in enumerate(listed) if len(ends) > dimension - 1 and -1 not in ends)
    diagram.ridge_vertices = [ends[1:] if i == large else ends for i, ends in enumerate(listed)]
    assert "voronoi.ridge-differs" in circumspect.check_voronoi(diagram, within=1e-9, structure=True).rules
    diagram.ridge_vertices = listed
    with pytest.raises(ValueError, match="expected ridge_vertices beside structure, found none"):
        circumspect.check_voronoi(diagram.points, diagram.vertices, [diagram.regions[i] for i in diagram.point_region],
                                  diagram.ridge_points, within=1e-9, structure=True)
    assert not circumspect.check_voronoi(diagram)
    diagram.vertices[3] += 0.5
    assert not circumspect.check_voronoi(diagram, within=1e-9)


@pytest.mark.parametrize("dimension", [2, 3])
def test_a_cell_without_a_corner_is_missing(dimension):
    sites, parts = 8 * np.eye(2, dimension), {"cells": [[-1], [-1]], "ridges": [[0, 1]], "ridge_vertices": [[-1]], "structure": True}
    assert circumspect.check_voronoi(sites, [], **parts).rules == {"voronoi.cell-missing": 2}
    assert len(circumspect.check_voronoi(sites, np.zeros((1, dimension)), **parts).rules) == 2


def test_a_diagram_without_sites_or_ridges():
    with pytest.raises(ValueError, match="expected a cell for each of 0 sites, found 1"):
        circumspect.check_voronoi([], [], [[]])
    cells = [[0, 1, 4, 3], [1, 2, 5, 4]]
    grid = [[x, y] for y in (0, 2) for x in (0, 2, 4)]
    for ridges in ((), np.zeros((0, 2))):
        assert circumspect.check_voronoi([[1, 1], [3, 1]], grid, cells, ridges, box=[[0, 0], [4, 2]])


def test_what_is_no_diagram_is_refused():
    with pytest.raises(ValueError, match="expected a cell for each of 5 sites, found 1"):
        circumspect.check_voronoi(SQUARE, [[2, 2]], [[0]])
    for cells in ({}, {"cells": [[0]] * 5}, {"vertices": [[2, 2]]}):
        with pytest.raises(TypeError, match="expected vertices and cells beside sites"):
            circumspect.check_voronoi(SQUARE, **cells)
    with pytest.raises(ValueError, match=r"expected vertices of shape \(n, 2\), found \(1, 3\)"):
        circumspect.check_voronoi(SQUARE, [[2, 2, 0]], [[0]] * 5)
    with pytest.raises(ValueError, match="expected the vertices of each of 2 ridges, found 1"):
        circumspect.check_voronoi(SQUARE, [[2, 2]], [[0]] * 5, [[0, 1], [1, 2]], [[0]])
    with pytest.raises(TypeError, match="expected doubles as sites"):
        circumspect.check_voronoi([[Fraction(1, 3), 0]], [[0, 0]], [[0]])


def test_a_mesh_that_repeats():
    cells, offsets = [[0, 0, 0], [0, 0, 0]], [[[0, 0], [1, 0], [1, 1]], [[0, 0], [1, 1], [0, 1]]]
    judged = lambda **how: circumspect.check([[0.25, 0.5]], cells, "periodic-delaunay", **how)
    for kind in (np.int64, np.int8, np.int32, np.uint16, np.uint64):
        assert judged(lattice=[1, 1], offsets=np.array(offsets, kind))
    with pytest.raises(TypeError, match="expected integers as offsets, found an array of float64"):
        judged(lattice=[1, 1], offsets=np.array(offsets) + 0.5)
    assert judged(lattice=[[1, 0], [0, 1]], offsets=np.array(offsets)).claim == "periodic-delaunay"
    assert judged(lattice=[[1, 0], [1, 1]], offsets=offsets).rules == {"delaunay.facet-not-local": 1}
    with pytest.raises(ValueError, match="expected no neighbors beside the claim periodic-delaunay"):
        judged(lattice=[1, 1], offsets=offsets, neighbors=[[1, 1, 1], [0, 0, 0]])
    with pytest.raises(ValueError, match="linearly dependent"):
        judged(lattice=[[1, 2], [2, 4]], offsets=offsets)
    with pytest.raises(ValueError, match="expected lattice and offsets beside the claim periodic-delaunay"):
        judged(lattice=[1, 1])
    with pytest.raises(ValueError, match="expected 2 vectors as a lattice, found 1"):
        judged(lattice=[[1, 0]], offsets=offsets)
    with pytest.raises(ValueError, match=r"expected offsets of shape \(2, 3, 2\), found \(2, 3\)"):
        judged(lattice=[1, 1], offsets=cells)
    with pytest.raises(ValueError, match="expected the claim periodic-delaunay beside lattice, found delaunay"):
        circumspect.check([[0, 0], [1, 0], [0, 1]], [[0, 1, 2]], "delaunay", lattice=[1, 1])


# Numbers that are large, small, not dyadic or on a grid; and of types that are not plain numbers.
PLAIN = [0, 1, 2, 3, 0.5, 0.1, 1 / 3, 2**53, -2**53, 2.0**60, 1e-300, np.float64(0.1)]
OTHERS = [2**53 + 1, Fraction(1, 3), decimal.Decimal("0.1"), np.float32(0.1), np.int64(2)]


@pytest.mark.parametrize("seed", range(40))
def test_predicates_of_plain_numbers_are_those_of_arrays(seed):
    random = np.random.default_rng(seed)
    dimension = int(random.integers(1, 5))
    choice = PLAIN if seed % 2 else PLAIN[:6] + OTHERS
    for predicate, count in ((circumspect.orient, dimension + 1), (circumspect.in_ball, dimension + 2)):
        points = [tuple(choice[i] for i in random.integers(0, len(choice), dimension)) for _ in range(count)]
        as_exact = [[Fraction(x if isinstance(x, (int, float, Fraction, decimal.Decimal)) else x.item()) for x in p] for p in points]
        answers = []
        for given in (points, [list(point) for point in points], as_exact):
            try:
                answers.append(predicate(*given))
            except circumspect.InputError:  # points of a flat
                answers.append("flat")
        assert answers[0] == answers[1] == answers[2], (predicate, points)


@pytest.mark.parametrize("points, error", [
    ([(0, 0), (1, 0)], ValueError), ([(0, 0), (1, 0), (0, 1), (1, 1)], ValueError), ([], ValueError), ([(), ()], ValueError),
    ([(0, 0), (1, 0), (0, float("nan"))], ValueError), ([(0, 0), (1, 0), (0, 1, 2)], ValueError),
    ([(0, 0), (1, 0), (0, True)], None), ([(0, 0), (1, 0), (0, "1")], TypeError), ([(0, 0), (1, 0), "ab"], (TypeError, ValueError)),
])
def test_points_that_make_no_sense_to_a_predicate(points, error):
    if error is None:
        assert circumspect.orient(*points) == 1
        return
    with pytest.raises(error):
        circumspect.orient(*points)
