// The witnesses of the checkers, in the numbers of a refutation.
#include <algorithm>
#include <cassert>

#include "oracle/certificate/evidence.hpp"

namespace circumspect::certificate {
namespace {

// A simplex and the place of one of its vertices.
struct Entry {
  std::size_t simplex;
  std::size_t place;
};

std::size_t place_of(const Simplex& simplex, Vertex v) {
  return static_cast<std::size_t>(std::find(simplex.begin(), simplex.end(), v) - simplex.begin());
}

// The simplex that joins the facet and the vertex.
Entry entry_of(const ExactMesh& mesh, Simplex facet, Vertex apex) {
  facet.push_back(apex);
  const Simplex vertices = sorted(facet);
  const auto found =
      std::find_if(mesh.simplices.begin(), mesh.simplices.end(),
                   [&](const Simplex& simplex) { return sorted(simplex) == vertices; });
  assert(found != mesh.simplices.end());
  return {static_cast<std::size_t>(found - mesh.simplices.begin()), place_of(*found, apex)};
}

// Any simplex that has the vertex.
Entry entry_of(const ExactMesh& mesh, Vertex v) {
  const auto found = std::find_if(mesh.simplices.begin(), mesh.simplices.end(),
                                  [v](const Simplex& simplex) { return contains(simplex, v); });
  assert(found != mesh.simplices.end());
  return {static_cast<std::size_t>(found - mesh.simplices.begin()), place_of(*found, v)};
}

void append(std::vector<Integer>& because, const Entry& entry) {
  because.emplace_back(static_cast<unsigned long>(entry.simplex + 1));
  because.emplace_back(static_cast<unsigned long>(entry.place));
}

}  // namespace

std::size_t number_of(const ExactMesh& mesh, const Simplex& simplex) {
  const auto found = std::find(mesh.simplices.begin(), mesh.simplices.end(), simplex);
  assert(found != mesh.simplices.end());
  return static_cast<std::size_t>(found - mesh.simplices.begin()) + 1;
}

std::optional<Evidence> ball_evidence(const ExactMesh& mesh, Rule rule, const Witness& witness) {
  Evidence evidence{rule, {}};
  const Vertex q = witness.vertices.front();
  const Simplex& simplex = witness.simplices.front();
  if (rule == Rule::kVertexSubmerged) {
    append(evidence.because, entry_of(mesh, q));
    for (const Vertex v : simplex) evidence.because.emplace_back(Integer(v) + 1);
  } else if (rule == Rule::kFacetNotLocal) {
    const std::size_t number = number_of(mesh, simplex);
    const Simplex& facet = *witness.face;
    const auto off =
        std::find_if(simplex.begin(), simplex.end(), [&](Vertex v) { return !contains(facet, v); });
    append(evidence.because, {number - 1, static_cast<std::size_t>(off - simplex.begin())});
    append(evidence.because, entry_of(mesh, facet, q));
  } else {
    evidence.because.emplace_back(static_cast<unsigned long>(number_of(mesh, simplex)));
    evidence.because.emplace_back(Integer(q) + 1);
  }
  return evidence;
}

}  // namespace circumspect::certificate
