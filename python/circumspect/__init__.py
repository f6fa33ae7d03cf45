"""The exact oracle for Delaunay triangulations.

>>> import circumspect
>>> points = [[0, 0], [1, 0], [0, 1], [0.9, 0.9]]
>>> bool(circumspect.check(points, [[0, 1, 3], [0, 3, 2]]))
True
>>> print(circumspect.check(points, [[0, 1, 2], [1, 3, 2]]))  # doctest: +ELLIPSIS
delaunay.facet-not-local: a facet is not locally Delaunay: ...
fails: delaunay mesh delaunay.facet-not-local 1 face 1 2 vertex 3

Nothing is rounded: coordinates are taken as exact numbers, and no tolerance affects a verdict.
"""
from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any, List, NamedTuple, Optional, Tuple

from . import _core
from ._core import InputError, NoTriangulation, Undecided
from .domains import Domain, domain_of, in_plane_of
from .hulls import claim_of, facets_of
from .meshes import (guarded, merges, mesh_of, number_text, numbers_of, points_of, requirements_of, seconds_of,
                     with_faces, without_coordinate)
from .periodic import periodic_of
from .voronoi import diagram_of, parts_of as diagram_parts
from .verdicts import Ball, CheckFailed, Comparison, Verdict, Violation

if TYPE_CHECKING:
    from .campaigns import Campaign, Finding, campaign, minimize

__version__: str = _core.version
__all__ = [
    "Ball", "Campaign", "CheckFailed", "Comparison", "Constrained", "Domain", "Family", "Finding", "InputError",
    "NoTriangulation", "Undecided", "Verdict", "Violation", "assert_delaunay", "campaign", "certify", "check", "check_voronoi",
    "compare", "constrained_delaunay", "delaunay", "families", "generate", "generate_domain", "in_ball", "inspect",
    "minimize", "orient",
]

# Claims about what is listed, which need not fill the hull of the points or a domain.
ABOUT_LISTS = ("complex", "convex-hull", "surface-delaunay", "periodic-delaunay")
OF_CAMPAIGNS = ("Campaign", "Finding", "campaign", "minimize")


def __getattr__(name: str) -> Any:
    """Who only judges does not wait for what hunts to be imported."""
    if name not in OF_CAMPAIGNS:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from . import campaigns

    globals().update((each, getattr(campaigns, each)) for each in OF_CAMPAIGNS)
    return globals()[name]


def __dir__() -> List[str]:
    return sorted({*globals(), *OF_CAMPAIGNS})


