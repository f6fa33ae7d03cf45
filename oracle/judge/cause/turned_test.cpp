// What is turned over against its neighbours, where points come in another order.
#include <algorithm>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "inputs/dice.hpp"
#include "oracle/judge/cause/bare_facets.hpp"
#include "oracle/judge/cause/planted_faults_test.hpp"

namespace circumspect::check {
namespace {

using generators::Dice;

// Points are exchanged in a mesh whose simplices all have one sign: what is said is counted anew.
// Some are flat then. Neither the order of simplices nor that of their vertices changes it.
template <std::size_t kDimension>
bool check_turned_over(std::uint64_t seed, std::size_t side) {
  CAPTURE(seed);
  Dice dice(seed);
  Lists lists = grid<kDimension>(side);
  for (Simplex& simplex : lists.simplices) {
    if (orientation_in(in_arrays(lists), simplex) < 0) std::swap(simplex[0], simplex[1]);
  }
  for (std::size_t times = dice.below(lists.points.size()); times > 0; --times) {
    std::swap(lists.points[dice.below(lists.points.size())],
              lists.points[dice.below(lists.points.size())]);
  }
  std::size_t of_sign[3] = {};
  for (const Simplex& simplex : lists.simplices) {
    ++of_sign[orientation_in(in_arrays(lists), simplex) + 1];
  }
  for (Simplex& simplex : lists.simplices) {
    std::swap(simplex, lists.simplices[dice.below(lists.simplices.size())]);
    std::swap(simplex[0], simplex[dice.below(simplex.size())]);
    std::swap(simplex[1], simplex[dice.below(simplex.size())]);
  }
  const auto verdict = judge(Claim::kComplex, in_arrays(lists), nullptr, {});
  const std::vector<Cause> found = causes_of(lists, Claim::kComplex);
  if (found.empty() || found.front().name != "points-of-another-mesh") return false;
  const std::size_t fewer = std::min(of_sign[0], of_sign[2]);
  CHECK(found.front().words ==
        "the points seem to be those of another mesh, or in another order: " +
            std::to_string(fewer) + " of " + std::to_string(of_sign[0] + of_sign[2]) + " " +
            (kDimension == 2 ? "triangles" : "tetrahedra") +
            " are turned over against their neighbours");
  const auto count = [&](Rule rule) {
    const auto tally = verdict->tallies().find(rule);
    return tally == verdict->tallies().end() ? 0 : tally->second.count;
  };
  CHECK(found.front().explains ==
        count(Rule::kOverlap) + count(Rule::kDegenerateSimplex) + count(Rule::kFacesCross));
  return true;
}

TEST_CASE("causes: of points in another order it is counted what they turn over") {
  std::size_t told = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    told += check_turned_over<2>(seed, 5) ? 1 : 0;
    told += check_turned_over<3>(seed, 3) ? 1 : 0;
  }
  CHECK(told > 12);
}

TEST_CASE("causes: what has one side only, like a Möbius strip, turns over against nothing") {
  for (const bool is_twisted : {false, true}) {
    std::size_t told = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      Dice dice(seed);
      constexpr Vertex kLength = 20;
      Lists strip;
      const auto vertex = [&](Vertex along, Vertex across) {
        const bool is_over = along == kLength;
        return 2 * (along % kLength) + (is_over && is_twisted ? 1 - across : across);
      };
      for (Vertex i = 0; i < kLength; ++i) {
        for (int side = 0; side < 2; ++side) {
          strip.points.push_back({dice.within(-50L, 50L), dice.within(-50L, 50L)});
        }
        strip.simplices.push_back({vertex(i, 0), vertex(i, 1), vertex(i + 1, 0)});
        strip.simplices.push_back({vertex(i, 1), vertex(i + 1, 1), vertex(i + 1, 0)});
      }
      if (!judge(Claim::kComplex, in_arrays(strip), nullptr, {})) continue;  // equal points
      told += named(strip, Claim::kComplex).starts_with("points-of-another-mesh") ? 1 : 0;
    }
    CHECK((told > 10) == !is_twisted);
    if (is_twisted) CHECK(told == 0);
  }
}

}  // namespace
}  // namespace circumspect::check
