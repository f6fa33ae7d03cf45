#include "reference/constrained/gift_wrap_cavity.hpp"

#include <algorithm>

#include "reference/complex/facets.hpp"
#include "reference/constrained/meets_interior.hpp"
#include "reference/predicates/orientation.hpp"
#include "reference/predicates/perturbation.hpp"

namespace circumspect::constrained {
namespace {

// Finish, as in Section 3.11: of the candidates that count, the first in the pencil of spheres
// through the facet. Obstacles that have no vertex in front of the facet cannot be in the way.
std::optional<Vertex> apex_in_cavity(const PointSet& points, const Cavity& cavity,
                                     const std::vector<OrientedFacet>& cavity_facets,
                                     const OrientedFacet& facet) {
  const Configuration& configuration = points.configuration();
  std::vector<Vertex> in_front;
  for (const Vertex q : cavity.candidates) {
    if (!contains(facet.vertices, q) &&
        orientation(configuration, cavity.axes, join(facet, q)) > 0) {
      in_front.push_back(q);
    }
  }
  const std::set<Vertex> ahead(in_front.begin(), in_front.end());
  std::vector<OrientedFacet> obstacles;
  for (const OrientedFacet& other : cavity_facets) {
    const Simplex& corners = other.vertices;
    if (std::any_of(corners.begin(), corners.end(), [&](Vertex v) { return ahead.contains(v); })) {
      obstacles.push_back(other);
    }
  }
  const auto counts = [&](Vertex q) {
    return std::none_of(obstacles.begin(), obstacles.end(), [&](const OrientedFacet& obstacle) {
      return meets_interior(points, cavity.axes, join(facet, q), obstacle.vertices);
    });
  };
  const auto comes_first = [&](Vertex q, Vertex r) {
    return perturbed_in_ball(configuration, cavity.axes, join(facet, r), q) > 0;
  };
  for (; !in_front.empty(); in_front.pop_back()) {
    const auto first = std::min_element(in_front.begin(), in_front.end(), comes_first);
    if (counts(*first)) return *first;
    std::iter_swap(first, in_front.end() - 1);
  }
  return std::nullopt;
}

Simplex oriented(const PointSet& points, const std::vector<std::size_t>& axes, Simplex simplex) {
  const bool is_negative = orientation(points.configuration(), axes, simplex) < 0;
  if (is_negative) std::swap(simplex[0], simplex[1]);
  return simplex;
}

}  // namespace

Cavity cavity_of(const PointSet& points, const std::vector<std::size_t>& axes,
                 const std::set<Simplex>& walls, const std::vector<Simplex>& deleted) {
  Cavity cavity;
  cavity.axes = axes;
  std::vector<Simplex> positive;
  for (const Simplex& simplex : deleted) positive.push_back(oriented(points, axes, simplex));
  for_each_facet(facet_uses(positive), [&](std::span<const FacetUse> uses) {
    if (uses.size() == 2 && !walls.contains(uses.front().facet)) return;
    for (const FacetUse& use : uses) {
      cavity.facets.add(OrientedFacet::opposite(positive[use.simplex], use.opposite));
    }
  });
  const std::set<Vertex> vertices = vertices_of(deleted);
  cavity.candidates.assign(vertices.begin(), vertices.end());
  return cavity;
}

tl::expected<std::vector<Simplex>, NoChange> gift_wrap_cavity(const PointSet& points,
                                                              const Cavity& cavity) {
  const std::vector<OrientedFacet> cavity_facets = cavity.facets.all();
  UnfinishedFacets unfinished = cavity.facets;
  SimplexDictionary finished;
  while (!unfinished.empty()) {
    const OrientedFacet facet = unfinished.first();
    const auto apex = apex_in_cavity(points, cavity, cavity_facets, facet);
    if (!apex) return tl::unexpected(NoChange{WhyNoChange::kFacetUnfinished, facet.vertices});
    const Simplex simplex = join(facet, *apex);
    for (std::size_t place = 0; place < simplex.size(); ++place) {
      const OrientedFacet side = OrientedFacet::opposite(simplex, place);
      if (finished.adjacent(side)) {
        return tl::unexpected(NoChange{WhyNoChange::kSimplicesOverlap, side.vertices});
      }
    }
    finished.add(simplex);
    unfinished.adjoin(simplex);
  }
  std::vector<Simplex> simplices = finished.simplices();
  for (Simplex& simplex : simplices) simplex = sorted(std::move(simplex));
  std::sort(simplices.begin(), simplices.end());
  return simplices;
}

}  // namespace circumspect::constrained