def check(points: Any, simplices: Any = None, claim: Optional[str] = None, *, neighbors: Any = None,
          weights: Any = None, domain: Any = None, within: Any = None, threads: int = 0, max_errors: int = 20,
          by: str = "lemma", oriented: bool = False, demands: Any = (), duplicates: str = "reject", allow_empty: bool = False,
          require: Any = (), except_sharp: Optional[str] = None, lattice: Any = None, offsets: Any = None, faces: Any = None, drop: Optional[str] = None, limit: Optional[float] = None, copy: bool = True,
          name: str = "mesh") -> Verdict:
    """Judges, exactly, a claim about a mesh.

    points: (n, d) floats, integers, or objects (Fraction, int, Decimal); or, without `simplices`, a mesh of
        scipy.spatial.Delaunay, matplotlib.tri.Triangulation, meshio, pyvista, trimesh or VTK.
    simplices: (m, d+1) integers from 0, in any order; (m, k+1) where the points span a flat of dimension k. An
        index that names no point is the mesh's fault, and the verdict says so.
    claim: "triangulation", "delaunay" (the default), "weighted-delaunay", "complex" (do the cells fit together,
        whatever they fill, be they full cells, a surface in space or edges?), "convex-hull" (are these the facets of
        the convex hull? in the plane also a list of vertices in their cyclic order), "surface-delaunay" (is a surface
        of triangles intrinsically Delaunay?), "periodic-delaunay" (are the cells, repeated by a lattice, Delaunay?);
        with a domain "plc-triangulation",
        "steiner-triangulation", "cdt", "steiner-cdt" or "conforming-delaunay" (the default is "cdt" if the mesh has the
        points of the domain, else "steiner-cdt").
    neighbors: (m, k) integers, the simplex opposite each vertex, -1 for none; judged too, of triangulations. Those of a
        SciPy mesh are judged by default.
    weights: (n,), for "weighted-delaunay".
    domain: a Domain, a dictionary of its parts, a surface of triangles, or polygons with holes: a text of WKT or
        GeoJSON, a dictionary of GeoJSON, or a geometry of shapely.
    within: how far cells of the domain may be moved, an exact number: rounded Steiner points need it.
    threads: 0 for as many as the machine has; the answer is the same. Other Python threads go on meanwhile.
    demands: names of what else is demanded, as the command's options: "manifold", "connected", "closed",
        "oriented=positive", "oriented=negative", "faces", "allow-hanging-vertex", "allow-unused" of "complex";
        "all-boundary-points", "only-extreme" of "convex-hull".
    duplicates: "reject", since a mesher that forgets to share vertices makes equal points: InputError. "merge":
        equal points count as one, the first (if weights count, the heaviest), and a note of the verdict says so.
    allow_empty: judge a mesh without points and simplices. Otherwise it is an InputError: usually a program made
        nothing.
    require: what is demanded of the shape of every simplex, a text such as "min-angle:20.7deg" or "radius-edge <=
        sqrt(2)", or a list of them; as `check --require` of the command.
    except_sharp: an angle such as "60deg"; simplices that touch both sides of a sharper one of the domain (without
        one, of the boundary of the mesh) are set aside.
    lattice, offsets: for "periodic-delaunay". (d, d) doubles, the vectors along which the mesh repeats, or d numbers, the
        edges of a box; and (m, d+1, d) integers, which multiples of them move the point of each corner there.
    faces: (f, 3) integers, triangles that are listed beside tetrahedra, or (f, 2), edges; instead of those of a mesh
        object. "complex" then demands that they are faces of the simplices. Of a mesh of a domain they are the
        triangles and edges that may dangle.
    drop: "x", "y" or "z": leaves out this coordinate of triangles or edges in space, so that a terrain is judged as it
        is seen from above ("z").
    limit: seconds after which Undecided is raised. Ctrl-C ends a long check, too.
    copy: False judges arrays of doubles and of 32 or 64 bit integers in C order in place. They must then not change
        before the call returns, or the verdict means nothing or the process crashes. Read-only arrays are never
        copied.

    Raises ValueError (InputError, if the input is at fault) and TypeError, which say what was expected and found; and
    Undecided.

    >>> bool(check([[0, 0], [4, 0], [0, 4]], [[0, 1, 2]]))
    True
    >>> check([[0, 0], [1, 0], [0, float("nan")]], [[0, 1, 2]])
    Traceback (most recent call last):
    ValueError: expected finite points, found nan at (2, 1)
    >>> check([[0, 0], [4, 0], [0, 4], [4, 4]], [[0, 1, 2], [1, 3, 2]], "complex", faces=[[0, 1], [0, 3]]).rules
    {'complex.stray-face': 1}
    >>> print(check([[0, 0], [4, 0], [0, 4]], [[0, 1, 2]], require=["min-angle:45deg", "max-angle:90deg"]))
    holds: delaunay mesh 3 points 1 triangle unique canonical min-angle:45deg max-angle:90deg
    >>> check([[0, 0], [1, 0], [0, 1]], [[0, 1, 2.0]])
    Traceback (most recent call last):
    TypeError: expected integers as simplices, found an array of float64
    """
    if by not in ("lemma", "definition"):
        raise ValueError(f"expected by='lemma' or by='definition', found {by!r}")
    merge = merges(duplicates)
    claim = claim or claim_of(points)
    if claim == "convex-hull":
        simplices = facets_of(simplices)
    mesh = mesh_of(points, simplices, neighbors, weights)
    if neighbors is None and claim in ABOUT_LISTS:  # what a SciPy object brings along
        mesh = mesh._replace(neighbors=None)
    words = demands if isinstance(demands, str) else " ".join(demands)
    if faces is not None:
        if claim != "complex" and domain is None:
            raise ValueError(f"expected the claim complex or a domain beside faces, found {claim or 'delaunay'}")
        mesh = with_faces(mesh, faces)
        words += " faces" if claim == "complex" else ""
    if drop is not None:
        mesh = without_coordinate(mesh, drop)
    about = None
    if domain is not None:
        filled = domain_of(domain)
        about = filled.parts()
        mesh = in_plane_of(mesh, filled)
    elif within is not None:
        raise ValueError("expected a domain beside within, found None")
    repeated = periodic_of(claim, mesh, lattice, offsets)
    distance = None if within is None else number_text(within, "a distance")
    return Verdict(_core.check(claim, (guarded(mesh) if copy else mesh).parts(), about, threads, max_errors,
                               by == "definition", oriented, merge, allow_empty, distance, words, name,
                               seconds_of(limit), False, requirements_of(require), except_sharp, *repeated))


