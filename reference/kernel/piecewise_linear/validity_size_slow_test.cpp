// Inputs large enough that anything quadratic would be felt.
#include <doctest/doctest.h>

#include "reference/kernel/piecewise_linear/polygon_triangles.hpp"
#include "reference/kernel/piecewise_linear/validity.hpp"

namespace circumspect {
namespace {

// A surface of 2·n² triangles over a square grid, with heights that follow no pattern.
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

}  // namespace
}  // namespace circumspect
