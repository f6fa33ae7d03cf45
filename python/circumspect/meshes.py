"""Turns meshes of common libraries into arrays that can be judged, without changing a number.

Nothing here imports a mesh library: objects are recognised by their attributes (`simplices`, `cells`, `triangles`,
...).
"""
from __future__ import annotations

import fractions
import numbers
from typing import Any, List, NamedTuple, Optional

LARGEST_EXACT_INTEGER = 1 << 53  # of doubles without gaps


class Numbers(NamedTuple):
    """Coordinates or weights: `values` is a flat array of doubles, or a list of exact texts."""

    values: Any
    shape: tuple


class Mesh(NamedTuple):
    """A mesh as arrays: see `mesh_of`."""

    points: Numbers
    simplices: Any  # m × k integers, or None
    neighbors: Any
    weights: Optional[Numbers]
    triangles: Any  # listed beside tetrahedra, or None
    edges: Any

    @property
    def dimension(self) -> int:
        """The number of coordinates of a point."""
        return self.points.shape[1]

    def parts(self) -> tuple:
        """What `_core` takes."""
        return (self.dimension, self.points.values, self.weights and self.weights.values, self.simplices,
                self.neighbors, self.triangles, self.edges)


def exact_text(value: Any, what: str) -> str:
    """The exact value of a number as a text such as "1/3"."""
    if isinstance(value, bool) or not (isinstance(value, numbers.Rational) or hasattr(value, "as_integer_ratio")):
        raise TypeError(f"expected numbers as {what}, found {value!r} of type {type(value).__name__}")
    try:
        if isinstance(value, numbers.Rational):
            exact = fractions.Fraction(int(value.numerator), int(value.denominator))
        else:
            exact = fractions.Fraction(*(int(part) for part in value.as_integer_ratio()))
    except (OverflowError, ValueError):
        raise ValueError(f"expected finite {what}, found {value!r}") from None
    return str(exact)


def number_text(number: Any, what: str) -> str:
    """The same; a text is returned unchanged."""
    return number if isinstance(number, str) else exact_text(number, what)


def array_of(values: Any, what: str):
    """A NumPy array of anything that is not one yet; ragged lists and masked entries are refused."""
    import numpy as np

    if isinstance(values, np.ma.MaskedArray):
        if np.ma.is_masked(values):
            raise ValueError(f"expected {what} without masked entries, found some")
        values = values.data
    if isinstance(values, (str, bytes)) or values is None:
        raise TypeError(f"expected an array of {what}, found {type(values).__name__}")
    try:
        array = np.asarray(values)
        if array.dtype.kind == "f" and not isinstance(values, np.ndarray) and not hasattr(values, "__array__"):
            # A list may hold integers or fractions that its float array has rounded.
            array = exactly_as_listed(values, array)
    except ValueError:
        raise ValueError(f"expected {what} in rows of one length, found a ragged list") from None
    except OverflowError:
        array = np.asarray(values, dtype=object)
    return array


def exactly_as_listed(values: Any, array: Any):
    """The float array of a list, or the list's own objects if one is not a float."""
    import numpy as np

    objects = np.asarray(values, dtype=object)
    if objects.shape != array.shape:
        return array
    small = (float, np.floating)
    for value in objects.flat:
        if not isinstance(value, small) and not (isinstance(value, int) and abs(value) <= LARGEST_EXACT_INTEGER):
            return objects
    return array


