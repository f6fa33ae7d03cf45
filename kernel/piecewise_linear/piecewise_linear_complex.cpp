#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "kernel/complex/point_set.hpp"
#include "kernel/complex/simplex.hpp"
#include "kernel/exact/each_once.hpp"
#include "kernel/piecewise_linear/cell_boxes.hpp"
#include "kernel/piecewise_linear/polygon_triangles.hpp"
#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/place.hpp"

namespace circumspect {

// From lines to linear cells.

namespace {

// All vertices and segments, for finding those that lie in a polygon.
class Assembly {
 public:
  Assembly(const PointSet& points, const std::vector<Simplex>& segments)
      : points_(points),
        boxes_(points),
        vertices_(boxes_.of_vertices()),
        neighbours_(points.size()) {
    for (const Simplex& segment : segments) {
      neighbours_[static_cast<std::size_t>(segment[0])].push_back(segment[1]);
    }
  }

  Polygon polygon(const PolygonLines& lines) const {
    Polygon polygon;
    polygon.hole_seeds = lines.hole_seeds;
    std::vector<Vertex> vertices = vertices_of(lines);
    const std::set<Simplex> listed = edges_of(lines);
    const std::vector<Simplex> walls(listed.begin(), listed.end());
    polygon.axes = axes_of(vertices);
    if (polygon.axes.size() != 2) return polygon;
    const bool is_triangle = vertices.size() == 3 && walls.size() == 3 && lines.hole_seeds.empty();
    if (is_triangle) {
      polygon.triangles = {vertices};
    } else {
      polygon.triangles =
          polygon_triangles(points_, polygon.axes, vertices, walls, polygon.hole_seeds);
    }
    const std::vector<Vertex> inside = vertices_in(polygon);
    const std::vector<Simplex> slits = segments_between(inside);
    const std::size_t count = vertices.size();
    vertices.insert(vertices.end(), inside.begin(), inside.end());
    keep_each_once(vertices);
    const bool has_slits = std::any_of(slits.begin(), slits.end(),
                                       [&](const Simplex& s) { return !listed.contains(s); });
    if (vertices.size() > count || has_slits) {
      polygon.triangles =
          polygon_triangles(points_, polygon.axes, vertices, walls, polygon.hole_seeds, slits);
    }
    // The triangles have all these vertices and segments as corners and edges; vertices and
    // segments that lie outside or in a hole have no triangle.
    std::set<Simplex> edges;
    for (const Simplex& triangle : polygon.triangles) {
      for (std::size_t i = 0; i < 3; ++i) edges.insert(facet_opposite(triangle, i));
    }
    polygon.vertices = inside;
    std::copy_if(slits.begin(), slits.end(), std::back_inserter(polygon.segments),
                 [&](const Simplex& s) { return edges.contains(s); });
    return polygon;
  }

 private:
  // Axes on which the plane of a polygon projects injectively; fewer if it has no plane.
  std::vector<std::size_t> axes_of(const std::vector<Vertex>& vertices) const {
    if (vertices.size() != 3) return flat_through(points_, vertices).axes;
    return axes_of_plane(points_.configuration(), vertices);
  }

  // All vertices in the triangles of a polygon.
  std::vector<Vertex> vertices_in(const Polygon& polygon) const {
    std::set<Vertex> found;
    for (const Simplex& triangle : polygon.triangles) {
      found.insert(triangle.begin(), triangle.end());
      for (const std::size_t place : vertices_.meeting(boxes_.of(triangle))) {
        const auto v = static_cast<Vertex>(place);
        if (found.contains(v)) continue;
        if (lies_in(points_.configuration(), polygon.axes, triangle, v)) found.insert(v);
      }
    }
    return {found.begin(), found.end()};
  }

  // All segments with both ends among some vertices, in lexicographic order.
  std::vector<Simplex> segments_between(const std::vector<Vertex>& vertices) const {
    std::vector<Simplex> found;
    for (const Vertex v : vertices) {
      for (const Vertex w : neighbours_[static_cast<std::size_t>(v)]) {
        if (std::binary_search(vertices.begin(), vertices.end(), w)) found.push_back({v, w});
      }
    }
    return found;
  }

  const PointSet& points_;
  CellBoxes boxes_;
  BoxIndex vertices_;
  std::vector<std::vector<Vertex>> neighbours_;  // the greater ends of segments, ascending
};

}  // namespace

PiecewiseLinearComplex assemble(const PiecewiseLinearInput& input) {
  PiecewiseLinearComplex complex{
      PointSet(input.points), segments_of(input), {}, input.hole_seeds, input.kind};
  if (input.polygons.empty()) return complex;
  const Assembly assembly(complex.points, complex.segments);
  complex.polygons.reserve(input.polygons.size());
  for (const PolygonLines& polygon : input.polygons) {
    complex.polygons.push_back(assembly.polygon(polygon));
  }
  return complex;
}

std::vector<Simplex> walls(const PiecewiseLinearComplex& complex) {
  if (complex.ambient_dimension() == 2) return complex.segments;
  std::vector<Simplex> triangles;
  for (const Polygon& polygon : complex.polygons) {
    triangles.insert(triangles.end(), polygon.triangles.begin(), polygon.triangles.end());
  }
  return triangles;
}

std::set<Simplex> edges_of(const PolygonLines& polygon) {
  std::set<Simplex> edges;
  for (const std::vector<Vertex>& line : polygon.lines) {
    if (line.size() < 2) continue;
    for (std::size_t i = 0; i < line.size(); ++i) {
      edges.insert(sorted({line[i], line[(i + 1) % line.size()]}));
    }
  }
  return edges;
}

std::vector<Vertex> vertices_of(const PolygonLines& polygon) {
  std::vector<Vertex> vertices;
  for (const auto& line : polygon.lines) vertices.insert(vertices.end(), line.begin(), line.end());
  keep_each_once(vertices);
  return vertices;
}

std::vector<Simplex> segments_of(const PiecewiseLinearInput& input) {
  std::vector<Simplex> segments;
  for (const auto& segment : input.segments) segments.push_back(sorted(segment));
  for (const PolygonLines& polygon : input.polygons) {
    for (const Simplex& edge : edges_of(polygon)) segments.push_back(edge);
  }
  keep_each_once(segments);
  return segments;
}

}  // namespace circumspect
