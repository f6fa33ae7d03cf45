#include "oracle/judge/definition/judge.hpp"

#include "oracle/judge/definition/constrained_delaunay.hpp"
#include "oracle/judge/definition/delaunay.hpp"
#include "oracle/judge/definition/plc_triangulation.hpp"
#include "oracle/judge/definition/simplicial_complex.hpp"
#include "oracle/judge/definition/triangulation.hpp"

namespace circumspect::definition {

Verdict judge(Claim claim, const ExactMesh& mesh, std::size_t max_violations) {
  Verdict verdict(claim, mesh, max_violations);
  const auto size = static_cast<std::size_t>(mesh.points.dimension() + 1);
  const bool are_simplices = judge_each_simplex(mesh, size, verdict);
  // A point of a weighted set need not be a vertex, unless it is outside of all simplices.
  const bool all_are_vertices = claim != Claim::kWeightedDelaunay || mesh.simplices.empty();
  if (all_are_vertices) judge_vertices_are_points(mesh, verdict);
  if (!are_simplices || !judge_every_two(mesh.points, mesh.simplices, verdict)) return verdict;
  judge_union_is_hull(mesh, Rule::kHullNotConvex, verdict);
  if (claim != Claim::kTriangulation) judge_balls_are_empty(mesh, verdict);
  return verdict;
}

Verdict judge(Claim claim, const ExactMesh& mesh, const PiecewiseLinearComplex& domain,
              std::size_t max_violations) {
  Verdict verdict(claim, mesh, max_violations);
  const bool may_have_more = claim != Claim::kPlcTriangulation && claim != Claim::kCdt;
  const auto augmented = judge_plc_triangulation(mesh, domain, may_have_more, verdict);
  if (!augmented) return verdict;
  if (claim == Claim::kCdt || claim == Claim::kSteinerCdt) {
    judge_constrained_delaunay(mesh, *augmented, verdict);
  }
  if (claim == Claim::kConformingDelaunay) {
    judge_balls_are_empty(mesh, verdict);
    judge_some_ball_is_empty(mesh.points, mesh.faces, verdict);
    verdict.unique.reset();  // there may be other conforming ones, with other Steiner points
    verdict.canonical.reset();
  }
  return verdict;
}

}  // namespace circumspect::definition
