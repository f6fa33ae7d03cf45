"""Domains that a mesh must fill: piecewise linear complexes."""
from __future__ import annotations

import fractions
import numbers
from typing import Any, Mapping, Optional, Sequence

from .meshes import Mesh, Numbers, indices_of, numbers_of, own_copy, parts_of
from .rings import is_of_rings, parts_of_rings


# As circumspect_domain_kind counts them.
KINDS = (None, "enclosed", "hull", "even-odd", "winding")


class Domain:
    """A piecewise linear complex: the domain that a mesh must fill.

    points: (n, 2) or (n, 3); segments: (s, 2) indices of points; polygons: each a list of corners, or of several such
    lines, in space outline, outlines of holes, segments, vertices, in the plane rings, an odd number of which encloses
    what the polygon covers; polygon_holes, only in space: for the index of a polygon, a list of points, one in each of
    its holes; holes: a point in each hole of the domain; kind: "enclosed" (what
    segments or polygons enclose), "even-odd" (of that, what is entered by an odd number of them), "winding" (what
    they wind around, as they are listed), "hull" (the convex hull), or None, which is "enclosed" if they enclose
    anything, and "hull" if there are none (in the plane only what polygons cover, if there are any); regions: a point in each region that is filled (default: all enclosed
    regions); merge_coplanar: coplanar polygons that share an edge count as one, like a face that was cut into
    triangles; resolve: segments may cross, touch and repeat, and points may be equal: where segments meet is a vertex,
    numbered after all others. `from_rings` takes polygons as coordinates.

    >>> square = Domain([[0, 0], [1, 0], [1, 1], [0, 1]], segments=[[0, 1], [1, 2], [2, 3], [3, 0]])
    >>> square
    Domain(4 points, 4 segments, 0 polygons)
    """

    def __init__(self, points: Any, segments: Any = None, polygons: Optional[Sequence] = None, holes: Any = None,
                 kind: Optional[str] = None, polygon_holes: Optional[Mapping] = None, regions: Any = None,
                 merge_coplanar: bool = False, resolve: bool = False):
        import numpy as np

        self.own_points = numbers_of(points, "points")
        if self.dimension not in (2, 3):
            raise ValueError(f"expected a domain of the plane or of space, found points of {self.dimension} coordinates")
        self.segments = indices_of([] if segments is None else segments, "segments", 2).astype(np.int64)
        self.polygons = [lines_of(polygon) for polygon in (() if polygons is None else polygons)]
        self._holes = self.seeds_of(holes, "holes")
        self._polygon_holes = {}
        for polygon, seeds in dict(polygon_holes or {}).items():
            if not isinstance(polygon, numbers.Integral) or not 0 <= polygon < len(self.polygons):
                raise ValueError(f"expected polygon_holes by the index of one of {len(self.polygons)} polygons, "
                                 f"found {polygon!r}")
            self._polygon_holes[int(polygon)] = self.seeds_of(seeds, "holes of a polygon")
        if kind not in KINDS:
            raise ValueError(f"expected the kind {', '.join(map(repr, KINDS[1:]))} or None, found {kind!r}")
        self.kind = kind
        self._regions = self.seeds_of(regions, "regions")
        self.merge_coplanar = bool(merge_coplanar)
        self.resolve = bool(resolve)

    @classmethod
    def from_rings(cls, shape: Any, *, coordinates: str = "double", **options: Any) -> "Domain":
        """The domain that polygons with holes cover, given by coordinates.

        shape: a ring [[x, y], ...], a polygon [outline, hole, ...] or a list of polygons; a dictionary or text of
            GeoJSON; a text of WKT; or an object of shapely, geopandas or the like. A ring may repeat its first point
            at its end. What an odd number of a polygon's rings enclose is covered. Lines become segments. Equal
            points are one vertex; vertices are numbered as they occur.
        coordinates: "double": "0.1" in a text means the nearest double, as for most programs; "decimal": exactly 1/10.
            Numbers that are not texts are exact.
        options: as Domain has them, such as `holes`, `regions` and `resolve`; `kind` says that something else is filled.

        Raises ValueError and TypeError.

        >>> Domain.from_rings("POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 2 1, 2 2, 1 1))")
        Domain(7 points, 0 segments, 1 polygon)
        """
        return cls(**parts_of_rings(shape, coordinates), **options)

    def seeds_of(self, seeds: Any, what: str) -> Numbers:
        """A point in each hole."""
        import numpy as np

        if seeds is None or np.size(seeds) == 0:
            return Numbers(np.zeros(0), (0, self.dimension))
        found = numbers_of(seeds, what)
        if found.shape[1] != self.dimension:
            raise ValueError(f"expected {what} of shape (h, {self.dimension}), found {found.shape}")
        return found

    @property
    def dimension(self) -> int:
        """2 or 3."""
        return self.own_points.shape[1]

    @property
    def points(self):
        """(n, d) doubles; an array of Fractions if the points are exact numbers that may not be doubles."""
        return rows_of(self.own_points)

    @property
    def holes(self):
        """(h, d), a point in each hole."""
        return rows_of(self._holes)

    @property
    def polygon_holes(self) -> dict:
        """For the index of a polygon (h, 3), a point in each of its holes."""
        return {polygon: rows_of(seeds) for polygon, seeds in self._polygon_holes.items()}

    @property
    def regions(self):
        """(r, d), a point in each region that is filled; none: all that are enclosed."""
        return rows_of(self._regions)

    def __repr__(self) -> str:
        return f"Domain({self.size()})"

    def size(self) -> str:
        """How many points and cells there are, for people."""
        counts = {"point": self.own_points.shape[0], "segment": len(self.segments), "polygon": len(self.polygons)}
        return ", ".join(f"{count} {what}{'' if count == 1 else 's'}" for what, count in counts.items())

    def parts(self) -> tuple:
        """What `_core` takes."""
        import numpy as np

        polygon_starts, line_starts, corners = [0], [0], []
        for lines in self.polygons:
            for line in lines:
                corners += line
                line_starts.append(len(corners))
            polygon_starts.append(len(line_starts) - 1)
        lists = [np.array(values, dtype=np.int64) for values in (polygon_starts, line_starts, corners)]
        owners = [polygon for polygon, seeds in self._polygon_holes.items() for _ in range(seeds.shape[0])]
        seeds: Any = [rows_of(seeds) for seeds in self._polygon_holes.values()]
        seeds = numbers_of(np.concatenate(seeds), "holes of polygons").values if owners else np.zeros(0)
        return (self.dimension, own_copy(self.own_points.values), own_copy(self.segments.reshape(-1)), *lists,
                own_copy(self._holes.values), KINDS.index(self.kind), np.array(owners, dtype=np.int64), seeds,
                own_copy(self._regions.values), self.merge_coplanar, self.resolve)

    def lists(self) -> tuple:
        """What `_core` takes to make a domain small and to write it."""
        if any(isinstance(own.values, list) for own in (self.own_points, self._holes, *self._polygon_holes.values())):
            raise ValueError("expected a domain whose points are doubles, found other numbers")
        has_rings = self.dimension == 2 and bool(self.polygons)
        if self.kind in ("even-odd", "winding") or self._regions.shape[0] or self.merge_coplanar or self.resolve or has_rings:
            raise ValueError("expected a domain that fills all that it encloses, or its hull, with its polygons as they are; "
                             f"found the kind {self.kind!r}, {self._regions.shape[0]} regions, "
                             f"merge_coplanar={self.merge_coplanar}, resolve={self.resolve}"
                             f"{', polygons of the plane' if has_rings else ''}")
        seeds = [(polygon, seed.tolist()) for polygon, all_of_it in self.polygon_holes.items() for seed in all_of_it]
        has_walls = len(self.segments if self.dimension == 2 else self.polygons) > 0
        is_hull = self.kind == "hull" or self.kind is None and not has_walls
        return (self.points, self.segments.tolist(), self.polygons, self.holes, seeds, is_hull)

    @classmethod
    def of_lists(cls, lists: tuple) -> "Domain":
        """A domain of the lists that `_core` draws."""
        points, segments, polygons, holes, seeds, is_hull = lists
        polygon_holes: dict = {}
        for polygon, seed in seeds:
            polygon_holes.setdefault(polygon, []).append(seed)
        return cls(points, segments, polygons, holes, "hull" if is_hull else "enclosed", polygon_holes)


