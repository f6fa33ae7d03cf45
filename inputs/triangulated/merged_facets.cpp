#include "inputs/triangulated/merged_facets.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "kernel/complex/point_set.hpp"
#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "kernel/piecewise_linear/polygon_triangles.hpp"
#include "kernel/piecewise_linear/validity.hpp"

namespace circumspect::properties {
namespace {

bool are_coplanar(const PointSet& points, const Simplex& a, const Simplex& b) {
  Simplex together = a;
  together.insert(together.end(), b.begin(), b.end());
  return flat_through(points, together).dimension() == 2;
}

std::map<Simplex, std::vector<Simplex>> triangles_by_edge(const std::vector<Simplex>& triangles) {
  std::map<Simplex, std::vector<Simplex>> by_edge;
  for (const Simplex& triangle : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      by_edge[facet_opposite(triangle, i)].push_back(triangle);
    }
  }
  return by_edge;
}

// Decomposes edges that form closed lines into closed lines.
std::vector<std::vector<Vertex>> closed_lines(std::set<Simplex> edges) {
  std::vector<std::vector<Vertex>> lines;
  while (!edges.empty()) {
    std::vector<Vertex> line = {(*edges.begin())[0]};
    while (line.size() == 1 || line.back() != line.front()) {
      const auto next = std::find_if(edges.begin(), edges.end(), [&](const Simplex& edge) {
        return contains(edge, line.back());
      });
      line.push_back((*next)[0] == line.back() ? (*next)[1] : (*next)[0]);
      edges.erase(next);
    }
    line.pop_back();
    lines.push_back(line);
  }
  return lines;
}

}  // namespace

std::vector<std::vector<Simplex>> coplanar_parts(const PointSet& points,
                                                 const std::vector<Simplex>& triangles) {
  const auto by_edge = triangles_by_edge(triangles);
  std::vector<std::vector<Simplex>> parts;
  std::set<Simplex> seen;
  for (const Simplex& first : triangles) {
    if (!seen.insert(first).second) continue;
    std::vector<Simplex> part = {first};
    for (std::size_t at = 0; at < part.size(); ++at) {
      for (std::size_t i = 0; i < 3; ++i) {
        for (const Simplex& next : by_edge.at(facet_opposite(part[at], i))) {
          if (are_coplanar(points, first, next) && seen.insert(next).second) part.push_back(next);
        }
      }
    }
    parts.push_back(part);
  }
  return parts;
}

PolygonLines polygon_of(const PointSet& points, const std::vector<Simplex>& part) {
  std::set<Simplex> boundary;
  std::set<Vertex> vertices;
  for (const auto& [edge, triangles] : triangles_by_edge(part)) {
    vertices.insert(edge.begin(), edge.end());
    if (triangles.size() == 1) boundary.insert(edge);
  }
  PolygonLines polygon{closed_lines(boundary), {}};
  // With all edges as segments, the polygon's triangles are those of the part and those that fill
  // its holes: the holes are the enclosed area outside the part.
  std::set<Simplex> edges;
  for (const auto& [edge, triangles] : triangles_by_edge(part)) edges.insert(edge);
  const std::vector<std::size_t> axes =
      flat_through(points, {vertices.begin(), vertices.end()}).axes;
  const std::set<Simplex> own(part.begin(), part.end());
  for (const Simplex& triangle : polygon_triangles(points, axes, {vertices.begin(), vertices.end()},
                                                   {edges.begin(), edges.end()}, {})) {
    if (!own.contains(triangle)) polygon.hole_seeds.push_back(barycentre(points, triangle));
  }
  return polygon;
}

}  // namespace circumspect::properties
