#include "oracle/judge/arrays/mesh_of.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <utility>

#include "oracle/model/mesh.hpp"

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

}  // namespace

Mesh mesh_of(const PointArray& points, const SimplexArray& simplices, bool weighted) {
  require_sound(points);
  Mesh mesh;
  mesh.coordinates = Rows<double>::of(points.coordinates, points.dimension);
  if (weighted && !points.weights.empty()) mesh.weights = Rows<double>::of(points.weights, 1);
  std::vector<Simplex> rows;
  rows.reserve(simplices.size());
  for (const std::vector<std::int64_t>& row : simplices) rows.emplace_back(row.begin(), row.end());
  mesh.simplices = IndexLists(std::move(rows));
  return mesh;
}

ExactMesh exact_mesh_of(const PointArray& points, const SimplexArray& simplices, bool weighted) {
  Mesh mesh = mesh_of(points, simplices, weighted);
  merge_equal_points(mesh);
  return exact(mesh);
}

}  // namespace circumspect::arrays
