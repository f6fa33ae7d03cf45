#include "oracle/judge/fast/volume.hpp"

#include <utility>

#include "oracle/judge/fast/finite.hpp"
#include "oracle/judge/fast/whole_sweep.hpp"

namespace circumspect::fast {

template <std::size_t kDimension, typename Index>
tl::expected<Volume, Undecided> volume(const MeshView<kDimension, Index>& mesh, bool balls,
                                       unsigned threads) {
  if (mesh.size() == 0) return tl::unexpected(Undecided::kEmpty);
  if (!are_finite(mesh.coordinates, threads)) return tl::unexpected(Undecided::kNotFinite);
  // Facets with the same vertices have the same hash: a facet without a link is in no other
  // simplex, and one with a link in no third. So two simplices with the same vertices would be
  // linked at all their facets, and neither has a vertex off a facet that the other has not.
  auto links = matched_facets(mesh, threads);
  if (!links) return tl::unexpected(links.error());
  WholeSweep<kDimension, Index, std::int32_t> sweep(mesh, links->view(), threads);
  Swept swept = sweep.run({.balls = balls, .ties = balls});
  if (swept.undecided) return tl::unexpected(*swept.undecided);
  return Volume{
      .boundary = sweep.boundary().template facets<kDimension + 1>(links->view(), 0, mesh.size()),
      .not_local = std::move(swept.not_local),
      .ties = std::move(swept.ties),
      .not_canonical = std::move(swept.not_canonical),
      .unused = sweep.unused(),
      .oriented = sweep.orientations().are_equal(),
      .links = std::move(*links),
      .stages = swept.stages};
}

template tl::expected<Volume, Undecided> volume(const MeshView<2, std::int32_t>&, bool, unsigned);
template tl::expected<Volume, Undecided> volume(const MeshView<2, std::int64_t>&, bool, unsigned);
template tl::expected<Volume, Undecided> volume(const MeshView<3, std::int32_t>&, bool, unsigned);
template tl::expected<Volume, Undecided> volume(const MeshView<3, std::int64_t>&, bool, unsigned);

}  // namespace circumspect::fast
