#include "oracle/judge/definition/triangulation.hpp"

#include <algorithm>

#include "kernel/predicates/orientation.hpp"
#include "oracle/model/witnesses.hpp"

namespace circumspect::definition {

void judge_vertices_are_points(const ExactMesh& mesh, Verdict& verdict) {
  for (Vertex v = 0; mesh.points.names(v); ++v) {
    const bool is_used = std::any_of(mesh.simplices.begin(), mesh.simplices.end(),
                                     [&](const Simplex& simplex) { return contains(simplex, v); });
    if (!is_used) verdict.add(Rule::kUnusedPoint, {.vertices = {v}, .point = mesh.points[v]});
  }
}

void judge_union_is_hull(const ExactMesh& mesh, Rule rule, Verdict& verdict) {
  const Configuration& points = mesh.points.configuration();
  for (const FacetUse& use : facet_uses(mesh.simplices)) {
    const Simplex& simplex = mesh.simplices[use.simplex];
    const auto is_shared = [&](const Simplex& other) {
      return &other != &simplex && has_face(other, use.facet);
    };
    if (std::any_of(mesh.simplices.begin(), mesh.simplices.end(), is_shared)) continue;
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
