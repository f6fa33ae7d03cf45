"""Turns Voronoi diagrams of common libraries into arrays that can be judged."""
from __future__ import annotations

from typing import Any, NamedTuple, Optional

from .meshes import indices_of, numbers_of


class Diagram(NamedTuple):
    """A cell a site: rows of indices of vertices, with -1 if the cell is unbounded."""

    sites: Any
    vertices: Any
    cells: Any
    ridges: Any  # pairs of sites
    ridge_vertices: Any  # for each pair a row as of cells


def is_diagram(value: Any) -> bool:
    """Is it scipy.spatial.Voronoi, or made like it?"""
    return all(hasattr(value, name) for name in ("points", "vertices", "regions", "point_region", "ridge_points"))


def diagram_of(sites: Any, vertices: Any, cells: Any, ridges: Any, ridge_vertices: Any) -> Diagram:
    """A diagram of a library, or one by its parts."""
    if not is_diagram(sites):
        if vertices is None or cells is None:
            raise TypeError("expected vertices and cells beside sites, or an object as scipy.spatial.Voronoi, found neither")
        return Diagram(sites, vertices, cells, ridges, ridge_vertices)
    # Region -1, which is empty, belongs to a site that SciPy left out.
    regions = [[] if region < 0 else sites.regions[region] for region in sites.point_region]
    return Diagram(sites.points, sites.vertices, regions, sites.ridge_points, getattr(sites, "ridge_vertices", ()))


def doubles_of(values: Any, what: str, columns: Optional[int] = None):
    """An array of doubles in rows; numbers that are none are refused, since programs compute cells with doubles."""
    import numpy as np

    if not np.size(values):
        return np.zeros((0, columns or 2))
    own = numbers_of(values, what)
    if not isinstance(own.values, np.ndarray):
        raise TypeError(f"expected doubles as {what}, found numbers that are none")
    if columns is not None and own.shape[1] != columns:
        raise ValueError(f"expected {what} of shape (n, {columns}), found {own.shape}")
    return own.values.reshape(own.shape)


def lists_of(rows: Any):
    """Where each row starts in the list of all their indices, and this list."""
    import numpy as np

    return (np.cumsum([0, *(len(row) for row in rows)], dtype=np.int64),
            np.array([int(v) for row in rows for v in row], dtype=np.int64))


def parts_of(diagram: Diagram, box: Any) -> tuple:
    """What `_core` takes."""
    import numpy as np

    sites = doubles_of(diagram.sites, "sites")
    columns = sites.shape[1]
    vertices = doubles_of(diagram.vertices, "vertices", columns)
    if len(diagram.cells) != len(sites):
        raise ValueError(f"expected a cell for each of {len(sites)} sites, found {len(diagram.cells)}")
    ridges = np.zeros((0, 2), np.int64) if not np.size(diagram.ridges) else indices_of(diagram.ridges, "ridges", 2)
    if len(diagram.ridge_vertices) not in (0, len(ridges)):
        raise ValueError(f"expected the vertices of each of {len(ridges)} ridges, found {len(diagram.ridge_vertices)}")
    ends = None if box is None else doubles_of(box, "corners of a box", columns)
    if ends is not None and len(ends) != 2:
        raise ValueError(f"expected a box of two corners, found {len(ends)}")
    listed = diagram.ridge_vertices if len(diagram.ridge_vertices) else [[]] * len(ridges)
    return columns, sites, vertices, *lists_of(diagram.cells), ridges.astype(np.int64), *lists_of(listed), ends
