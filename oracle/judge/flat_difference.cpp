#include "oracle/judge/flat_difference.hpp"

#include <algorithm>
#include <compare>
#include <thread>
#include <utility>
#include <variant>

#include "oracle/judge/fast/finite.hpp"
#include "oracle/judge/mesh_of_doubles.hpp"

namespace circumspect::check {
namespace {

using formats::FlatPoints;

// One of the points of a mesh; the first coordinate is at hand, since it tells most of them apart.
struct Place {
  double first;
  std::size_t point;
};

double weight(const FlatPoints& points, std::size_t i) {
  return points.weights.rows() == 0 ? 0 : points.weights.row(i)[0];
}

// By coordinates from the first, then by weights. Requires: finite numbers.
std::partial_ordering order(const FlatPoints& a, std::size_t i, const FlatPoints& b,
                            std::size_t j) {
  const auto of_a = a.coordinates.row(i);
  const auto of_b = b.coordinates.row(j);
  const auto points =
      std::lexicographical_compare_three_way(of_a.begin(), of_a.end(), of_b.begin(), of_b.end());
  return points != 0 ? points : weight(a, i) <=> weight(b, j);
}

bool has_equal_coordinates(const FlatPoints& points, std::size_t i, std::size_t j) {
  const auto first = points.coordinates.row(i);
  const auto second = points.coordinates.row(j);
  return std::equal(first.begin(), first.end(), second.begin());
}

// The points in order; none if two of them have the same coordinates, or a number is not finite.
std::optional<std::vector<Place>> in_order(const FlatPoints& points) {
  const unsigned threads = std::max(1U, std::thread::hardware_concurrency());
  if (!fast::are_finite(points.coordinates.values(), threads) ||
      !fast::are_finite(points.weights.values(), threads)) {
    return std::nullopt;
  }
  std::vector<Place> places;
  places.reserve(points.coordinates.rows());
  for (std::size_t i = 0; i < points.coordinates.rows(); ++i) {
    const auto row = points.coordinates.row(i);
    places.push_back({row.empty() ? 0 : row.front(), i});
  }
  std::sort(places.begin(), places.end(), [&points](const Place& a, const Place& b) {
    if (a.first != b.first) return a.first < b.first;
    return order(points, a.point, points, b.point) < 0;
  });
  const auto repeated =
      std::adjacent_find(places.begin(), places.end(), [&points](const Place& a, const Place& b) {
        return a.first == b.first && has_equal_coordinates(points, a.point, b.point);
      });
  if (repeated != places.end()) return std::nullopt;
  return places;
}

// For each point of a the one of b that it is, or −1; what has no other goes to `result`.
std::vector<Vertex> matched(const FlatPoints& a, const std::vector<Place>& places_of_a,
                            const FlatPoints& b, const std::vector<Place>& places_of_b,
                            Difference& result) {
  std::vector<Vertex> place_in_b(places_of_a.size(), -1);
  auto of_a = places_of_a.begin();
  auto of_b = places_of_b.begin();
  while (of_a != places_of_a.end() || of_b != places_of_b.end()) {
    const std::partial_ordering which = of_a == places_of_a.end() ? std::partial_ordering::greater
                                        : of_b == places_of_b.end()
                                            ? std::partial_ordering::less
                                            : order(a, of_a->point, b, of_b->point);
    if (which < 0) {
      result.points_only_in_a.push_back(static_cast<Vertex>((of_a++)->point));
    } else if (which > 0) {
      result.points_only_in_b.push_back(static_cast<Vertex>((of_b++)->point));
    } else {
      place_in_b[(of_a++)->point] = static_cast<Vertex>((of_b++)->point);
    }
  }
  std::sort(result.points_only_in_a.begin(), result.points_only_in_a.end());
  std::sort(result.points_only_in_b.begin(), result.points_only_in_b.end());
  return place_in_b;
}

formats::FlatRows<double> copy(const formats::FlatRows<double>& rows) {
  formats::FlatRows<double> copied(rows.rows(), rows.columns());
  std::copy(rows.values().begin(), rows.values().end(), copied.values().begin());
  return copied;
}

}  // namespace

FlatComplex flat_complex(const formats::FlatMesh& mesh, bool weighted) {
  FlatComplex complex;
  complex.points.first_index = mesh.points.first_index;
  complex.points.coordinates = copy(mesh.points.coordinates);
  if (weighted) complex.points.weights = copy(mesh.points.weights);
  std::visit(
      [&complex](const auto& rows) {
        complex.cells.reserve(rows.rows(), rows.rows() * rows.columns());
        for (std::size_t i = 0; i < rows.rows(); ++i) complex.cells.add(rows.row(i));
      },
      mesh.simplices);
  std::vector<Simplex> faces = mesh.faces;
  std::erase_if(faces, [d = mesh.dimension()](const Simplex& face) { return face.size() > d; });
  add_dangling(complex.cells, faces, mesh.points.coordinates.rows());
  return complex;
}

std::optional<FlatComplex> flat_complex(const Mesh& mesh) {
  auto points = points_of_doubles(mesh.points);
  if (!points) return std::nullopt;
  return FlatComplex{std::move(*points), cells_of(mesh)};
}

std::optional<Difference> difference(const FlatComplex& a, const FlatComplex& b) {
  const auto places_of_a = in_order(a.points);
  const auto places_of_b = in_order(b.points);
  if (!places_of_a || !places_of_b) return std::nullopt;
  Difference result;
  const auto place_in_b = matched(a.points, *places_of_a, b.points, *places_of_b, result);
  CellDifference cells = difference_of_cells(a.cells, b.cells, place_in_b, places_of_b->size());
  result.simplices_only_in_a = std::move(cells.only_in_a);
  result.simplices_only_in_b = std::move(cells.only_in_b);
  return result;
}

}  // namespace circumspect::check
