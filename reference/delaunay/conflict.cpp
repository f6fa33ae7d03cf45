#include "reference/delaunay/conflict.hpp"

#include <algorithm>

#include "reference/kernel/complex/dictionary.hpp"
#include "reference/kernel/predicates/in_ball.hpp"
#include "reference/kernel/predicates/orientation.hpp"
#include "reference/kernel/predicates/perturbation.hpp"

namespace circumspect::delaunay {
namespace {

// The solid facet of a ghost simplex, and the sign that its orientation with a point on its outer
// side has.
struct HullFacet {
  Simplex facet;
  int outward;
};

HullFacet hull_facet(const Simplex& ghost_simplex, Simplex::const_iterator ghost) {
  const auto place = static_cast<std::size_t>(ghost - ghost_simplex.begin());
  // The ghost is in front of its facet; bringing it to the end takes one transposition for each
  // vertex behind it.
  const int outward = (ghost_simplex.size() - 1 - place) % 2 == 0 ? 1 : -1;
  return {facet_opposite(ghost_simplex, place), outward};
}

}  // namespace

bool is_in_conflict(const PointSet& points, const Simplex& simplex, Vertex q) {
  const Configuration& configuration = points.configuration();
  const auto ghost = std::find(simplex.begin(), simplex.end(), kGhost);
  if (ghost == simplex.end()) return perturbed_in_ball(configuration, simplex, q) > 0;
  const auto [facet, outward] = hull_facet(simplex, ghost);
  return perturbed_in_outer_halfspace(configuration, facet, outward, q) > 0;
}

bool is_in_unperturbed_conflict(const PointSet& points, const Simplex& simplex, Vertex q) {
  const Configuration& configuration = points.configuration();
  const auto ghost = std::find(simplex.begin(), simplex.end(), kGhost);
  if (ghost == simplex.end()) return in_ball(configuration, simplex, q) > 0;
  auto [facet, outward] = hull_facet(simplex, ghost);
  Simplex with_q = facet;
  with_q.push_back(q);
  const int side = orientation(configuration, with_q);
  if (side != 0) return side == outward;
  return in_ball(configuration, axes_of(configuration, facet), facet, q) > 0;
}

}  // namespace circumspect::delaunay
