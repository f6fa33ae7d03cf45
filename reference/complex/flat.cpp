#include "reference/complex/flat.hpp"

#include <cassert>
#include <numeric>

#include "reference/exact/affine_hull.hpp"

namespace circumspect {

Flat flat_through(const PointSet& points, const std::vector<Vertex>& members) {
  std::vector<std::size_t> axes(points.ambient_dimension());
  std::iota(axes.begin(), axes.end(), std::size_t{0});
  return flat_through(points, axes, members);
}

Flat flat_through(const PointSet& points, const std::vector<std::size_t>& axes,
                  const std::vector<Vertex>& members) {
  assert(!members.empty());
  std::vector<Point> projections;
  for (const Vertex v : members) {
    Point projection;
    for (const std::size_t axis : axes) projection.push_back(points[v][axis]);
    projections.push_back(std::move(projection));
  }
  const AffineHull hull = affine_hull(projections);
  Flat flat;
  for (const std::size_t i : hull.basis) flat.basis.push_back(members[i]);
  for (const std::size_t i : hull.axes) flat.axes.push_back(axes[i]);
  return flat;
}

std::vector<Vertex> all_vertices(const PointSet& points) {
  std::vector<Vertex> all(points.size());
  std::iota(all.begin(), all.end(), Vertex{0});
  return all;
}

}  // namespace circumspect
