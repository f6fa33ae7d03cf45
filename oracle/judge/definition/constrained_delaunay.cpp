#include "oracle/judge/definition/constrained_delaunay.hpp"

#include <set>

#include "kernel/predicates/in_ball.hpp"
#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/place.hpp"
#include "oracle/judge/definition/visibility.hpp"
#include "oracle/model/witnesses.hpp"

namespace circumspect::definition {
namespace {

// The triangles of polygons that no tetrahedron has for a face.
std::set<Simplex> dangling_triangles(const ExactMesh& mesh, const PiecewiseLinearComplex& complex) {
  std::set<Simplex> dangling;
  for (const Polygon& polygon : complex.polygons) {
    dangling.insert(polygon.triangles.begin(), polygon.triangles.end());
  }
  for (const Simplex& facet : faces_of(mesh.simplices, 3)) dangling.erase(facet);
  return dangling;
}

}  // namespace

void judge_constrained_delaunay(const ExactMesh& mesh, const PiecewiseLinearComplex& complex,
                                Verdict& verdict) {
  const Configuration& points = mesh.points.configuration();
  for (const Simplex& simplex : mesh.simplices) {
    for (Vertex v = 0; mesh.points.names(v); ++v) {
      if (contains(simplex, v) || in_ball(points, simplex, v) <= 0) continue;
      if (!is_visible(complex, v, simplex)) continue;
      add_vertex_in_ball(mesh.points, Rule::kVisibleVertexInBall, simplex, std::nullopt, v,
                         verdict);
    }
  }
  if (complex.ambient_dimension() == 2) return;
  for (const Simplex& triangle : dangling_triangles(mesh, complex)) {
    const std::vector<std::size_t> axes = axes_of(points, triangle);
    for (Vertex v = 0; mesh.points.names(v); ++v) {
      if (contains(triangle, v) || side_of_triangle(points, triangle, v) != 0) continue;
      if (in_ball(points, axes, triangle, v) <= 0) continue;
      if (!is_visible(complex, v, triangle)) continue;
      add_vertex_in_ball(mesh.points, Rule::kDanglingNotDelaunay, triangle, std::nullopt, v,
                         verdict);
    }
  }
}

}  // namespace circumspect::definition
