#include "reference/constrained/clear_apex.hpp"

#include <algorithm>

#include "reference/predicates/orientation.hpp"
#include "reference/predicates/perturbation.hpp"

namespace circumspect::constrained {

InFront first_clear_apex(const PointSet& points, const std::vector<std::size_t>& axes,
                         const OrientedFacet& facet, const std::vector<Vertex>& candidates,
                         const std::function<bool(const Simplex&)>& is_clear) {
  std::vector<Vertex> in_front;
  for (const Vertex q : candidates) {
    if (contains(facet.vertices, q)) continue;
    if (orientation(points.configuration(), axes, join(facet, q)) > 0) in_front.push_back(q);
  }
  // A heap whose top is the first in the pencil: a comes later than b iff b is in the ball of a.
  const auto comes_later = [&](Vertex a, Vertex b) {
    return a != b && perturbed_in_ball(points.configuration(), axes, join(facet, a), b) > 0;
  };
  InFront result{!in_front.empty(), std::nullopt};
  std::make_heap(in_front.begin(), in_front.end(), comes_later);
  while (!in_front.empty() && !result.apex) {
    std::pop_heap(in_front.begin(), in_front.end(), comes_later);
    if (is_clear(join(facet, in_front.back()))) result.apex = in_front.back();
    in_front.pop_back();
  }
  return result;
}

}  // namespace circumspect::constrained
