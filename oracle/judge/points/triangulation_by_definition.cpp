// The definition, word for word. Book: Definition 2.1.
#include "oracle/judge/points/boundary_facet.hpp"
#include "oracle/judge/points/triangulation.hpp"
#include "reference/kernel/complex/proper_intersection.hpp"
#include "reference/kernel/complex/simplex.hpp"

namespace circumspect::check {
namespace {

// "A simplicial complex": any two simplices meet in a common face or not at all. Their faces then do
// so too, since a face's point has one carrier in either simplex.
bool judge_pairs(const ExactMesh& mesh, Verdict& verdict) {
  bool proper = true;
  for (std::size_t a = 0; a < mesh.simplices.size(); ++a) {
    for (std::size_t b = a + 1; b < mesh.simplices.size(); ++b) {
      const Simplex& first = mesh.simplices[a];
      const Simplex& second = mesh.simplices[b];
      const auto common = improper_intersection(mesh.points, first, second);
      if (!common) continue;
      proper = false;
      verdict.add(Rule::kOverlap, {.simplices = {first, second}, .point = common});
    }
  }
  return proper;
}

// "Whose union is conv S". In a complex, a generic path from a covered point of the interior of
// conv S to an uncovered one leaves the union through the relative interior of a facet that only
// one simplex has, towards the interior of conv S; so some point of S lies beyond that facet. And
// nothing outside conv S is covered, because all vertices are points of S.
void judge_union(const ExactMesh& mesh, Verdict& verdict) {
  const Configuration& points = mesh.points.configuration();
  for (const BoundaryFacet& facet : boundary_facets(mesh, facet_uses(mesh.simplices))) {
    for (Vertex q = 0; mesh.points.names(q); ++q) {
      if (side_of(points, facet, q) >= 0) continue;
      verdict.add(Rule::kHullNotConvex, beyond(mesh, facet, q));
      break;
    }
  }
}

}  // namespace

bool judge_complex_by_definition(const ExactMesh& mesh, Verdict& verdict) {
  if (!judge_pairs(mesh, verdict)) return false;
  judge_union(mesh, verdict);
  return true;
}

}  // namespace circumspect::check
