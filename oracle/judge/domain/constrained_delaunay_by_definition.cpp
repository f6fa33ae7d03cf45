#include <array>
#include <set>

#include "oracle/judge/domain/constrained_delaunay.hpp"
#include "oracle/judge/domain/coplanar.hpp"
#include "oracle/judge/points/ball_witness.hpp"
#include "reference/kernel/piecewise_linear/visibility.hpp"
#include "reference/kernel/predicates/in_ball.hpp"

namespace circumspect::check {
namespace {

// The triangles of polygons that no simplex has for a facet.
std::set<Simplex> dangling_triangles(const ExactMesh& mesh, const PiecewiseLinearComplex& complex) {
  std::set<Simplex> dangling;
  for (const Polygon& polygon : complex.polygons) {
    dangling.insert(polygon.triangles.begin(), polygon.triangles.end());
  }
  for (const FacetUse& use : facet_uses(mesh.simplices)) dangling.erase(use.facet);
  return dangling;
}

}  // namespace

void judge_constrained_delaunay_by_definition(const ExactMesh& mesh,
                                              const PiecewiseLinearComplex& complex,
                                              Verdict& verdict) {
  const Configuration& points = mesh.points.configuration();
  const Regions regions(complex);
  for (const Simplex& simplex : mesh.simplices) {
    for (Vertex v = 0; mesh.points.names(v); ++v) {
      if (contains(simplex, v) || in_ball(points, simplex, v) <= 0) continue;
      if (!is_visible(complex, regions, v, simplex)) continue;
      add_in_ball(mesh, Rule::kVisibleVertexInBall, simplex, std::nullopt, v, verdict);
    }
  }
  if (complex.ambient_dimension() == 2) return;
  for (const Simplex& triangle : dangling_triangles(mesh, complex)) {
    const std::vector<std::size_t> axes = axes_of(points, triangle);
    for (Vertex v = 0; mesh.points.names(v); ++v) {
      if (contains(triangle, v) || !is_coplanar(points, triangle, v)) continue;
      if (in_ball(points, axes, triangle, v) <= 0) continue;
      if (!is_visible(complex, regions, v, triangle)) continue;
      add_in_ball(mesh, Rule::kDanglingNotDelaunay, triangle, std::nullopt, v, verdict);
    }
  }
}

}  // namespace circumspect::check
