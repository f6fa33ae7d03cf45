// Stage 3 of `validated`: what the lines of a polygon enclose, and its hole seeds.
#include <algorithm>
#include <optional>

#include "reference/piecewise_linear/breaches.hpp"
#include "reference/piecewise_linear/cell_boxes.hpp"
#include "reference/piecewise_linear/lines.hpp"
#include "reference/piecewise_linear/plane_offset.hpp"
#include "reference/piecewise_linear/polygon_triangles.hpp"
#include "reference/predicates/intersection.hpp"
#include "reference/predicates/orientation.hpp"

namespace circumspect {
namespace {

// Which of some simplices hold a point, ascending.
class Simplices {
 public:
  Simplices(const PointSet& points, const CellBoxes& boxes, std::vector<Simplex> simplices)
      : points_(points), simplices_(std::move(simplices)), index_(boxes.index_of(simplices_)) {}

  std::optional<Simplex> at(const Point& point) const {
    for (const std::size_t i : index_.meeting(box_around(point))) {
      if (!intersection(coordinates(points_, simplices_[i]), {point}).empty()) {
        return simplices_[i];
      }
    }
    return std::nullopt;
  }

 private:
  const PointSet& points_;
  std::vector<Simplex> simplices_;
  BoxIndex index_;
};

std::vector<Simplex> as_simplices(const std::vector<Vertex>& vertices) {
  std::vector<Simplex> simplices;
  for (const Vertex v : vertices) simplices.push_back({v});
  return simplices;
}

void find_polygon_seed_breaches(const PointSet& points, const CellBoxes& boxes, std::size_t place,
                                const PolygonLines& lines, const Polygon& polygon,
                                BreachList& found) {
  const std::vector<Vertex> listed = vertices_of(lines);
  const std::set<Simplex> edges = edges_of(lines);
  const std::vector<Simplex> walls(edges.begin(), edges.end());
  // Without seeds the holes belong to the polygon, and nothing else is added to it.
  const std::vector<Simplex> filled = polygon_triangles(points, polygon.axes, listed, walls, {});
  if (filled.empty()) return;
  const Simplices vertices(points, boxes, as_simplices(listed));
  const Simplices segments(points, boxes, walls);
  const Simplices triangles(points, boxes, filled);
  for (const Point& seed : polygon.hole_seeds) {
    if (found.is_full()) return;
    const Rational offset = offset_from_plane(coordinates(points, filled.front()), seed);
    if (sign(offset) != 0) {
      found.add(
          {BreachKind::kPolygonHoleSeed, filled.front(), {}, {place}, seed, Rational(offset)});
    } else if (const auto vertex = vertices.at(seed)) {
      found.add({BreachKind::kPolygonHoleSeed, *vertex, {}, {place}, seed});
    } else if (const auto segment = segments.at(seed)) {
      found.add({BreachKind::kPolygonHoleSeed, {}, {*segment}, {place}, seed});
    } else if (!triangles.at(seed)) {
      found.add({BreachKind::kPolygonHoleSeed, {}, {}, {place}, seed});
    }
  }
}

}  // namespace

void find_area_breaches(const PiecewiseLinearInput& input, const PiecewiseLinearComplex& complex,
                        BreachList& found) {
  std::optional<CellBoxes> boxes;
  for (std::size_t i = 0; i < complex.polygons.size() && !found.is_full(); ++i) {
    const Polygon& polygon = complex.polygons[i];
    const std::size_t before = found.breaches().size();
    if (!polygon.hole_seeds.empty()) {
      if (!boxes) boxes.emplace(complex.points);
      find_polygon_seed_breaches(complex.points, *boxes, i, input.polygons[i], polygon, found);
    }
    // If a seed is wrong, that may be why nothing is left.
    if (polygon.triangles.empty() && found.breaches().size() == before) {
      found.add({BreachKind::kDegeneratePolygon, {}, {}, {i}});
    }
  }
}

}  // namespace circumspect
