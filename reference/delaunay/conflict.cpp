#include "reference/delaunay/conflict.hpp"

#include <algorithm>

#include "reference/complex/dictionary.hpp"
#include "reference/predicates/perturbation.hpp"

namespace circumspect::delaunay {

bool is_in_conflict(const PointSet& points, const Simplex& simplex, Vertex q) {
  const Configuration& configuration = points.configuration();
  const auto ghost = std::find(simplex.begin(), simplex.end(), kGhost);
  if (ghost == simplex.end()) return perturbed_in_ball(configuration, simplex, q) > 0;
  const auto place = static_cast<std::size_t>(ghost - simplex.begin());
  // The ghost is in front of its facet; bringing it to the end takes one transposition for each
  // vertex behind it.
  const int outward = (simplex.size() - 1 - place) % 2 == 0 ? 1 : -1;
  return perturbed_in_outer_halfspace(configuration, facet_opposite(simplex, place), outward, q) >
         0;
}

}  // namespace circumspect::delaunay