def check_voronoi(sites: Any, vertices: Any = None, cells: Any = None, ridges: Any = (), ridge_vertices: Any = (), *,
                  within: Any = 0, structure: bool = False, box: Any = None, max_errors: int = 20, by: str = "lemma",
                  limit: Optional[float] = None, name: str = "cells") -> Verdict:
    """Judges, exactly, whether cells are the Voronoi cells of sites, within a box and up to a distance.

    sites: (n, d) doubles, d = 2 or 3; or a scipy.spatial.Voronoi, and nothing else.
    vertices: (m, d) doubles.
    cells: for each site the indices of the corners of its cell, in any order, with -1 if it is unbounded.
    ridges: (r, 2) integers, pairs of sites whose cells have a common ridge; unbounded cells need them.
    ridge_vertices: for each ridge the indices of its vertices, with -1 if it is unbounded; `structure` needs them.
    within: how far a cell may be from the exact one, an exact number. The verdict names the least distance.
    structure: demand that the vertices and ridges are those of the diagram, too. Within the distance vertices count as one.
    box: the least and the largest coordinates; by default the box of the sites, enlarged on each side by half its
        longest edge. What is outside is not judged.

    Raises ValueError (InputError, if the input is at fault) and TypeError.

    >>> square = [[0, 0], [4, 0], [4, 4], [0, 4]]
    >>> print(check_voronoi(square, [[2, 2]], [[0, -1]] * 4, [[0, 1], [1, 2], [2, 3], [3, 0]]))
    holds: voronoi cells 4 sites 4 cells within 0
    """
    if by not in ("lemma", "definition"):
        raise ValueError(f"expected by='lemma' or by='definition', found {by!r}")
    diagram = diagram_of(sites, vertices, cells, ridges, ridge_vertices)
    if structure and not len(diagram.ridge_vertices) and len(diagram.sites) > 1:
        raise ValueError("expected ridge_vertices beside structure, found none")
    parts = diagram_parts(diagram, box)
    return Verdict(_core.check_voronoi(*parts, number_text(within, "a distance"), max_errors, by == "definition", name,
                                       seconds_of(limit), "structure" if structure else ""))


def assert_delaunay(points: Any, simplices: Any = None, claim: Optional[str] = None, **options: Any) -> Verdict:
    """Like `check`, but raises AssertionError with the witness in its text if the claim does not hold.

    For pytest, unittest and plain scripts alike.

    >>> assert_delaunay([[0, 0], [1, 0], [0, 1], [0.9, 0.9]], [[0, 1, 3], [0, 3, 2]])
    <Verdict holds: delaunay mesh 4 points 2 triangles unique canonical>
    """
    __tracebackhide__ = True  # pytest shows the caller's line
    return check(points, simplices, claim, **options).raise_for_failure()


def delaunay(points: Any, weights: Any = None):
    """The canonical Delaunay triangulation of (n, d) points, (m, d+1) integers, whatever the order of the points.

    It uses exact arithmetic and is meant as a reference, not for speed. With (n,) weights, it is the weighted one.
    Flat sets have rows of k+1 indices. Raises InputError if points are equal.

    >>> delaunay([[0, 0], [1, 0], [0, 1], [1, 1]]).tolist()
    [[0, 1, 3], [2, 0, 3]]
    """
    return _core.delaunay(guarded(points_of(points, weights)).parts())


class Constrained(NamedTuple):
    """The canonical constrained Delaunay triangulation of a domain; all (m, k) integers, indices of its points."""

    simplices: Any
    triangles: Any  # those of space that are in no tetrahedron
    edges: Any  # that are in no simplex
    vertices: Any


def constrained_delaunay(domain: Any) -> Constrained:
    """The canonical constrained Delaunay triangulation of a Domain, without further points.

    Raises NoTriangulation (a LookupError) if the domain has none, and InputError if it is not a piecewise linear
    complex.

    >>> square = Domain([[0, 0], [2, 0], [2, 2], [0, 2]], segments=[[0, 1], [1, 2], [2, 3], [3, 0], [1, 3]])
    >>> constrained_delaunay(square).simplices.tolist()
    [[0, 1, 3], [1, 2, 3]]
    """
    return Constrained(*_core.constrained_delaunay(domain_of(domain).parts()))


def orient(*points: Any) -> int:
    """The sign of det(p_0 - p_d, ..., p_{d-1} - p_d) of d+1 points: -1, 0 or 1; exact.

    In the plane it is positive if they turn counterclockwise.

    >>> orient((0, 0), (1, 0), (0, 1)), orient((0.1, 0.1), (0.2, 0.2), (0.3, 0.3))
    (1, 0)
    """
    return sign_of(False, points)


