#include "reference/delaunay/apex_of_facet.hpp"

#include "reference/predicates/orientation.hpp"
#include "reference/predicates/perturbation.hpp"

namespace circumspect::delaunay {

// Keeps the first candidate in front, and replaces it by any later one that lies in the open
// circumball of the facet and the one kept. The spheres through the facet are a pencil, in which the
// candidates in front stand in one order; the scan finds the first of them.
std::optional<Vertex> apex_of_facet(const PointSet& points, const std::vector<std::size_t>& axes,
                                    const OrientedFacet& facet,
                                    const std::vector<Vertex>& candidates) {
  std::optional<Vertex> kept;
  for (const Vertex q : candidates) {
    if (orientation(points.configuration(), axes, join(facet, q)) <= 0) continue;
    const bool better =
        !kept || perturbed_in_ball(points.configuration(), axes, join(facet, *kept), q) > 0;
    if (better) kept = q;
  }
  return kept;
}

}  // namespace circumspect::delaunay
