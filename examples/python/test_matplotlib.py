"""matplotlib's own triangulation under test, and a fault of it that Hypothesis finds: pytest test_matplotlib.py"""
import matplotlib.tri
import numpy as np
import pytest
from hypothesis import given, reject, settings

import circumspect
from circumspect import strategies


def test_a_grid(assert_delaunay):
    x, y = np.meshgrid(np.arange(20.0), np.arange(20.0))
    assert_delaunay(matplotlib.tri.Triangulation(x.ravel(), y.ravel()))


@pytest.mark.xfail(reason="triangles overlap where points are almost on one line", strict=True)
@settings(deadline=None, derandomize=True, max_examples=400)
@given(strategies.points(families=["box-boundary+ulp"], dimension=2, min_points=4, max_points=8))
def test_points_almost_on_a_line(points):
    try:
        mesh = matplotlib.tri.Triangulation(*points.T)
    except RuntimeError:
        reject()  # it may refuse what is almost flat
    verdict = circumspect.check(mesh)
    assert "complex.overlap" not in verdict.rules, f"{points.tolist()}\n{verdict}"
