#include "reference/delaunay/gift_wrapping_seed.hpp"

#include <cassert>
#include <optional>

#include "reference/complex/circumball.hpp"
#include "reference/complex/polytope.hpp"
#include "reference/delaunay/apex_of_facet.hpp"
#include "reference/predicates/orientation.hpp"

namespace circumspect::delaunay {
namespace {

// The facet with the members, all on one side of it, in front.
OrientedFacet facing(const PointSet& points, const std::vector<std::size_t>& axes,
                     const Simplex& facet, const std::vector<Vertex>& members) {
  const OrientedFacet oriented = OrientedFacet::of(facet);
  for (const Vertex q : members) {
    const int side = orientation(points.configuration(), axes, join(oriented, q));
    if (side != 0) return side > 0 ? oriented : oriented.reverse();
  }
  return oriented;
}

// A simplex of the canonical triangulation of the members in their own flat, on its boundary.
Simplex canonical_simplex(const PointSet& points, const std::vector<Vertex>& members) {
  const Flat flat = flat_through(points, members);
  if (flat.dimension() == 0) return {members.front()};
  const Simplex seed = canonical_simplex(points, some_facet(points, flat.axes, members));
  const OrientedFacet facet = facing(points, flat.axes, seed, members);
  const std::optional<Vertex> apex = apex_of_facet(points, flat.axes, facet, members);
  assert(apex.has_value());
  return sorted(join(facet, *apex));
}

}  // namespace

Simplex hull_facet_seed(const PointSet& points) {
  const std::vector<Vertex> all = all_vertices(points);
  return canonical_simplex(points, some_facet(points, flat_through(points, all).axes, all));
}

Simplex nearest_neighbour_seed(const PointSet& points) {
  Simplex seed = {0};
  while (static_cast<int>(seed.size()) < points.dimension()) {
    std::optional<Rational> least;
    Simplex best;
    for (const Vertex q : all_vertices(points)) {
      Simplex larger = seed;
      larger.push_back(q);
      if (flat_through(points, larger).dimension() < seed.size()) continue;
      const Rational squared_radius = circumball(points, larger).squared_radius;
      if (least && squared_radius >= *least) continue;
      least = squared_radius;
      best = larger;
    }
    seed = best;
  }
  return sorted(seed);
}

}  // namespace circumspect::delaunay
