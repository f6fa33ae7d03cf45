#include "oracle/judge/verdict_of_facts.hpp"

#include <utility>
#include <vector>

#include "oracle/judge/part.hpp"
#include "oracle/judge/shared_facets.hpp"

namespace circumspect::check {
namespace {

template <std::size_t kDimension, typename Index>
Verdict not_local(Claim claim, const fast::MeshView<kDimension, Index>& mesh,
                  const fast::Facts& facts, const Options& options) {
  std::vector<SharedFacet> facets = shared_facets(mesh, facts.not_local);
  std::vector<std::size_t> simplices, apexes;
  for (const SharedFacet& shared : facets) {
    simplices.push_back(shared.simplex);
    apexes.push_back(static_cast<std::size_t>(shared.apex));
  }
  const Part<kDimension, Index> part(mesh, std::move(simplices), apexes);
  for (SharedFacet& shared : facets) {
    for (Vertex& v : shared.facet) v = part.place_of(v);
    shared.simplex = part.place_of_simplex(shared.simplex);
    shared.apex = part.place_of(shared.apex);
  }
  const bool weighted = claim == Claim::kWeightedDelaunay && !mesh.weights.empty();
  Verdict verdict = not_locally_delaunay(claim, part.mesh(weighted), std::move(facets), options);
  verdict.name_in_whole(part.vertices(), part.simplices());
  return verdict;
}

}  // namespace

template <std::size_t kDimension, typename Index>
Verdict verdict_of_facts(Claim claim, const fast::MeshView<kDimension, Index>& mesh,
                         const fast::Facts& facts, const Options& options) {
  Verdict verdict(claim, options.max_violations);
  if (facts.holds()) {
    if (claim != Claim::kTriangulation) {
      verdict.unique = facts.unique;
      verdict.canonical = facts.canonical;
    }
  } else {
    verdict = not_local(claim, mesh, facts, options);
  }
  verdict.points = mesh.points();
  verdict.simplices = mesh.size();
  verdict.dimension = static_cast<int>(kDimension);
  return verdict;
}

template Verdict verdict_of_facts(Claim, const fast::MeshView<2, std::int32_t>&, const fast::Facts&,
                                  const Options&);
template Verdict verdict_of_facts(Claim, const fast::MeshView<2, std::int64_t>&, const fast::Facts&,
                                  const Options&);
template Verdict verdict_of_facts(Claim, const fast::MeshView<3, std::int32_t>&, const fast::Facts&,
                                  const Options&);
template Verdict verdict_of_facts(Claim, const fast::MeshView<3, std::int64_t>&, const fast::Facts&,
                                  const Options&);

}  // namespace circumspect::check
