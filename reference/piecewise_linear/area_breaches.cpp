// Stage 3 of `validated`: what the lines of a polygon enclose, and its hole seeds.
#include <algorithm>
#include <optional>
#include <span>

#include "reference/complex/facets.hpp"
#include "reference/piecewise_linear/breaches.hpp"
#include "reference/piecewise_linear/cell_boxes.hpp"
#include "reference/piecewise_linear/disjoint_sets.hpp"
#include "reference/piecewise_linear/lines.hpp"
#include "reference/piecewise_linear/plane_offset.hpp"
#include "reference/piecewise_linear/polygon_triangles.hpp"
#include "reference/predicates/intersection.hpp"
#include "reference/predicates/orientation.hpp"

namespace circumspect {
namespace {

// Which of some simplices hold a point.
class Simplices {
 public:
  Simplices(const PointSet& points, const CellBoxes& boxes, std::vector<Simplex> simplices)
      : points_(points), simplices_(std::move(simplices)), index_(boxes.index_of(simplices_)) {}

  // The place in the list of one that does.
  std::optional<std::size_t> place_at(const Point& point) const {
    for (const std::size_t i : index_.meeting(box_around(point))) {
      if (!intersection(coordinates(points_, simplices_[i]), {point}).empty()) return i;
    }
    return std::nullopt;
  }
  std::optional<Simplex> at(const Point& point) const {
    const auto place = place_at(point);
    return place ? std::optional(simplices_[*place]) : std::nullopt;
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

// For each triangle of a polygon with all its holes filled: is it in a component of the complement of
// the lines that is beside the unbounded one? Without such a component a polygon has an indentation,
// or is nothing, but no hole.
std::vector<bool> beside_outside(const std::vector<Simplex>& filled,
                                 const std::set<Simplex>& edges) {
  const std::vector<FacetUse> uses = facet_uses(filled);
  DisjointSets components(filled.size());
  for_each_facet(uses, [&](std::span<const FacetUse> at_edge) {
    const bool is_within = at_edge.size() == 2 && !edges.contains(at_edge.front().facet);
    if (is_within) components.unite(at_edge[0].simplex, at_edge[1].simplex);
  });
  std::vector<bool> is_beside(filled.size(), false);
  for_each_facet(uses, [&](std::span<const FacetUse> at_edge) {
    if (at_edge.size() == 1) is_beside[components.find(at_edge.front().simplex)] = true;
  });
  std::vector<bool> answers;
  for (std::size_t i = 0; i < filled.size(); ++i) {
    answers.push_back(is_beside[components.find(i)]);
  }
  return answers;
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
  const std::vector<bool> is_beside_outside = beside_outside(filled, edges);
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
    } else if (const auto place_in_filled = triangles.place_at(seed);
               !place_in_filled || is_beside_outside[*place_in_filled]) {
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
    // If nothing is left, a seed that is in no hole may be why.
    if (polygon.triangles.empty() && found.breaches().size() == before) {
      found.add({BreachKind::kDegeneratePolygon, {}, {}, {i}});
    }
  }
}

}  // namespace circumspect
