#include "oracle/judge/arrays/mesh_of.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "oracle/model/merged_points.hpp"

namespace circumspect::arrays {
namespace {

void require_sound(const PointArray& points) {
  if (points.dimension == 0 || points.coordinates.size() % points.dimension != 0) {
    throw std::invalid_argument("expected " + std::to_string(points.dimension) +
                                " coordinates a point, found " +
                                std::to_string(points.coordinates.size()) + " in all");
  }
  if (!points.weights.empty() && points.weights.size() != points.size()) {
    throw std::invalid_argument("expected one weight a point, found " +
                                std::to_string(points.weights.size()) + " for " +
                                std::to_string(points.size()) + " points");
  }
  const auto is_finite = [](double value) { return std::isfinite(value); };
  if (!std::all_of(points.coordinates.begin(), points.coordinates.end(), is_finite) ||
      !std::all_of(points.weights.begin(), points.weights.end(), is_finite)) {
    throw std::invalid_argument("expected finite coordinates and weights, found another");
  }
}

Point exact_point(const PointArray& points, std::size_t i) {
  Point point;
  for (std::size_t axis = 0; axis < points.dimension; ++axis) {
    point.push_back(exact_value(points.point(i)[axis]));
  }
  return point;
}

}  // namespace

Mesh mesh_of(const PointArray& points, const SimplexArray& simplices, bool weighted) {
  require_sound(points);
  std::vector<Point> listed;
  std::vector<Rational> weights;
  for (std::size_t i = 0; i < points.size(); ++i) {
    listed.push_back(exact_point(points, i));
    if (weighted && !points.weights.empty()) weights.push_back(exact_value(points.weights[i]));
  }
  std::vector<Simplex> rows;
  for (const std::vector<std::int64_t>& row : simplices) rows.emplace_back(row.begin(), row.end());
  const std::vector<Duplicate> repeated = duplicates(listed);
  return mesh_of_merged(std::move(listed), std::move(weights), repeated, 0, std::move(rows));
}

}  // namespace circumspect::arrays