def in_ball(*points: Any) -> int:
    """Is the last of d+2 points inside (1), on (0) or outside (-1) the circumsphere of the others? Exact.

    >>> from fractions import Fraction
    >>> third = Fraction(1, 3)
    >>> in_ball((0, 0), (third, 0), (0, third), (third, third))
    0
    """
    return sign_of(True, points)


def sign_of(in_ball: bool, points: tuple) -> int:
    """Points of plain numbers are not made an array of first, which would take most of the time."""
    sign = _core.plain_predicate(in_ball, points)
    if sign is None:
        own = numbers_of(list(points), "points")
        sign = _core.predicate(in_ball, own.shape[1], own.values)
    return sign


def inspect(points: Any, weights: Any = None) -> dict:
    """Facts about (n, d) points: their number, the dimension that they span, equal ones, whether their Delaunay
    triangulation is the only one, and if not, points on the boundary of one empty ball. It builds the triangulation,
    so use it for small sets.

    >>> inspect([[0, 0], [1, 0], [0, 1], [1, 1], [0, 0]])
    {'points': 5, 'dimension': 2, 'repeated': [[0, 4]], 'unique': False, 'cospherical': [0, 1, 2, 3]}
    """
    return json.loads(_core.inspect(guarded(points_of(points, weights)).parts())[1])


def compare(a: Any, b: Any, *, weights: Tuple[Any, Any] = (None, None)) -> Comparison:
    """Are two meshes the same complex, whatever their numbering? Each is a mesh object, or a pair (points,
    simplices).

    Raises InputError if points of one are equal, or if one has neither points nor simplices.

    >>> points = [[0, 0], [1, 0], [0, 1]]
    >>> bool(compare((points, [[0, 1, 2]]), (points[::-1], [[0, 1, 2]])))
    True
    """
    meshes = []
    for mesh, own in zip((a, b), weights):
        parts = mesh if isinstance(mesh, tuple) and not hasattr(mesh, "simplices") else (mesh, None)
        meshes.append(guarded(mesh_of(parts[0], parts[1], None, own)).parts())
    return Comparison(_core.compare(*meshes))


def certify(points: Any, simplices: Any = None, claim: str = "delaunay", *, weights: Any = None,
            require: Any = ()) -> str:
    """What proves the verdict to circumspect-verified: the text of a certificate, or of a refutation.

    Raises InputError if points are equal, or if there are neither points nor simplices; and ValueError if something is
    required of the shape of simplices, about which nothing is proved.

    >>> certify([[0, 0], [1, 0], [0, 1]], [[0, 1, 2]]).split()[0]
    'circumspect-certificate'
    """
    if requirements_of(require):
        raise ValueError(f"expected no require of a certificate, found {require!r}: nothing is proved of the shape of "
                         "simplices; check judges it")
    return _core.certify(claim, guarded(mesh_of(points, simplices, None, weights)).parts())[1]


class Family(NamedTuple):
    """A family of inputs. Those of domains have one dimension."""

    name: str
    about: str
    dimensions: Tuple[int, ...]
    weighted: bool = False
    repeats_points: bool = False
    is_of_domains: bool = False


def families() -> List[Family]:
    """All families of point sets, with their modifiers, then those of domains.

    >>> [family.name for family in families() if family.is_of_domains][:2]
    ['scattered-cells', 'coplanar-cells']
    """
    sets = [Family(name, about, tuple(dimensions), weighted, repeats)
            for name, about, dimensions, weighted, repeats in _core.families()]
    return sets + [Family(name, about, (dimension,), is_of_domains=True)
                   for name, about, dimension in _core.domain_families()]


def generate(family: str, *, dimension: int = 3, points: int = 12, seed: int = 0, fewer: bool = False,
             exact: bool = False):
    """The points that a seed stands for, as `circumspect generate` draws them: (n, d) doubles.

    `fewer`: any number of points up to `points`. `exact`: Fraction objects, not yet rounded to doubles. For a
    weighted family it returns a pair (points, weights).

    >>> generate("sphere", dimension=2, points=4, seed=7).shape
    (4, 2)
    """
    if exact:
        import numpy as np
        from fractions import Fraction

        texts = _core.generate_exact(family, dimension, points, seed, fewer)
        return np.array([Fraction(text) for text in texts], dtype=object).reshape(-1, dimension)
    drawn, weights = _core.generate(family, dimension, points, seed, fewer)
    return drawn if weights is None else (drawn, weights)


def generate_domain(family: str, *, points: int = 12, seed: int = 0) -> Domain:
    """The domain that a seed stands for.

    >>> generate_domain("glued-tetrahedra", seed=1).dimension
    3
    """
    return Domain.of_lists(_core.generate_domain(family, points, seed))
