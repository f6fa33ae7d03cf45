"""Campaigns, Hypothesis strategies and the pytest plugin of the package circumspect. Run by pytest."""
import importlib.metadata
import os
import time
import types

import numpy as np
import pytest

import circumspect

pytest_plugins = ["pytester"]


def test_a_campaign_finds_each_kind_of_mistake(tmp_path):
    def answer(points):
        if len(points) == 6:
            raise RuntimeError("six")
        if len(points) == 7:
            return "rubbish"
        if len(points) == 8:
            return [[0, 1, 2], [0, 1]]
        return [[0, 1, 2]]

    found = circumspect.campaign(answer, dimension=2, cases=200, save=tmp_path / "kept")
    rules = {finding.rule: finding for finding in found.findings}
    assert not found and {"raised", "no-mesh", "triangulation.unused-point"} <= set(rules)
    assert "RuntimeError: six" in rules["raised"].report and len(rules["raised"].points) == 6
    assert len(rules["triangulation.unused-point"].points) == 4
    assert len(list((tmp_path / "kept").glob("*.npy"))) == len(found.findings)
    with pytest.raises(AssertionError, match="six"):
        found.raise_for_failure()
    assert circumspect.campaign(lambda points: circumspect.delaunay(points), dimension=2, cases=50)
    again = circumspect.campaign(answer, dimension=2, cases=200)
    assert [finding.rule for finding in again.findings] == [finding.rule for finding in found.findings]
    unused = rules["triangulation.unused-point"]
    assert unused.rule in unused.report and np.array_equal(unused.simplices, [[0, 1, 2]])
    small = circumspect.minimize(answer, rules["raised"].original)
    assert small.rule == "raised" and len(small.points) == 6
    with pytest.raises(ValueError, match="it is right on them"):
        circumspect.minimize(lambda points: [[0, 1, 2]], [[0, 0], [1, 0], [0, 1]])
    assert circumspect.campaign(answer, dimension=2, cases=60, refuses=(RuntimeError,)).findings[0].rule != "raised"
    with pytest.raises(TypeError, match="expected a function"):
        circumspect.campaign(7)
    with pytest.raises(ValueError, match="found 'nowhere'"):
        circumspect.campaign(answer, families=["nowhere"])


def test_points_that_span_less_are_smaller_unless_they_are_not_wanted():
    square = [[0, 0], [1, 0], [0, 1], [1, 1]]
    assert len(circumspect.minimize(lambda points: 1 / 0, square).points) < 3
    assert len(circumspect.minimize(lambda points: 1 / 0, square, flat=False).points) == 3


def test_a_campaign_survives_crashes_and_hangs():
    def answer(points):
        if len(points) == 19:
            os.kill(os.getpid(), 11)
        if len(points) == 15:
            time.sleep(60)
        return circumspect.delaunay(points)

    found = circumspect.campaign(answer, dimension=2, cases=4, isolated=True, time_limit=0.5, time=1,
                                 families=["integers"])
    reports = {finding.rule: finding.report for finding in found.findings}
    assert "signal 11" in reports["crash"] and "0.5 s" in reports["hang"]
    ended = circumspect.minimize(lambda points: os._exit(3), [[0, 0], [1, 0], [0, 1]], isolated=True, time=0.1)
    assert (ended.rule, ended.report) == ("crash", "the process ended by exit code 3")


def test_a_campaign_is_quick():
    start = time.monotonic()
    found = circumspect.campaign(lambda points: circumspect.delaunay(points), dimension=2, points=8, cases=300)
    assert found.cases == 300 and time.monotonic() - start < 10


def test_weighted_campaign():
    found = circumspect.campaign(lambda points, weights: circumspect.delaunay(points, weights), dimension=2,
                                 claim="weighted-delaunay", cases=40)
    assert found and found.cases == 40
    wrong = circumspect.campaign(lambda points, weights: circumspect.delaunay(points), dimension=2,
                                 claim="weighted-delaunay", cases=60)
    assert wrong.findings[0].weights is not None