def rows_of(own: Numbers):
    """An array of doubles, or of Fractions."""
    import numpy as np

    values = own.values
    if isinstance(values, list):
        values = np.array([fractions.Fraction(text) for text in values], dtype=object)
    return values.reshape(own.shape)


def distinct_rows(own: Numbers) -> set:
    """The points, each once."""
    return set(map(tuple, rows_of(own).tolist()))


def with_cells_of(domain: Domain, segments: Sequence, polygons: Sequence) -> Domain:
    """The domain with some of its segments and polygons, given by index, and without points that only the others
    used."""
    import numpy as np

    lines = [[domain.polygons[p] for p in polygons], domain.polygons]
    rows = [domain.segments[list(segments)], domain.segments]
    kept, all_used = ({*edges.ravel().tolist(), *(v for polygon in cells for line in polygon for v in line)}
                      for edges, cells in zip(rows, lines))
    stays = np.array([v in kept or v not in all_used for v in range(len(domain.points))], dtype=bool)
    place = np.cumsum(stays) - 1
    holes = {new: domain.polygon_holes[old] for new, old in enumerate(polygons) if old in domain.polygon_holes}
    return Domain(domain.points[stays], place[rows[0]], [[[int(place[v]) for v in line] for line in polygon]
                                                         for polygon in lines[0]], domain.holes, domain.kind, holes,
                  domain.regions, domain.merge_coplanar, domain.resolve)


