// Stages 1 and 2 of `validated`, as far as they look at one cell at a time.
#include <algorithm>
#include <cassert>
#include <map>

#include "reference/complex/point_set.hpp"
#include "reference/piecewise_linear/breaches.hpp"
#include "reference/piecewise_linear/lines.hpp"
#include "reference/piecewise_linear/plane_offset.hpp"
#include "reference/predicates/orientation.hpp"

namespace circumspect {
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
  std::vector<Point> coordinates_of;
  for (const Vertex v : vertices) coordinates_of.push_back(points[v]);
  Simplex basis;
  for (const std::size_t i : affine_hull(coordinates_of).basis) basis.push_back(vertices[i]);
  basis.resize(std::min<std::size_t>(basis.size(), 3));
  return basis;
}

}  // namespace

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
    for (const Vertex v : vertices) {
      if (contains(basis, v)) continue;
      const Simplex four = {basis[0], basis[1], basis[2], v};
      if (orientation(points.configuration(), space, four) == 0) continue;
      found.add({BreachKind::kPolygonNotPlanar,
                 {v, basis[0], basis[1], basis[2]},
                 {},
                 {i},
                 points[v],
                 offset_from_plane(coordinates(points, basis), points[v])});
    }
  }
}

}  // namespace circumspect
