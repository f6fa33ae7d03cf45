// What is known of the simplices of a mesh, by exact numbers and by looking at everything: what a faster
// judge has to find, for tests.
#pragma once

#include <algorithm>
#include <optional>

#include "oracle/judge/domain/judge_domain.hpp"
#include "oracle/judge/points/simplices.hpp"
#include "oracle/judge/points/triangulation.hpp"
#include "reference/kernel/complex/simplex.hpp"
#include "reference/kernel/predicates/in_ball.hpp"
#include "reference/kernel/predicates/perturbation.hpp"

namespace circumspect::check {

inline bool fills_hull(const ExactMesh& mesh) {
  Verdict verdict(Claim::kTriangulation, mesh, 1);
  judge_vertex_set(mesh, verdict);
  return judge_complex_by_lemma(mesh, facet_uses(mesh.simplices), verdict) && verdict.holds();
}

// Nothing if conditions 0 and 1 do not hold of the simplices.
inline std::optional<fast::SimplexFacts> exact_facts(Claim claim, const ExactMesh& mesh,
                                                     const Domain& domain) {
  const PointSet& points = mesh.points;
  if (mesh.simplices.empty()) return std::nullopt;
  if (points.dimension() != static_cast<int>(points.ambient_dimension())) return std::nullopt;
  const std::vector<FacetUse> uses = facet_uses(mesh.simplices);
  Verdict verdict(claim, mesh, 1);
  if (!judge_simplices(mesh, false, verdict)) return std::nullopt;
  if (!judge_facet_matching(mesh, uses, verdict)) return std::nullopt;
  fast::SimplexFacts known;
  for_each_facet(uses, [&](std::span<const FacetUse> group) {
    const Simplex& simplex = mesh.simplices[group[0].simplex];
    const fast::FacetId facet(group[0].simplex, group[0].opposite);
    if (group.size() == 1) known.boundary.push_back(facet);
    if (group.size() == 1 || !is_about_balls(claim)) return;
    const Configuration& all = points.configuration();
    const Vertex apex = mesh.simplices[group[1].simplex][group[1].opposite];
    const int side = in_ball(all, simplex, apex);
    if (side > 0) known.not_local.push_back(facet);
    if (side != 0) return;
    known.ties.push_back(facet);
    const bool canonical = perturbed_in_ball(all, all.axes(), simplex, apex) < 0;
    if (!canonical) known.not_canonical.push_back(facet);
  });
  for (auto* facets : {&known.boundary, &known.not_local, &known.ties, &known.not_canonical}) {
    std::sort(facets->begin(), facets->end());
  }
  known.fills_hull = domain.complex.kind == DomainKind::kHull && fills_hull(mesh);
  return known;
}

}  // namespace circumspect::check
