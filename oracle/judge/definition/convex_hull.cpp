#include "oracle/judge/definition/convex_hull.hpp"

#include <algorithm>
#include <set>

#include "kernel/complex/polytope.hpp"
#include "kernel/exact/linear_algebra.hpp"
#include "kernel/predicates/orientation.hpp"
#include "oracle/judge/definition/triangulation.hpp"

namespace circumspect::definition {
namespace {

// The facets that have all vertices in one facet of conv S, as a mesh of its points.
ExactMesh part_in(const PointSet& points, const Face& of_hull, const std::vector<Simplex>& facets) {
  ExactMesh part{PointSet(coordinates(points, of_hull)), {}};
  for (Simplex facet : facets) {
    if (!std::includes(of_hull.begin(), of_hull.end(), facet.begin(), facet.end())) continue;
    for (Vertex& v : facet) v = std::find(of_hull.begin(), of_hull.end(), v) - of_hull.begin();
    part.simplices.push_back(facet);
  }
  return part;
}

}  // namespace

std::optional<Simplex> on_both_sides(const PointSet& points, const Simplex& facet) {
  std::optional<Vertex> first[2];
  for (Vertex q = 0; points.names(q); ++q) {
    const int side = side_of_facet(points.configuration(), facet, q);
    if (side != 0 && !first[side > 0]) first[side > 0] = q;
  }
  if (!first[0] || !first[1]) return std::nullopt;
  return sorted({*first[0], *first[1]});
}

bool cover_boundary(const PointSet& points, const std::vector<Simplex>& facets) {
  std::vector<Simplex> ascending;
  for (const Simplex& facet : facets) ascending.push_back(sorted(facet));
  for (const Face& of_hull : facets_by_definition(points, all_vertices(points))) {
    const ExactMesh part = part_in(points, of_hull, ascending);
    if (part.simplices.empty()) return false;
    Verdict verdict(Claim::kConvexHull, part, 1);
    judge_union_is_hull(part, Rule::kHullUncovered, verdict);
    if (!verdict.holds()) return false;
  }
  return true;
}

std::vector<Vertex> boundary_points(const PointSet& points) {
  std::set<Vertex> found;
  for (const Face& facet : facets_by_definition(points, all_vertices(points))) {
    found.insert(facet.begin(), facet.end());
  }
  return {found.begin(), found.end()};
}

bool is_extreme(const PointSet& points, Vertex v) {
  const std::size_t d = points.ambient_dimension();
  RationalMatrix rows(d + 1);
  for (Vertex q = 0; points.names(q); ++q) {
    if (q == v) continue;
    for (std::size_t axis = 0; axis < d; ++axis) rows[axis].push_back(points[q][axis]);
    rows[d].push_back(1);
  }
  std::vector<Rational> right = points[v];
  right.emplace_back(1);
  return !is_solvable(std::move(rows), std::move(right));
}

}  // namespace circumspect::definition
