#include "oracle/check/check.hpp"

#include <cassert>

#include "oracle/check/delaunay.hpp"
#include "oracle/check/neighbors.hpp"
#include "oracle/check/simplices.hpp"
#include "oracle/check/triangulation.hpp"

namespace circumspect::check {
namespace {

// The simplices one by one and the vertex set; then, if every simplex can be worked with, whether
// they are a complex that covers the hull. Says whether facets have their meaning, so that whether
// they are locally Delaunay can be asked.
bool judge_triangulation(const Mesh& mesh, const Options& options, Verdict& verdict) {
  const bool simplices_are_sound = judge_simplices(mesh, options.oriented, verdict);
  judge_vertex_set(mesh, verdict);
  if (!simplices_are_sound) return false;
  const bool facets_match = options.by == By::kLemma ? judge_complex_by_lemma(mesh, verdict)
                                                     : judge_complex_by_definition(mesh, verdict);
  if (facets_match && mesh.neighbors) judge_neighbors(mesh, verdict);
  return facets_match;
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
  if (options.by == By::kLemma) {
    judge_facets_locally_delaunay(mesh, verdict);
  } else {
    judge_balls_empty(mesh, verdict);
  }
  return verdict;
}

Verdict judge(Claim claim, const Mesh& mesh, const Options& options) {
  return claim == Claim::kTriangulation ? triangulation(mesh, options) : delaunay(mesh, options);
}

}  // namespace circumspect::check
