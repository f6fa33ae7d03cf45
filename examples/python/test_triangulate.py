"""A triangulator under test, by pytest and Hypothesis: pytest test_triangulate.py"""
import numpy as np
import pytest
import scipy.spatial
from hypothesis import given, settings

import circumspect
from circumspect import strategies


def triangulate(points):
    """SciPy's triangulation in single precision, as one makes it who wants to save memory."""
    return scipy.spatial.Delaunay(points.astype(np.float32)).simplices


def test_random_points(assert_delaunay):
    points = np.random.default_rng(1).random((1000, 2)).astype(np.float32)
    assert_delaunay(points, triangulate(points))


@pytest.mark.xfail(reason="the points are rounded", strict=True)
@settings(deadline=None, derandomize=True)
@given(strategies.points(families=["uniform", "sphere"], dimension=2, min_points=4))
def test_any_points(points):
    circumspect.assert_delaunay(points, triangulate(points))


@pytest.mark.xfail(reason="the points are rounded", strict=True)
def test_hunt(circumspect_campaign):
    circumspect_campaign(triangulate, dimension=2, refuses=(scipy.spatial.QhullError,))
