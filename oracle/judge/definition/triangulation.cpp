#include "oracle/judge/definition/triangulation.hpp"

#include <algorithm>

#include "kernel/predicates/orientation.hpp"
#include "oracle/judge/definition/simplicial_complex.hpp"

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
      return &other != &simplex && std::all_of(use.facet.begin(), use.facet.end(),
                                               [&](Vertex v) { return contains(other, v); });
    };
    if (std::any_of(mesh.simplices.begin(), mesh.simplices.end(), is_shared)) continue;
    const auto with = [&](Vertex apex) { return with_apex(use.facet, apex); };
    const Simplex own = with(simplex[use.opposite]);
    for (Vertex q = 0; mesh.points.names(q); ++q) {
      if (orientation(points, with(q)) * orientation(points, own) >= 0) continue;
      const auto volume_of = [&](const Simplex& of) {
        return orientation_determinant(points, points.axes(), of);
      };
      verdict.add(
          rule,
          {.simplices = {simplex},
           .face = use.facet,
           .vertices = {q},
           .values = {{"orientation determinant of facet and own apex", volume_of(own)},
                      {"orientation determinant of facet and vertex beyond", volume_of(with(q))}}});
      break;
    }
  }
}

}  // namespace circumspect::definition
