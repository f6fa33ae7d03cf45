// Orders of insertion, and the space-filling curves behind them.
#include "reference/delaunay/insertion_order.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <doctest/doctest.h>

#include "kernel/exact/interruption.hpp"
#include "properties/arguments/laws.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect::delaunay {

namespace {

// All cells of the grid {0, …, 2^bits − 1}^k.
std::vector<GridCell> all_cells(std::size_t k, int bits) {
  std::vector<GridCell> cells = {{}};
  for (std::size_t axis = 0; axis < k; ++axis) {
    std::vector<GridCell> longer;
    for (const GridCell& cell : cells) {
      for (std::uint64_t x = 0; x < std::uint64_t{1} << bits; ++x) {
        longer.push_back(cell);
        longer.back().push_back(x);
      }
    }
    cells = longer;
  }
  return cells;
}

TEST_CASE("z-order curve: it goes through the corners of each square in the shape of a Z") {
  std::vector<GridCell> cells = {{1, 1}, {1, 0}, {2, 0}, {0, 1}, {0, 0}, {0, 2}};
  std::sort(cells.begin(), cells.end(), precedes_on_z_order_curve);
  CHECK(cells == std::vector<GridCell>{{0, 0}, {0, 1}, {1, 0}, {1, 1}, {0, 2}, {2, 0}});
}

TEST_CASE("Hilbert curve: in the grid of two by two it goes around") {
  std::vector<GridCell> cells = all_cells(2, 1);
  std::sort(cells.begin(), cells.end(), [](const GridCell& a, const GridCell& b) {
    return precedes_on_z_order_curve(from_hilbert_to_z_order(a, 1), from_hilbert_to_z_order(b, 1));
  });
  CHECK(cells == std::vector<GridCell>{{0, 0}, {0, 1}, {1, 1}, {1, 0}});
}

TEST_CASE("Hilbert curve: it visits every cell once, and consecutive cells share a facet") {
  for (const auto& grid : {std::pair(1U, 6), {2U, 1}, {2U, 4}, {3U, 3}, {4U, 2}, {5U, 2}}) {
    const unsigned k = grid.first;
    const int bits = grid.second;
    CAPTURE(k);
    CAPTURE(bits);
    std::vector<std::pair<GridCell, GridCell>> cells;  // place on the z-order curve, cell
    std::set<GridCell> places;
    for (const GridCell& cell : all_cells(k, bits)) {
      cells.emplace_back(from_hilbert_to_z_order(cell, bits), cell);
      places.insert(cells.back().first);
    }
    CHECK(places.size() == cells.size());
    std::sort(cells.begin(), cells.end(), [](const auto& a, const auto& b) {
      return precedes_on_z_order_curve(a.first, b.first);
    });
    std::size_t leaps = 0;
    for (std::size_t i = 1; i < cells.size(); ++i) {
      std::uint64_t distance = 0;
      for (std::size_t axis = 0; axis < k; ++axis) {
        const std::uint64_t a = cells[i - 1].second[axis];
        const std::uint64_t b = cells[i].second[axis];
        distance += a < b ? b - a : a - b;
      }
      if (distance != 1) ++leaps;
    }
    CHECK(leaps == 0);
  }
}

TEST_CASE("space-filling curve: it is followed from point to point, however uneven the axes are") {
  const PointSet points({{Rational(1, 3), 1000}, {-7, 5}, {Rational(1, 3), 5}, {-7, 1000}});
  CHECK(along_curve(points, {0, 1, 2, 3}, SpaceFillingCurve::kHilbert) ==
        std::vector<Vertex>{1, 3, 0, 2});
  CHECK(along_curve(points, {0, 1, 2, 3}, SpaceFillingCurve::kZOrder) ==
        std::vector<Vertex>{1, 3, 2, 0});
  CHECK(along_curve(points, {3, 0}, SpaceFillingCurve::kZOrder) == std::vector<Vertex>{3, 0});
  CHECK(along_curve(points, {}, SpaceFillingCurve::kHilbert).empty());
}

TEST_CASE("space-filling curve: a permutation that does not depend on the order given") {
  for (const std::size_t d : {1U, 2U, 3U, 4U}) {
    CHECK(properties::holds("dimension " + std::to_string(d), [d] {
      const PointSet points((*generators::unweighted(generators::any_point_set(d, 20))).points);
      const std::vector<Vertex> all = generators::first_vertices(points.size());
      for (const auto curve : {SpaceFillingCurve::kHilbert, SpaceFillingCurve::kZOrder}) {
        const std::vector<Vertex> sequence = along_curve(points, all, curve);
        RC_ASSERT(sorted(sequence) == all);
        RC_ASSERT(along_curve(points, generators::shuffled(all), curve) == sequence);
      }
    }));
  }
}

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

TEST_CASE("points that are converted and sorted ask often whether anybody waits for them") {
  std::vector<Point> all;
  for (int i = 0; i < 100; ++i) all.push_back({Rational(i * 37 % 100) / 3, Rational(i)});
  const PointSet points(all);
  std::vector<Vertex> vertices(all.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) vertices[i] = static_cast<Vertex>(i);
  const Interruption past{nullptr, std::chrono::steady_clock::now() - std::chrono::hours(1)};
  const Interruptible interruptible(&past);
  CHECK_THROWS_AS(Configuration(all, {}), Interrupted);
  CHECK_THROWS_AS(duplicates(all), Interrupted);
  CHECK_THROWS_AS(along_curve(points, vertices, SpaceFillingCurve::kHilbert), Interrupted);
}

}  // namespace circumspect::delaunay
