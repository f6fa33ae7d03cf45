// Matching the facets of two simplices, and the orders in which they list a facet.
#include "oracle/judge/fast/facet_matching.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <random>

#include <doctest/doctest.h>

#include "oracle/judge/fast/facet_records.hpp"
#include "oracle/judge/fast/grid_mesh_test.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect::fast {

// Facets are matched as a dictionary matches them.

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

template <std::size_t kVertices, typename Index>
void shuffle(std::vector<Index>& simplices) {
  std::mt19937_64 random(3);
  for (std::size_t s = simplices.size() / kVertices; s > 1; --s) {
    const std::size_t other = random() % s;
    std::swap_ranges(&simplices[(s - 1) * kVertices], &simplices[0] + s * kVertices,
                     &simplices[other * kVertices]);
  }
}

std::vector<std::int32_t> listed(const OwnedLinks& links) {
  return {links.view().begin(), links.view().end()};
}

template <std::size_t kDimension, typename Index>
void check_grid(std::size_t side, bool in_order = true) {
  auto mesh = grid_mesh<kDimension, Index>(side);
  if (!in_order) shuffle<kDimension + 1>(mesh.simplices);
  const auto expected = matched_by_dictionary(mesh.view());
  for (const unsigned threads : {1U, 2U, 5U}) {
    for (const Proposal proposal : {Proposal::kLikely, Proposal::kComplete}) {
      const auto links = matched_facets(mesh.view(), threads, proposal);
      REQUIRE(links.has_value());
      CHECK(listed(*links) == expected);
    }
    // Likely links are those of a complete proposal, and nothing needs to be matched again.
    auto links = matched_facets(mesh.view(), threads, Proposal::kLikely).value();
    CHECK(complete(mesh.view(), links, threads).empty());
    CHECK(listed(links) == expected);
  }
}

TEST_CASE("what is likely does not depend on the number of threads") {
  const auto grid = grid_mesh<3>(properties::points_a_side(32));
  MeshInArrays<3> mesh{grid.coordinates};
  for (std::size_t s = 0; s < grid.size(); ++s) {  // each twice, one after the other
    const auto row = grid.view().row(s);
    for (int time = 0; time < 2; ++time) {
      mesh.simplices.insert(mesh.simplices.end(), row.begin(), row.end());
    }
  }
  const auto links = matched_facets(mesh.view(), 1, Proposal::kLikely).value();
  for (const unsigned threads : {2U, 5U}) {
    const auto again = matched_facets(mesh.view(), threads, Proposal::kLikely).value();
    CHECK(listed(again) == listed(links));
    CHECK(again.overused == links.overused);
  }
}

TEST_CASE("likely links of simplices that are listed twice, far apart, are made complete") {
  for (const bool in_order : {true, false}) {
    auto mesh = grid_mesh<3>(properties::points_a_side(22));
    if (!in_order) shuffle<4>(mesh.simplices);
    const std::vector<std::int32_t> some(mesh.simplices.begin() + 4000,
                                         mesh.simplices.begin() + 6000);
    mesh.simplices.insert(mesh.simplices.end(), some.begin(), some.end());
    const auto expected = matched_facets(mesh.view(), 1).value();
    REQUIRE(!expected.overused.empty());
    for (const unsigned threads : {1U, 3U}) {
      auto links = matched_facets(mesh.view(), threads, Proposal::kLikely).value();
      CHECK(listed(links) != listed(expected));
      const auto again = complete(mesh.view(), links, threads);
      CHECK(std::is_sorted(again.begin(), again.end()));
      CHECK(listed(links) == listed(expected));
      CHECK(links.overused == expected.overused);
    }
  }
}

TEST_CASE("facets of grids are matched, by one thread or several") {
  for (const std::size_t side : {2, 3, 12}) {
    check_grid<2, std::int32_t>(side);
    check_grid<2, std::int64_t>(side);
    check_grid<3, std::int32_t>(side);
    check_grid<3, std::int64_t>(side);
  }
  check_grid<2, std::int32_t>(properties::points_a_side(150));  // several piles, several passes
  check_grid<3, std::int32_t>(properties::points_a_side(22));
}

TEST_CASE("facets of grids are matched where those who share them stand far apart") {
  check_grid<2, std::int32_t>(properties::points_a_side(150), false);
  check_grid<3, std::int32_t>(properties::points_a_side(22), false);
  check_grid<3, std::int64_t>(12, false);
}

