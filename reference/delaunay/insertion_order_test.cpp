// Insertion orders: permutations, the rounds of a BRIO. Book: Sections 5.3 and 5.5.
#include "reference/delaunay/insertion_order.hpp"

#include <algorithm>
#include <map>

#include <doctest/doctest.h>

#include "properties/generators/laws.hpp"

namespace circumspect::delaunay {
namespace {

constexpr auto kOrders = {InsertionOrder::kAsGiven, InsertionOrder::kRandom,
                          InsertionOrder::kBrioHilbert, InsertionOrder::kBrioZOrder};

PointSet line(std::size_t count) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i) points.push_back({Rational(Integer(i))});
  return PointSet(points);
}

TEST_CASE("insertion order: every order has every vertex once, and the same for the same seed") {
  for (const std::size_t count : {0U, 1U, 2U, 3U, 17U, 64U}) {
    const PointSet points = line(count);
    for (const InsertionOrder order : kOrders) {
      const std::vector<Vertex> sequence = insertion_order(points, order, 5);
      CHECK(sorted(sequence) == generators::first_vertices(count));
      CHECK(sequence == insertion_order(points, order, 5));
    }
    CHECK(insertion_order(points, InsertionOrder::kAsGiven, 5) ==
          generators::first_vertices(count));
  }
}

TEST_CASE("insertion order: a seed means the same permutation on every machine") {
  CHECK(random_permutation(8, 1) != random_permutation(8, 2));
  CHECK(random_permutation(8, 2026) == std::vector<Vertex>{4, 7, 0, 6, 1, 3, 2, 5});
}

// χ² with 23 degrees of freedom exceeds 49.7 with probability 0.001.
TEST_CASE("insertion order: all permutations are equally likely") {
  std::map<std::vector<Vertex>, int> counts;
  const int trials = 24000;
  for (int seed = 0; seed < trials; ++seed) {
    ++counts[random_permutation(4, static_cast<std::uint64_t>(seed))];
  }
  REQUIRE(counts.size() == 24);
  int squares = 0;
  for (const auto& [permutation, count] : counts) squares += (count - 1000) * (count - 1000);
  CHECK(squares < 49700);
}

TEST_CASE("BRIO: rounds zero through the logarithm of n, rounded up") {
  CHECK(brio_rounds(0, 1).empty());
  for (const auto& [count, rounds] :
       {std::pair(1U, 1U), {2U, 2U}, {3U, 3U}, {4U, 3U}, {5U, 4U}, {1024U, 11U}, {1025U, 12U}}) {
    CHECK(brio_rounds(count, 1).size() == rounds);
  }
}

// Half of the vertices in the last round, a quarter in the one before it, …; the final two equally.
TEST_CASE("BRIO: each round takes half of what is left by those after it") {
  const std::size_t count = 1U << 16;
  const auto rounds = brio_rounds(count, 3);
  REQUIRE(rounds.size() == 17);
  std::size_t total = 0;
  for (const auto& round : rounds) {
    CHECK(std::is_sorted(round.begin(), round.end()));
    total += round.size();
  }
  CHECK(total == count);
  for (std::size_t i = 1; i <= 6; ++i) {
    const std::size_t expected = count >> i;  // in the i-th round from the end
    const std::size_t size = rounds[17 - i].size();
    // Within five standard deviations of a binomial distribution.
    const std::size_t difference = size < expected ? expected - size : size - expected;
    CHECK(difference * difference <= 25 * expected);
  }
  // Round zero is empty or nearly so: one vertex is expected in it.
  CHECK(rounds[0].size() <= 6);
}

TEST_CASE("BRIO: rounds follow the curve forwards when odd, backwards when even") {
  const PointSet points = line(300);
  const auto rounds = brio_rounds(300, 9);
  std::vector<Vertex> expected;
  for (std::size_t i = 0; i < rounds.size(); ++i) {
    std::vector<Vertex> round = rounds[i];  // on a line any curve is the line
    if (i % 2 == 0) std::reverse(round.begin(), round.end());
    expected.insert(expected.end(), round.begin(), round.end());
  }
  CHECK(insertion_order(points, InsertionOrder::kBrioHilbert, 9) == expected);
  CHECK(insertion_order(points, InsertionOrder::kBrioZOrder, 9) == expected);
}

}  // namespace
}  // namespace circumspect::delaunay
