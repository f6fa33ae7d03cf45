#include "oracle/judge/fast/row_predicates.hpp"

#include <random>

#include <doctest/doctest.h>

#include "oracle/judge/fast/reference_signs_test.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect::fast {
namespace {

template <std::size_t kDimension>
using Tuple = std::array<Site<kDimension>, kDimension + 2>;

// Different points of a grid with `side` points along each axis.
template <std::size_t kDimension>
Tuple<kDimension> grid_tuple(std::mt19937_64& random, std::size_t side) {
  while (true) {
    Tuple<kDimension> sites{};
    bool are_different = true;
    for (std::size_t i = 0; i < sites.size(); ++i) {
      for (double& x : sites[i].at) x = static_cast<double>(random() % side);
      for (std::size_t k = 0; k < i; ++k) are_different &= sites[i].at != sites[k].at;
    }
    if (are_different) return sites;
  }
}

template <std::size_t kDimension>
void hold_zeros() {
  std::mt19937_64 random(kDimension);
  Vertices all;
  for (std::size_t i = 0; i < kDimension + 2; ++i) all.push_back(static_cast<std::ptrdiff_t>(i));
  int zeros = 0, crossings = 0;
  for (int i = 0; i < 20000 / properties::kOneInputIn; ++i) {
    CAPTURE(i);
    const Tuple<kDimension> sites = grid_tuple<kDimension>(random, 3);
    SiteRow<kDimension> row;
    for (std::size_t k = 0; k <= kDimension; ++k) row[k] = sites[k];
    const Site<kDimension>& query = sites.back();
    Stages stages;
    const int own = orientation<kDimension>(row, stages);
    if (own == 0 || ball_of<kDimension, false>(row).contains(query, stages) != 0) continue;
    ++zeros;
    const int expected = reference_signs(sites, false).perturbed_ball(all);
    REQUIRE(perturbed_sign_of_zero<kDimension>(row, own, query, stages) == expected);
    REQUIRE(perturbed_sign_of_zero<kDimension>(row, own, query, stages, {1}) == expected);
    for (std::size_t place = 0; place <= kDimension; ++place) {
      if (orientation_with<kDimension>(row, place, query, stages) * own >= 0) continue;
      ++crossings;
      REQUIRE(perturbed_sign_of_zero<kDimension>(row, own, query, stages, {1}, place) == expected);
    }
  }
  CHECK(zeros > 100 / properties::kOneInputIn);
  CHECK(crossings >= zeros);  // each query is outside
}

TEST_CASE(
    "zeros are perturbed as the reference perturbs them, beyond a known "
    "facet or not") {
  hold_zeros<2>();
  hold_zeros<3>();
}

}  // namespace
}  // namespace circumspect::fast