def numbers_of(values: Any, what: str, columns: Optional[int] = None) -> Numbers:
    """Doubles if all numbers are doubles, else exact texts; n × d, or n if `columns` is 0."""
    import numpy as np

    array = array_of(values, what)
    expected = "(n,)" if columns == 0 else "(n, d)"
    if array.ndim != (1 if columns == 0 else 2) or (array.ndim == 2 and array.shape[1] == 0):
        raise ValueError(f"expected {what} of shape {expected}, found {array.shape}")
    kind = array.dtype.kind
    if kind == "f" and array.dtype.itemsize <= 8:
        doubles = np.ascontiguousarray(array, dtype=np.float64)
    elif kind in "iu" and not has_large_integers(array):
        doubles = np.ascontiguousarray(array, dtype=np.float64)
    elif kind in "fiuO":
        return Numbers([exact_text(value, what) for value in array.ravel()], array.shape)
    else:
        raise TypeError(f"expected numbers as {what}, found an array of {array.dtype}")
    if not np.isfinite(doubles).all():
        place = np.argwhere(~np.isfinite(doubles))[0]
        raise ValueError(f"expected finite {what}, found {doubles[tuple(place)]} at {tuple(map(int, place))}")
    return Numbers(doubles.reshape(-1), array.shape)


def has_large_integers(array: Any) -> bool:
    """Does an array of integers have some beyond 2^53, which may not be doubles?"""
    return bool(array.size) and (int(array.max()) > LARGEST_EXACT_INTEGER
                               or int(array.min()) < -LARGEST_EXACT_INTEGER)


def indices_of(values: Any, what: str, columns: Optional[int] = None):
    """Indices in C order, of 32 or 64 bits."""
    import numpy as np

    array = array_of(values, what)
    if array.size == 0 and array.ndim < 2:
        array = np.zeros((0, columns or 1), dtype=np.int64)
    if array.dtype.kind == "O":
        if not all(isinstance(value, numbers.Integral) and not isinstance(value, bool) for value in array.flat):
            raise TypeError(f"expected integers as {what}, found other objects")
        if any(not -(1 << 63) <= value < 1 << 63 for value in array.flat):
            raise ValueError(f"expected {what} of 64 bits, found larger ones")
        array = array.astype(np.int64)
    if array.dtype.kind not in "iu":
        raise TypeError(f"expected integers as {what}, found an array of {array.dtype}")
    if array.ndim != 2 or (columns is not None and array.shape[1] != columns):
        wanted = "(m, k)" if columns is None else f"(m, {columns})"
        raise ValueError(f"expected {what} of shape {wanted}, found {array.shape}")
    if array.dtype.kind == "u" and array.dtype.itemsize == 8 and array.size and int(array.max()) >= 1 << 63:
        raise ValueError(f"expected {what} of 64 bits with a sign, found {int(array.max())}")
    wide = array.dtype.itemsize == 8 or array.dtype == np.uint32
    return np.ascontiguousarray(array, dtype=np.int64 if wide else np.int32)


def mesh_of(points: Any, simplices: Any = None, neighbors: Any = None, weights: Any = None) -> Mesh:
    """A mesh of arrays, or of one mesh object in the place of `points`."""
    import numpy as np

    triangles = edges = None
    if simplices is None and not isinstance(points, (np.ndarray, list, tuple)):
        points, simplices, found_neighbors, triangles, edges = parts_of(points)
        neighbors = found_neighbors if neighbors is None else neighbors
    elif simplices is None:
        raise TypeError("expected simplices beside an array of points, or a mesh object, found neither")
    own = numbers_of(points, "points")
    rows = indices_of(simplices, "simplices", None if np.size(simplices) else own.shape[1] + 1)
    across = None
    if neighbors is not None:
        across = indices_of(neighbors, "neighbors")
        if across.shape != rows.shape:
            raise ValueError(f"expected neighbors of the shape of the simplices, {rows.shape}, found {across.shape}")
        if across.dtype != rows.dtype:
            rows, across = rows.astype(np.int64), across.astype(np.int64)
    return Mesh(own, rows, across, weights_of(weights, own), triangles, edges)


def weights_of(weights: Any, points: Numbers) -> Optional[Numbers]:
    """One weight a point."""
    if weights is None:
        return None
    own = numbers_of(weights, "weights", 0)
    if own.shape[0] != points.shape[0]:
        raise ValueError(f"expected one weight a point, {points.shape[0]}, found {own.shape[0]}")
    return own


