#include "oracle/judge/domain/judge_exactly.hpp"

#include <cassert>

#include "oracle/judge/complex/judge_complex.hpp"
#include "oracle/judge/convex_hull/judge_convex_hull.hpp"
#include "oracle/judge/definition/judge.hpp"
#include "oracle/judge/domain/judge_domain.hpp"
#include "oracle/judge/points/delaunay.hpp"
#include "oracle/judge/points/triangulation.hpp"
#include "oracle/judge/surface/judge_surface.hpp"

namespace circumspect::check {
namespace {

Verdict judge_by_definition(Claim claim, const ExactMesh& mesh, const Domain* domain,
                            const Options& options) {
  Verdict verdict = domain == nullptr
                        ? definition::judge(claim, mesh, options.max_violations)
                        : definition::judge(claim, mesh, domain->complex, options.max_violations);
  judge_beside_definition(mesh, options, verdict);
  return verdict;
}

Verdict judge_list(Claim claim, const ExactMesh& mesh, const Options& options) {
  const bool by_definition = options.by == By::kDefinition;
  switch (claim) {
    case Claim::kComplex:
      return judge_complex({mesh.points.points(), mesh.simplices}, options.complex, by_definition,
                           options.max_violations);
    case Claim::kConvexHull:
      return judge_convex_hull(mesh, options.hull, options.oriented, by_definition,
                               options.max_violations);
    default:
      assert(claim == Claim::kSurfaceDelaunay);
      return judge_surface(mesh, by_definition, options.max_violations);
  }
}

}  // namespace

Verdict judge_exactly(Claim claim, const ExactMesh& mesh, const Domain* domain,
                      const Options& options, const fast::SimplexFacts* known) {
  assert((domain != nullptr) == is_about_a_domain(claim));
  if (is_about_a_list(claim)) return judge_list(claim, mesh, options);
  if (options.by == By::kDefinition) return judge_by_definition(claim, mesh, domain, options);
  return domain == nullptr ? judge_points(claim, mesh, options)
                           : judge_domain(claim, mesh, *domain, options, known);
}

}  // namespace circumspect::check
