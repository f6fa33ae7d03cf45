#include "reference/delaunay/genericity.hpp"

#include <algorithm>
#include <optional>

#include "kernel/complex/by_facet.hpp"
#include "kernel/complex/point_set.hpp"
#include "kernel/complex/simplex.hpp"
#include "kernel/complex/triangulation.hpp"
#include "kernel/exact/point.hpp"
#include "kernel/predicates/in_ball.hpp"

namespace circumspect::delaunay {
namespace {

// Some ball has all these points on its boundary iff, within their affine hull, the ball of an
// affine basis of them has the others on its boundary.
bool lie_on_one_sphere(const PointSet& points, const Simplex& subset) {
  const AffineHull hull = affine_hull(coordinates(points, subset));
  Simplex basis;
  for (const std::size_t i : hull.basis) basis.push_back(subset[i]);
  return std::all_of(subset.begin(), subset.end(), [&](Vertex q) {
    return contains(basis, q) || in_ball(points.configuration(), hull.axes, basis, q) == 0;
  });
}

}  // namespace

std::optional<Simplex> cospherical_points(const PointSet& points) {
  const std::size_t size = static_cast<std::size_t>(points.dimension() + 2);
  if (points.size() < size) return std::nullopt;
  Simplex subset = first_subset(size);
  do {
    if (lie_on_one_sphere(points, subset)) return subset;
  } while (next_subset(subset, points.size()));
  return std::nullopt;
}

std::optional<Simplex> cospherical_points_of_an_empty_ball(const PointSet& points,
                                                           const Triangulation& triangulation) {
  for (const auto group : ByFacet(facet_uses(triangulation.simplices()))) {
    if (group.size() != 2) continue;
    Simplex simplex = triangulation.simplices()[group[0].simplex];
    const Vertex apex = triangulation.simplices()[group[1].simplex][group[1].opposite];
    if (in_ball(points.configuration(), simplex, apex) != 0) continue;
    simplex.push_back(apex);
    return sorted(simplex);
  }
  return std::nullopt;
}

}  // namespace circumspect::delaunay
