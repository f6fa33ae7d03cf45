// For every width of vectors that this machine has, the loops over lanes compute, to the last bit,
// what filter.hpp computes for one simplex: law F5 of predicates.hpp holds for them.
#include "oracle/judge/fast/block.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "oracle/judge/fast/facet_records.hpp"
#include "oracle/judge/fast/predicates/exact_sign.hpp"
#include "oracle/judge/fast/predicates/filter.hpp"
#include "oracle/judge/fast/predicates/tuples_test.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect::fast {
namespace {

std::vector<double> entries(const SimplexFilter<2>& filter) {
  const auto& c = filter.cofactors;
  return {c.xy, c.xw, c.yw, filter.scale.x, filter.scale.y, filter.scale.weight};
}
std::vector<double> entries(const SimplexFilter<3>& filter) {
  const auto& c = filter.cofactors;
  const Scale3& s = filter.scale;
  return {c.xyz, c.xyw, c.xzw, c.yzw, s.x, s.y, s.z, s.weight};
}

bool are_same(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) ||
         std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

template <bool kWeighted>
SimplexFilter<2> filter_of(const SiteRow<2>& row) {
  return simplex_filter<kWeighted>(row[0], row[1], row[2]);
}
template <bool kWeighted>
SimplexFilter<3> filter_of(const SiteRow<3>& row) {
  return simplex_filter<kWeighted>(row[0], row[1], row[2], row[3]);
}

template <std::size_t kDimension>
bool boxes_touch(const SiteRow<kDimension>& row, const SimplexBlock<kDimension>& block) {
  bool touch = true;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    const auto [low, high] = std::minmax_element(
        row.begin(), row.end(),
        [axis](const auto& a, const auto& b) { return a.at[axis] < b.at[axis]; });
    touch &= low->at[axis] <= block.high[axis] && high->at[axis] >= block.low[axis];
  }
  return touch;
}

template <bool kWeighted, std::size_t kDimension>
void hold_lane(const SimplexBlock<kDimension>& block, std::size_t lane, Lattice lattice) {
  CAPTURE(lane);
  const SiteRow<kDimension> row = block.row(lane);
  const SimplexFilter<kDimension> filter = filter_of<kWeighted>(row);
  const std::vector<double> expected = entries(filter);
  for (std::size_t i = 0; i <= kDimension; ++i) {
    REQUIRE(are_same(block.cofactors[i][lane], expected[i]));
    REQUIRE(are_same(block.scales[i][lane], expected[kDimension + 1 + i]));
  }
  REQUIRE(block.orientation[lane] == filtered_orientation<int>(filter, lattice));
  REQUIRE(block.apart[lane] == (boxes_touch(row, block) ? 0 : 1));
  for (std::size_t place = 0; place <= kDimension; ++place) {
    const Site<kDimension> query = block.apexes[place].site(lane);
    REQUIRE(block.inside[place][lane] ==
            filtered_ball<kWeighted, int>(filter, row[kDimension], query, lattice));
  }
}

template <std::size_t kDimension>
void set(SiteLanes<kDimension>& sites, std::size_t lane, const Site<kDimension>& site) {
  for (std::size_t axis = 0; axis < kDimension; ++axis) sites.at[axis][lane] = site.at[axis];
  sites.weight[lane] = site.weight;
}

template <std::size_t kDimension>
void hold_blocks(const BlockKernels<kDimension>& kernels, int kind) {
  Tuples tuples(static_cast<std::uint64_t>(kind));
  const auto block = std::make_unique<SimplexBlock<kDimension>>();
  for (int i = 0; i < 100 / properties::kOneInputIn; ++i) {
    for (std::size_t lane = 0; lane < kBlock; ++lane) {
      const auto sites = tuples.draw<kDimension, 2 * kDimension + 2>(static_cast<Kind>(kind));
      for (std::size_t place = 0; place <= kDimension; ++place) {
        set(block->vertices[place], lane, sites[place]);
        set(block->apexes[place], lane, sites[kDimension + 1 + place]);
      }
      if (lane == 0) {
        block->low = sites[0].at;
        block->high = sites[1].at;
      }
    }
    const Lattice lattice{i % 3 == 0 ? 0 : i % 3 == 1 ? 1 : 0x1p-30};
    kernels.simplices(*block, false, lattice);
    kernels.balls(*block, false, lattice);
    for (std::size_t lane = 0; lane < kBlock; ++lane) hold_lane<false>(*block, lane, lattice);
    kernels.simplices(*block, true, lattice);
    kernels.balls(*block, true, lattice);
    for (std::size_t lane = 0; lane < kBlock; ++lane) hold_lane<true>(*block, lane, lattice);
  }
}

