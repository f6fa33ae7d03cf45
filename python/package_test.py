"""The package circumspect: what it accepts, what it refuses, and what it returns. Run by pytest."""
import decimal
import doctest
import importlib
import pathlib
import pickle
import re
import signal
import subprocess
import sys
import threading
import time
import types
import unittest
from fractions import Fraction

import numpy as np
import pytest

import circumspect

ROOT = pathlib.Path(__file__).resolve().parent.parent
COMMAND = pathlib.Path(circumspect._core.__file__).resolve().parents[2] / "bin" / "circumspect"  # of the same build
POINTS = np.array([[0, 0], [1, 0], [0, 1], [0.9, 0.9]])
RIGHT = np.array([[0, 1, 3], [0, 3, 2]], dtype=np.int32)
WRONG = np.array([[0, 1, 2], [1, 3, 2]], dtype=np.int32)


def scipy_mesh(count, dimension, seed=1):
    """SciPy's triangulation of random points."""
    spatial = pytest.importorskip("scipy.spatial")
    return spatial.Delaunay(np.random.default_rng(seed).random((count, dimension)))



@pytest.mark.parametrize("name", ["circumspect", "circumspect.domains", "circumspect.verdicts",
                                  "circumspect.campaigns"])
def test_docstrings(name):
    found = doctest.testmod(importlib.import_module(name), optionflags=doctest.ELLIPSIS)
    assert found.failed == 0 and found.attempted >= (1 if name != "circumspect.campaigns" else 2)


