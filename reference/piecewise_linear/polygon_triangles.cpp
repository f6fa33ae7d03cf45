#include "reference/piecewise_linear/polygon_triangles.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "reference/complex/facets.hpp"
#include "reference/predicates/orientation.hpp"

namespace circumspect {
namespace {

// One plane of the complex with coordinates in it.
struct InPlane {
  const PointSet& points;
  const std::vector<std::size_t>& axes;

  int side(Vertex a, Vertex b, Vertex c) const {
    return orientation(points.configuration(), axes, Simplex{a, b, c});
  }
  Rational coordinate(Vertex v, std::size_t i) const { return points[v][axes[i]]; }

  // Is c, on the line ab, strictly between a and b?
  bool is_between(Vertex a, Vertex b, Vertex c) const {
    for (const std::size_t i : {0u, 1u}) {
      const Rational& p = points[a][axes[i]];
      const Rational& q = points[b][axes[i]];
      if (p != q) {
        const Rational& r = points[c][axes[i]];
        return (p < r && r < q) || (q < r && r < p);
      }
    }
    return false;
  }

  // Do the relative interiors of two edges with no vertex inside cross?
  bool cross(const Simplex& a, const Simplex& b) const {
    for (const Vertex v : a) {
      if (contains(b, v)) return false;
    }
    return side(a[0], a[1], b[0]) * side(a[0], a[1], b[1]) < 0 &&
           side(b[0], b[1], a[0]) * side(b[0], b[1], a[1]) < 0;
  }

  // Twice the signed area of the triangle with corners a, b and any point q of the plane.
  Rational area(Vertex a, Vertex b, const Point& q) const {
    const Rational ux = coordinate(a, 0) - q[axes[0]], uy = coordinate(a, 1) - q[axes[1]];
    const Rational vx = coordinate(b, 0) - q[axes[0]], vy = coordinate(b, 1) - q[axes[1]];
    return ux * vy - uy * vx;
  }
  bool holds(const Simplex& triangle, const Point& q) const {
    const int front = side(triangle[0], triangle[1], triangle[2]);
    for (const std::size_t i : {0u, 1u, 2u}) {
      if (sign(area(triangle[i], triangle[(i + 1) % 3], q)) == -front) return false;
    }
    return true;
  }
};

// Does an edge between two vertices keep clear of all other vertices and of the edges drawn?
bool can_be_drawn(const InPlane& plane, const Simplex& edge, const std::vector<Vertex>& vertices,
                  const std::vector<Simplex>& drawn) {
  for (const Vertex v : vertices) {
    if (!contains(edge, v) && plane.side(edge[0], edge[1], v) == 0 &&
        plane.is_between(edge[0], edge[1], v)) {
      return false;
    }
  }
  return std::none_of(drawn.begin(), drawn.end(),
                      [&](const Simplex& other) { return plane.cross(edge, other); });
}

// The triangles into which a set of edges that cannot grow cuts the hull of the vertices: three
// vertices joined by edges, with no vertex between them.
std::vector<Simplex> triangles_between(const InPlane& plane, const std::vector<Simplex>& edges) {
  std::map<Vertex, std::set<Vertex>> joined;
  for (const Simplex& edge : edges) {
    joined[edge[0]].insert(edge[1]);
    joined[edge[1]].insert(edge[0]);
  }
  std::vector<Simplex> triangles;
  for (const Simplex& edge : edges) {
    std::vector<Vertex> apexes;
    std::set_intersection(joined[edge[0]].begin(), joined[edge[0]].end(), joined[edge[1]].begin(),
                          joined[edge[1]].end(), std::back_inserter(apexes));
    for (const Vertex apex : apexes) {
      const Simplex triangle = {edge[0], edge[1], apex};
      if (apex < edge[1] || plane.side(edge[0], edge[1], apex) == 0) continue;
      // A vertex inside would be joined to a corner within the triangle, and a chain of triangles at
      // the edge would lead to it: one of the other common neighbours of the edge is then inside.
      const bool is_empty = std::none_of(joined.begin(), joined.end(), [&](const auto& vertex) {
        return !contains(triangle, vertex.first) &&
               plane.holds(triangle, plane.points[vertex.first]);
      });
      if (is_empty) triangles.push_back(triangle);
    }
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

}  // namespace

std::vector<Simplex> polygon_triangles(const PointSet& points, const std::vector<std::size_t>& axes,
                                       const std::vector<Vertex>& vertices,
                                       const std::vector<Simplex>& segments,
                                       const std::vector<Point>& hole_seeds) {
  const InPlane plane{points, axes};
  std::vector<Simplex> drawn = segments;
  const std::set<Simplex> walls(segments.begin(), segments.end());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    for (std::size_t j = i + 1; j < vertices.size(); ++j) {
      const Simplex edge = {vertices[i], vertices[j]};
      if (!walls.contains(edge) && can_be_drawn(plane, edge, vertices, drawn)) {
        drawn.push_back(edge);
      }
    }
  }
  const std::vector<Simplex> triangles = triangles_between(plane, drawn);

  // Flood what does not belong, from the outside and from the hole seeds, up to the segments.
  std::map<Simplex, std::vector<std::size_t>> at_edge;
  for (const FacetUse& use : facet_uses(triangles)) at_edge[use.facet].push_back(use.simplex);
  std::vector<bool> is_out(triangles.size(), false);
  std::vector<std::size_t> pending;
  const auto flood = [&](std::size_t triangle) {
    if (is_out[triangle]) return;
    is_out[triangle] = true;
    pending.push_back(triangle);
  };
  for (const auto& [edge, uses] : at_edge) {
    if (uses.size() == 1 && !walls.contains(edge)) flood(uses.front());
  }
  for (const Point& seed : hole_seeds) {
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      if (plane.holds(triangles[i], seed)) flood(i);
    }
  }
  while (!pending.empty()) {
    const Simplex triangle = triangles[pending.back()];
    pending.pop_back();
    for (std::size_t place = 0; place < 3; ++place) {
      const Simplex edge = sorted(facet_opposite(triangle, place));
      if (walls.contains(edge)) continue;
      for (const std::size_t neighbour : at_edge[edge]) flood(neighbour);
    }
  }
  std::vector<Simplex> inside;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (!is_out[i]) inside.push_back(triangles[i]);
  }
  return inside;
}

}  // namespace circumspect
