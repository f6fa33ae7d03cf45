"""Which part of a domain is filled, and which of its polygons are joined, as in the command. Run by pytest."""
import pathlib
import subprocess
import types
from fractions import Fraction

import numpy as np
import pytest

import circumspect
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