@pytest.mark.parametrize("page", ["python.md"])
def test_pages(page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    found = doctest.testfile(str(ROOT / "docs" / page), module_relative=False, optionflags=doctest.ELLIPSIS)
    assert found.failed == 0 and found.attempted > 20


def test_what_is_imported():
    """Who judges waits neither for NumPy, which a call imports, nor for what campaigns need."""
    seen = subprocess.run([sys.executable, "-c", "import sys, circumspect; print(*sys.modules)"], capture_output=True, text=True,
                          check=True).stdout.split()
    assert "circumspect.verdicts" in seen
    assert not {"numpy", "multiprocessing", "inspect", "circumspect.campaigns"} & set(seen)
    assert {"campaign", "minimize", "Campaign", "Finding"} <= set(dir(circumspect))
    assert circumspect.campaign.__module__ == "circumspect.campaigns"
    with pytest.raises(AttributeError, match="no attribute 'campain'"):
        circumspect.campain  # pylint: disable=pointless-statement


def test_one_module_for_all_pythons():
    name = pathlib.Path(circumspect._core.__file__).name
    assert name == "_core.abi3.so" or sys.version_info < (3, 11)


def test_a_verdict_and_its_parts():
    verdict = circumspect.check(POINTS, WRONG, name="mine")
    assert not verdict and verdict.rules == {"delaunay.facet-not-local": 1}
    violation, = verdict.violations
    assert violation.rule == "delaunay.facet-not-local" and violation.vertices == [3]
    assert violation.ball.centre == (Fraction(1, 2), Fraction(1, 2)) and violation.ball.squared_radius == Fraction(1, 2)
    distance = sum((Fraction(x) - c) ** 2 for x, c in zip(POINTS[3].tolist(), violation.ball.centre))
    assert distance < violation.ball.squared_radius
    assert verdict.unique is None and verdict.to_dict()["mesh"] == "mine"
    assert str(verdict).endswith("fails: delaunay mine delaunay.facet-not-local 1 face 1 2 vertex 3")
    assert "fails" in repr(verdict)
    with pytest.raises(circumspect.CheckFailed, match="vertex 3") as caught:
        verdict.raise_for_failure()
    assert str(caught.value) == str(verdict).rstrip() and caught.value.verdict is verdict and isinstance(caught.value, AssertionError)
    over = circumspect.check([[0, 0], [4, 0], [0, 4], [1, 1], [5, 1], [1, 5]], [[0, 1, 2], [3, 4, 5]], "triangulation").violations
    assert any(one.point is not None and len(one.point) == 2 for one in over) and repr(circumspect.compare((POINTS, RIGHT), (POINTS, RIGHT))) == "<Comparison same>"
    holds = circumspect.check(POINTS, RIGHT)
    assert holds.unique is True and holds.canonical is True and holds.raise_for_failure() is holds
    assert circumspect.check(POINTS, RIGHT, "triangulation").unique is None


def test_a_notebook_shows_the_pictures():
    verdict = circumspect.check(POINTS, WRONG, name="<script>alert('a')</script>")
    page = verdict.to_html()
    assert page.startswith("<!DOCTYPE html>") and "delaunay.facet-not-local" in page and "<script>alert" not in page
    shown = verdict._repr_html_()
    assert shown.index("<pre") < shown.index("<svg") and "<script" not in shown and "<circle" in shown
    assert shown.count("<polygon") == 1 and ">3</text>" in shown
    holds = circumspect.check(POINTS, RIGHT)
    assert "<pre" in holds._repr_html_() and "<svg" not in holds._repr_html_() and "holds" in holds.to_html()
    again = pickle.loads(pickle.dumps(verdict))
    assert str(again) == str(verdict) and again._repr_html_() == shown
    with pytest.raises(ValueError, match="one that was pickled"):
        again.to_html()
    in_five = circumspect.check(np.vstack([np.zeros(5), np.eye(5), np.ones((1, 5))]), [[0, 1, 2, 3, 4, 5]])
    assert not in_five and "<svg" not in in_five._repr_html_()


def test_what_a_notebook_keeps_is_small():
    cells = scipy_mesh(20, 3).simplices
    moved = np.random.default_rng(3).random((20, 3))
    many = circumspect.check(moved, cells, "complex", max_errors=0)
    assert sum(many.rules.values()) > 500 and len(many._repr_html_()) <= 60000
    assert 1 <= circumspect.check(moved, cells, "complex")._repr_html_().count("<svg") <= 3
    wide = circumspect.check(np.random.default_rng(4).random((60, 2)), [range(60)])  # a picture of 1,770 edges
    assert "simplex.wrong-dimension" in wide.rules and len(wide._repr_html_()) <= 60000
    near = circumspect.check([[0, 0], [1, 0], [1e-300, 1e-300], [0, 1]], [[0, 1, 2]], "triangulation")
    assert "nan" not in near._repr_html_() and "<svg" in near._repr_html_()


@pytest.mark.parametrize("points", [
    POINTS.astype(np.float32), np.asfortranarray(POINTS), POINTS.tolist(), POINTS.astype(">f8"), POINTS[::1, ::1],
    np.repeat(POINTS, 2, axis=0)[::2], POINTS.astype(object), POINTS.astype(np.longdouble), POINTS.astype(np.float16),
    [[Fraction(x) for x in row] for row in POINTS.tolist()], [[decimal.Decimal(x) for x in row] for row in POINTS.tolist()]])
@pytest.mark.parametrize("dtype", [np.int8, np.int32, np.int64, np.uint64, np.uint32, np.int16, ">i4", object, list])
def test_all_kinds_of_numbers_are_taken_exactly(points, dtype):
    def rows(simplices):
        return simplices.tolist() if dtype is list else np.asfortranarray(simplices).astype(dtype)

    assert circumspect.check(points, rows(RIGHT))
    assert circumspect.check(points, rows(WRONG)).rules == {"delaunay.facet-not-local": 1}


def test_nothing_is_rounded():
    third = Fraction(1, 3)
    on_circle = [[0, 0], [third, 0], [0, third], [third, third]]
    verdict = circumspect.check(on_circle, [[0, 1, 2], [1, 3, 2]])
    assert verdict and verdict.unique is False
    # 2^53 + 1 is not a double, and lies between the two others.
    middle = [[2**53, 0], [2**53 + 2, 0], [2**53 + 1, 0]]
    for points in (middle, np.array(middle), np.array(middle, dtype=np.uint64)):
        assert circumspect.check(points, [[0, 2], [2, 1]])
        assert not circumspect.check(points, [[0, 1]])
    assert circumspect.check([[10**30, 0.5], [0, 0], [0, 1]], [[0, 1, 2]])
    big = np.array([[2**53, 0], [2**53 + 2, 0]], dtype=np.longdouble)
    big = np.vstack([big, (big[:1] + big[1:]) / 2])
    assert circumspect.check(big, [[0, 2], [2, 1]])
    assert circumspect.orient((0, 0), (Fraction(1, 10), Fraction(1, 10)), (0.1, 0.1)) == 0
    assert circumspect.orient((0, 0), (Fraction(1, 10), 0.1), (1, 1)) != 0
    assert circumspect.in_ball((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1)) == 0


@pytest.mark.parametrize("arguments, error, message", [
    (([[0, 0], [1]], RIGHT), ValueError, "rows of one length, found a ragged list"),
    ((POINTS[:, 0], RIGHT), ValueError, r"points of shape \(n, d\), found \(4,\)"),
    ((POINTS, RIGHT[0]), ValueError, r"simplices of shape \(m, k\), found \(3,\)"),
    ((POINTS, RIGHT.astype(float)), TypeError, "integers as simplices, found an array of float64"),
    ((POINTS, RIGHT > 0), TypeError, "integers as simplices, found an array of bool"),
    ((POINTS > 0, RIGHT), TypeError, "numbers as points, found an array of bool"),
    ((POINTS * 1j, RIGHT), TypeError, "numbers as points, found an array of complex128"),
    (("mesh", None), TypeError, "a mesh as scipy.spatial.Delaunay"),
    ((POINTS, "mesh"), TypeError, "an array of simplices, found str"),
    ((object(), None), TypeError, "found object"),
    ((POINTS, None), TypeError, "expected simplices beside an array of points"),
    (([["a", "b"]], RIGHT), TypeError, "numbers as points"),
    (([[None, Fraction(1)]], RIGHT), TypeError, "numbers as points, found None"),
    (([[0, 0], [float("inf"), 0]], RIGHT), ValueError, r"finite points, found inf at \(1, 0\)"),
    (([[Fraction(1), float("nan")]], RIGHT), ValueError, "finite points, found nan"),
    (([[0, decimal.Decimal("inf")]], RIGHT), ValueError, "finite points"),
    ((POINTS, RIGHT, "delauney"), ValueError, "one of triangulation delaunay weighted-delaunay"),
    ((POINTS, RIGHT, "cdt"), ValueError, "a claim about a mesh without a domain"),
    ((POINTS, np.array([[2**63, 0, 1]], dtype=np.uint64)), ValueError, "of 64 bits"),
    ((POINTS, [[2**70, 0, 1]]), ValueError, "of 64 bits, found larger"),
    ((np.ma.masked_equal(POINTS, 0.9), RIGHT), ValueError, "without masked entries"),
    ((np.zeros((4, 0)), RIGHT), ValueError, "found \\(4, 0\\)"),
    ((np.zeros((2, 65)), RIGHT), ValueError, "a dimension from 1 to 64, found 65"),
])
def test_what_is_wrong_is_refused(arguments, error, message):
    with pytest.raises(error, match=message):
        circumspect.check(*arguments)


@pytest.mark.parametrize("options, error, message", [
    ({"neighbors": RIGHT[:1]}, ValueError, "neighbors of the shape of the simplices"),
    ({"weights": [1, 2]}, ValueError, "one weight a point, 4, found 2"),
    ({"weights": POINTS}, ValueError, r"weights of shape \(n,\)"),
    ({"threads": -1}, ValueError, "0 to 4096 threads, found -1"),
    ({"max_errors": -1}, ValueError, "a number of witnesses"),
    ({"by": "guess"}, ValueError, "by='lemma'"),
    ({"within": 1}, ValueError, "a domain beside within"),
    ({"require": "min-angle"}, ValueError, "min-angle:20.7deg"),
    ({"require": "volume:1"}, ValueError, "a measure of triangles"),
    ({"require": [20.7]}, TypeError, "texts such as 'min-angle:20.7deg' as require, found 20.7"),
    ({"except_sharp": "60deg"}, ValueError, "requirements beside `except_sharp`"),
    ({"domain": {"corners": []}}, ValueError, "a domain with the keys"),
    ({"domain": 7}, TypeError, "found int"),
    ({"domain": {"points": [[0, 0], [1, 1], [1, 0], [0, 1]], "segments": [[0, 1], [2, 3]]}}, circumspect.InputError,
     "plc.crossing-segments"),
    ({"domain": {"points": POINTS, "segments": [[0, 1], [1, 9]]}}, circumspect.InputError, "plc.index-out-of-range"),
])
def test_options_that_are_wrong_are_refused(options, error, message):
    with pytest.raises(error, match=message):
        circumspect.check(POINTS, RIGHT, **options)


def test_requirements():
    square = [[0, 0], [1, 0], [1, 1], [0, 1]]
    halves = [[0, 1, 2], [0, 2, 3]]
    assert circumspect.check(square, halves, require="min-angle:45deg")
    verdict = circumspect.check(square, halves, require=["min-angle:45deg", "max-angle <= 89deg"])
    assert not verdict and verdict.rules == {"quality.max-angle": 2}
    assert circumspect.check(square, halves, require="max-angle:89deg", except_sharp="91deg")
    with pytest.raises(AssertionError, match="measured 90deg, required max-angle <= 89deg"):
        circumspect.assert_delaunay(square, halves, require="max-angle:89deg")
    with pytest.raises(ValueError, match="nothing is proved of the shape of simplices"):
        circumspect.certify(square, halves, require="max-angle:89deg")


def test_indices_of_no_point_are_the_meshs_fault():
    for wrong in (4, -1, 2**40):
        assert circumspect.check(POINTS, [[0, 1, wrong]]).rules["triangulation.unknown-vertex"] == 1
    assert not circumspect.check(POINTS, [])
    assert not circumspect.check(POINTS, np.zeros((0, 3), int))
    assert circumspect.check(np.zeros((0, 2)), [], allow_empty=True)


def test_objects_of_other_libraries():
    mesh = scipy_mesh(300, 3)
    assert circumspect.check(mesh) and circumspect.check(mesh.points, mesh.simplices, neighbors=mesh.neighbors)
    changed = mesh.neighbors.copy()
    changed[0] = changed[0][::-1].copy()
    assert "complex.wrong-neighbor" in circumspect.check(mesh, neighbors=changed).rules
    tri = pytest.importorskip("matplotlib.tri")
    plane = scipy_mesh(50, 2)
    triangulation = tri.Triangulation(*plane.points.T)
    assert circumspect.check(triangulation)
    triangulation.set_mask([True] + [False] * (len(triangulation.triangles) - 1))
    assert not circumspect.check(triangulation)
    for mask, holds in (([False, True], True), ([True, False], False), (None, False)):  # the second is flat
        two = types.SimpleNamespace(x=[0, 1, 0], y=[0, 0, 1], triangles=[[0, 1, 2], [0, 0, 1]], mask=mask and np.array(mask))
        assert bool(circumspect.check(two)) is holds
    of_no_row = types.SimpleNamespace(points=plane.points, cells_dict={"tetra": np.zeros((0, 4), int), "triangle": plane.simplices})
    assert circumspect.check(of_no_row) and circumspect.compare(of_no_row, (plane.points, plane.simplices))
    cells = {"tetra": mesh.simplices, "triangle": mesh.convex_hull}
    assert circumspect.check(types.SimpleNamespace(points=mesh.points, cells_dict=cells))
    as_pyvista = types.SimpleNamespace(points=plane.points.astype(np.float32), cells_dict={5: plane.simplices})
    assert circumspect.check(as_pyvista, claim="triangulation").to_dict()["simplices"] == len(plane.simplices)
    flat = np.column_stack([plane.points, np.full(50, 0.1)])
    faces = np.column_stack([np.full(len(plane.simplices), 3), plane.simplices]).ravel()
    assert circumspect.check(types.SimpleNamespace(points=flat, faces=faces))
    assert circumspect.check(types.SimpleNamespace(vertices=flat, faces=plane.simplices))
    assert circumspect.check(types.SimpleNamespace(points=np.zeros((0, 3)), cells_dict=None), allow_empty=True)
    with pytest.raises(ValueError, match="found cells of type 'hexahedron'"):
        circumspect.check(types.SimpleNamespace(points=flat, cells_dict={"hexahedron": [[0] * 8]}))
    with pytest.raises(ValueError, match="a surface of triangles"):
        circumspect.check(types.SimpleNamespace(points=flat, faces=np.array([4, 0, 1, 2, 3])))


def test_data_sets_of_vtk():
    """A mesh of VTK itself; pyvista's meshes are of this type, too."""
    vtk = pytest.importorskip("vtk")  # 227 MB: no package of `make test`; debian/fresh_root_test.sh has it

    def filled(grid, points, rows, kinds, data_type=vtk.VTK_DOUBLE):
        held = vtk.vtkPoints()
        held.SetDataType(data_type)
        for point in points:
            held.InsertNextPoint(*point)
        grid.SetPoints(held)
        grid.Allocate()
        for kind, row in zip(kinds, rows):
            grid.InsertNextCell(kind, len(row), row)
        return grid

    points = circumspect.generate("uniform", points=60, seed=1)
    simplices = circumspect.delaunay(points).tolist()
    listed = filled(vtk.vtkUnstructuredGrid(), points, [*simplices, [0, 1, 2], [3, 4]],
                    [vtk.VTK_TETRA] * len(simplices) + [vtk.VTK_TRIANGLE, vtk.VTK_LINE])
    verdict = circumspect.check(listed)
    assert verdict and verdict.to_dict()["simplices"] == len(simplices) and verdict.to_dict()["points"] == len(points)
    for data_type in (vtk.VTK_DOUBLE, vtk.VTK_FLOAT):
        flat = filled(vtk.vtkPolyData(), np.column_stack([POINTS, np.zeros(4)]), WRONG.tolist(), [vtk.VTK_TRIANGLE] * 2, data_type)
        assert circumspect.check(flat).rules == {"delaunay.facet-not-local": 1}
    corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    surface = filled(vtk.vtkPolyData(), corners, [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]], [vtk.VTK_TRIANGLE] * 4)
    assert circumspect.check(corners, [[0, 1, 2, 3]], domain=surface)
    for empty in (vtk.vtkUnstructuredGrid(), vtk.vtkPolyData(), vtk.vtkImageData()):
        assert circumspect.check(empty, allow_empty=True).to_dict()["points"] == 0
    image = vtk.vtkImageData()
    image.SetDimensions(2, 2, 1)
    for other, found in ((image, "8 of VTK"), (filled(vtk.vtkPolyData(), corners, [[0, 1, 2, 3], [0, 1, 2]], [6, 6]), "6 of VTK"),
                         (filled(vtk.vtkUnstructuredGrid(), corners, [[0, 1, 2, 3]], [9]), "9 of VTK")):
        with pytest.raises(ValueError, match=f"found cells of type {found}"):
            circumspect.check(other)


