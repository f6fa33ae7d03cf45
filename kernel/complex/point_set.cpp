#include "kernel/complex/point_set.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "kernel/exact/interruption.hpp"
#include "kernel/exact/point.hpp"
#include "kernel/predicates/orientation.hpp"

namespace circumspect {

namespace {

// Equal points would have consecutive ranks.
bool are_different(const std::vector<Point>& points, const Configuration& configuration) {
  std::vector<std::size_t> order(points.size());
  for (std::size_t v = 0; v < order.size(); ++v) {
    order[configuration.rank(static_cast<Vertex>(v))] = v;
  }
  return std::adjacent_find(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
           return points[a] == points[b];
         }) == order.end();
}

}  // namespace

std::vector<Duplicate> duplicates(const std::vector<Point>& points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    end_if_interrupted();
    return points[a] < points[b];
  });
  std::vector<Duplicate> found;
  for (std::size_t i = 0; i < order.size();) {
    std::size_t j = i + 1;
    for (; j < order.size() && points[order[j]] == points[order[i]]; ++j) {
      found.push_back({static_cast<Vertex>(order[i]), static_cast<Vertex>(order[j])});
    }
    i = j;
  }
  std::sort(found.begin(), found.end(),
            [](const Duplicate& a, const Duplicate& b) { return a.again < b.again; });
  return found;
}

PointSet::PointSet(std::vector<Point> points, std::vector<Rational> weights)
    : points_(std::move(points)), weights_(std::move(weights)), configuration_(points_, weights_) {
  assert(are_different(points_, configuration_));
}

std::vector<Point> coordinates(const PointSet& points, const Simplex& simplex) {
  std::vector<Point> vertices;
  vertices.reserve(simplex.size());
  for (const Vertex v : simplex) vertices.push_back(points[v]);
  return vertices;
}

Point barycentre(const PointSet& points, const Simplex& simplex) {
  return barycentre(coordinates(points, simplex));
}

Simplex positively_oriented(const PointSet& points, std::span<const std::size_t> axes,
                            Simplex simplex) {
  if (orientation(points.configuration(), axes, simplex) < 0) std::swap(simplex[0], simplex[1]);
  return simplex;
}

Simplex positively_oriented(const PointSet& points, Simplex simplex) {
  if (orientation(points.configuration(), simplex) < 0) std::swap(simplex[0], simplex[1]);
  return simplex;
}

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
