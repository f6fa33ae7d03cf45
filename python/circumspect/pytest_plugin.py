"""The pytest plugin: the fixtures assert_delaunay and circumspect_campaign.

    def test_mesh(assert_delaunay):
        assert_delaunay(scipy.spatial.Delaunay(points))

    def test_hunt(circumspect_campaign):
        circumspect_campaign(my_triangulate, dimension=2)  # for --circumspect-time seconds
"""
import re
from pathlib import Path

import pytest


def pytest_addoption(parser):
    """The options of the plugin."""
    group = parser.getgroup("circumspect")
    group.addoption("--circumspect-time", type=float, default=2.0, metavar="SECONDS",
                    help="how long each campaign hunts (default: 2)")
    group.addoption("--circumspect-findings", default=".circumspect", metavar="FOLDER",
                    help="where findings are kept as files (default: .circumspect)")


@pytest.fixture
def assert_delaunay():
    """circumspect.assert_delaunay."""
    from circumspect import assert_delaunay as function

    return function


@pytest.fixture
def circumspect_campaign(request):
    """circumspect.campaign with the time of the command line; it fails the test if something is found."""
    from circumspect import campaign

    def hunt(function, **options):
        __tracebackhide__ = True  # pytest shows the caller's line
        options.setdefault("time", request.config.getoption("--circumspect-time"))
        name = re.sub(r"[^\w.-]+", "_", request.node.nodeid)
        folder = Path(request.config.getoption("--circumspect-findings")) / name
        found = campaign(function, **options)
        if found.findings:
            from circumspect.campaigns import save_findings

            save_findings(folder, found.findings)
            pytest.fail(f"{found}\nkept in {folder}", pytrace=False)
        return found

    return hunt
