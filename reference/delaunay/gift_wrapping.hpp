// The gift-wrapping algorithm, under the canonical perturbation. Book: Section 5.6 (d = 3),
// Section 3.11 (d = 2); here in any dimension.
#pragma once

#include <vector>

#include "reference/complex/flat.hpp"
#include "reference/complex/triangulation.hpp"
#include "reference/complex/unfinished_facets.hpp"

namespace circumspect::delaunay {

// Finishes unfinished facets until none is left, and returns the simplices constructed, positively
// oriented. Requires: every unfinished facet is in the canonical triangulation of some set, and so is
// the simplex in front of it, if there is one, with a candidate for its apex. Throws
// std::logic_error if the simplices found contradict that by being in each other's way.
std::vector<Simplex> gift_wrap(const PointSet& points, const std::vector<std::size_t>& axes,
                               UnfinishedFacets unfinished, const std::vector<Vertex>& candidates);

// The canonical (weighted) Delaunay triangulation, seeded with a hull facet (gift_wrapping_seed).
// Any number of points, any dimension; time O(n h) for h simplices.
Triangulation gift_wrapping(const PointSet& points);

// The same from a seed of the caller's. Requires: points.dimension() ≥ 1; the seed is a facet, a
// (k−1)-simplex, of the canonical triangulation.
Triangulation gift_wrapping(const PointSet& points, const Simplex& seed);

}  // namespace circumspect::delaunay