def lines_of(polygon: Any) -> list:
    """A polygon as lines of corners: one line may stand for itself."""
    polygon = list(polygon)
    if not polygon or not hasattr(polygon[0], "__iter__"):
        polygon = [polygon]
    return [[int(corner) for corner in line] for line in polygon]


def domain_of(domain: Any) -> Domain:
    """A domain, the dictionary of one (vertices, segments, holes, as `triangle` has it), what `Domain.from_rings` takes,
    or a closed surface."""
    if isinstance(domain, Domain):
        return domain
    if is_of_rings(domain):
        return Domain.from_rings(domain)
    if isinstance(domain, dict):
        known = {"vertices": "points", "points": "points", "segments": "segments", "polygons": "polygons",
                 "holes": "holes", "kind": "kind", "polygon_holes": "polygon_holes", "regions": "regions",
                 "merge_coplanar": "merge_coplanar", "resolve": "resolve"}
        unknown = set(domain) - set(known)
        if unknown or not {"vertices", "points"} & set(domain):
            raise ValueError(f"expected a domain with the keys {', '.join(sorted(known))}, found {sorted(domain)}")
        return Domain(**{known[key]: value for key, value in domain.items()})
    import numpy as np

    points, simplices, _, _, edges = parts_of(domain)
    faces = np.asarray(simplices)
    if faces.ndim != 2 or faces.shape[1] != 3:
        raise ValueError(f"expected a surface of triangles as a domain, found cells of shape {faces.shape}")
    return Domain(points, edges, polygons=faces.tolist())


def in_plane_of(mesh: Mesh, domain: Domain) -> Mesh:
    """The mesh without its third coordinate, if that is the same for all points and the domain is planar."""
    points = mesh.points
    if domain.dimension != 2 or mesh.dimension != 3 or isinstance(points.values, list) or not points.shape[0]:
        return mesh
    rows = points.values.reshape(points.shape)
    if (rows[:, 2] != rows[0, 2]).any():
        return mesh
    return mesh._replace(points=numbers_of(rows[:, :2].copy(), "points"))
