#include "oracle/judge/within/rounded_polygons.hpp"

#include <algorithm>
#include <utility>

#include "kernel/complex/point_set.hpp"
#include "kernel/piecewise_linear/nearest_plane.hpp"
#include "kernel/piecewise_linear/polygon_triangles.hpp"
#include "kernel/piecewise_linear/validity.hpp"

namespace circumspect::check {
namespace {

// The axes along which the plane is seen most nearly from the front.
std::vector<std::size_t> axes_across(const Point& normal) {
  std::size_t along = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (abs(normal[i]) > abs(normal[along])) along = i;
  }
  return {along == 0 ? std::size_t{1} : std::size_t{0},
          along == 2 ? std::size_t{1} : std::size_t{2}};
}

// A polygon with vertices and edges of its own.
struct Alone {
  std::vector<Vertex> vertices;  // of the input, ascending
  std::vector<Point> points;
  std::vector<Simplex> edges;  // by places among these
};

Alone alone(const PiecewiseLinearInput& input, const PolygonLines& polygon) {
  Alone own{vertices_of(polygon), {}, {}};
  for (const Vertex v : own.vertices)
    own.points.push_back(input.points[static_cast<std::size_t>(v)]);
  const auto place = [&own](Vertex v) {
    const auto at = std::lower_bound(own.vertices.begin(), own.vertices.end(), v);
    return static_cast<Vertex>(at - own.vertices.begin());
  };
  for (const Simplex& edge : edges_of(polygon))
    own.edges.push_back({place(edge[0]), place(edge[1])});
  return own;
}

// Do its edges meet in their ends alone, seen along the third axis?
bool is_seen_as_polygon(const Alone& own, const std::vector<std::size_t>& axes) {
  PiecewiseLinearInput seen;
  for (const Point& point : own.points) seen.points.push_back({point[axes[0]], point[axes[1]]});
  seen.segments.assign(own.edges.begin(), own.edges.end());
  return validated(seen, 1).has_value();
}

}  // namespace

std::optional<CutPolygons> rounded_polygons_cut(const PiecewiseLinearInput& input,
                                                const Rational& squared_distance) {
  CutPolygons result{input, {}, segments_of(input)};
  result.input.polygons.clear();
  for (std::size_t p = 0; p < input.polygons.size(); ++p) {
    const PolygonLines& polygon = input.polygons[p];
    const Alone own = alone(input, polygon);
    if (!duplicates(own.points).empty()) return std::nullopt;
    const PointSet points(own.points);
    if (points.dimension() < 3) {
      result.input.polygons.push_back(polygon);
      result.cut_of.push_back(p);
      continue;
    }
    const NearestPlane plane = nearest_plane(own.points);
    const std::vector<std::size_t> axes = axes_across(plane.normal);
    if (plane.squared_distance > squared_distance || !is_seen_as_polygon(own, axes)) {
      return std::nullopt;
    }
    std::vector<Vertex> all(own.vertices.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<Vertex>(i);
    ++result.cut;
    result.squared_height = std::max(result.squared_height, plane.squared_distance);
    for (const Simplex& triangle :
         polygon_triangles(points, axes, all, own.edges, polygon.hole_seeds)) {
      std::vector<Vertex> corners;
      for (const Vertex v : triangle) corners.push_back(own.vertices[static_cast<std::size_t>(v)]);
      result.input.polygons.push_back({{std::move(corners)}, {}});
      result.cut_of.push_back(p);
    }
  }
  return result;
}

}  // namespace circumspect::check
