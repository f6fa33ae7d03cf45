#include "reference/constrained/planar_domain.hpp"

#include <algorithm>

#include "reference/piecewise_linear/polygon_triangles.hpp"
#include "reference/predicates/orientation.hpp"

namespace circumspect::constrained {
namespace {

// The chain of the hull that has all vertices on its left or on it, from the first vertex to the last
// in the order given, which is that of the first axis (then of the second).
std::vector<Vertex> hull_chain(const PointSet& points, const std::vector<std::size_t>& axes,
                               const std::vector<Vertex>& in_order) {
  std::vector<Vertex> chain;
  for (const Vertex v : in_order) {
    while (chain.size() >= 2 && orientation(points.configuration(), axes,
                                            Simplex{chain.end()[-2], chain.back(), v}) < 0) {
      chain.pop_back();
    }
    chain.push_back(v);
  }
  return chain;
}

}  // namespace

std::vector<Simplex> hull_edges(const PointSet& points, const std::vector<std::size_t>& axes,
                                std::vector<Vertex> vertices) {
  std::sort(vertices.begin(), vertices.end(), [&](Vertex a, Vertex b) {
    const Point& p = points[a];
    const Point& q = points[b];
    return p[axes[0]] != q[axes[0]] ? p[axes[0]] < q[axes[0]] : p[axes[1]] < q[axes[1]];
  });
  std::vector<Simplex> edges;
  for (int side = 0; side < 2; ++side) {
    const std::vector<Vertex> chain = hull_chain(points, axes, vertices);
    for (std::size_t i = 1; i < chain.size(); ++i) {
      edges.push_back(sorted({chain[i - 1], chain[i]}));
    }
    std::reverse(vertices.begin(), vertices.end());
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

Polygon planar_domain(const PointSet& points, const std::vector<std::size_t>& axes,
                      const std::vector<Vertex>& vertices, std::vector<Simplex> segments,
                      const std::vector<Point>& hole_seeds, DomainKind kind) {
  if (kind == DomainKind::kHull) {
    for (const Simplex& edge : hull_edges(points, axes, vertices)) segments.push_back(edge);
    std::sort(segments.begin(), segments.end());
    segments.erase(std::unique(segments.begin(), segments.end()), segments.end());
  }
  const bool has_holes = kind == DomainKind::kEnclosed;
  Polygon polygon{vertices, segments, has_holes ? hole_seeds : std::vector<Point>{}, axes, {}};
  polygon.triangles = polygon_triangles(points, axes, vertices, segments, polygon.hole_seeds);
  return polygon;
}

}  // namespace circumspect::constrained
