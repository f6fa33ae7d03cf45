#include "reference/delaunay/point_location.hpp"

#include <utility>

#include "reference/delaunay/conflict.hpp"
#include "reference/kernel/predicates/orientation.hpp"

namespace circumspect::delaunay {

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
