#include "kernel/piecewise_linear/validity.hpp"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <map>
#include <optional>

#include "kernel/complex/by_facet.hpp"
#include "kernel/complex/point_set.hpp"
#include "kernel/complex/simplex.hpp"
#include "kernel/piecewise_linear/cell_boxes.hpp"
#include "kernel/piecewise_linear/cell_index.hpp"
#include "kernel/piecewise_linear/disjoint_sets.hpp"
#include "kernel/piecewise_linear/nearest_plane.hpp"
#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "kernel/piecewise_linear/polygon_triangles.hpp"
#include "kernel/predicates/intersection.hpp"
#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/place.hpp"

namespace circumspect {

Rational offset_from_plane(const std::vector<Point>& plane, const Point& q) {
  const Point normal = cross_product(plane[1] - plane[0], plane[2] - plane[0]);
  const Rational& longest = normal[longest_axis(normal)];
  assert(sign(longest) != 0);
  return inner_product(normal, q - plane[0]) / longest;
}

namespace {

bool names_a_point(const PiecewiseLinearInput& input, Vertex v) {
  return v >= 0 && v < static_cast<Vertex>(input.points.size());
}

void find_segment_list_breaches(const PiecewiseLinearInput& input, BreachList& found) {
  for (const Simplex& segment : input.segments) {
    bool in_range = true;
    for (const Vertex v : segment) {
      if (names_a_point(input, v)) continue;
      in_range = false;
      found.add({BreachKind::kIndexOutOfRange, {v}, {segment}});
    }
    if (in_range && (segment.size() != 2 || segment[0] == segment[1])) {
      found.add({BreachKind::kDegenerateSegment, {}, {segment}});
    }
  }
}

void find_line_list_breaches(const PiecewiseLinearInput& input, BreachList& found) {
  for (std::size_t i = 0; i < input.polygons.size() && !found.is_full(); ++i) {
    for (const std::vector<Vertex>& line : input.polygons[i].lines) {
      for (std::size_t j = 0; j < line.size(); ++j) {
        if (!names_a_point(input, line[j])) {
          found.add({BreachKind::kIndexOutOfRange, {line[j]}, {}, {i}});
        } else if (line.size() > 1 && line[j] == line[(j + 1) % line.size()]) {
          found.add({BreachKind::kDegeneratePolygon, {line[j]}, {}, {i}});
        }
      }
    }
  }
}

// Three vertices of a polygon that are not on one line, or two if there are none, ascending places.
Simplex spanning(const PointSet& points, const std::vector<Vertex>& vertices) {
  // Most polygons are triangles; this answers for them in integers.
  if (vertices.size() == 3 && !axes_of_plane(points.configuration(), vertices).empty()) {
    return vertices;
  }
  std::vector<Point> coordinates_of;
  for (const Vertex v : vertices) coordinates_of.push_back(points[v]);
  Simplex basis;
  for (const std::size_t i : affine_hull(coordinates_of).basis) basis.push_back(vertices[i]);
  basis.resize(std::min<std::size_t>(basis.size(), 3));
  return basis;
}

void find_list_breaches(const PiecewiseLinearInput& input, BreachList& found) {
  const std::size_t dimension = input.points.empty() ? 3 : input.points.front().size();
  assert(dimension == 3 || (dimension == 2 && input.polygons.empty()));
  for (const Duplicate& pair : duplicates(input.points)) {
    const Point& point = input.points[static_cast<std::size_t>(pair.kept)];
    assert(point.size() == dimension);
    found.add({BreachKind::kDuplicateVertex, {pair.kept, pair.again}, {}, {}, point});
  }
  find_segment_list_breaches(input, found);
  find_line_list_breaches(input, found);
}

// These three vertices may be nearly collinear; then the others may be far off their plane for that
// reason alone.
Breach not_planar(const PointSet& points, const std::vector<Vertex>& vertices,
                  std::size_t polygon) {
  const NearestPlane plane = nearest_plane(coordinates(points, vertices));
  Breach breach{BreachKind::kPolygonNotPlanar};
  for (const std::size_t place : plane.farthest) breach.vertices.push_back(vertices[place]);
  breach.polygons = {polygon};
  breach.squared_distance = plane.squared_distance;
  return breach;
}

void find_plane_breaches(const PiecewiseLinearInput& input, const PointSet& points,
                         BreachList& found) {
  const std::vector<std::size_t> space = {0, 1, 2};
  for (std::size_t i = 0; i < input.polygons.size() && !found.is_full(); ++i) {
    const std::vector<Vertex> vertices = vertices_of(input.polygons[i]);
    const Simplex basis = spanning(points, vertices);
    if (basis.size() < 3) {
      found.add({BreachKind::kDegeneratePolygon, basis, {}, {i}});
      continue;
    }
    const bool is_planar = std::all_of(vertices.begin(), vertices.end(), [&](Vertex v) {
      if (contains(basis, v)) return true;
      const Simplex four = {basis[0], basis[1], basis[2], v};
      return orientation(points.configuration(), space, four) == 0;
    });
    if (!is_planar) found.add(not_planar(points, vertices, i));
  }
}

// Two segments of one line that overlap have an end of one inside the other, or are the same.
void find_segment_breaches(const PointSet& points, const std::vector<Simplex>& segments,
                           const Progress& progress, BreachList& found) {
  if (segments.empty()) return;
  const Configuration& configuration = points.configuration();
  const CellBoxes boxes(points);
  const BoxIndex vertex_index(boxes.of_vertices());
  const CellIndex segment_index(boxes.of(segments), segments);
  for (std::size_t i = 0; i < segments.size() && !found.is_full(); ++i) {
    tell(progress, "segments", i, segments.size());
    const Simplex& a = segments[i];
    const Box box = boxes.of(a);
    for (const std::size_t place : vertex_index.meeting(box)) {
      const auto v = static_cast<Vertex>(place);
      if (contains(a, v) || !lies_inside_segment(configuration, a, v)) continue;
      found.add({BreachKind::kVertexInSegment, {v}, {a}, {}, points[v]});
    }
    for (const std::size_t j : segment_index.apart(box, a)) {
      const Simplex& b = segments[j];
      if (j <= i || !segments_cross(configuration, a, b)) continue;
      const auto common = intersection(coordinates(points, a), coordinates(points, b));
      found.add({BreachKind::kCrossingSegments, {}, {a, b}, {}, common.front()});
    }
  }
}

// Which of some simplices hold a point.
class Simplices {
 public:
  Simplices(const PointSet& points, const CellBoxes& boxes, std::vector<Simplex> simplices)
      : points_(points), simplices_(std::move(simplices)), index_(boxes.index_of(simplices_)) {}

