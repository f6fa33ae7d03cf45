"""Turns convex hulls of common libraries into lists of facets."""
from __future__ import annotations

from typing import Any, Optional


def is_hull(mesh: Any) -> bool:
    """Is it scipy.spatial.ConvexHull, or made like it? It lists its vertices and the hyperplanes of its facets."""
    return all(hasattr(mesh, name) for name in ("points", "simplices", "vertices", "equations", "volume"))


def claim_of(mesh: Any) -> Optional[str]:
    """The claim that fits an object if the user names none; None leaves the usual one."""
    return "convex-hull" if is_hull(mesh) else None


def facets_of(facets: Any) -> Any:
    """The facets of a hull as rows. In the plane vertices in their cyclic order may be a flat list."""
    import numpy as np

    return np.asarray(facets)[:, None] if facets is not None and np.ndim(facets) == 1 and np.size(facets) else facets
