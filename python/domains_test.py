"""Domains of the package circumspect: judged, triangulated and drawn. Run by pytest."""
import pathlib
import subprocess
import types
from fractions import Fraction

import numpy as np
import pytest

import circumspect
from circumspect import _core

COMMAND = pathlib.Path(_core.__file__).resolve().parents[2] / "bin" / "circumspect"  # of the same build
SQUARE = {"vertices": [[0, 0], [1, 0], [1, 1], [0, 1]], "segments": [[0, 1], [1, 2], [2, 3], [3, 0]]}


def test_domains():
    halves = [[0, 1, 2], [0, 2, 3]]
    assert circumspect.check(SQUARE["vertices"], halves, domain=SQUARE).claim == "cdt"
    centre = SQUARE["vertices"] + [[0.5, 0.5]]
    fan = [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]]
    assert circumspect.check(centre, fan, domain=SQUARE).claim == "steiner-cdt"
    assert not circumspect.check(centre, fan, "cdt", domain=SQUARE)
    in_space = [[*point, 0.25] for point in SQUARE["vertices"]]
    assert circumspect.check(in_space, halves, domain=SQUARE)
    rounded = np.array(SQUARE["vertices"]) + [[0, 0], [1e-12, 0], [0, 0], [0, 0]]
    assert not circumspect.check(rounded, halves, domain=SQUARE)
    for within in (1e-9, "1e-9", Fraction(1, 10**9)):
        assert circumspect.check(rounded, halves, domain=SQUARE, within=within)
    # As many points as the domain, but other ones, in the command's words.
    moved = circumspect.check([[0, 0], [1, 0], [1, 1], [0, 1], [0.5, 0.5]], fan,
                              domain={**SQUARE, "vertices": [*SQUARE["vertices"], [0.5, 0.25]]})
    assert moved.claim == "steiner-cdt" and "domain.vertex-missing" in moved.rules
    with pytest.raises(ValueError, match="enclose nothing"):
        circumspect.check(SQUARE["vertices"], halves, domain={**SQUARE, "segments": [[0, 1]]})
    corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    tetrahedron = circumspect.Domain(corners, polygons=[[0, 1, 2], [0, 1, 3], [[0, 2, 3]], [1, 2, 3]])
    built = circumspect.constrained_delaunay(tetrahedron)
    assert built.simplices.shape == (1, 4) and not len(built.edges) and not len(built.vertices)
    assert circumspect.check(corners, built.simplices, domain=tetrahedron)
    surface = types.SimpleNamespace(vertices=np.array(corners), faces=np.array([[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]]))
    assert circumspect.check(corners, [[0, 1, 2, 3]], domain=surface)
    holed = circumspect.Domain(
        [*SQUARE["vertices"], [.25, .25], [.75, .25], [.5, .75]], [*SQUARE["segments"], [4, 5], [5, 6], [6, 4]],
        holes=[[.5, .5]])
    assert len(circumspect.constrained_delaunay(holed).simplices) == 7
    # A square hole through a cube: without the holes in its lid and floor, the shaft would be
    # filled.
    outer = [[x, y, z] for z in (0, 4) for x, y in ((0, 0), (4, 0), (4, 4), (0, 4))]
    inner = [[x, y, z] for z in (0, 4) for x, y in ((1, 1), (3, 1), (3, 3), (1, 3))]
    sides = [[s + i, s + (i + 1) % 4, s + (i + 1) % 4 + 4, s + i + 4] for s in (0, 8) for i in range(4)]
    lids = [[[0, 1, 2, 3], [8, 9, 10, 11]], [[4, 5, 6, 7], [12, 13, 14, 15]]]
    whole = {"points": outer + inner, "polygons": [*sides, *lids]}
    tube = {**whole, "polygon_holes": {8: [[2, 2, 0]], 9: [[2, 2, 4]]}}
    volumes = []
    for domain in (whole, tube):
        built = circumspect.constrained_delaunay(domain).simplices
        corners = np.array(outer + inner, dtype=float)[built]
        volumes.append(np.abs(np.linalg.det(corners[:, 1:] - corners[:, :1])).sum() / 6)
        assert circumspect.check(outer + inner, built, domain=domain)
    assert volumes == pytest.approx([64, 48])
    # Turned by exact numbers, so that neither the lids' planes nor the seeds in them have double
    # coordinates.
    third = Fraction(1, 3)
    turned = [[x + third * z, y - third * x, z + third * y] for x, y, z in outer + inner]
    seeds = {8: [[2, 2 - 2 * third, 2 * third]], 9: [[2 + 4 * third, 2 - 2 * third, 4 + 2 * third]]}
    exact = circumspect.Domain(turned, polygons=whole["polygons"], polygon_holes=seeds, holes=[[third, third, 100]])
    assert len(circumspect.constrained_delaunay(exact).simplices) == len(built)
    assert exact.polygon_holes[8][0].tolist() == seeds[8][0] and exact.holes[0][0] == third
    with pytest.raises(ValueError, match="whose points are doubles"):
        circumspect.minimize(lambda domain: [], exact)
    with pytest.raises(ValueError, match=r"holes of shape \(h, 3\), found \(1, 2\)"):
        circumspect.Domain(turned, holes=[[1, 1]])
    with pytest.raises(ValueError, match="one of 10 polygons, found 10"):
        circumspect.check(outer, [[0, 1, 2, 4]], domain={**whole, "polygon_holes": {10: [[2, 2, 0]]}})
    with pytest.raises(circumspect.InputError, match="plc.polygon-hole-seed"):
        circumspect.check(outer, [[0, 1, 2, 4]], domain={**whole, "polygon_holes": {8: [[2, 2, 1]]}})
    for seed in range(20):
        domain = circumspect.generate_domain("delaunay-polyhedra", seed=seed)
        built = circumspect.constrained_delaunay(domain)
        points = domain.points
        cells = types.SimpleNamespace(points=points, cells_dict={"tetra": built.simplices, "triangle": built.triangles,
                                                                 "line": built.edges})
        assert circumspect.check(cells, domain=domain)