def points_of(points: Any, weights: Any = None) -> Mesh:
    """Points without simplices."""
    own = numbers_of(points, "points")
    return Mesh(own, None, None, weights_of(weights, own), None, None)


# The cells that count, by VTK's number and by meshio's name, and how many vertices each has.
CELLS = {10: 4, 5: 3, 3: 2, 1: 1, "tetra": 4, "triangle": 3, "line": 2, "vertex": 1}


def parts_of(mesh: Any):
    """(points, simplices, neighbors, triangles, edges) of a mesh object of another library."""
    import numpy as np

    if hasattr(mesh, "points") and hasattr(mesh, "simplices"):  # scipy.spatial.Delaunay
        return mesh.points, mesh.simplices, getattr(mesh, "neighbors", None), None, None
    if hasattr(mesh, "triangles") and hasattr(mesh, "x") and hasattr(mesh, "y"):  # matplotlib.tri
        mask = getattr(mesh, "mask", None)
        triangles = np.asarray(mesh.triangles)
        return np.column_stack([mesh.x, mesh.y]), triangles if mask is None else triangles[~mask], None, None, None
    if hasattr(mesh, "points") and hasattr(mesh, "cells_dict"):  # meshio.Mesh, pyvista.UnstructuredGrid
        return with_cells(mesh.points, mesh.cells_dict)
    if hasattr(mesh, "points") and hasattr(mesh, "faces"):  # pyvista.PolyData: 3 a b c 3 d e f
        faces = np.asarray(mesh.faces)
        if faces.ndim == 1:
            if faces.size % 4 or not (faces[::4] == 3).all():
                raise ValueError("expected a surface of triangles, found other faces")
            faces = faces.reshape(-1, 4)[:, 1:]
        return mesh.points, faces, None, None, None
    if hasattr(mesh, "vertices") and hasattr(mesh, "faces"):  # trimesh.Trimesh
        return np.asarray(mesh.vertices), np.asarray(mesh.faces), None, None, None
    if hasattr(mesh, "GetNumberOfCells") and hasattr(mesh, "GetPoint"):  # vtkUnstructuredGrid
        return with_cells(*vtk_cells(mesh))
    raise TypeError(
        "expected points and simplices, or a mesh as scipy.spatial.Delaunay, matplotlib.tri.Triangulation, "
        f"meshio.Mesh, pyvista or trimesh make it, found {type(mesh).__name__}")


def vtk_cells(grid: Any):
    """The points of a VTK data set, and its cells by VTK's numbers."""
    import numpy as np

    points = np.zeros((grid.GetNumberOfPoints(), 3))
    try:
        if len(points):
            points = np.array(memoryview(grid.GetPoints().GetData()))
    except (AttributeError, TypeError):  # images have no array of points, and some arrays expose no memory
        points = np.array([grid.GetPoint(i) for i in range(len(points))])
    cells: dict = {}
    if hasattr(grid, "GetCellTypesArray") and grid.GetNumberOfCells():  # an unstructured grid
        kinds, vertices, starts = (np.array(memoryview(array)) for array in (
            grid.GetCellTypesArray(), grid.GetCells().GetConnectivityArray(), grid.GetCells().GetOffsetsArray()))
        for kind in np.unique(kinds).tolist():
            own = starts[:-1][kinds == kind]
            cells[kind] = vertices[own[:, None] + np.arange(CELLS[kind])] if kind in CELLS else own
        return points, cells
    for i in range(grid.GetNumberOfCells()):
        ids = grid.GetCell(i).GetPointIds()
        row = [ids.GetId(k) for k in range(ids.GetNumberOfIds())]
        cells.setdefault(grid.GetCellType(i), []).append(row)
    return points, cells


