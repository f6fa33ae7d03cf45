#include "oracle/judge/definition/triangulation.hpp"

#include "kernel/predicates/orientation.hpp"
#include "oracle/model/witnesses.hpp"

namespace circumspect::definition {

void judge_vertices_are_points(const ExactMesh& mesh, Verdict& verdict) {
  for (Vertex v = 0; mesh.points.names(v); ++v) {
    if (count_with_face(mesh.simplices, {v}) > 0) continue;
    verdict.add(Rule::kUnusedPoint, {.vertices = {v}, .point = mesh.points[v]});
  }
}

void judge_union_is_hull(const ExactMesh& mesh, Rule rule, Verdict& verdict) {
  const Configuration& points = mesh.points.configuration();
  for (const FacetUse& use : facet_uses(mesh.simplices)) {
    if (count_with_face(mesh.simplices, use.facet) > 1) continue;
    const Simplex& simplex = mesh.simplices[use.simplex];
    const Vertex apex = simplex[use.opposite];
    const int own = side_of_facet(points, use.facet, apex);
    for (Vertex q = 0; mesh.points.names(q); ++q) {
      if (side_of_facet(points, use.facet, q) * own >= 0) continue;
      verdict.add(rule, vertex_beyond_facet(mesh.points, simplex, use.facet, apex, q));
      break;
    }
  }
}

}  // namespace circumspect::definition
