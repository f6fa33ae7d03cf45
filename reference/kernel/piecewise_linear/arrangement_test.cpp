#include "reference/kernel/piecewise_linear/arrangement.hpp"

#include <doctest/doctest.h>

#include "reference/kernel/piecewise_linear/validity.hpp"

namespace circumspect {
namespace {

using Pairs = std::vector<std::vector<Vertex>>;

PiecewiseLinearInput of(std::vector<Point> points, Pairs segments) {
  PiecewiseLinearInput input;
  input.points = std::move(points);
  input.segments = std::move(segments);
  input.kind = DomainKind::kHull;
  return input;
}

// The arrangement, which is valid whatever goes in, and its own arrangement.
PiecewiseLinearInput valid_arrangement(const PiecewiseLinearInput& input) {
  const PiecewiseLinearInput result = arranged(input);
  CHECK(validated(result, 1));
  const PiecewiseLinearInput again = arranged(result);
  CHECK(again.points == result.points);
  CHECK(again.segments == result.segments);
  return result;
}

TEST_CASE("segments that cross are cut where they do, exactly") {
  const auto result = valid_arrangement(of({{0, 0}, {3, 1}, {0, 1}, {3, 0}}, {{0, 1}, {2, 3}}));
  CHECK(result.points.size() == 5);
  CHECK(result.points[4] == Point{Rational(3, 2), Rational(1, 2)});
  CHECK(result.segments == Pairs{{0, 4}, {1, 4}, {2, 4}, {3, 4}});
  const auto thirds = valid_arrangement(of({{0, 0}, {2, 2}, {0, 1}, {2, 0}}, {{0, 1}, {2, 3}}));
  CHECK(thirds.points[4] == Point{Rational(2, 3), Rational(2, 3)});
}

TEST_CASE("a vertex on a segment cuts it, whether a segment ends there or not") {
  const auto alone = valid_arrangement(of({{0, 0}, {4, 0}, {1, 0}}, {{1, 0}}));
  CHECK(alone.segments == Pairs{{0, 2}, {1, 2}});
  const auto ends = valid_arrangement(of({{0, 0}, {4, 0}, {1, 0}, {1, 5}}, {{0, 1}, {2, 3}}));
  CHECK(ends.segments == Pairs{{0, 2}, {1, 2}, {2, 3}});
  // Beside it, or on its line beyond its end, it cuts nothing.
  CHECK(valid_arrangement(of({{0, 0}, {4, 0}, {1, 1}, {5, 0}}, {{0, 1}})).segments ==
        Pairs{{0, 1}});
}

TEST_CASE("what overlaps is there once, and equal vertices are one") {
  const auto overlap =
      valid_arrangement(of({{0, 0}, {4, 0}, {2, 0}, {6, 0}}, {{0, 1}, {3, 2}, {1, 0}}));
  CHECK(overlap.segments == Pairs{{0, 2}, {1, 2}, {1, 3}});
  const auto equal = valid_arrangement(
      of({{0, 0}, {1, 0}, {0, 0}, {1, 1}, {1, 0}}, {{0, 1}, {2, 3}, {0, 2}, {4, 2}}));
  CHECK(equal.points == std::vector<Point>{{0, 0}, {1, 0}, {1, 1}});
  CHECK(equal.segments == Pairs{{0, 1}, {0, 2}});
}

TEST_CASE("three segments through one point have one vertex there") {
  const auto star = valid_arrangement(
      of({{-1, 0}, {1, 0}, {0, -1}, {0, 1}, {-1, -1}, {1, 1}}, {{0, 1}, {2, 3}, {4, 5}}));
  CHECK(star.points.size() == 7);
  CHECK(star.segments.size() == 6);
}

TEST_CASE("segments that are parallel or do not reach each other share nothing") {
  const auto apart = valid_arrangement(
      of({{0, 0}, {1, 0}, {0, 1}, {1, 1}, {5, -1}, {5, 7}}, {{0, 1}, {2, 3}, {4, 5}}));
  CHECK(apart.points.size() == 6);
  CHECK(apart.segments.size() == 3);
}

}  // namespace
}  // namespace circumspect
