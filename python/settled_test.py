"""What the package circumspect refuses unless an option allows it, what ends a long call, and who may write into an
array meanwhile. Run by pytest."""
import os
import subprocess
import sys
import time
import types

import numpy as np
import pytest

import circumspect
from circumspect import meshes

# A square of two triangles that share no vertex, as made by a mesher that forgets to share them.
TORN = [[0, 0], [1, 0], [1, 1], [0, 1], [0, 0], [1, 1]]
SEAM = [[0, 1, 2], [4, 5, 3]]
SQUARE = circumspect.Domain(TORN[:4], [[0, 1], [1, 2], [2, 3], [3, 0]])
# A mesh that takes minutes by definition: a fan of points in convex position.
LONG = np.array([[i, i * i] for i in range(2000)], dtype=float)
FAN = np.array([[0, i - 1, i] for i in range(2, 2000)])


def test_equal_points_are_refused_everywhere():
    refused = pytest.raises(circumspect.InputError, match="expected distinct points, found points 0 and 4 equal and 1 more")
    as_object = types.SimpleNamespace(points=np.array(TORN), cells_dict={"triangle": np.array(SEAM)})
    for ask in (lambda: circumspect.check(TORN, SEAM), lambda: circumspect.check(as_object),
                lambda: circumspect.check(TORN, SEAM, "triangulation"), lambda: circumspect.check(TORN, SEAM, by="definition"),
                lambda: circumspect.check(TORN, SEAM, "weighted-delaunay", weights=[0] * 6),
                lambda: circumspect.check(TORN, SEAM, domain=SQUARE),
                lambda: circumspect.check(TORN, SEAM, domain=SQUARE, within=1e-9),
                lambda: circumspect.assert_delaunay(TORN, SEAM), lambda: circumspect.compare((TORN, SEAM), (TORN, SEAM)),
                lambda: circumspect.certify(TORN, SEAM), lambda: circumspect.delaunay(TORN),
                lambda: circumspect.minimize(lambda points: [], TORN)):
        with refused:
            ask()
    with pytest.raises(circumspect.InputError, match="give duplicates=\"merge\""):
        circumspect.check(TORN, SEAM)
    with pytest.raises(ValueError, match="duplicates='merge', found 'yes'"):
        circumspect.check(TORN, SEAM, duplicates="yes")


def test_equal_points_are_merged_with_a_note():
    merged = circumspect.check(TORN, SEAM, duplicates="merge")
    note = "points 0 and 4 are equal and count as one; in all, 2 points repeat an earlier one"
    assert merged and merged.notes == [note] and merged.to_dict()["notes"] == [note]
    assert str(merged) == f"note: {note}\nholds: delaunay mesh 4 points 2 triangles not-unique canonical"
    assert note in merged.to_html() and "note: points" in merged._repr_html_()
    assert circumspect.assert_delaunay(TORN, SEAM, duplicates="merge").notes == [note]
    of_domain = circumspect.check(TORN, SEAM, domain=SQUARE, duplicates="merge")
    assert of_domain and of_domain.claim == "cdt" and of_domain.notes == [note]
    assert circumspect.check(TORN, SEAM, domain=SQUARE, duplicates="merge", within=1e-9).claim == "cdt"
    assert not circumspect.check(TORN[:4], [[0, 1, 2], [0, 2, 3]]).notes
    with pytest.raises(AssertionError, match="note: points 0 and 4 are equal"):
        circumspect.assert_delaunay(TORN, SEAM[:1], duplicates="merge")


def test_campaigns_see_equal_points():
    def torn(domain):
        built = circumspect.constrained_delaunay(domain).simplices
        corners = np.arange(built.size).reshape(built.shape)
        return np.vstack([domain.points, domain.points[built.ravel()]]), corners + len(domain.points)

    def whole(domain):
        return circumspect.constrained_delaunay(domain).simplices

    options = {"domains": True, "dimension": 2, "families": ["planar-grid"], "claim": "steiner-triangulation", "cases": 8}
    for isolated in (False, True):
        found = circumspect.campaign(torn, isolated=isolated, **options)
        told, = (finding for finding in found.findings if finding.rule == "other-points")
        assert "expected distinct points" in told.report
    # Merging the points of the torn mesh restores the original mesh.
    rules = [{finding.rule for finding in circumspect.campaign(function, **more, **options).findings}
             for function, more in ((torn, {"duplicates": "merge"}), (whole, {}))]
    assert rules[0] == rules[1] and "other-points" not in rules[0]
    # Families that repeat points need duplicates="merge".
    repeating = [family.name for family in circumspect.families() if family.repeats_points and 2 in family.dimensions]
    once = [circumspect.generate(name, dimension=2, points=12, seed=seed) for name in repeating for seed in range(5)]
    assert any(len(np.unique(points, axis=0)) < len(points) for points in once)

    def of_distinct(points):
        distinct, first = np.unique(points, axis=0, return_index=True)
        return first[circumspect.delaunay(distinct)]

    with pytest.raises(ValueError, match="duplicates='merge' beside the family"):
        circumspect.campaign(of_distinct, dimension=2, families=repeating[:1], cases=1)
    assert circumspect.campaign(of_distinct, dimension=2, families=repeating, cases=20, duplicates="merge")


