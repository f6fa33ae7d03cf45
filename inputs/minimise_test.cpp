#include "inputs/minimise.hpp"

#include <algorithm>
#include <atomic>

#include <doctest/doctest.h>

#include "inputs/named_complexes.hpp"
#include "kernel/piecewise_linear/validity.hpp"

namespace circumspect::generators {
namespace {

PointsCase scattered(int count) {
  PointsCase set;
  for (int i = 0; i < count; ++i) {
    set.points.push_back({Rational(i * 7919 % 1009) / 8, Rational(i * 104729 % 2003) / 16,
                          Rational(-i * 31 % 977) / 4});
  }
  return set;
}

TEST_CASE("three points that fail together are all that is left of a thousand") {
  const PointsCase set = scattered(1000);
  const std::vector<Point> needed = {set.points[17], set.points[500], set.points[983]};
  std::size_t asked = 0;
  const PointsCase small = minimised(set, [&](const PointsCase& candidate) {
    ++asked;
    return std::all_of(needed.begin(), needed.end(), [&](const Point& point) {
      return std::count(candidate.points.begin(), candidate.points.end(), point) == 1;
    });
  });
  CHECK(small.points == needed);
  CHECK(asked < 1000);
}

TEST_CASE("it ends where it is stopped, with the smallest input so far") {
  const PointsCase set = scattered(1000);
  std::atomic<bool> stop = false;
  std::size_t asked = 0;
  const auto still_fails = [&](const PointsCase& candidate) {
    stop = ++asked == 3;
    return candidate.points.size() >= 100;
  };
  const PointsCase small = minimised(set, still_fails, {.stop = &stop});
  CHECK(asked == 3);
  CHECK(small.points.size() < set.points.size());
}

TEST_CASE("coordinates become small integers where they may") {
  PointsCase set = scattered(20);
  set.weights.assign(20, Rational(5) / 8);
  const PointsCase small =
      minimised(set, [](const PointsCase& candidate) { return candidate.points.size() >= 4; });
  CHECK(small.points.size() == 4);
  for (const Point& point : small.points) {
    for (const Rational& x : point) CHECK((x == 0 || x == 1 || x == -1 || x == 2));
  }
  CHECK(std::count(small.weights.begin(), small.weights.end(), Rational(0)) == 4);
  // Points stay distinct, because the set had no equal ones.
  CHECK(small.points[0] != small.points[1]);
}

TEST_CASE("what matters about a coordinate stays") {
  PointsCase set;
  const Rational tiny = Rational(1) / (Integer(1) << 80);
  set.points = {{Rational(1) / 3, 7}, {12 + tiny, 1000}};
  const PointsCase small = minimised(set, [](const PointsCase& candidate) {
    return std::any_of(candidate.points.begin(), candidate.points.end(),
                       [](const Point& point) { return point[0] > 12 && point[0] < 13; });
  });
  REQUIRE(small.points.size() == 1);
  CHECK(small.points[0][0] == Rational(25) / 2);
  CHECK(small.points[0][1] == 0);
}

TEST_CASE("limits end it with what was reached") {
  std::size_t asked = 0;
  const PointsCase small = minimised(scattered(100),
                                     [&](const PointsCase& candidate) {
                                       ++asked;
                                       return candidate.points.size() >= 2;
                                     },
                                     {10, std::chrono::seconds(100)});
  CHECK(asked == 10);
  CHECK(small.points.size() < 100);
}

TEST_CASE("a domain loses cells, vertices and digits, and stays valid") {
  ComplexCase whole{"boxes", both(box(0, 4), box(1, 3))};
  whole.input.points.push_back({Rational(1) / 2, Rational(7) / 2, Rational(1) / 2});
  whole.input.segments.push_back({0, 16});
  whole.input.hole_seeds.push_back({2, 2, 2});
  std::size_t asked = 0;
  const ComplexCase small = minimised(whole, [&](const ComplexCase& candidate) {
    ++asked;
    CHECK(validated(candidate.input));
    return !candidate.input.segments.empty() && candidate.input.polygons.size() >= 2;
  });
  CHECK(asked > 0);
  CHECK(small.input.polygons.size() == 2);
  CHECK(small.input.segments.size() == 1);
  CHECK(small.input.hole_seeds.empty());
  CHECK(small.input.points.size() <= 10);
}

}  // namespace
}  // namespace circumspect::generators
