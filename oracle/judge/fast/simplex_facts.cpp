#include "oracle/judge/fast/simplex_facts.hpp"

#include <utility>

#include "oracle/judge/fast/facet_matching.hpp"
#include "oracle/judge/fast/in_chunks.hpp"
#include "oracle/judge/fast/judge.hpp"
#include "oracle/judge/fast/sweep.hpp"

namespace circumspect::fast {

template <std::size_t kDimension, typename Index>
tl::expected<SimplexFacts, Undecided> simplex_facts(const MeshView<kDimension, Index>& mesh,
                                                    Wanted wanted, unsigned threads) {
  if (mesh.size() == 0) return tl::unexpected(Undecided::kEmpty);
  if (!are_finite(mesh.coordinates, threads)) return tl::unexpected(Undecided::kNotFinite);
  // Facets with the same vertices have the same hash: a facet without a link is in no other
  // simplex, and one with a link in no third. So two simplices with the same vertices would be
  // linked at all their facets, and neither has a vertex off a facet that the other has not.
  const auto links = matched_facets(mesh, threads);
  if (!links) return tl::unexpected(links.error());
  if (!links->overused.empty()) return tl::unexpected(Undecided::kFacetOverused);
  WholeSweep<kDimension, Index, std::int32_t> sweep(mesh, links->view(), threads);
  Swept swept = sweep.run({.balls = wanted.balls, .ties = wanted.balls});
  if (swept.undecided) return tl::unexpected(*swept.undecided);
  SimplexFacts facts{
      .boundary = sweep.boundary().template facets<kDimension + 1>(links->view(), 0, mesh.size()),
      .not_local = std::move(swept.not_local),
      .ties = std::move(swept.ties),
      .not_canonical = std::move(swept.not_canonical),
      .oriented = sweep.orientations().are_equal(),
      .stages = swept.stages};
  if (wanted.hull) {
    facts.fills_hull = judge(mesh, links->view(), Question::kTriangulation, threads).has_value();
  }
  return facts;
}

template tl::expected<SimplexFacts, Undecided> simplex_facts(const MeshView<2, std::int32_t>&,
                                                             Wanted, unsigned);
template tl::expected<SimplexFacts, Undecided> simplex_facts(const MeshView<2, std::int64_t>&,
                                                             Wanted, unsigned);
template tl::expected<SimplexFacts, Undecided> simplex_facts(const MeshView<3, std::int32_t>&,
                                                             Wanted, unsigned);
template tl::expected<SimplexFacts, Undecided> simplex_facts(const MeshView<3, std::int64_t>&,
                                                             Wanted, unsigned);

}  // namespace circumspect::fast