def test_a_mesh_of_nothing_is_refused():
    nothing = (np.zeros((0, 3)), np.zeros((0, 4), int))
    as_object = types.SimpleNamespace(points=np.zeros((0, 3)), cells_dict=None)
    cube = circumspect.generate_domain("glued-tetrahedra", seed=1)
    for ask in (lambda: circumspect.check(*nothing), lambda: circumspect.check(as_object),
                lambda: circumspect.assert_delaunay(as_object), lambda: circumspect.check(*nothing, domain=cube),
                lambda: circumspect.compare(nothing, nothing), lambda: circumspect.certify(*nothing)):
        with pytest.raises(circumspect.InputError, match="found neither points nor simplices"):
            ask()
    with pytest.raises(circumspect.InputError, match="give allow_empty=True"):
        circumspect.check(*nothing)
    assert circumspect.check(*nothing, allow_empty=True)
    assert not circumspect.check(*nothing, domain=cube, allow_empty=True)
    # A mesher that makes nothing of an input is wrong; that is not a fault of the input.
    found = circumspect.campaign(lambda domain: nothing, domains=True, cases=3)
    assert found.findings and all(finding.rule.startswith("domain.") for finding in found.findings)


def run(*arguments):
    """python3 -m circumspect."""
    return subprocess.run([sys.executable, "-m", "circumspect", *map(str, arguments)], capture_output=True, text=True,
                          check=False)


def test_command(tmp_path):
    np.savez(tmp_path / "torn.npz", points=np.array(TORN), simplices=np.array(SEAM))
    refused = run("check", tmp_path / "torn.npz")
    assert refused.returncode == 3 and not refused.stdout and "torn.npz: expected distinct points" in refused.stderr
    assert "add --duplicates merge" in refused.stderr
    merged = run("check", tmp_path / "torn.npz", "--duplicates", "merge")
    assert merged.returncode == 0 and merged.stdout.startswith("holds") and "note: points 0 and 4" in merged.stderr
    np.savez(tmp_path / "none.npz", points=np.zeros((0, 2)), simplices=np.zeros((0, 3), int))
    refused = run("check", tmp_path / "none.npz")
    assert refused.returncode == 3 and "add --allow-empty" in refused.stderr
    assert run("check", tmp_path / "none.npz", "--allow-empty").returncode == 0
    np.savez(tmp_path / "long.npz", points=circumspect.generate("uniform", points=3000, dimension=6),
             simplices=np.arange(3000 - 6)[:, None] + np.arange(7))
    late = run("check", tmp_path / "long.npz", "--limit", "0.1")
    assert late.returncode == 4 and "within the time limit" in late.stderr and "long.npz" in late.stderr


def test_a_limit_ends_a_long_check():
    start = time.monotonic()
    with pytest.raises(circumspect.Undecided, match="within the time limit"):
        circumspect.check(LONG, FAN, "triangulation", by="definition", limit=0.2)
    assert time.monotonic() - start < 10
    assert circumspect.check(LONG, FAN, "triangulation", limit=60)
    for wrong in (0, -1, float("nan"), "1", True):
        with pytest.raises(ValueError, match="a limit of more than 0 seconds"):
            circumspect.check(LONG, FAN, limit=wrong)


@pytest.mark.parametrize("long_call", [
    "circumspect.check(LONG, FAN, 'triangulation', by='definition')",
    "circumspect.delaunay(MANY)",
    "circumspect.certify(HIGH, numpy.arange(20000 - 8)[:, None] + numpy.arange(8))"])
def test_an_interrupt_ends_a_long_call(long_call):
    program = (
        "import circumspect, numpy, os, signal, threading, time\n"
        "LONG = numpy.array([[i, i * i] for i in range(2000)], dtype=float)\n"
        "FAN = numpy.array([[0, i - 1, i] for i in range(2, 2000)])\n"
        "MANY = numpy.random.default_rng(1).random((150000, 3))\n"
        "HIGH = numpy.random.default_rng(1).random((20000, 7))\n"
        "threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()\n"
        "begin = time.monotonic()\n"
        f"try:\n    {long_call}\n"
        "except KeyboardInterrupt:\n    print('interrupted after', time.monotonic() - begin)\n"
        "print(circumspect.check([[0, 0], [1, 0], [0, 1]], [[0, 1, 2]]))\n")  # and the next call is a new one
    ran = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False, timeout=120)
    assert ran.returncode == 0 and ran.stdout.startswith("interrupted after"), (ran.stdout, ran.stderr)
    assert float(ran.stdout.split()[2]) < 20 and "holds" in ran.stdout


