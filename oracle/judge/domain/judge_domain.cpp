#include "oracle/judge/domain/judge_domain.hpp"

#include <cassert>

#include "oracle/judge/domain/conforming_delaunay.hpp"
#include "oracle/judge/domain/constrained_delaunay.hpp"
#include "oracle/judge/domain/plc_triangulation.hpp"

namespace circumspect::check {
namespace {

bool is_constrained(Claim claim) { return claim == Claim::kCdt || claim == Claim::kSteinerCdt; }

}  // namespace

bool is_about_balls(Claim claim) {
  return is_constrained(claim) || claim == Claim::kConformingDelaunay;
}

bool allows_steiner_points(Claim claim) {
  return claim != Claim::kPlcTriangulation && claim != Claim::kCdt;
}

Verdict judge_domain(Claim claim, const ExactMesh& mesh, const Domain& domain,
                     const Options& options, const fast::SimplexFacts* known) {
  assert(is_about_a_domain(claim) && !mesh.points.is_weighted());
  assert(options.by == By::kLemma);
  Verdict verdict(claim, mesh, options.max_violations);
  const auto then = [&](const MeshedDomain& in, const std::vector<WallPiece>& pieces) {
    if (is_constrained(claim)) judge_constrained_delaunay_by_lemma(in, pieces, verdict);
    if (claim == Claim::kConformingDelaunay) judge_delaunay_by_lemma(in, pieces, verdict);
  };
  judge_plc_triangulation_by_lemma(mesh, domain, options, known, allows_steiner_points(claim), then,
                                   verdict);
  return verdict;
}

}  // namespace circumspect::check