def test_references_and_comparisons():
    points = circumspect.generate("grid", dimension=3, points=20, seed=3)
    built = circumspect.delaunay(points)
    verdict = circumspect.check(points, built)
    assert verdict and verdict.canonical
    order = np.random.default_rng(1).permutation(len(points))
    again = circumspect.delaunay(points[order])
    assert circumspect.compare((points, built), (points[order], again))
    difference = circumspect.compare((points, built), (points, built[1:]))
    assert not difference and len(difference.only_in_a["simplices"]) == 1 and "1 simplices only in a" in repr(difference)
    assert circumspect.compare(types.SimpleNamespace(points=points, simplices=built), (points, built))
    with pytest.raises(circumspect.InputError, match="distinct points, found points 0 and 2 equal"):
        circumspect.delaunay([[0, 0], [1, 0], [0, 0]])
    light = circumspect.delaunay([[0, 0], [4, 0], [0, 4], [1, 1]], weights=[0, 0, 0, -100])
    assert light.tolist() == [[0, 1, 2]]
    assert circumspect.check([[0, 0], [4, 0], [0, 4], [1, 1]], light, "weighted-delaunay", weights=[0, 0, 0, -100])
    facts = circumspect.inspect([[Fraction(1, 3), 0], [1, 0], [Fraction(1, 3), 0]])
    assert facts == {"points": 3, "dimension": 1, "repeated": [[0, 2]], "unique": True}
    assert circumspect.inspect(np.zeros((0, 3)))["dimension"] == -1
    assert "refutation" in circumspect.certify(POINTS, WRONG).split("\n")[0]


