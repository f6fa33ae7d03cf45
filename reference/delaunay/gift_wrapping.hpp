// The gift-wrapping algorithm, under the canonical perturbation. Book: Section 5.6 (d = 3),
// Section 3.11 (d = 2); here in any dimension.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "kernel/complex/point_set.hpp"
#include "kernel/complex/triangulation.hpp"
#include "reference/delaunay/unfinished_facets.hpp"

namespace circumspect::delaunay {

// Finish: the candidate in front of the facet whose simplex with the facet has no other candidate
// in front in its (perturbed) open circumball; nothing if none is in front. `axes` are coordinates
// of the flat in which this happens. Candidates on the facet's own hyperplane are skipped.
std::optional<Vertex> apex_of_facet(const PointSet& points, const std::vector<std::size_t>& axes,
                                    const OrientedFacet& facet,
                                    const std::vector<Vertex>& candidates);

// A facet to start from ("seed the algorithm with one strongly Delaunay triangle"): a facet of the
// canonical triangulation that lies on the convex hull. All points on a facet of the hull have, by
// recursion on the dimension, a canonical simplex of their own, under the perturbation in their
// flat; this is a facet of the canonical triangulation of the whole set. The book's recipe below
// needs a generic set without weights; this one has no such condition. Requires: points.dimension()
// ≥ 1.
Simplex hull_facet_seed(const PointSet& points);

// The recipe of the book: an arbitrary point, its nearest neighbour, then again and again the point
// that minimises the radius of the smallest circumball of the simplex with one vertex more. Why it
// works: the ball with the first edge as its diameter is empty, because the neighbour is nearest.
// And if the smallest circumball of a simplex is empty, so is that of the simplex with the best
// further point: the balls through the simplex grow on from the empty one, within the flat that a
// point inside the new ball would span with the simplex, and would have met that point at a smaller
// radius. Requires: points.dimension() ≥ 1; the set is generic (Definition 4.2) and not weighted.
Simplex nearest_neighbour_seed(const PointSet& points);

// Called for each finished facet, with its apex, or the fact that it is on the hull.
using FinishWatch = std::function<void(const OrientedFacet&, std::optional<Vertex>)>;

// Finishes unfinished facets until none is left, and returns the simplices constructed, positively
// oriented. Requires: every unfinished facet is in the canonical triangulation of some set, and so
// is the simplex in front of it, if there is one, with a candidate for its apex. Throws
// std::logic_error if the simplices found contradict that by being in each other's way.
std::vector<Simplex> gift_wrap(const PointSet& points, const std::vector<std::size_t>& axes,
                               UnfinishedFacets unfinished, const std::vector<Vertex>& candidates,
                               const FinishWatch& watch = {});

// The canonical (weighted) Delaunay triangulation, seeded with a hull facet (hull_facet_seed).
// Any number of points, any dimension; time O(n h) for h simplices.
Triangulation gift_wrapping(const PointSet& points, const FinishWatch& watch = {});

// The same from a seed given by the caller. Requires: points.dimension() ≥ 1; the seed is a facet,
// a (k−1)-simplex, of the canonical triangulation.
Triangulation gift_wrapping(const PointSet& points, const Simplex& seed,
                            const FinishWatch& watch = {});

}  // namespace circumspect::delaunay
