#include "reference/delaunay/gift_wrapping.hpp"

#include <cassert>
#include <optional>
#include <vector>

#include "kernel/complex/circumball.hpp"
#include "kernel/complex/point_set.hpp"
#include "kernel/complex/polytope.hpp"
#include "kernel/complex/star_index.hpp"
#include "kernel/complex/triangulation.hpp"
#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/perturbation.hpp"
#include "reference/delaunay/dictionary.hpp"
#include "reference/delaunay/unfinished_facets.hpp"

namespace circumspect::delaunay {

// Keeps the first candidate in front, and replaces it by any later one that lies in the open
// circumball of the facet and the one kept. The spheres through the facet are a pencil, in which
// the candidates in front have a linear order; the scan finds the first of them.
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

std::vector<Simplex> gift_wrap(const PointSet& points, const std::vector<std::size_t>& axes,
                               UnfinishedFacets unfinished, const std::vector<Vertex>& candidates,
                               const FinishWatch& watch) {
  SimplexDictionary dictionary;
  while (!unfinished.empty()) {
    const OrientedFacet facet = unfinished.first();
    const std::optional<Vertex> apex = apex_of_facet(points, axes, facet, candidates);
    if (watch) watch(facet, apex);
    if (apex) {
      const Simplex simplex = join(facet, *apex);
      dictionary.add(simplex);
      unfinished.adjoin(simplex);
    } else {
      unfinished.remove(facet);  // Nothing is in front: the facet is on the hull.
    }
  }
  return dictionary.simplices();
}

Triangulation gift_wrapping(const PointSet& points, const Simplex& seed, const FinishWatch& watch) {
  const Flat flat = flat_through(points, all_vertices(points));
  UnfinishedFacets unfinished;
  unfinished.add(OrientedFacet::of(seed));
  unfinished.add(OrientedFacet::of(seed).reverse());
  return Triangulation(points.dimension(),
                       gift_wrap(points, flat.axes, unfinished, all_vertices(points), watch));
}

Triangulation gift_wrapping(const PointSet& points, const FinishWatch& watch) {
  if (points.empty()) return Triangulation(-1, {});
  if (points.dimension() == 0) return Triangulation(0, {{0}});
  return gift_wrapping(points, hull_facet_seed(points), watch);
}

}  // namespace circumspect::delaunay
