#include "oracle/judge/points/check.hpp"

#include <algorithm>
#include <cassert>
#include <stdexcept>

#include "oracle/judge/points/simplices.hpp"
#include "oracle/judge/points/triangulation.hpp"

namespace circumspect::check {

Verdict judge_points(Claim claim, const ExactMesh& mesh, const Options& options) {
  const bool is_weighted = claim == Claim::kWeightedDelaunay;
  assert(is_weighted || claim == Claim::kTriangulation ||
         (claim == Claim::kDelaunay && !mesh.points.is_weighted()));
  assert(options.by == By::kLemma);
  Verdict verdict(claim, mesh, options.max_violations);
  const bool simplices_are_sound = judge_simplices(mesh, options.oriented, verdict);
  // Weighted points need not be vertices. A mesh without simplices leaves every point uncovered.
  if (!is_weighted || mesh.simplices.empty()) judge_vertex_set(mesh, verdict);
  if (!simplices_are_sound) return verdict;
  const std::vector<FacetUse> uses = facet_uses(mesh.simplices);
  if (!judge_complex_by_lemma(mesh, uses, verdict)) return verdict;
  if (mesh.neighbors) judge_neighbors(mesh, uses, verdict);
  if (claim == Claim::kTriangulation) return verdict;
  const bool is_triangulation = verdict.holds();
  Ambiguity ambiguity;
  judge_facets_locally_delaunay(mesh, uses, verdict, ambiguity);
  if (is_weighted && is_triangulation) judge_submerged_points(mesh, uses, verdict, ambiguity);
  ambiguity.conclude(verdict);
  return verdict;
}

Verdict not_locally_delaunay(Claim claim, const ExactMesh& mesh, std::vector<SharedFacet> facets,
                             const Options& options) {
  assert(claim == Claim::kDelaunay || claim == Claim::kWeightedDelaunay);
  assert(!facets.empty());
  std::sort(facets.begin(), facets.end(),
            [](const SharedFacet& a, const SharedFacet& b) { return a.facet < b.facet; });
  Verdict verdict(claim, mesh, options.max_violations);
  for (const SharedFacet& shared : facets) {
    if (judge_facet_locally_delaunay(mesh, shared, verdict) > 0) continue;
    throw std::logic_error("a facet was taken for one that is not locally Delaunay, and is");
  }
  return verdict;
}

void judge_beside_definition(const ExactMesh& mesh, const Options& options, Verdict& verdict) {
  Verdict beside(verdict.claim(), mesh, 0);
  const bool was_compared = verdict.tallies().count(Rule::kWrongDimension) == 0 &&
                            judge_simplices(mesh, options.oriented, beside);
  if (!was_compared) return;
  if (mesh.neighbors && verdict.tallies().count(Rule::kOverlap) == 0) {
    judge_neighbors(mesh, facet_uses(mesh.simplices), beside);
  }
  for (const Violation& violation : beside.violations()) {
    verdict.add(violation.rule, violation.witness);
    verdict.unique.reset();
    verdict.canonical.reset();
  }
}

}  // namespace circumspect::check
