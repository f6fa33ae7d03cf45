// Inputs large enough to show quadratic time.
#include <doctest/doctest.h>

#include "kernel/piecewise_linear/polygon_triangles.hpp"
#include "kernel/piecewise_linear/validity.hpp"

namespace circumspect {
namespace {

// A surface of 2·n² triangles over a square grid, with irregular heights.
PiecewiseLinearInput height_field(Vertex n) {
  PiecewiseLinearInput input;
  unsigned state = 1;
  for (Vertex x = 0; x <= n; ++x) {
    for (Vertex y = 0; y <= n; ++y) {
      state = state * 1103515245u + 12345u;
      input.points.push_back({Rational(x), Rational(y), Rational((state >> 16) % 1000, 1024)});
      input.points.back()[2].canonicalize();
    }
  }
  for (Vertex x = 0; x < n; ++x) {
    for (Vertex y = 0; y < n; ++y) {
      const Vertex a = x * (n + 1) + y, b = a + 1, c = a + n + 1, d = c + 1;
      input.polygons.push_back({{{a, b, d}}, {}});
      input.polygons.push_back({{{a, d, c}}, {}});
    }
  }
  return input;
}

// A comb: teeth up and down, so that vertices that are neighbours on the line are far apart.
PiecewiseLinearInput comb(Vertex teeth) {
  PiecewiseLinearInput input;
  std::vector<Vertex> line;
  for (Vertex i = 0; i < teeth; ++i) {
    input.points.push_back({Rational(2 * i), 0, 0});
    input.points.push_back({Rational(2 * i + 1), Rational(1000 - i % 7), 0});
    line.insert(line.end(), {2 * i, 2 * i + 1});
  }
  input.points.push_back({Rational(2 * teeth), Rational(-1), 0});
  input.points.push_back({Rational(-1), Rational(-1), 0});
  line.insert(line.end(), {2 * teeth, 2 * teeth + 1});
  input.polygons = {{{line}, {}}};
  return input;
}

TEST_CASE("validated: a surface of 20,000 triangles") {
  PiecewiseLinearInput input = height_field(100);
  CHECK(validated(input).has_value());
  // A needle through it is found.
  const Point low = {Rational(101, 2), Rational(201, 4), -1}, high = {low[0], low[1], 2};
  input.points.insert(input.points.end(), {low, high});
  const auto last = static_cast<Vertex>(input.points.size()) - 1;
  input.segments = {{last - 1, last}};
  const auto breaches = validated(input).error();
  REQUIRE(breaches.size() == 1);
  CHECK(breaches[0].kind == BreachKind::kSegmentPiercesPolygon);
}

TEST_CASE("validated: a polygon with 4,000 vertices") {
  const auto complex = validated(comb(2000));
  REQUIRE(complex);
  CHECK(complex->polygons[0].triangles.size() == 4000);
}

TEST_CASE("validated: 1,000 triangles about one vertex, over a disk") {
  PiecewiseLinearInput input;
  std::vector<Vertex> rim;
  input.points = {{0, 0, 1}};
  // Rational points of a parabola, in convex position.
  for (Vertex i = 0; i < 1000; ++i) {
    const Rational t = Rational(i) - 500;
    input.points.push_back({t, t * t, 0});
    rim.push_back(i + 1);
  }
  for (Vertex i = 1; i <= 1000; ++i) input.polygons.push_back({{{0, i, i % 1000 + 1}}, {}});
  input.polygons.push_back({{rim}, {}});
  CHECK(validated(input).has_value());
}

// Rational points of a circle, in order.
std::vector<Point> circle(Vertex n) {
  std::vector<Point> points;
  for (Vertex i = 0; i < n; ++i) {
    // The tangent of half an angle runs through an octant; the octants follow each other.
    Rational t(4 * i % n, n);
    t.canonicalize();
    const Rational square = t * t;
    Rational x = (1 - square) / (1 + square), y = 2 * t / (1 + square);
    for (Vertex quarter = 4 * i / n; quarter > 0; --quarter) {
      std::swap(x, y);
      x = -x;
    }
    points.push_back({x, y, 0});
  }
  return points;
}

PiecewiseLinearInput double_cone(Vertex rim) {
  PiecewiseLinearInput input;
  input.points = circle(rim);
  input.points.insert(input.points.end(), {{0, 0, 1}, {0, 0, -1}});
  for (const Vertex apex : {rim, rim + 1}) {
    for (Vertex i = 0; i < rim; ++i) input.polygons.push_back({{{i, (i + 1) % rim, apex}}, {}});
  }
  return input;
}

// Pages around the z-axis; without the spine they cross in it.
PiecewiseLinearInput book(Vertex pages, bool has_spine) {
  PiecewiseLinearInput input;
  input.points = {{0, 0, 0}, {0, 0, 1}};
  for (const Point& p : circle(pages)) {
    const auto next = static_cast<Vertex>(input.points.size());
    input.points.insert(input.points.end(), {p, {p[0], p[1], 1}});
    if (has_spine) {
      input.polygons.push_back({{{0, 1, next + 1, next}}, {}});
    } else {
      // On both sides of the axis, which runs through it from vertex to vertex.
      input.points.back() = {-p[0] / 9, -p[1] / 9, Rational(1, 2)};
      input.polygons.push_back({{{0, next, 1, next + 1}}, {}});
    }
  }
  return input;
}

PiecewiseLinearInput prism(Vertex n) {
  PiecewiseLinearInput input;
  input.points = circle(n);
  std::vector<Vertex> bottom, top;
  for (Vertex i = 0; i < n; ++i) {
    const Point& p = input.points[static_cast<std::size_t>(i)];
    input.points.push_back({p[0], p[1], 1});
    bottom.push_back(i);
    top.push_back(n + i);
    input.polygons.push_back({{{i, (i + 1) % n, n + (i + 1) % n, n + i}}, {}});
  }
  input.polygons.push_back({{bottom}, {}});
  input.polygons.push_back({{top}, {}});
  return input;
}

TEST_CASE("validated: a double cone with 4,000 triangles a side") {
  const auto complex = validated(double_cone(4000));
  REQUIRE(complex);
  CHECK(complex->segments.size() == 12000);
}

TEST_CASE("validated: a book of 4,000 pages on one segment, and 999 that cross where it is not") {
  CHECK(validated(book(4000, true)).has_value());
  const auto breaches = validated(book(999, false)).error();
  CHECK(breaches.size() == kBreachLimit);
  CHECK(breaches[0].kind == BreachKind::kPolygonsCross);
}

TEST_CASE("validated: a prism over a polygon of 1,500 vertices") {
  CHECK(validated(prism(1500)).has_value());
}

TEST_CASE("validated: segments that all cross, one breach at a time") {
  PiecewiseLinearInput input;
  constexpr Vertex kSegments = 150;
  for (Vertex i = 0; i < kSegments; ++i) {
    input.points.push_back({Rational(i), 0});
    input.points.push_back({kSegments - i - Rational(3, 4), kSegments});
    input.segments.push_back({2 * i, 2 * i + 1});
  }
  std::size_t heard = 0;
  const auto breaches = validated(input, 0, {.on_breach = [&](const Breach&) { ++heard; }}).error();
  CHECK(heard == kSegments * (kSegments - 1) / 2);
  CHECK(breaches.size() == kBreachLimit);  // no more are kept
  CHECK(validated(input, 0).error().size() == heard);
}

}  // namespace
}  // namespace circumspect
