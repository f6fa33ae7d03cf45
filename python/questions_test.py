"""Hulls, surfaces and Voronoi diagrams in Python."""
import fractions

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


def test_a_surface():
    points = [[0, 0, 0], [4, 0, 0], [2, 1, 0], [2, 0, 1]]
    assert circumspect.check(points, [[0, 1, 2], [1, 0, 3]], "surface-delaunay").rules == {"surface.edge-not-delaunay": 1}
    assert circumspect.check(points, [[2, 3, 0], [3, 2, 1]], "surface-delaunay")


@pytest.mark.parametrize("dimension", [2, 3])
def test_a_diagram_of_scipy_is_right_within_rounding(dimension):
    diagram = scipy.spatial.Voronoi(POINTS[:30 if dimension == 2 else 12, :dimension])
    assert circumspect.check_voronoi(diagram, within=1e-9)
    assert not circumspect.check_voronoi(diagram)
    diagram.vertices[3] += 0.5
    assert not circumspect.check_voronoi(diagram, within=1e-9)


def test_what_is_no_diagram_is_refused():
    with pytest.raises(ValueError, match="expected a cell for each of 5 sites, found 1"):
        circumspect.check_voronoi(SQUARE, [[2, 2]], [[0]])
    with pytest.raises(TypeError, match="expected vertices and cells beside sites"):
        circumspect.check_voronoi(SQUARE)
    with pytest.raises(TypeError, match="expected doubles as sites"):
        circumspect.check_voronoi([[fractions.Fraction(1, 3), 0]], [[0, 0]], [[0]])