def test_points_of_another_shape_are_refused():
    for points in (np.zeros(6), np.zeros((3, 0)), np.zeros((3, 2, 1))):
        with pytest.raises(ValueError, match=re.escape(f"expected points of shape (n, d), found {points.shape}")):
            circumspect.check(points, [[0, 1, 2]])


def test_families():
    families = circumspect.families()
    assert {"sphere", "grid+ulp", "protected-solids"} <= {family.name for family in families}
    assert (circumspect.generate("sphere", seed=5) == circumspect.generate("sphere", seed=5)).all()
    exact = circumspect.generate("sphere", dimension=2, points=5, seed=5, exact=True)
    assert {sum(x * x for x in point) for point in exact} and isinstance(exact[0][0], Fraction)
    assert not any(family.weighted or family.repeats_points for family in families if family.is_of_domains)
    weighted = next(family for family in families if family.weighted)
    points, weights = circumspect.generate(weighted.name, dimension=weighted.dimensions[-1])
    assert len(points) == len(weights)
    with pytest.raises(ValueError, match="found 'spheer'"):
        circumspect.generate("spheer")
    with pytest.raises(ValueError, match="found 'sphere'"):
        circumspect.generate_domain("sphere")


def test_judging_lets_other_threads_go_on():
    mesh = scipy_mesh(30, 3)
    answers = []
    thread = threading.Thread(target=lambda: answers.append(bool(circumspect.check(mesh, by="definition"))))
    thread.start()
    steps = 0
    while thread.is_alive():
        steps += 1
        time.sleep(0.0005)
    assert answers == [True] and steps > 5