@pytest.mark.parametrize("call", ["circumspect.check(P, T)", "circumspect.check(LONG, FAN, 'triangulation', by='definition')",
                                  "circumspect.delaunay(P)", "circumspect.campaign(circumspect.delaunay, time=9)"])
def test_the_interpreter_ends_beside_calls(call):
    """With threads that nothing waits for."""
    program = (
        "import circumspect, atexit, numpy, threading, time\n"
        "atexit.register(lambda: print(circumspect.check([[0, 0], [1, 0], [0, 1]], [[0, 1, 2]])))\n"
        "P = circumspect.generate('uniform', points=300, dimension=3); T = circumspect.delaunay(P)\n"
        "LONG = numpy.array([[i, i * i] for i in range(2000)], dtype=float)\n"
        "FAN = numpy.array([[0, i - 1, i] for i in range(2, 2000)])\n"
        f"def work():\n    while True:\n        {call}\n"
        "for _ in range(4): threading.Thread(target=work, daemon=True).start()\n"
        "time.sleep(0.3)\n")
    for _ in range(1 if "CIRCUMSPECT_ONE_INPUT_IN" in os.environ else 3):
        start = time.monotonic()
        ran = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False, timeout=120)
        assert (ran.returncode, ran.stderr) == (0, "") and time.monotonic() - start < 30
        assert ran.stdout.startswith("holds")


def test_a_forked_process_ends_by_itself():
    """The child has none of the threads that make calls here, and does not wait for them."""
    program = (
        "import circumspect, numpy, os, sys, threading, time\n"
        "LONG = numpy.array([[i, i * i] for i in range(2000)], dtype=float)\n"
        "FAN = numpy.array([[0, i - 1, i] for i in range(2, 2000)])\n"
        "def work():\n    circumspect.check(LONG, FAN, 'triangulation', by='definition')\n"
        "threading.Thread(target=work, daemon=True).start()\n"
        "time.sleep(0.3)\n"
        "child = os.fork()\n"
        "if child == 0: sys.exit(0 if circumspect.check([[0, 0], [1, 0], [0, 1]], [[0, 1, 2]]) else 1)\n"
        "assert os.waitpid(child, 0)[1] == 0\n")
    ran = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False, timeout=60)
    assert ran.returncode == 0, ran.stderr


def test_other_threads_change_the_arrays():
    """A copy is judged: the verdict is about some state of the array, and the process survives."""
    program = (
        "import circumspect, numpy, scipy.spatial, threading\n"
        "points = numpy.random.default_rng(1).random((8_000, 2))\n"
        "simplices = scipy.spatial.Delaunay(points).simplices.copy()\n"
        "views, kept, ended = (points[:], simplices[:]), simplices.copy(), threading.Event()\n"
        "def disturb():\n"
        "    changes = numpy.random.default_rng(2)\n"
        "    while not ended.is_set():\n"
        "        rows = changes.integers(len(kept), size=1000)\n"
        "        views[1][rows] = changes.integers(-2**31, 2**31 - 1, (1000, 3))\n"
        "        views[1][rows] = kept[rows]\n"
        "threading.Thread(target=disturb, daemon=True).start()\n"
        "for _ in range(6): circumspect.check(points, simplices, 'triangulation', max_errors=1)\n"
        "ended.set()\n"
        "print('lives')\n")
    ran = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False, timeout=250)
    assert ran.returncode == 0 and ran.stdout == "lives\n", (ran.returncode, ran.stderr)


def test_what_is_copied():
    array = np.zeros((4, 2))
    for view in (array, array[:], array.reshape(-1)):
        assert not np.shares_memory(meshes.own_copy(view), array)
    read_only = array[:]
    read_only.flags.writeable = False
    assert not np.shares_memory(meshes.own_copy(read_only), array)  # others may write through `array`
    array.flags.writeable = False
    assert meshes.own_copy(array) is array and np.shares_memory(meshes.own_copy(array[1:]), array)
    assert meshes.own_copy(["1/3"]) == ["1/3"] and meshes.own_copy(None) is None
    assert circumspect.check([[0, 0], [1, 0], [0, 1]], [[0, 1, 2]], copy=False)
