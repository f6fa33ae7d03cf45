// Breaches in the plane, beside what is legal there.
#include <doctest/doctest.h>

#include "reference/piecewise_linear/validity.hpp"

namespace circumspect {
namespace {

PiecewiseLinearInput plane(const std::vector<Point>& points, const std::vector<Simplex>& segments,
                           const std::vector<Point>& seeds = {}) {
  PiecewiseLinearInput input;
  input.points = points;
  input.segments = segments;
  input.hole_seeds = seeds;
  return input;
}
std::vector<Breach> breaches(const PiecewiseLinearInput& input) {
  const auto complex = validated(input);
  return complex ? std::vector<Breach>() : complex.error();
}

const std::vector<Point> kSquare = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
const std::vector<Simplex> kSides = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};

TEST_CASE("validated in the plane: legal inputs") {
  CHECK(breaches(plane(kSquare, kSides)).empty());
  CHECK(breaches(plane(kSquare, {{0, 2}, {2, 0}, {0, 2}})).empty());
  // An isolated vertex, and a seed right there and outside: none is on a segment.
  std::vector<Point> points = kSquare;
  points.push_back({1, 2});
  CHECK(breaches(plane(points, kSides, {{1, 2}, {9, 9}})).empty());
  CHECK(breaches(plane({{0, 0}, {1, 1}, {2, 2}}, {{0, 1}, {1, 2}})).empty());
}

TEST_CASE("validated in the plane: lists") {
  CHECK(breaches(plane(kSquare, {{0, 4}})).front().kind == BreachKind::kIndexOutOfRange);
  CHECK(breaches(plane(kSquare, {{1, 1}})).front().kind == BreachKind::kDegenerateSegment);
  CHECK(breaches(plane({{0, 0}, {1, 0}, {0, 0}}, {})) ==
        std::vector<Breach>{{BreachKind::kDuplicateVertex, {0, 2}, {}, {}, Point{0, 0}}});
}

TEST_CASE("validated in the plane: vertices and segments") {
  CHECK(
      breaches(plane(kSquare, {{0, 2}, {1, 3}})) ==
      std::vector<Breach>{{BreachKind::kCrossingSegments, {}, {{0, 2}, {1, 3}}, {}, Point{2, 2}}});
  const std::vector<Point> row = {{0, 0}, {1, 1}, {3, 3}, {4, 4}};
  CHECK(breaches(plane(row, {{0, 2}})) ==
        std::vector<Breach>{{BreachKind::kVertexInSegment, {1}, {{0, 2}}, {}, Point{1, 1}}});
  // Segments of one line that overlap have vertices inside one another.
  CHECK(breaches(plane(row, {{0, 2}, {1, 3}})).size() == 2);
  // A T: the end of one inside the other, which is no crossing.
  CHECK(breaches(plane({{0, 0}, {4, 0}, {2, 0}, {2, 3}}, {{0, 1}, {2, 3}})) ==
        std::vector<Breach>{{BreachKind::kVertexInSegment, {2}, {{0, 1}}, {}, Point{2, 0}}});
}

TEST_CASE("validated in the plane: a hole seed on a segment") {
  CHECK(breaches(plane(kSquare, kSides, {{1, 1}, {Rational(1, 3), 0}})) ==
        std::vector<Breach>{
            {BreachKind::kHoleSeedOnWall, {}, {{0, 1}}, {}, Point{Rational(1, 3), 0}}});
}

}  // namespace
}  // namespace circumspect
