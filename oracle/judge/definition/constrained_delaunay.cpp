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
  const auto judge = [&](const Simplex& simplex, Rule rule) {
    const std::vector<std::size_t> axes = axes_of(points, simplex);
    for (Vertex v = 0; mesh.points.names(v); ++v) {
      if (contains(simplex, v) || !is_in_hull_of(points, axes, simplex, v)) continue;
      if (in_ball(points, axes, simplex, v) <= 0 || !is_visible(complex, v, simplex)) continue;
      add_vertex_in_ball(mesh.points, rule, simplex, std::nullopt, v, verdict);
    }
  };
  for (const Simplex& simplex : mesh.simplices) judge(simplex, Rule::kVisibleVertexInBall);
  for (const Simplex& triangle : dangling_triangles(mesh, complex)) {
    judge(triangle, Rule::kDanglingNotDelaunay);
  }
}

}  // namespace circumspect::definition
