// The sweep as such: for every width of vectors, and where the filter leaves much to the exact stages.
#include "oracle/judge/fast/sweep.hpp"

#include <random>
#include <string>

#include <doctest/doctest.h>

#include "oracle/judge/fast/exact_sign.hpp"
#include "oracle/judge/fast/facet_matching.hpp"
#include "oracle/judge/fast/grid_mesh_test.hpp"

namespace circumspect::fast {
namespace {

template <std::size_t kDimension>
SiteRow<kDimension> row_of(const MeshView<kDimension, std::int32_t>& mesh, std::size_t s) {
  SiteRow<kDimension> row;
  for (std::size_t i = 0; i <= kDimension; ++i) row[i] = mesh.template site<false>(mesh.row(s)[i]);
  return row;
}

// All simplices are oriented alike.
template <std::size_t kDimension>
int orientation_of(const MeshView<kDimension, std::int32_t>& mesh) {
  Stages stages;
  return exact_orientation(row_of<kDimension>(mesh, 0), stages);
}

template <std::size_t kDimension>
Swept swept(const MeshView<kDimension, std::int32_t>& mesh, Lattice lattice,
            const BlockKernels<kDimension>& kernels) {
  const Orientations orientations(orientation_of<kDimension>(mesh));
  UsedPoints used(mesh.points());
  BoundarySimplices boundary(mesh.size());
  return sweep<kDimension, std::int32_t, std::int32_t>({.mesh = mesh,
                                                        .links = mesh.neighbors,
                                                        .orientations = orientations,
                                                        .sample = nullptr,
                                                        .balls = true,
                                                        .weighted = false,
                                                        .ties = true,
                                                        .lattice = lattice,
                                                        .used = used,
                                                        .boundary = boundary,
                                                        .kernels = &kernels},
                                                       0, mesh.size());
}

// Facets of two simplices whose far apexes are inside, on the ball: by exact signs.
struct Facets {
  std::vector<FacetId> not_local, ties;
};
template <std::size_t kDimension>
Facets facets_of(const MeshView<kDimension, std::int32_t>& mesh) {
  constexpr std::size_t kVertices = kDimension + 1;
  const int own = orientation_of<kDimension>(mesh);
  Facets facets;
  Stages stages;
  for (std::size_t f = 0; f < mesh.neighbors.size(); ++f) {
    const auto beyond = static_cast<std::size_t>(mesh.neighbors[f]);
    if (mesh.neighbors[f] < static_cast<std::int32_t>(f / kVertices)) continue;
    std::int32_t apex = mesh.row(f / kVertices)[f % kVertices];
    for (std::size_t i = 0; i < kVertices; ++i) {
      apex ^= mesh.row(f / kVertices)[i] ^ mesh.row(beyond)[i];
    }
    const int side = own * exact_ball_sign(row_of<kDimension>(mesh, f / kVertices),
                                           mesh.template site<false>(apex), false, stages);
    if (side >= 0)
      (side > 0 ? facets.not_local : facets.ties).emplace_back(f / kVertices, f % kVertices);
  }
  return facets;
}

template <std::size_t kDimension>
void hold_grid(std::size_t side) {
  auto mesh = grid_mesh<kDimension>(side);
  const auto links = matched_facets(mesh.view(), 1);
  mesh.neighbors.assign(links->view().begin(), links->view().end());
  std::mt19937_64 random(kDimension);
  // As it is; off any lattice of use, by as much everywhere; then by various amounts.
  for (const int turn : {0, 1, 2}) {
    CAPTURE(turn);
    for (double& x : mesh.coordinates) {
      if (turn > 0) x += 0x1p-43;
      if (turn == 2 && random() % 4 == 0) x += static_cast<double>(random() % 5) * 0x1p-43;
    }
    const Lattice lattice = lattice_of_all(mesh.coordinates, {});
    CHECK((lattice.unit != 0) == (turn == 0));
    const Facets facets = facets_of<kDimension>(mesh.view());
    CHECK(facets.not_local.empty() == (turn < 2));
    CHECK_FALSE(facets.ties.empty());
    const Swept first = swept<kDimension>(mesh.view(), lattice, block_kernels<kDimension>()[0]);
    CHECK((first.stages.exact() > 0) == (turn > 0));
    CHECK(first.up == first.down);
    for (const BlockKernels<kDimension>& kernels : block_kernels<kDimension>()) {
      CAPTURE(std::string(kernels.name));
      const Swept again = swept<kDimension>(mesh.view(), lattice, kernels);
      REQUIRE(again.goes_on());
      CHECK(again.not_local == facets.not_local);
      CHECK(again.ties == facets.ties);
      CHECK(again.not_canonical == first.not_canonical);
      CHECK_FALSE(again.unique);
      CHECK(again.canonical == first.not_canonical.empty());
      CHECK(again.stages == first.stages);
    }
  }
}

TEST_CASE("facets that are not locally Delaunay are found, and ties, whatever decides") {
  hold_grid<2>(23);
  hold_grid<3>(7);
}

}  // namespace
}  // namespace circumspect::fast
