#include "oracle/arrays/mesh_of.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

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
  const bool has_weights = weighted && !points.weights.empty();
  std::map<Point, std::size_t> places;
  std::vector<Vertex> place_of;
  std::vector<Point> distinct;
  std::vector<Rational> weights;
  std::vector<Vertex> labels;
  for (std::size_t i = 0; i < points.size(); ++i) {
    Point point = exact_point(points, i);
    const Rational weight = has_weights ? exact_value(points.weights[i]) : Rational(0);
    const auto [found, is_new] = places.emplace(point, distinct.size());
    place_of.push_back(static_cast<Vertex>(found->second));
    if (is_new) {
      distinct.push_back(std::move(point));
      labels.push_back(static_cast<Vertex>(i));
      if (has_weights) weights.push_back(weight);
    } else if (has_weights && weights[found->second] < weight) {
      weights[found->second] = weight;
      labels[found->second] = static_cast<Vertex>(i);
    }
  }
  Mesh mesh{PointSet(std::move(distinct), std::move(weights)), {}, std::move(labels), 0, {}, {}};
  for (const std::vector<std::int64_t>& row : simplices) {
    Simplex simplex;
    for (const std::int64_t v : row) {
      const bool names_a_point = v >= 0 && v < static_cast<std::int64_t>(place_of.size());
      // What names no point must not come to name one when equal points are merged.
      simplex.push_back(names_a_point ? place_of[static_cast<std::size_t>(v)]
                                      : static_cast<Vertex>(v));
    }
    mesh.simplices.push_back(std::move(simplex));
  }
  return mesh;
}

}  // namespace circumspect::arrays