def test_a_campaign_on_domains(tmp_path):
    def right(domain):
        built = circumspect.constrained_delaunay(domain)
        assert domain.points.shape[1] == domain.dimension and len(domain.holes) < 20
        return built

    refuses = (circumspect.NoTriangulation,)
    for dimension in (2, 3):
        found = circumspect.campaign(right, domains=True, dimension=dimension, cases=20, refuses=refuses)
        assert found and found.cases == 20, str(found)
    flat = {"families": ["scattered-cells"], "points": 4, "cases": 150}  # whose hulls nothing fills are left out
    assert circumspect.campaign(right, domains=True, refuses=refuses, **flat)

    def careless(domain):
        return right(domain).simplices[1:]

    found = circumspect.campaign(careless, domains=True, families=["planar-segments"], dimension=2, cases=30,
                                 save=tmp_path)
    assert not found
    finding = found.findings[0]
    assert finding.domain.dimension == 2 and len(finding.domain.points) <= 4 and finding.family == "planar-segments"
    assert finding.rule in finding.report and finding.domain.size() in str(finding)
    original = circumspect.generate_domain(finding.family, points=20, seed=finding.seed)
    assert (original.points == finding.original.points).all() and len(finding.original.segments) == len(original.segments)
    assert {path.suffix for path in tmp_path.iterdir()} == {".npy", ".txt", ".poly"}
    again = circumspect.minimize(careless, finding.original)
    assert again.rule == finding.rule and len(again.points) == len(finding.points)
    in_process = circumspect.campaign(careless, domains=True, families=["planar-segments"], dimension=2, cases=30,
                                      isolated=True)
    assert [one.rule for one in in_process.findings] == [one.rule for one in found.findings]


def test_what_functions_make_of_domains():
    square = circumspect.Domain([[0, 0], [2, 0], [2, 2], [0, 2]], [[0, 1], [1, 2], [2, 3], [3, 0]])
    fan = [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]]
    centre = np.vstack([square.points, [[1, 1]]])

    def holds(made, claim="steiner-cdt", **options):
        with pytest.raises(ValueError, match="found that it is right"):
            circumspect.minimize(lambda domain: made, square, claim=claim, **options)

    holds((centre, fan))
    holds(types.SimpleNamespace(points=np.column_stack([centre, np.zeros(5)]), cells_dict={"triangle": fan}))
    holds([[0, 1, 2], [0, 2, 3]], "conforming-delaunay")
    holds((centre + [[0, 1e-13], [0, 0], [0, 0], [0, 0], [0, 0]], fan), within=1e-9)
    for made, rule in (((centre, []), "triangulation.unused-point"), ((centre[:, :1], fan), "no-mesh"), ((centre, "fan"), "no-mesh"), (None, "no-mesh"),
                       (np.zeros((2, 3)), "no-mesh"), (([[0.5]], fan), "no-mesh")):
        assert circumspect.minimize(lambda domain, made=made: made, square, claim="steiner-cdt").rule == rule
    crossing = circumspect.Domain(square.points, [[0, 2], [1, 3]])
    with pytest.raises(circumspect.InputError, match="plc.crossing-segments"):
        circumspect.minimize(lambda domain: 1 / 0, crossing)
    for options, message in (({"claim": "delaunay"}, "expected the claim plc-triangulation"),
                             ({"families": ["sphere"]}, "a family of domains, found 'sphere'"),
                             ({"families": ["planar-grid"], "dimension": 3}, "planar-grid exists in dimension 2; expected such a dimension, found 3"),
                             ({"dimension": 4}, "of the plane or of space"), ({"within": -1}, "at least 0")):
        with pytest.raises(ValueError, match=message):
            circumspect.campaign(lambda domain: [], domains=True, cases=1, **options)
    with pytest.raises(ValueError, match="domains beside within"):
        circumspect.campaign(lambda points: [], cases=1, within=1)


def test_plugin(pytester):
    pytester.makepyfile("""
        def test_right(assert_delaunay):
            assert_delaunay([[0, 0], [1, 0], [0, 1]], [[0, 1, 2]])
        def test_wrong(assert_delaunay):
            assert_delaunay([[0, 0], [1, 0], [0, 1], [0.9, 0.9]], [[0, 1, 2], [1, 3, 2]])
        def test_hunt(circumspect_campaign):
            circumspect_campaign(lambda points: [[0, 1, 2]], dimension=2)
    """)
    # An installed package registers its plugin by itself.
    is_registered = "circumspect" in {point.name for point in importlib.metadata.entry_points(group="pytest11")}
    by_name = () if is_registered else ("-p", "circumspect.pytest_plugin")
    result = pytester.runpytest_subprocess(*by_name, "--circumspect-time=0.2")
    result.assert_outcomes(passed=1, failed=2)
    result.stdout.fnmatch_lines(["*vertex   3 at (0.9, 0.9)*", "*triangulation.unused-point on 4 points*"])
    assert list((pytester.path / ".circumspect").rglob("*.npy"))