TEST_CASE("a vertex of all simplices makes no pile of all facets") {
  constexpr std::int32_t kRing = 40000 / properties::kOneInputIn;
  MeshInArrays<2> fan;
  for (std::int32_t v = 1; v <= kRing; ++v) {
    fan.simplices.insert(fan.simplices.end(), {v, 0, v % kRing + 1});
  }
  fan.coordinates.assign((kRing + 1) * 2, 0);
  shuffle<3>(fan.simplices);
  for (const Proposal proposal : {Proposal::kLikely, Proposal::kComplete}) {
    const auto links = matched_facets(fan.view(), 1, proposal);
    REQUIRE(links.has_value());
    CHECK(listed(*links) == matched_by_dictionary(fan.view()));
  }
}

TEST_CASE("a facet of three simplices, and an index that names no point, are seen") {
  MeshInArrays<2> mesh;
  mesh.coordinates.assign(10, 0);
  mesh.simplices = {0, 1, 2, 1, 0, 3, 0, 4, 1};
  const auto overused = [](const auto& of, unsigned threads) {
    return matched_facets(of.view(), threads)->overused;
  };
  CHECK(overused(mesh, 1) == std::vector<std::vector<std::uint64_t>>{{2, 5, 7}});
  MeshInArrays<2> book;  // all pages at one spine
  for (std::int32_t v = 2; v < 50000; ++v) {
    book.simplices.insert(book.simplices.end(), {0, 1, v});
  }
  book.coordinates.assign(100000, 0);
  REQUIRE(overused(book, 1).size() == 1);
  CHECK(overused(book, 2)[0].size() == 49998);
  auto grid = grid_mesh<3>(properties::points_a_side(22));
  const std::vector<std::int32_t> first(grid.simplices.begin(), grid.simplices.begin() + 4);
  grid.simplices.insert(grid.simplices.end(), first.begin(), first.end());
  const auto found = overused(grid, 2);
  CHECK(!found.empty());
  CHECK(found == overused(grid, 1));
  mesh.simplices = {0, 1, 2, 1, 0, 3, 0, 4, 2};
  CHECK(listed(matched_facets(mesh.view(), 1).value()) ==
        std::vector<std::int32_t>{-1, 2, 1, -1, -1, 0, -1, 0, -1});
  for (const std::int32_t wrong : {-1, 5, 1 << 30}) {
    mesh.simplices[4] = wrong;
    CHECK(matched_facets(mesh.view(), 1).error() == Undecided::kUnknownVertex);
  }
}

// Rows of two simplices with a common facet, in every order.

template <std::size_t kVertices>
using Row = std::array<std::int32_t, kVertices>;

template <std::size_t kVertices>
Fit<std::int32_t> fit_of_rows(const Row<kVertices>& first, std::size_t apex,
                              const Row<kVertices>& second) {
  Row<kVertices> ordered{first[apex]};
  for (std::size_t i = 0; i + 1 < kVertices; ++i) {
    ordered[i + 1] = first[kFacetPlaces<kVertices>[apex][i]];
  }
  return fit_of(ordered, second);
}

// Every order of the second row, for each apex of the first.
template <std::size_t kVertices>
void check_all_orders() {
  Row<kVertices> first;
  std::iota(first.begin(), first.end(), 10);
  for (std::size_t apex = 0; apex < kVertices; ++apex) {
    Row<kVertices> places;
    std::iota(places.begin(), places.end(), 0);
    do {
      Row<kVertices> second;
      bool odd = false;
      for (std::size_t i = 0; i < kVertices; ++i) {
        second[i] = first[static_cast<std::size_t>(places[i])];
        for (std::size_t k = i + 1; k < kVertices; ++k) odd ^= places[i] > places[k];
      }
      CHECK(fit_of_rows(first, apex, second).matches == 0);  // the same simplex
      const auto own = std::find(second.begin(), second.end(), first[apex]);
      *own = 99;
      const Fit<std::int32_t> found = fit_of_rows(first, apex, second);
      CHECK(found.matches == -1);
      CHECK(found.place == own - second.begin());
      CHECK(found.apex == 99);
      CHECK(found.odd == (odd ? -1 : 0));
      for (std::int32_t& v : second) {
        if (v == 99) continue;
        const std::int32_t right = v;
        for (const std::int32_t wrong : {98, 99, first[apex], first[(apex + 1) % kVertices]}) {
          v = wrong;
          if (wrong != right) CHECK(fit_of_rows(first, apex, second).matches == 0);
        }
        v = right;
      }
    } while (std::next_permutation(places.begin(), places.end()));
  }
}

TEST_CASE("a facet is recognized in any order, with the sign of the permutation") {
  check_all_orders<3>();
  check_all_orders<4>();
}

}  // namespace

}  // namespace circumspect::fast
