// Facets are matched as a dictionary of them matches them.
#include "oracle/fast/facet_matching.hpp"

#include <map>
#include <random>

#include <doctest/doctest.h>

#include "oracle/fast/grid_mesh_test.hpp"

namespace circumspect::fast {
namespace {

template <std::size_t kDimension, typename Index>
std::vector<std::int32_t> matched_by_dictionary(const MeshView<kDimension, Index>& mesh) {
  constexpr std::size_t kVertices = kDimension + 1;
  std::map<std::vector<Index>, std::size_t> unmatched;
  std::vector<std::int32_t> links(mesh.simplices.size(), -1);
  for (std::size_t facet = 0; facet < mesh.simplices.size(); ++facet) {
    const auto row = mesh.row(facet / kVertices);
    std::vector<Index> vertices(row.begin(), row.end());
    vertices.erase(vertices.begin() + static_cast<std::ptrdiff_t>(facet % kVertices));
    std::sort(vertices.begin(), vertices.end());
    const auto [found, is_new] = unmatched.emplace(vertices, facet);
    if (is_new) continue;
    links[facet] = static_cast<std::int32_t>(found->second / kVertices);
    links[found->second] = static_cast<std::int32_t>(facet / kVertices);
    unmatched.erase(found);
  }
  return links;
}

std::vector<std::int32_t> listed(const OwnedLinks& links) {
  return {links.view().begin(), links.view().end()};
}

template <std::size_t kDimension, typename Index>
void check_grid(std::size_t side) {
  auto mesh = grid_mesh<kDimension, Index>(side);
  const auto expected = matched_by_dictionary(mesh.view());
  for (const unsigned threads : {1U, 2U, 5U}) {
    const auto links = matched_facets(mesh.view(), threads);
    REQUIRE(links.has_value());
    CHECK(listed(*links) == expected);
  }
}

TEST_CASE("facets of grids are matched, by one thread or several") {
  for (const std::size_t side : {2, 3, 12}) {
    check_grid<2, std::int32_t>(side);
    check_grid<2, std::int64_t>(side);
    check_grid<3, std::int32_t>(side);
    check_grid<3, std::int64_t>(side);
  }
  check_grid<2, std::int32_t>(150);  // several piles, several passes
  check_grid<3, std::int32_t>(22);
}

TEST_CASE("a vertex of all simplices makes no pile of all facets") {
  constexpr std::int32_t kRing = 40000;
  MeshInArrays<2> fan;
  for (std::int32_t v = 1; v <= kRing; ++v) {
    fan.simplices.insert(fan.simplices.end(), {v, 0, v % kRing + 1});
  }
  fan.coordinates.assign((kRing + 1) * 2, 0);
  const auto links = matched_facets(fan.view(), 1);
  REQUIRE(links.has_value());
  CHECK(listed(*links) == matched_by_dictionary(fan.view()));
}

TEST_CASE("a facet of three simplices, and an index that names no point, are seen") {
  MeshInArrays<2> mesh;
  mesh.coordinates.assign(10, 0);
  mesh.simplices = {0, 1, 2, 1, 0, 3, 0, 4, 1};
  CHECK(matched_facets(mesh.view(), 1).error() == Undecided::kFacetOverused);
  mesh.simplices = {0, 1, 2, 1, 0, 3, 0, 4, 2};
  CHECK(listed(matched_facets(mesh.view(), 1).value()) ==
        std::vector<std::int32_t>{-1, 2, 1, -1, -1, 0, -1, 0, -1});
  for (const std::int32_t wrong : {-1, 5, 1 << 30}) {
    mesh.simplices[4] = wrong;
    CHECK(matched_facets(mesh.view(), 1).error() == Undecided::kUnknownVertex);
  }
}

}  // namespace
}  // namespace circumspect::fast
