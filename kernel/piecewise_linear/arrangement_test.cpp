#include "kernel/piecewise_linear/arrangement.hpp"

#include <doctest/doctest.h>

#include "kernel/piecewise_linear/validity.hpp"

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

// The arrangement is valid whatever the input, and is its own arrangement.
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
  // A vertex beside the segment, or on its line beyond its end, cuts nothing.
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

// The vertices of a tetrahedron.
const std::vector<Point> kCorners = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}};

PiecewiseLinearInput tetrahedron() {
  PiecewiseLinearInput input;
  input.points = kCorners;
  for (const std::vector<Vertex>& line : Pairs{{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}) {
    input.polygons.push_back({{line}, {}});
  }
  return input;
}

using Lines = std::vector<std::vector<Vertex>>;

TEST_CASE("in space: triangles that each have their own vertices get common ones") {
  PiecewiseLinearInput soup;
  for (const PolygonLines& triangle : tetrahedron().polygons) {
    std::vector<Vertex> own;
    for (const Vertex v : triangle.lines[0]) {
      own.push_back(static_cast<Vertex>(soup.points.size()));
      soup.points.push_back(kCorners[static_cast<std::size_t>(v)]);
    }
    soup.polygons.push_back({{own}, {}});
  }
  CHECK(!validated(soup, 1));
  const auto result = valid_arrangement(soup);
  CHECK(result.points == kCorners);
  CHECK(result.polygons[3].lines == Lines{{1, 2, 3}});
  // A line without three different vertices is not a polygon; the arrangement does not hide that.
  soup.points[2] = soup.points[1];
  CHECK(arranged(soup).polygons[0].lines == Lines{{0, 1}});
  CHECK(validated(arranged(soup), 1).error().front().kind == BreachKind::kDegeneratePolygon);
}

TEST_CASE("in space: a vertex on an edge cuts it in all polygons, and segments cut each other") {
  PiecewiseLinearInput input = tetrahedron();
  input.points.push_back({1, 0, 0});
  input.points.push_back({3, 0, 0});
  CHECK(validated(input, 1).error().front().kind == BreachKind::kVertexInSegment);
  const auto cut = valid_arrangement(input);
  CHECK(cut.polygons[0].lines == Lines{{0, 4, 5, 1, 2}});
  CHECK(cut.polygons[1].lines == Lines{{0, 4, 5, 1, 3}});
  CHECK(cut.polygons[3].lines == Lines{{1, 2, 3}});
  // One segment goes through the middle of an edge and beyond, in a plane with it; another one
  // misses it.
  input = tetrahedron();
  input.points.insert(input.points.end(), {{2, -1, 0}, {2, 0, -1}, {2, 0, 1}, {2, -1, 5}});
  input.segments = {{5, 6}, {4, 7}};
  const auto crossed = valid_arrangement(input);
  REQUIRE(crossed.points.size() == 9);
  CHECK(crossed.points[8] == Point{2, 0, 0});
  CHECK(crossed.segments == Lines{{4, 7}, {5, 8}, {6, 8}});
}

TEST_CASE("in space: where a segment goes through a polygon both have a vertex") {
  PiecewiseLinearInput input = tetrahedron();
  input.points.insert(input.points.end(), {{1, 1, -1}, {1, 1, 3}});
  input.segments = {{4, 5}};
  CHECK(validated(input, 1).error().front().kind == BreachKind::kSegmentPiercesPolygon);
  const auto pierced = valid_arrangement(input);
  CHECK(std::vector<Point>(pierced.points.begin() + 6, pierced.points.end()) ==
        std::vector<Point>{{1, 1, 0}, {1, 1, 2}});
  CHECK(pierced.segments == Lines{{4, 6}, {5, 7}, {6, 7}});
}

TEST_CASE("in space: polygons that cross still do") {
  PiecewiseLinearInput input = tetrahedron();
  input.points.insert(input.points.end(), {{1, 1, -1}, {1, 1, 1}, {-5, -5, 0}});
  input.polygons.push_back({{{4, 5, 6}}, {}});
  CHECK(validated(arranged(input), 1).error().front().kind == BreachKind::kPolygonsCross);
}

}  // namespace
}  // namespace circumspect
