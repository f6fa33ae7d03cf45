// Faults of the boundary: the simplices of the facets in question are looked up.
#include <algorithm>
#include <cassert>

#include "oracle/certificate/evidence.hpp"

namespace circumspect::certificate {
namespace {

// The number of a simplex that has the facet, and the place of its other vertex.
void append_facet(std::vector<Integer>& because, const ExactMesh& mesh, const Simplex& facet) {
  const auto found =
      std::find_if(mesh.simplices.begin(), mesh.simplices.end(), [&](const Simplex& simplex) {
        return std::all_of(facet.begin(), facet.end(),
                           [&](Vertex v) { return contains(simplex, v); });
      });
  assert(found != mesh.simplices.end());
  const auto off =
      std::find_if(found->begin(), found->end(), [&](Vertex v) { return !contains(facet, v); });
  because.emplace_back(static_cast<unsigned long>(found - mesh.simplices.begin()) + 1);
  because.emplace_back(static_cast<unsigned long>(off - found->begin()));
}

}  // namespace

std::optional<Evidence> hull_evidence(const ExactMesh& mesh, Rule rule, const Witness& witness) {
  Evidence evidence{rule, {}};
  if (rule == Rule::kHullNotConvex) {
    append_facet(evidence.because, mesh, *witness.face);
    evidence.because.emplace_back(Integer(witness.vertices.front()) + 1);
    return evidence;
  }
  // Each simplex around a ridge has two of the facets there, and no facet is in three simplices: so
  // those that are in one simplex only are even in number, and if they are not two, they are four.
  constexpr std::size_t kEnough = 3;
  if (witness.simplices.size() < kEnough) return std::nullopt;
  for (std::size_t i = 0; i < kEnough; ++i) {
    append_facet(evidence.because, mesh, witness.simplices[i]);
  }
  return evidence;
}

std::optional<Evidence> uncovered_point_evidence(const ExactMesh& mesh, const ScaledPoints& points,
                                                 Vertex point) {
  Evidence evidence{Rule::kUnusedPoint, {Integer(point) + 1}};
  const HomogeneousPoint q = barycentre(points, {point});
  Sidedness sidedness(points);
  for (const Simplex& simplex : mesh.simplices) {
    const auto place = sidedness.separating_place(simplex, sidedness.orientation(simplex), q);
    if (!place) return std::nullopt;
    evidence.because.emplace_back(static_cast<unsigned long>(*place));
  }
  return evidence;
}

}  // namespace circumspect::certificate
