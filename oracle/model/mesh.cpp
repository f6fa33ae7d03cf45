#include "oracle/model/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace circumspect {
namespace {

Rational exact_number(double number) { return exact_value(number); }
const Rational& exact_number(const Rational& number) { return number; }

Rational exact_at(const Numbers& numbers, std::size_t row, std::size_t column) {
  return std::visit([&](const auto& rows) { return Rational(exact_number(rows.row(row)[column])); },
                    numbers);
}

// `number(row, column)`, in doubles if all are.
template <class Number>
Numbers in_narrowest(std::size_t rows, std::size_t columns, const Number& number) {
  Rows<double> doubles(rows, columns);
  bool fits = true;
  for (std::size_t i = 0; i < rows && fits; ++i) {
    for (std::size_t j = 0; j < columns && fits; ++j) {
      double& value = doubles.row(i)[j];
      value = number(i, j).get_d();
      fits = std::isfinite(value) && exact_value(value) == number(i, j);
    }
  }
  if (fits) return doubles;
  Rows<Rational> exact_rows(rows, columns);
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) exact_rows.row(i)[j] = number(i, j);
  }
  return exact_rows;
}

// Its indices in the order in which the vertices stand here.
Simplex in_order(const AsListed::Cell& cell, const Simplex& vertices) {
  if (cell.vertices == vertices) return cell.indices;
  Simplex indices;
  for (const Vertex v : vertices) {
    const auto found = std::find(cell.vertices.begin(), cell.vertices.end(), v);
    indices.push_back(cell.indices[static_cast<std::size_t>(found - cell.vertices.begin())]);
  }
  return indices;
}

// Every index but −1 less `before`, plus `after`.
void shift(std::vector<Simplex>& lists, Vertex before, Vertex after) {
  for (Simplex& list : lists) {
    for (Vertex& index : list) {
      if (index != -1) index = index_of_place(place_of_index(index, before), after);
    }
  }
}

}  // namespace

Numbers numbers_of(const std::vector<Point>& points, std::size_t dimension) {
  return in_narrowest(
      points.size(), dimension,
      [&](std::size_t i, std::size_t j) -> const Rational& { return points[i][j]; });
}

Numbers numbers_of(const std::vector<Rational>& numbers) {
  return in_narrowest(numbers.size(), 1,
                      [&](std::size_t i, std::size_t) -> const Rational& { return numbers[i]; });
}

std::size_t rows_of(const Numbers& numbers) {
  return std::visit([](const auto& rows) { return rows.rows(); }, numbers);
}

std::size_t columns_of(const Numbers& numbers) {
  return std::visit([](const auto& rows) { return rows.columns(); }, numbers);
}

ListedNeighbors::ListedNeighbors(Neighbors listed) : first_index(listed.first_index) {
  const Vertex before_first = index_of_place(-1, first_index);
  are_as_listed = before_first != -1 &&
                  std::any_of(listed.rows.begin(), listed.rows.end(), [&](const auto& row) {
                    return std::find(row.begin(), row.end(), before_first) != row.end();
                  });
  if (!are_as_listed) shift(listed.rows, first_index, 0);
  rows = IndexLists(std::move(listed.rows));
}

Neighbors ListedNeighbors::as_listed() const {
  Neighbors listed{rows.lists(), first_index};
  if (!are_as_listed) shift(listed.rows, 0, first_index);
  return listed;
}

Point Mesh::point(Vertex v) const {
  Point point;
  point.reserve(dimension());
  for (std::size_t axis = 0; axis < dimension(); ++axis) {
    point.push_back(exact_at(coordinates, static_cast<std::size_t>(v), axis));
  }
  return point;
}

Rational Mesh::weight(Vertex v) const {
  return is_weighted() ? exact_at(weights, static_cast<std::size_t>(v), 0) : Rational(0);
}

std::vector<Point> Mesh::exact_points() const {
  std::vector<Point> all;
  all.reserve(points());
  for (Vertex v = 0; names(v); ++v) all.push_back(point(v));
  return all;
}

Simplex Mesh::listed(const Simplex& simplex, std::optional<std::size_t> place) const {
  if (place) {
    const auto found = as_listed.by_place.find(*place);
    if (found != as_listed.by_place.end()) return found->second;
  } else {
    const auto found = as_listed.by_set.find(sorted(simplex));
    if (found != as_listed.by_set.end()) return in_order(found->second, simplex);
  }
  Simplex own;
  for (const Vertex v : simplex) own.push_back(label(v));
  return own;
}

ExactMesh exact(const Mesh& mesh) {
  std::vector<Rational> weights;
  if (mesh.is_weighted()) {
    weights.reserve(mesh.points());
    for (Vertex v = 0; mesh.names(v); ++v) weights.push_back(mesh.weight(v));
  }
  ExactMesh result{PointSet(mesh.exact_points(), std::move(weights)),
                   mesh.simplices.lists(),
                   mesh.labels,
                   mesh.first_index,
                   {},
                   mesh.faces};
  if (mesh.neighbors) result.neighbors = mesh.neighbors->as_listed();
  return result;
}

Mesh in_rows(const ExactMesh& mesh) {
  Mesh result;
  result.coordinates = numbers_of(mesh.points.points(), mesh.points.ambient_dimension());
  if (mesh.points.is_weighted()) {
    std::vector<Rational> weights;
    for (Vertex v = 0; mesh.points.names(v); ++v) weights.push_back(mesh.points.weight(v));
    result.weights = numbers_of(weights);
  }
  result.simplices = IndexLists(mesh.simplices);
  result.labels = mesh.labels;
  result.first_index = mesh.first_index;
  if (mesh.neighbors) result.neighbors.emplace(*mesh.neighbors);
  result.faces = mesh.faces;
  return result;
}

}  // namespace circumspect
