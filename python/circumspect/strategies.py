"""Hypothesis strategies that draw from the families of inputs, and shrink.

    from hypothesis import given
    import circumspect, circumspect.strategies

    @given(circumspect.strategies.points(dimension=2, min_points=3))
    def test_triangulate(points):
        circumspect.assert_delaunay(points, triangulate(points))
"""
from __future__ import annotations

from typing import Any, Optional, Sequence, Tuple

import hypothesis.strategies as st
import numpy as np

from . import _core, families as all_families, generate_domain
from .campaigns import EXPONENTS, is_wanted, within_exponents
from .domains import with_cells_of


def names_in(dimension: int, families: Optional[Sequence[str]]) -> list:
    """The families to draw from; raises ValueError for those that do not exist in the dimension."""
    known = {family.name: family for family in all_families() if not family.is_of_domains}
    if families is None:
        return [name for name, family in known.items()
                if dimension in family.dimensions and not family.weighted and not family.repeats_points]
    for name in families:
        if name not in known or dimension not in known[name].dimensions:
            raise ValueError(f"expected a family of points of dimension {dimension}, found {name!r}")
    return list(families)


@st.composite
def drawn_points(draw: Any, names: list, dimension: int, min_points: int, max_points: int, flat: bool,
                 exponents: Optional[Tuple[int, int]]):
    """A set of a family; shrinks by leaving points out, then by coordinates that are small integers."""
    family = draw(st.sampled_from(names))
    seed = draw(st.integers(0, 2**32 - 1))
    points = within_exponents(*_core.generate(family, dimension, max_points, seed, False), exponents)[0]
    # 0 leaves a point out; few are, at first.
    kept = draw(st.lists(st.integers(0, 15), min_size=len(points), max_size=len(points)))
    points = points[np.array(kept, dtype=int) > 0]
    if draw(st.integers(0, 7)) == 0:
        points = ranks(points)
    enough = len(points) >= min_points and (flat or is_wanted(points, False))
    return points if enough else None


def ranks(points: Any):
    """Replaces each coordinate by its rank on its axis; of points that become equal, keeps the first."""
    columns = [np.unique(column, return_inverse=True)[1].astype(float) for column in points.T]
    moved = np.stack(columns, axis=1) if len(points) else points
    return moved[np.sort(np.unique(moved, axis=0, return_index=True)[1])]


def points(families: Optional[Sequence[str]] = None, dimension: int = 3, min_points: int = 1, max_points: int = 12,
           flat: bool = False, exponents: Optional[Tuple[int, int]] = EXPONENTS) -> st.SearchStrategy:
    """(n, d) doubles: distinct points, degenerate, nearly degenerate, or neither.

    `flat`: also points that span less than their space. `exponents`: coordinates other than 0 lie between these powers
    of 2, by default those of a campaign; None: as the family draws them, up to 1e300.
    """
    if not 1 <= min_points <= max_points:
        raise ValueError(f"expected 1 <= min_points <= max_points, found {min_points} and {max_points}")
    least = min_points if flat else max(min_points, dimension + 1)
    names = names_in(dimension, families)
    return drawn_points(names, dimension, least, max(max_points, least), flat, exponents).filter(lambda drawn: drawn is not None)


@st.composite
def drawn_domain(draw: Any, names: list, max_points: int):
    """A domain of a family; shrinks by leaving out segments, polygons and the points that these used, then to smaller sets."""
    family = draw(st.sampled_from(names))
    domain = generate_domain(family, points=draw(st.integers(4, max_points)), seed=draw(st.integers(0, 2**32 - 1)))
    kept = []
    for count in (len(domain.segments), len(domain.polygons)):
        marks = draw(st.lists(st.integers(0, 15), min_size=count, max_size=count))  # 0 leaves a cell out; few are, at first
        kept.append([cell for cell, mark in enumerate(marks) if mark > 0])
    fewer = with_cells_of(domain, *kept)
    return fewer if len(fewer.points) and is_wanted(fewer.points, fewer.kind != "hull") else None


def domains(families: Optional[Sequence[str]] = None, dimension: int = 3, max_points: int = 12) -> st.SearchStrategy:
    """Valid domains (circumspect.Domain) of the plane or of space."""
    known = [family.name for family in all_families()
             if family.is_of_domains and dimension in family.dimensions]
    names = known if families is None else list(families)
    for name in names:
        if name not in known:
            raise ValueError(f"expected a family of domains of dimension {dimension}, found {name!r}")
    return drawn_domain(names, max_points).filter(lambda drawn: drawn is not None)