  // The place in the list of a simplex that holds one.
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

// For each triangle of a polygon with all its holes filled: is it in a component of the complement
// of the lines that is next to the unbounded one? If the triangles of such a component were left
// out, the polygon would have a notch, or be empty, but would not have a hole.
std::vector<bool> beside_outside(const std::vector<Simplex>& filled,
                                 const std::set<Simplex>& edges) {
  const std::vector<FacetUse> uses = facet_uses(filled);
  DisjointSets components(filled.size());
  for (const auto at_edge : ByFacet(uses)) {
    const bool is_within = at_edge.size() == 2 && !edges.contains(at_edge.front().facet);
    if (is_within) components.unite(at_edge[0].simplex, at_edge[1].simplex);
  }
  std::vector<bool> is_beside(filled.size(), false);
  for (const auto at_edge : ByFacet(uses)) {
    if (at_edge.size() == 1) is_beside[components.find(at_edge.front().simplex)] = true;
  }
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

void find_area_breaches(const PiecewiseLinearInput& input, const PiecewiseLinearComplex& complex,
                        BreachList& found) {
  std::optional<CellBoxes> boxes;
  for (std::size_t i = 0; i < complex.polygons.size() && !found.is_full(); ++i) {
    const Polygon& polygon = complex.polygons[i];
    const std::size_t before = found.count();
    if (!polygon.hole_seeds.empty()) {
      if (!boxes) boxes.emplace(complex.points);
      find_polygon_seed_breaches(complex.points, *boxes, i, input.polygons[i], polygon, found);
    }
    // If nothing is left, a seed that is in no hole may be why.
    if (polygon.triangles.empty() && found.count() == before) {
      found.add({BreachKind::kDegeneratePolygon, {}, {}, {i}});
    }
  }
}

// The elements of `a` that are not in `b`; both ascending.
template <typename A, typename B>
std::vector<typename A::value_type> difference(const A& a, const B& b) {
  std::vector<typename A::value_type> result;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

}  // namespace

tl::expected<PiecewiseLinearComplex, std::vector<Breach>> validated(
    const PiecewiseLinearInput& input, std::size_t limit, const ValidityWatch& watch) {
  BreachList found(limit, watch.on_breach);
  const auto breaches = [&] { return tl::make_unexpected(found.breaches()); };
  find_list_breaches(input, found);
  if (!found.empty()) return breaches();
  {
    const PointSet points(input.points);
    find_plane_breaches(input, points, found);
    find_segment_breaches(points, segments_of(input), watch.progress, found);
    if (!found.empty()) return breaches();
  }
  PiecewiseLinearComplex complex = assemble(input);
  find_area_breaches(input, complex, found);
  if (!found.empty()) return breaches();
  find_piercing_segments(complex, watch.progress, found);
  if (!found.empty()) return breaches();
  find_polygon_pair_breaches(complex, watch.progress, found);
  find_hole_seed_breaches(complex, found);
  if (!found.empty()) return breaches();
  return complex;
}

std::vector<Adoption> adoptions(const PiecewiseLinearInput& input,
                                const PiecewiseLinearComplex& complex) {
  assert(input.polygons.size() == complex.polygons.size());
  std::vector<Adoption> result;
  for (std::size_t i = 0; i < input.polygons.size(); ++i) {
    const Polygon& polygon = complex.polygons[i];
    const std::vector<Vertex> vertices = vertices_of(input.polygons[i]);
    const std::set<Simplex> segments = edges_of(input.polygons[i]);
    const Adoption adoption = {
        i, difference(polygon.vertices, vertices), difference(polygon.segments, segments),
        difference(vertices, polygon.vertices), difference(segments, polygon.segments)};
    const bool differs = polygon.vertices != vertices || !adoption.segments.empty() ||
                         !adoption.left_segments.empty();
    if (differs) result.push_back(adoption);
  }
  return result;
}

}  // namespace circumspect
