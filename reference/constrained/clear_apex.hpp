// The step of gift-wrapping a CDT that finds the simplex in front of a facet. Book: Section 5.6 (in
// the plane Section 3.11, Finish).
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "reference/complex/oriented_facet.hpp"
#include "reference/complex/point_set.hpp"

namespace circumspect::constrained {

struct InFront {
  bool has_candidates = false;  // is any strictly in front of the facet?
  std::optional<Vertex> apex;   // the first that counts
};

// Of the candidates strictly in front of a facet, the first in the (perturbed) pencil of spheres
// through it that counts: whose simplex with the facet, positively oriented, is clear of the
// constraints. The book scans the vertices, keeps the first that is visible and replaces it by any
// later one that is visible and in the ball; taking them as they stand in the pencil asks about fewer.
//
// Clear instead of visible: the first that is clear is right if there is a CDT that has the facet. Its
// simplex in front of the facet is clear, and any other clear apex is visible from the facet.
InFront first_clear_apex(const PointSet& points, const std::vector<std::size_t>& axes,
                         const OrientedFacet& facet, const std::vector<Vertex>& candidates,
                         const std::function<bool(const Simplex&)>& is_clear);

}  // namespace circumspect::constrained