template <std::size_t kDimension>
void hold_all_blocks() {
  REQUIRE_FALSE(block_kernels<kDimension>().empty());
  for (const BlockKernels<kDimension>& kernels : block_kernels<kDimension>()) {
    CAPTURE(std::string(kernels.name));
    for (int kind = 0; kind <= static_cast<int>(Kind::kLast); ++kind) {
      CAPTURE(kind);
      hold_blocks(kernels, kind);
    }
  }
}

TEST_CASE(
    "F5: lanes hold the values of the filter for one simplex, to the "
    "last bit") {
  hold_all_blocks<2>();
  hold_all_blocks<3>();
}

TEST_CASE("a block is as expected iff all lanes are") {
  for (const BlockKernels<3>& kernels : block_kernels<3>()) {
    CAPTURE(std::string(kernels.name));
    const auto block = std::make_unique<SimplexBlock<3>>();
    const SiteRow<3> row = {{{{0, 0, 0}}, {{0, 1, 0}}, {{1, 0, 0}}, {{0, 0, 1}}}};
    const Site<3> q{{0.5, 0.5, 0.5}};
    Stages stages;
    const int own = exact_orientation(row, stages);
    for (std::size_t lane = 0; lane < kBlock; ++lane) {
      for (std::size_t i = 0; i < 4; ++i) set(block->vertices[i], lane, row[i]);
      block->own[lane] = own;
    }
    const auto is_as_expected = [&] {
      kernels.simplices(*block, false, {});
      return block->as_expected;
    };
    block->low = block->high = {2, 0, 0};
    CHECK(is_as_expected());
    block->own[31] = -own;
    CHECK_FALSE(is_as_expected());
    block->own[31] = own;
    block->low = block->high = q.at;
    CHECK_FALSE(is_as_expected());  // all boxes touch it
    block->low = block->high = {2, 0, 0};
    for (std::size_t i = 0; i < 4; ++i) block->vertices[i].at[0][7] += 1.5;
    CHECK_FALSE(is_as_expected());  // one does
  }
}

// Rows with and without a common facet, as lanes and one by one.
template <std::size_t kVertices, typename Index, typename Fits>
void hold_fits(const Fits& fits) {
  std::mt19937_64 random(kVertices);
  const auto block = std::make_unique<RowBlock<kVertices, Index>>();
  int matches = 0;
  for (int turn = 0; turn < 100; ++turn) {
    for (std::size_t lane = 0; lane < kBlock; ++lane) {
      std::array<Index, kVertices> row;
      for (std::size_t i = 0; i < kVertices; ++i) {
        row[i] = static_cast<Index>(10 * i + random() % 5);
        block->rows[i][lane] = row[i];
      }
      for (std::size_t place = 0; place < kVertices; ++place) {
        auto other = row;
        other[place] = static_cast<Index>(random() % 45);
        if (random() % 8 == 0) other[random() % kVertices] = row[random() % kVertices];
        std::shuffle(other.begin(), other.end(), random);
        for (std::size_t i = 0; i < kVertices; ++i) block->beyond[place][i][lane] = other[i];
      }
    }
    fits(*block);
    for (std::size_t place = 0; place < kVertices; ++place) {
      for (std::size_t lane = 0; lane < kBlock; ++lane) {
        std::array<Index, kVertices> first, second;
        first[0] = block->rows[place][lane];
        for (std::size_t i = 0; i + 1 < kVertices; ++i) {
          first[i + 1] = block->rows[kFacetPlaces<kVertices>[place][i]][lane];
        }
        for (std::size_t i = 0; i < kVertices; ++i) second[i] = block->beyond[place][i][lane];
        const Fit<Index> fit = fit_of(first, second);
        const Index found = block->fits[place][lane];
        REQUIRE((found >= 0) == (fit.matches != 0));
        if (fit.matches == 0) continue;
        ++matches;
        REQUIRE(found == fit.place + (fit.odd != 0 ? RowBlock<kVertices, Index>::kOdd : 0));
        REQUIRE(block->apex[place][lane] == fit.apex);
      }
    }
  }
  CHECK(matches > 1000);
}

TEST_CASE("facets across fit in lanes as they do one by one") {
  for (const BlockKernels<2>& kernels : block_kernels<2>()) {
    CAPTURE(std::string(kernels.name));
    hold_fits<3, std::int32_t>([&](auto& block) { kernels.fit(block); });
    hold_fits<3, std::int64_t>([&](auto& block) { kernels.fit(block); });
  }
  for (const BlockKernels<3>& kernels : block_kernels<3>()) {
    CAPTURE(std::string(kernels.name));
    hold_fits<4, std::int32_t>([&](auto& block) { kernels.fit(block); });
    hold_fits<4, std::int64_t>([&](auto& block) { kernels.fit(block); });
  }
}

}  // namespace
}  // namespace circumspect::fast
