#include "oracle/judge/definition/surface_delaunay.hpp"

#include "oracle/judge/definition/quality.hpp"

namespace circumspect::definition {

SurfaceEdges surface_edges(const std::vector<Simplex>& triangles) {
  SurfaceEdges edges;
  for (const Simplex& edge : faces_of(triangles, 2)) {
    std::vector<std::size_t> with;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      if (contains(triangles[t], edge[0]) && contains(triangles[t], edge[1])) with.push_back(t);
    }
    edges.boundary += with.size() == 1 ? 1 : 0;
    edges.set_apart += with.size() > 2 ? 1 : 0;
    if (with.size() != 2) continue;
    const auto opposite = [&](std::size_t t) {
      std::size_t place = 0;
      while (contains(edge, triangles[t][place])) ++place;
      return triangles[t][place];
    };
    edges.interior.push_back({edge, with[0], with[1], opposite(with[0]), opposite(with[1])});
  }
  return edges;
}

bool is_delaunay(const std::vector<Point>& points, const InteriorEdge& edge) {
  const auto at = [&](Vertex v) -> const Point& { return points[static_cast<std::size_t>(v)]; };
  const Point &p = at(edge.edge[0]), &q = at(edge.edge[1]);
  return signed_square_at({at(edge.of_first)}, p, q) >=
         -signed_square_at({at(edge.of_second)}, p, q);
}

}  // namespace circumspect::definition
