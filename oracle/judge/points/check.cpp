#include "oracle/judge/points/check.hpp"

#include <algorithm>
#include <cassert>
#include <optional>
#include <stdexcept>

#include "oracle/judge/complex/judge_complex.hpp"
#include "oracle/judge/convex_hull/judge_convex_hull.hpp"
#include "oracle/judge/definition/judge.hpp"
#include "oracle/judge/points/delaunay.hpp"
#include "oracle/judge/points/neighbors.hpp"
#include "oracle/judge/points/simplices.hpp"
#include "oracle/judge/points/triangulation.hpp"
#include "oracle/judge/surface/judge_surface.hpp"

namespace circumspect::check {
namespace {

using FacetUses = std::vector<FacetUse>;

// Judges whether the simplices are a complex that covers a convex set, if every one of them is
// usable. Returns the uses of the facets if each facet is in one or two simplices, so that it makes
// sense to ask whether they are locally Delaunay.
std::optional<FacetUses> judge_complex(const ExactMesh& mesh, bool simplices_are_sound,
                                       Verdict& verdict) {
  if (!simplices_are_sound) return std::nullopt;
  FacetUses uses = facet_uses(mesh.simplices);
  if (!judge_complex_by_lemma(mesh, uses, verdict)) return std::nullopt;
  if (mesh.neighbors) judge_neighbors(mesh, uses, verdict);
  return uses;
}

// The simplices one by one, then the vertex set, then how they fit together.
std::optional<FacetUses> judge_triangulation(const ExactMesh& mesh, const Options& options,
                                             Verdict& verdict) {
  const bool simplices_are_sound = judge_simplices(mesh, options.oriented, verdict);
  judge_vertex_set(mesh, verdict);
  return judge_complex(mesh, simplices_are_sound, verdict);
}

Verdict by_definition(Claim claim, const ExactMesh& mesh, const Options& options) {
  Verdict verdict = definition::judge(claim, mesh, options.max_violations);
  judge_beside_definition(mesh, options, verdict);
  return verdict;
}

}  // namespace

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

Verdict triangulation(const ExactMesh& mesh, const Options& options) {
  if (options.by == By::kDefinition) return by_definition(Claim::kTriangulation, mesh, options);
  Verdict verdict(Claim::kTriangulation, mesh, options.max_violations);
  judge_triangulation(mesh, options, verdict);
  return verdict;
}

Verdict delaunay(const ExactMesh& mesh, const Options& options) {
  assert(!mesh.points.is_weighted());
  if (options.by == By::kDefinition) return by_definition(Claim::kDelaunay, mesh, options);
  Verdict verdict(Claim::kDelaunay, mesh, options.max_violations);
  const auto uses = judge_triangulation(mesh, options, verdict);
  if (!uses) return verdict;
  Ambiguity ambiguity;
  judge_facets_locally_delaunay(mesh, *uses, verdict, ambiguity);
  ambiguity.conclude(verdict);
  return verdict;
}

Verdict weighted_delaunay(const ExactMesh& mesh, const Options& options) {
  if (options.by == By::kDefinition) return by_definition(Claim::kWeightedDelaunay, mesh, options);
  Verdict verdict(Claim::kWeightedDelaunay, mesh, options.max_violations);
  const bool simplices_are_sound = judge_simplices(mesh, options.oriented, verdict);
  // A mesh without simplices leaves every point uncovered; in other meshes, points need not be
  // vertices.
  if (mesh.simplices.empty()) judge_vertex_set(mesh, verdict);
  const auto uses = judge_complex(mesh, simplices_are_sound, verdict);
  if (!uses) return verdict;
  Ambiguity ambiguity;
  const bool is_triangulation = verdict.holds();
  judge_facets_locally_delaunay(mesh, *uses, verdict, ambiguity);
  if (is_triangulation) judge_submerged_points(mesh, *uses, verdict, ambiguity);
  ambiguity.conclude(verdict);
  return verdict;
}

Verdict judge_points(Claim claim, const ExactMesh& mesh, const Options& options) {
  switch (claim) {
    case Claim::kTriangulation:
      return triangulation(mesh, options);
    case Claim::kDelaunay:
      return delaunay(mesh, options);
    case Claim::kWeightedDelaunay:
      return weighted_delaunay(mesh, options);
    case Claim::kComplex:
      return judge_complex({mesh.points.points(), mesh.simplices}, options.complex,
                           options.by == By::kDefinition, options.max_violations);
    case Claim::kConvexHull:
      return judge_convex_hull(mesh, options.hull, options.oriented, options.by == By::kDefinition,
                               options.max_violations);
    case Claim::kSurfaceDelaunay:
      return judge_surface(mesh, options.by == By::kDefinition, options.max_violations);
    default:
      break;
  }
  assert(false);
  return weighted_delaunay(mesh, options);
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

}  // namespace circumspect::check