class TestUnittest(unittest.TestCase):
    """As in tests without pytest."""

    def test_assertion(self):
        circumspect.assert_delaunay(POINTS, RIGHT)
        with self.assertRaisesRegex(AssertionError, "vertex   3 at"):
            circumspect.assert_delaunay(POINTS, WRONG)


def run(*arguments):
    """python3 -m circumspect."""
    return subprocess.run([sys.executable, "-m", "circumspect", *map(str, arguments)], capture_output=True, text=True,
                          check=False)


@pytest.mark.parametrize("words, is_passed_on", [
    (["check", "x.ele"], True), (["campaign", "--", "x.cgns"], True), (["check", "x.npz"], True), (["--version"], True), ([], True),
    (["check", "x.ele", "y.cgns"], False), (["check", "--claim", "cdt", "x.med"], False),
])
def test_words_for_the_command(words, is_passed_on, monkeypatch):
    """What pip installs has the command in it, which gets all words but those about files that only meshio reads."""
    program = importlib.import_module("circumspect.__main__")
    monkeypatch.setattr(circumspect._core, "command", lambda given: given[1:] == words and 17, raising=False)
    monkeypatch.setattr(program, "judged_here", lambda given: given == words and 18)
    before = signal.getsignal(signal.SIGINT)
    try:
        assert program.main(words) == (17 if is_passed_on else 18)
        assert (signal.getsignal(signal.SIGINT) == signal.SIG_DFL) == is_passed_on  # as any program does
    finally:
        signal.signal(signal.SIGINT, before)
        signal.signal(signal.SIGPIPE, signal.SIG_IGN)


