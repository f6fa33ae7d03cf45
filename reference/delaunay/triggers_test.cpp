// The analysis of random insertion by triggers and stoppers. Book: Section 5.4.
#include "reference/delaunay/triggers.hpp"

#include <doctest/doctest.h>

#include "reference/delaunay/dictionary.hpp"
#include "reference/delaunay/lifted_hull.hpp"

namespace circumspect::delaunay {
namespace {

// Triggers, stoppers, and the probabilities of Section 5.4.

TEST_CASE("stoppers: the points in the open circumball; on it, as the perturbation decides") {
  // The circle through the first three has centre (2, 2). (4, 4) is on it, and (0, 0) has the
  // largest perturbation, so that the square is cut at (0, 0).
  const PointSet points({{0, 0}, {4, 0}, {0, 4}, {1, 1}, {4, 4}, {3, 3}, {9, 9}});
  CHECK(stoppers(points, {0, 1, 2}) == Simplex{3, 4, 5});
  CHECK(stoppers(points, {2, 0, 1}) == Simplex{3, 4, 5});
  CHECK(stoppers(points, {0, 1, 4}) == Simplex{3, 5});
}

TEST_CASE("j-simplices: of points on a line, by how many lie between") {
  const PointSet points({{0}, {1}, {2}, {5}, {9}});
  CHECK(numbers_of_j_simplices(points) == std::vector<std::uint64_t>{4, 3, 2, 1});
}

TEST_CASE("j-simplices: 0-simplices are the Delaunay triangulation, flat subsets are none") {
  std::vector<Point> grid;
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 3; ++y) grid.push_back({x, y});
  }
  const PointSet points(grid);
  const auto numbers = numbers_of_j_simplices(points);
  CHECK(numbers.front() == by_definition(points).simplices().size());
  std::uint64_t total = 0;
  for (const std::uint64_t f : numbers) total += f;
  CHECK(total == 84 - 8);  // three rows, three columns, two diagonals
  CHECK(numbers_of_j_simplices(PointSet({})).empty());
}

TEST_CASE("probabilities: Proposition 5.2 below 4!/j^4, Proposition 5.3 as the book states it") {
  CHECK(binomial(7, 4) == 35);
  CHECK(binomial(3, 4) == 0);
  CHECK(binomial(0, 0) == 1);
  CHECK(probability_in_random_order(3, 0) == 1);
  CHECK(probability_in_random_order(3, 1) == Rational(1, 5));
  CHECK(probability_in_random_order(3, 3) == Rational(1, 35));
  for (std::uint64_t j = 1; j < 100; ++j) {
    CHECK(probability_in_random_order(3, j) < Rational(24, Integer(j * j * j * j)));
  }
  CHECK(bound_in_brio(3, 0) == 1);
  CHECK(bound_in_brio(3, 4) == 1);
  CHECK(bound_in_brio(3, 5) == Rational(77, 125));
  CHECK(bound_in_brio(3, 10) == Rational(77, 2000));
  CHECK(bound_in_brio(2, 5) == Rational(49, 125));
}

TEST_CASE("Theorem 5.4: expected numbers of simplices and conflicts, for points on a line") {
  const Expectation sum = expectation(1, {4, 3, 2, 1}, probability_in_random_order);
  CHECK(sum.simplices == 4 + 1 + Rational(1, 3) + Rational(1, 10));
  CHECK(sum.conflicts == 1 + Rational(2, 3) + Rational(3, 10));
}

}  // namespace
}  // namespace circumspect::delaunay