def test_generated_domains_are_those_of_the_command():
    """Complete domains, with the holes of their polygons, which these families draw."""
    holes = 0
    for family in (family for family in circumspect.families() if family.is_of_domains):
        for seed in range(40 if family.name == "furnished-boxes" else 3):
            domain = circumspect.generate_domain(family.name, seed=seed)
            holes += sum(map(len, domain.polygon_holes.values()))
            if COMMAND.exists():
                drawn = subprocess.run([COMMAND, "generate", family.name, "--seed", str(seed)], capture_output=True,
                                       text=True, check=True).stdout
                assert drawn.startswith(_core.poly_text(domain.lists())), (family.name, seed)
            try:
                circumspect.check(np.zeros((0, family.dimensions[0])), [], domain=domain, allow_empty=True)
            except circumspect.InputError as error:
                raise AssertionError((family.name, seed)) from error
    assert holes > 5


def test_none_is_said():
    schoenhardt = [[10, 0, 0], [-5, 9, 0], [-5, -9, 0], [9, 5, 10], [-9, 5, 10], [0, -10, 10]]
    ends = [[0, 1, 2], [3, 4, 5]]
    inwards = [[0, 1, 4], [0, 4, 3], [1, 2, 5], [1, 4, 5], [0, 2, 3], [2, 3, 5]]
    outwards = [[0, 1, 3], [1, 4, 3], [1, 2, 4], [2, 5, 4], [2, 0, 5], [0, 3, 5]]
    with pytest.raises(circumspect.NoTriangulation, match="found none: it shows at"):
        circumspect.constrained_delaunay(circumspect.Domain(schoenhardt, polygons=ends + inwards))
    # Triangles on the sides of a cube whose diagonals are not the canonical ones.
    cube = [[x, y, z] for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
    quads = [[0, 1, 2, 3], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]
    halves = [half for a, b, c, d in quads for half in ([a, b, c], [a, c, d])]
    with pytest.raises(circumspect.NoTriangulation, match=r"it shows at \d+ \d+ \d+$"):
        circumspect.constrained_delaunay(circumspect.Domain(cube, polygons=halves))
    built = circumspect.constrained_delaunay(circumspect.Domain(schoenhardt, polygons=ends + outwards))
    assert circumspect.check(schoenhardt, built.simplices, domain={"points": schoenhardt, "polygons": ends + outwards})
