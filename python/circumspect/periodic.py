"""How a lattice repeats a mesh, as arrays."""
from __future__ import annotations

from typing import Any, Optional, Tuple

from .meshes import Mesh, array_of
from .voronoi import doubles_of


def periodic_of(claim: Optional[str], mesh: Mesh, lattice: Any, offsets: Any) -> Tuple[Any, Any]:
    """What `_core` takes of both; nothing if the claim is not about meshes that repeat."""
    import numpy as np

    if claim != "periodic-delaunay":
        for name, given in (("lattice", lattice), ("offsets", offsets)):
            if given is not None:
                raise ValueError(f"expected the claim periodic-delaunay beside {name}, found {claim}")
        return None, None
    if lattice is None or offsets is None:
        raise ValueError("expected lattice and offsets beside the claim periodic-delaunay, found None")
    d = mesh.dimension
    vectors = np.diag(doubles_of([lattice], "edges of a box", d)[0]) if np.ndim(lattice) == 1 else doubles_of(lattice, "a lattice", d)
    if len(vectors) != d:
        raise ValueError(f"expected {d} vectors as a lattice, found {len(vectors)}")
    moves = array_of(offsets, "offsets")
    if moves.dtype.kind not in "iu":
        raise TypeError(f"expected integers as offsets, found an array of {moves.dtype}")
    expected = (*mesh.simplices.shape, d)
    if moves.shape != expected:
        raise ValueError(f"expected offsets of shape {expected}, found {moves.shape}")
    return np.ascontiguousarray(vectors, dtype=np.float64), np.ascontiguousarray(moves, dtype=np.int64)
