// From lines to linear cells.
#include <algorithm>
#include <set>

#include "reference/complex/simplex.hpp"
#include "reference/piecewise_linear/piecewise_linear_complex.hpp"
#include "reference/piecewise_linear/polygon_triangles.hpp"
#include "reference/predicates/intersection.hpp"
#include "reference/predicates/orientation.hpp"

namespace circumspect {
namespace {

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

std::set<Vertex> vertices_of(const PolygonLines& polygon) {
  std::set<Vertex> vertices;
  for (const auto& line : polygon.lines) vertices.insert(line.begin(), line.end());
  return vertices;
}

// Two coordinate axes of the plane through some vertices.
std::vector<std::size_t> axes_through(const PointSet& points, const std::set<Vertex>& vertices) {
  Simplex basis;
  for (const Vertex v : vertices) {
    basis.push_back(v);
    if (axes_of(points.configuration(), basis).size() + 1 < basis.size()) basis.pop_back();
    if (basis.size() == 3) break;
  }
  return axes_of(points.configuration(), basis);
}

bool lies_in(const PointSet& points, const std::vector<Simplex>& triangles, const Point& point) {
  return std::any_of(triangles.begin(), triangles.end(), [&](const Simplex& triangle) {
    return !intersection(coordinates(points, triangle), {point}).empty();
  });
}

// The polygon with every vertex and segment of the complex that lies in it.
Polygon polygon_of(const PointSet& points, const std::set<Simplex>& all_segments,
                   const PolygonLines& lines) {
  std::set<Vertex> vertices = vertices_of(lines);
  std::set<Simplex> segments = edges_of(lines);
  Polygon polygon;
  polygon.hole_seeds = lines.hole_seeds;
  polygon.axes = axes_through(points, vertices);
  const auto cut = [&] {
    polygon.vertices.assign(vertices.begin(), vertices.end());
    polygon.segments.assign(segments.begin(), segments.end());
    polygon.triangles = polygon_triangles(points, polygon.axes, polygon.vertices, polygon.segments,
                                          polygon.hole_seeds);
  };
  cut();
  const std::size_t listed = vertices.size() + segments.size();
  for (Vertex v = 0; points.names(v); ++v) {
    if (!vertices.contains(v) && lies_in(points, polygon.triangles, points[v])) vertices.insert(v);
  }
  for (const Simplex& segment : all_segments) {
    if (segments.contains(segment) || !vertices.contains(segment[0]) ||
        !vertices.contains(segment[1])) {
      continue;
    }
    if (lies_in(points, polygon.triangles, barycentre(coordinates(points, segment)))) {
      segments.insert(segment);
    }
  }
  if (vertices.size() + segments.size() > listed) cut();
  return polygon;
}

}  // namespace

PiecewiseLinearComplex assemble(const PiecewiseLinearInput& input) {
  std::set<Simplex> segments;
  for (const auto& segment : input.segments) segments.insert(sorted(segment));
  for (const PolygonLines& polygon : input.polygons) segments.merge(edges_of(polygon));
  PiecewiseLinearComplex complex{
      PointSet(input.points), {segments.begin(), segments.end()}, {}, input.hole_seeds, input.kind};
  for (const PolygonLines& polygon : input.polygons) {
    complex.polygons.push_back(polygon_of(complex.points, segments, polygon));
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

}  // namespace circumspect
