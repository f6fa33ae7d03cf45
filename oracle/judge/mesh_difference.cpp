#include "oracle/judge/mesh_difference.hpp"

#include <algorithm>
#include <compare>
#include <utility>
#include <variant>

#include "kernel/exact/interruption.hpp"
#include "oracle/judge/points/cells.hpp"
#include "oracle/judge/unlike_rows.hpp"
#include "oracle/model/mesh.hpp"

namespace circumspect::check {
namespace {

// Points whose coordinates and weights are doubles.
struct PointsOfDoubles {
  const Rows<double>& coordinates;
  const Rows<double>& weights;  // none, or one a point
};

// None if a number is not a double.
std::optional<PointsOfDoubles> points_of_doubles(const Mesh& mesh) {
  const auto* const coordinates = std::get_if<Rows<double>>(&mesh.coordinates);
  const auto* const weights = std::get_if<Rows<double>>(&mesh.weights);
  if (coordinates == nullptr || weights == nullptr) return std::nullopt;
  return PointsOfDoubles{*coordinates, *weights};
}

// One of the points of a mesh; the first coordinate is at hand, since it tells most of them apart.
struct Place {
  double first;
  std::size_t point;
};

double weight(const PointsOfDoubles& points, std::size_t i) {
  return points.weights.rows() == 0 ? 0 : points.weights.row(i)[0];
}

// By coordinates from the first, then by weights. Requires: finite numbers.
std::partial_ordering order(const PointsOfDoubles& a, std::size_t i, const PointsOfDoubles& b,
                            std::size_t j) {
  const auto of_a = a.coordinates.row(i);
  const auto of_b = b.coordinates.row(j);
  const auto points =
      std::lexicographical_compare_three_way(of_a.begin(), of_a.end(), of_b.begin(), of_b.end());
  return points != 0 ? points : weight(a, i) <=> weight(b, j);
}

bool has_equal_coordinates(const PointsOfDoubles& points, std::size_t i, std::size_t j) {
  const auto first = points.coordinates.row(i);
  const auto second = points.coordinates.row(j);
  return std::equal(first.begin(), first.end(), second.begin());
}

// The points in order; none if two of them have the same coordinates.
std::optional<std::vector<Place>> in_order(const PointsOfDoubles& points) {
  std::vector<Place> places;
  places.reserve(points.coordinates.rows());
  for (std::size_t i = 0; i < points.coordinates.rows(); ++i) {
    const auto row = points.coordinates.row(i);
    places.push_back({row.empty() ? 0 : row.front(), i});
  }
  std::sort(places.begin(), places.end(), [&points](const Place& a, const Place& b) {
    end_if_interrupted();
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

bool are_one_list(const PointsOfDoubles& a, const PointsOfDoubles& b) {
  const auto are_equal = [](const Rows<double>& one, const Rows<double>& other) {
    const auto values = one.values(), others = other.values();
    return one.columns() == other.columns() &&
           std::equal(values.begin(), values.end(), others.begin(), others.end());
  };
  return are_equal(a.coordinates, b.coordinates) && are_equal(a.weights, b.weights);
}

// For each point of a the one of b that it is, or −1; what has no other goes to `result`.
// None if two points of one mesh have the same coordinates.
std::optional<std::vector<Vertex>> matched(const PointsOfDoubles& a, const PointsOfDoubles& b,
                                           Difference& result) {
  const auto places_of_a = in_order(a);
  const auto places_of_b = are_one_list(a, b) ? places_of_a : in_order(b);
  if (!places_of_a || !places_of_b) return std::nullopt;
  std::vector<Vertex> place_in_b(places_of_a->size(), -1);
  auto of_a = places_of_a->begin();
  auto of_b = places_of_b->begin();
  while (of_a != places_of_a->end() || of_b != places_of_b->end()) {
    const std::partial_ordering which = of_a == places_of_a->end() ? std::partial_ordering::greater
                                        : of_b == places_of_b->end()
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

// The simplices at some places, ascending.
CellList cells_at(const Mesh& mesh, const std::vector<std::size_t>& places) {
  CellList cells;
  for (const std::size_t i : places) cells.add(mesh.simplices[i]);
  return cells;
}

template <class Visit>
void for_each_simplex(const Mesh& mesh, const Visit& visit) {
  mesh.simplices.visit([&visit]<class Lists>(const Lists& lists) {
    if constexpr (std::is_same_v<Lists, std::vector<Simplex>>) {
      for (const Simplex& simplex : lists) visit(simplex);
    } else {
      Simplex simplex;
      for (std::size_t i = 0; i < lists.rows(); ++i) {
        const auto row = lists.row(i);
        simplex.assign(row.begin(), row.end());
        visit(simplex);
      }
    }
  });
}

CellList simplices_of(const Mesh& mesh) {
  CellList cells;
  for_each_simplex(mesh, [&cells](const Simplex& simplex) { cells.add(simplex); });
  return cells;
}

CellList dangling_faces_of(const Mesh& mesh) {
  const auto each = [&mesh](const auto& visit) { for_each_simplex(mesh, visit); };
  return dangling_faces(mesh.faces, each, mesh.points());
}

CellDifference difference_of(const Mesh& a, const Mesh& b, const std::vector<Vertex>& place_in_b) {
  // What the two meshes list equally often is in neither's list, whatever else they have. A
  // dangling face is none of these, since it would be a face of a simplex.
  const auto unlike = unlike_rows(a.simplices, b.simplices, place_in_b, b.points());
  CellList of_a = unlike ? cells_at(a, unlike->of_a) : simplices_of(a);
  CellList of_b = unlike ? cells_at(b, unlike->of_b) : simplices_of(b);
  of_a.add_all(dangling_faces_of(a));
  of_b.add_all(dangling_faces_of(b));
  return difference_of_cells(of_a, of_b, place_in_b, b.points());
}

}  // namespace

std::optional<Difference> difference(const Mesh& a, const Mesh& b) {
  const auto points_of_a = points_of_doubles(a);
  const auto points_of_b = points_of_doubles(b);
  if (!points_of_a || !points_of_b) {
    if (!equal_points(a).empty() || !equal_points(b).empty()) return std::nullopt;
    return difference(exact(a), exact(b));
  }
  Difference result;
  const auto place_in_b = matched(*points_of_a, *points_of_b, result);
  if (!place_in_b) return std::nullopt;
  result.add(difference_of(a, b, *place_in_b));
  return result;
}

}  // namespace circumspect::check
