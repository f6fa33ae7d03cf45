#include "oracle/check/check.hpp"

#include <cassert>

#include "oracle/check/delaunay.hpp"
#include "oracle/check/neighbors.hpp"
#include "oracle/check/simplices.hpp"
#include "oracle/check/submerged_points.hpp"
#include "oracle/check/triangulation.hpp"

namespace circumspect::check {
namespace {

// Whether the simplices are a complex that covers a convex set, if every one of them can be worked
// with. Says whether facets have their meaning, so that whether they are locally Delaunay can be
// asked.
bool judge_complex(const Mesh& mesh, const Options& options, bool simplices_are_sound,
                   Verdict& verdict) {
  if (!simplices_are_sound) return false;
  const bool facets_match = options.by == By::kLemma ? judge_complex_by_lemma(mesh, verdict)
                                                     : judge_complex_by_definition(mesh, verdict);
  if (facets_match && mesh.neighbors) judge_neighbors(mesh, verdict);
  return facets_match;
}

// The simplices one by one, then the vertex set, then how they fit together.
bool judge_triangulation(const Mesh& mesh, const Options& options, Verdict& verdict) {
  const bool simplices_are_sound = judge_simplices(mesh, options.oriented, verdict);
  judge_vertex_set(mesh, verdict);
  return judge_complex(mesh, options, simplices_are_sound, verdict);
}

void judge_balls(const Mesh& mesh, const Options& options, Verdict& verdict, Ambiguity& ambiguity) {
  if (options.by == By::kLemma) {
    judge_facets_locally_delaunay(mesh, verdict, ambiguity);
  } else {
    judge_balls_empty(mesh, verdict, ambiguity);
  }
}

}  // namespace

Verdict triangulation(const Mesh& mesh, const Options& options) {
  Verdict verdict(Claim::kTriangulation, mesh, options.max_violations);
  judge_triangulation(mesh, options, verdict);
  return verdict;
}

Verdict delaunay(const Mesh& mesh, const Options& options) {
  assert(!mesh.points.is_weighted());
  Verdict verdict(Claim::kDelaunay, mesh, options.max_violations);
  if (!judge_triangulation(mesh, options, verdict)) return verdict;
  Ambiguity ambiguity;
  judge_balls(mesh, options, verdict, ambiguity);
  ambiguity.conclude(verdict);
  return verdict;
}

Verdict weighted_delaunay(const Mesh& mesh, const Options& options) {
  Verdict verdict(Claim::kWeightedDelaunay, mesh, options.max_violations);
  const bool simplices_are_sound = judge_simplices(mesh, options.oriented, verdict);
  // A mesh without simplices leaves every point uncovered; otherwise not all points are vertices.
  if (mesh.simplices.empty()) judge_vertex_set(mesh, verdict);
  if (!judge_complex(mesh, options, simplices_are_sound, verdict)) return verdict;
  Ambiguity ambiguity;
  const bool is_triangulation = verdict.holds();
  judge_balls(mesh, options, verdict, ambiguity);
  // By definition the balls have been held against all points already.
  if (is_triangulation && options.by == By::kLemma) {
    judge_submerged_points(mesh, verdict, ambiguity);
  }
  ambiguity.conclude(verdict);
  return verdict;
}

Verdict judge(Claim claim, const Mesh& mesh, const Options& options) {
  switch (claim) {
    case Claim::kTriangulation:
      return triangulation(mesh, options);
    case Claim::kDelaunay:
      return delaunay(mesh, options);
    case Claim::kWeightedDelaunay:
      return weighted_delaunay(mesh, options);
    default:
      break;
  }
  assert(false);
  return weighted_delaunay(mesh, options);
}

}  // namespace circumspect::check
