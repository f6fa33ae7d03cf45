#include "kernel/piecewise_linear/nearest_plane.hpp"

#include <algorithm>
#include <random>

#include <doctest/doctest.h>

#include "kernel/exact/number.hpp"

namespace circumspect {
namespace {

using Random = std::mt19937_64;

long some(Random& random, long most) {
  return static_cast<long>(random() % static_cast<unsigned long>(2 * most + 1)) - most;
}

Rational squared_half_width(const std::vector<Point>& points, const Point& normal) {
  std::vector<Rational> heights;
  for (const Point& point : points) heights.push_back(inner_product(normal, point));
  const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
  const Rational half = (*high - *low) / 2;
  return half * half / squared_length(normal);
}

// Corners of a polygon in a slanted plane, each a few bits off it; with `bits` 0 anywhere in a
// cube.
std::vector<Point> cloud(Random& random, std::size_t count, long bits) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i) {
    const long x = some(random, 50), y = some(random, 50);
    const Rational z = bits == 0 ? Rational(some(random, 50))
                                 : Rational(x, 3) - y + Rational(some(random, bits), 1'000'000'000);
    points.push_back({x, y, z});
  }
  return points;
}

}  // namespace

TEST_CASE("nearest_plane: a tetrahedron, along its least height or between two edges") {
  // The heights are 2, 2, 2 and 2/√3; opposite edges are √2 apart.
  const NearestPlane right = nearest_plane({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}});
  CHECK(right.squared_distance == Rational(1, 3));
  CHECK(right.farthest == std::vector<std::size_t>{0, 1, 2, 3});
  // A regular tetrahedron: its height is 4/√3, and opposite edges are 2 apart.
  CHECK(nearest_plane({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}).squared_distance == 1);
  // A box of 9 × 9 × 2, and a point halfway between the planes about it, which is on neither.
  std::vector<Point> box = {{4, 3, 1}};
  for (const int corner : {0, 1, 2, 3, 4, 5, 6, 7}) {
    box.push_back({9 * (corner & 1), 9 * (corner >> 1 & 1), 2 * (corner >> 2)});
  }
  const NearestPlane middle = nearest_plane(box);
  CHECK(middle.squared_distance == 1);
  CHECK(middle.farthest.front() > 0);
}

TEST_CASE(
    "nearest_plane: all points are so near, some on both sides are no nearer, no plane is nearer") {
  Random random(1);
  for (int i = 0; i < 120; ++i) {
    const auto points = cloud(random, 4 + random() % 12, i % 3 == 0 ? 0 : 4);
    if (affine_hull(points).dimension < 3) continue;
    const NearestPlane plane = nearest_plane(points);
    CHECK(sign(plane.squared_distance) > 0);
    CHECK(squared_half_width(points, plane.normal) == plane.squared_distance);
    std::vector<Point> farthest;
    for (const std::size_t place : plane.farthest) farthest.push_back(points[place]);
    CHECK(squared_half_width(farthest, plane.normal) == plane.squared_distance);
    // Other normals: at right angles to two differences of points, near the one that was found, or
    // anywhere.
    for (int j = 0; j < 30; ++j) {
      const auto difference = [&] {
        return points[random() % points.size()] - points[random() % points.size()];
      };
      Point other = cross_product(difference(), difference());
      if (j % 3 == 1) other = {some(random, 9), some(random, 9), some(random, 9)};
      if (j % 3 == 2) {
        other = plane.normal;
        other[random() % 3] *= 1 + Rational(some(random, 99), 10'000);
      }
      if (sign(squared_length(other)) == 0) continue;
      CHECK(squared_half_width(points, other) >= plane.squared_distance);
    }
  }
}

TEST_CASE("nearest_plane: of many points a few are looked at, and all are that near") {
  Random random(2);
  for (const long bits : {0L, 1000L}) {
    const auto points = cloud(random, 600, bits);
    const NearestPlane plane = nearest_plane(points);
    CHECK(squared_half_width(points, plane.normal) == plane.squared_distance);
    CHECK(plane.farthest.size() >= 2);
    if (bits > 0) CHECK(plane.squared_distance < Rational(1, 1'000'000'000'000L) * 2);
  }
}

}  // namespace circumspect