def test_files_of_meshio_alone():
    """What the command reads itself, exactly, does not go to meshio."""
    table = (ROOT / "oracle" / "formats" / "format_table.cpp").read_text(encoding="utf-8")
    read = {ending for row in re.findall(r"\.endings = \{([^}]*)\}", table) for ending in re.findall(r'"(\.[^"]+)"', row)}
    program = importlib.import_module("circumspect.__main__")
    assert {".ele", ".vtu"} <= read and not read & set(program.FILES_OF_MESHIO)


def test_command(tmp_path):
    np.savez(tmp_path / "right.npz", points=POINTS, simplices=RIGHT)
    np.savez(tmp_path / "wrong.npz", points=POINTS, simplices=WRONG)
    right = run("check", tmp_path / "right.npz")
    assert right.returncode == 0 and right.stdout.startswith("holds: delaunay") and "NumPy reads" in right.stderr
    wrong = run("check", tmp_path / "wrong.npz", "--format", "json")
    assert wrong.returncode == 1 and '"verdict": "fails"' in wrong.stdout
    (tmp_path / "bad.npz").write_bytes(b"PK rubbish")
    assert run("check", tmp_path / "bad.npz").returncode == 3
    assert run("check", tmp_path / "none.npz").returncode == 3
    assert run("chek").returncode == 2
    meshio = pytest.importorskip("meshio")
    meshio.write_points_cells(tmp_path / "x.vtu", np.column_stack([POINTS, np.zeros(4)]), [("triangle", RIGHT)])
    of_meshio = run("check", tmp_path / "x.vtu", tmp_path / "wrong.npz")
    assert of_meshio.returncode == 1 and "holds" in of_meshio.stdout and "meshio" in of_meshio.stderr
    assert circumspect.check(meshio.read(tmp_path / "x.vtu"))
    assert run("check", tmp_path / "absent.vtu").returncode == 3
    if COMMAND.exists():  # what `check --vtu` writes, meshio reads
        (tmp_path / "w.node").write_text("5 2\n0 0 0\n1 4 0\n2 5 5\n3 0 4\n4 2 1\n", encoding="utf-8")
        (tmp_path / "w.ele").write_text("4 3\n0 0 1 4\n1 1 2 4\n2 2 3 4\n3 3 0 2\n", encoding="utf-8")
        subprocess.run([COMMAND, "check", tmp_path / "w.ele", "--vtu", tmp_path / "bad.vtu"], check=False,
                       capture_output=True)
        bad = meshio.read(tmp_path / "bad.vtu")
        assert {"role", "rule", "violation"} == set(bad.cell_data) and {"index", "radius"} == set(bad.point_data)


def test_import_is_light():
    code = ("import time, sys; start = time.process_time(); import circumspect; "
            "assert not {'numpy', 'scipy', 'hypothesis', 'meshio'} & set(sys.modules); print(time.process_time() - start)")
    seconds = min(float(subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout)
                  for _ in range(3))
    assert seconds < 0.5  # 0.15 on a machine with nothing else to do
