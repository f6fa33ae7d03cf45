#include "oracle/judge/mesh_of_doubles.hpp"

#include <cmath>
#include <utility>

namespace circumspect::check {
namespace {

using formats::FlatRows;

bool read(const Rational& number, double& value) {
  value = number.get_d();
  return std::isfinite(value) && exact_value(value) == number;
}

bool read_coordinates(const PointSet& points, FlatRows<double>& rows) {
  rows = FlatRows<double>(points.size(), points.ambient_dimension());
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    for (std::size_t axis = 0; axis < rows.columns(); ++axis) {
      if (!read(points.points()[i][axis], rows.row(i)[axis])) return false;
    }
  }
  return true;
}

bool read_weights(const PointSet& points, FlatRows<double>& rows) {
  if (!points.is_weighted()) return true;
  rows = FlatRows<double>(points.size(), 1);
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    if (!read(points.weight(static_cast<Vertex>(i)), rows.row(i)[0])) return false;
  }
  return true;
}

// `listed` less `first`, −1 for −1. False if that is below −1, or −1 for another, or more than 32 bits hold.
bool read_index(Vertex listed, Vertex first, std::int32_t& index) {
  index = -1;
  if (listed == -1) return true;
  Vertex wide = 0;
  if (__builtin_sub_overflow(listed, first, &wide)) return false;
  index = static_cast<std::int32_t>(wide);
  return wide >= 0 && index == wide;
}

bool read_indices(const std::vector<std::vector<Vertex>>& lists, std::size_t columns, Vertex first,
                  FlatRows<std::int32_t>& rows) {
  rows = FlatRows<std::int32_t>(lists.size(), columns);
  for (std::size_t i = 0; i < lists.size(); ++i) {
    if (lists[i].size() != columns) return false;
    for (std::size_t j = 0; j < columns; ++j) {
      if (!read_index(lists[i][j], first, rows.row(i)[j])) return false;
    }
  }
  return true;
}

}  // namespace

std::optional<formats::FlatPoints> points_of_doubles(const PointSet& points) {
  formats::FlatPoints flat;
  if (!read_coordinates(points, flat.coordinates)) return std::nullopt;
  if (!read_weights(points, flat.weights)) return std::nullopt;
  return flat;
}

std::optional<formats::FlatMesh> mesh_of_doubles(const Mesh& mesh) {
  if (mesh.simplices.empty()) return std::nullopt;
  const std::size_t columns = mesh.simplices.front().size();
  formats::FlatMesh flat;
  FlatRows<std::int32_t>& simplices = flat.simplices.emplace<FlatRows<std::int32_t>>();
  if (!read_indices(mesh.simplices, columns, 0, simplices)) return std::nullopt;
  auto points = points_of_doubles(mesh.points);
  if (!points) return std::nullopt;
  flat.points = std::move(*points);
  flat.points.first_index = mesh.first_index;
  if (mesh.neighbors) {
    FlatRows<std::int32_t>& neighbors = flat.neighbors.emplace();
    if (mesh.neighbors->rows.size() != mesh.simplices.size()) return std::nullopt;
    if (!read_indices(mesh.neighbors->rows, columns, mesh.neighbors->first_index, neighbors)) {
      return std::nullopt;
    }
  }
  return flat;
}

}  // namespace circumspect::check