def test_hypothesis_shrinks():
    hypothesis = pytest.importorskip("hypothesis")
    from circumspect import strategies

    seen = []

    @hypothesis.settings(max_examples=60, deadline=None, database=None, derandomize=True)
    @hypothesis.given(strategies.points(dimension=2, max_points=10))
    def drop_one(points):
        made = circumspect.delaunay(points)
        assert circumspect.inspect(points)["dimension"] == 2
        seen.append(points)
        if len(made) > 1:
            circumspect.assert_delaunay(points, made[1:])

    with pytest.raises(AssertionError):
        drop_one()
    assert len(seen[-1]) == 4

    @hypothesis.settings(max_examples=15, deadline=None, database=None)
    @hypothesis.given(strategies.domains(dimension=2), strategies.points(families=["grid"], dimension=3, flat=True))
    def right(domain, points):
        assert domain.dimension == 2 and points.shape[1] == 3
        circumspect.check(np.zeros((0, 2)), [], domain=domain, allow_empty=True)  # which refuses anything but a domain
        circumspect.assert_delaunay(points, circumspect.delaunay(points))

    right()
    drawn = set()

    @hypothesis.settings(max_examples=10, deadline=None, database=None, derandomize=True)
    @hypothesis.given(strategies.domains(dimension=2, families=["planar-segments"], max_points=4))
    def of_many_seeds(domain):
        drawn.update(map(tuple, domain.points.tolist()))

    of_many_seeds()
    assert drawn - {*map(tuple, circumspect.generate_domain("planar-segments", points=4).points.tolist())}

    @hypothesis.settings(max_examples=60, deadline=None, database=None, derandomize=True)
    @hypothesis.given(strategies.domains(dimension=3, families=["furnished-boxes"]))
    def few_polygons(domain):
        circumspect.check(np.zeros((0, 3)), [], domain=domain, allow_empty=True)
        seen.append(domain)
        assert len(domain.polygons) < 3

    with pytest.raises(AssertionError):
        few_polygons()
    assert len(seen[-1].polygons) == 3 and len(seen[-1].points) < 12

    for call in (lambda: strategies.points(families=["nothing"]), lambda: strategies.points(min_points=9, max_points=3),
                 lambda: strategies.domains(families=["sphere"])):
        with pytest.raises(ValueError, match="expected"):
            call()


def test_numbers_that_no_campaign_can_use():
    points = [[0, 0], [1, 0], [0, 1]]
    for refused, message in ((lambda: circumspect.generate("grid", seed=-1), "integer from 0 to 18446744073709551615, found -1"),
                             (lambda: circumspect.generate("grid", points=-1), "integer from 0 to .*, found -1"),
                             (lambda: circumspect.generate("grid", dimension=2 + 2**32), "dimension, found 4294967298"),
                             (lambda: circumspect.generate_domain("planar-grid", seed=2**64), "found 18446744073709551616"),
                             (lambda: circumspect.campaign(lambda points: [], seed=-1, cases=1), "found -1"),
                             (lambda: circumspect.check(points, [[0, 1, 2]], threads=2**32), "4096 threads, found 4294967296"),
                             (lambda: circumspect.campaign(lambda points: [], cases=1, exponents=(0, 1024)), "found .0, 1024."),
                             (lambda: circumspect.minimize(lambda points: [], [[10**400, 0], [1, 0]]), "within the range of double"),
                             (lambda: circumspect.minimize(lambda points, weights: [], points, weights=[0, 1]), "one weight a point, 3, found 2"),
                             (lambda: circumspect.minimize(lambda points, weights: [], points, weights=[0, 1, float("nan")]),
                              "finite weights, found nan")):
        with pytest.raises(ValueError, match=message):
            refused()
    assert circumspect.campaign(lambda points: circumspect.delaunay(points), cases=1, exponents=(0, 1023))
    with pytest.raises(circumspect.InputError, match="distinct points"):
        circumspect.minimize(lambda points: [], [*points, points[0]])
    with pytest.raises(TypeError, match="numbers as weights, found None"):
        circumspect.minimize(lambda points, weights: [], points, weights=[0, 1, None])
