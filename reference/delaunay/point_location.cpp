#include "reference/delaunay/point_location.hpp"

#include <algorithm>
#include <utility>

#include "kernel/predicates/in_ball.hpp"
#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/perturbation.hpp"
#include "reference/delaunay/dictionary.hpp"

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
  // The ghost is in front of its facet; moving it to the end takes one transposition for each
  // vertex after it.
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
  const int side = side_of_facet(configuration, facet, q);
  if (side != 0) return side == outward;
  return in_ball(configuration, axes_of(configuration, facet), facet, q) > 0;
}

std::optional<Simplex> linear_scan(const PointSet& points, const SimplexDictionary& dictionary,
                                   Vertex q, Statistics& statistics) {
  return dictionary.find([&](const Simplex& simplex) {
    ++statistics.conflict_tests;
    return is_in_conflict(points, simplex, q);
  });
}

namespace {

// The place of a vertex of the simplex on the other side of whose facet q lies strictly; nothing if
// the simplex contains q. Requires: the simplex solid and positively oriented.
std::optional<std::size_t> facet_towards(const PointSet& points, Simplex simplex, Vertex q) {
  for (std::size_t place = 0; place < simplex.size(); ++place) {
    const Vertex apex = std::exchange(simplex[place], q);
    if (orientation(points.configuration(), simplex) < 0) return place;
    simplex[place] = apex;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Simplex> walk(const PointSet& points, const SimplexDictionary& dictionary,
                            const Simplex& start, Vertex q, Statistics& statistics) {
  Simplex simplex = start;
  while (!is_ghost(simplex)) {
    const std::optional<std::size_t> place = facet_towards(points, simplex, q);
    if (!place) break;
    const OrientedFacet crossed = OrientedFacet::opposite(simplex, *place).reverse();
    simplex = join(crossed, dictionary.adjacent(crossed).value());
    ++statistics.walk_steps;
  }
  ++statistics.conflict_tests;
  if (!is_in_conflict(points, simplex, q)) return std::nullopt;
  return simplex;
}

}  // namespace circumspect::delaunay
