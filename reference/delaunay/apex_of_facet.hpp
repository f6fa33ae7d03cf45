// The step of gift-wrapping that finds the simplex in front of a facet.
// Book: Section 3.11 (Finish), Section 5.6.
#pragma once

#include <optional>
#include <vector>

#include "reference/complex/dictionary.hpp"
#include "reference/complex/point_set.hpp"

namespace circumspect::delaunay {

// The candidate in front of the facet whose simplex with the facet has no other candidate in front
// in its (perturbed) open circumball; nothing if none is in front. `axes` are coordinates of the
// flat in which this happens. Candidates on the facet's own hyperplane are passed over.
std::optional<Vertex> apex_of_facet(const PointSet& points, const std::vector<std::size_t>& axes,
                                    const OrientedFacet& facet,
                                    const std::vector<Vertex>& candidates);

}  // namespace circumspect::delaunay