def with_cells(points: Any, cells: Optional[dict]):
    """The cells of the highest dimension are the simplices; those of lower dimension are listed beside them."""
    import numpy as np

    of_size: dict = {}
    for kind, rows in (cells or {}).items():  # earlier versions of pyvista have None if there are no cells
        if not len(rows):
            continue
        if kind not in CELLS:
            what = repr(kind) if isinstance(kind, str) else f"{kind} of VTK"
            raise ValueError(f"expected tetrahedra, triangles, edges and vertices, found cells of type {what}")
        of_size[CELLS[kind]] = np.asarray(rows)
    if not of_size:
        return points, np.zeros((0, np.shape(points)[1] + 1), np.int64), None, None, None
    most = max(of_size)
    listed = {size: np.ascontiguousarray(rows, dtype=np.int64) for size, rows in of_size.items() if size < most}
    return points, of_size[most], None, listed.get(3), listed.get(2)


def with_faces(mesh: Mesh, faces: Any) -> Mesh:
    """The mesh with these triangles or edges beside its simplices, and no others."""
    import numpy as np

    rows = indices_of(faces, "faces").astype(np.int64)
    if rows.shape[1] not in (2, 3) and rows.size:
        raise ValueError(f"expected triangles or edges as faces, found faces of {rows.shape[1]} vertices")
    return mesh._replace(triangles=rows if rows.shape[1] == 3 else None,
                         edges=rows if rows.shape[1] == 2 else None)


def without_coordinate(mesh: Mesh, axis: str) -> Mesh:
    """A surface or lines of space, as they are seen along an axis."""
    import numpy as np

    if axis not in ("x", "y", "z"):
        raise ValueError(f"expected drop='x', drop='y' or drop='z', found {axis!r}")
    if mesh.dimension != 3:
        raise ValueError(f"expected points with 3 coordinates for drop, found {mesh.dimension}")
    if mesh.simplices.shape[1] > 3:
        raise ValueError(f"expected triangles or edges for drop, found simplices of {mesh.simplices.shape[1]} vertices")
    kept = ["xyz".index(other) for other in "xyz" if other != axis]
    values = mesh.points.values
    rows = np.asarray(values, dtype=object if isinstance(values, list) else None).reshape(-1, 3)[:, kept].ravel()
    own = Numbers(rows.tolist() if isinstance(values, list) else np.ascontiguousarray(rows), (mesh.points.shape[0], 2))
    return mesh._replace(points=own, triangles=None)


def guarded(mesh: Mesh) -> Mesh:
    """The mesh in memory that no other thread changes while it is judged without the interpreter's lock."""
    def kept(own: Numbers) -> Numbers:
        return own._replace(values=own_copy(own.values))

    return mesh._replace(points=kept(mesh.points), weights=mesh.weights and kept(mesh.weights),
                         simplices=own_copy(mesh.simplices), neighbors=own_copy(mesh.neighbors),
                         triangles=own_copy(mesh.triangles), edges=own_copy(mesh.edges))


def own_copy(values: Any) -> Any:
    """A copy of an array, unless it is read-only and so is what it is a view of; a list stays."""
    owner = values
    while owner is not None and not isinstance(values, list):
        flags = getattr(owner, "flags", None)
        if flags is None or flags.writeable:
            return values.copy()
        owner = owner.base
    return values


def merges(duplicates: str) -> bool:
    """Are equal points to count as one?"""
    if duplicates not in ("reject", "merge"):
        raise ValueError(f"expected duplicates='reject' or duplicates='merge', found {duplicates!r}")
    return duplicates == "merge"


def requirements_of(require: Any) -> List[str]:
    """One requirement, or several, as texts."""
    texts = [require] if isinstance(require, str) else list(require)
    for text in texts:
        if not isinstance(text, str):
            raise TypeError(f"expected texts such as 'min-angle:20.7deg' as require, found {text!r}")
    return texts


def seconds_of(limit: Optional[float]) -> float:
    """A limit in seconds; 0 for none."""
    if limit is None:
        return 0.0
    if isinstance(limit, bool) or not isinstance(limit, numbers.Real) or not limit > 0:
        raise ValueError(f"expected a limit of more than 0 seconds, found {limit!r}")
    return float(limit)
