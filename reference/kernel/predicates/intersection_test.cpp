// What vertices, segments and triangles have in common.
#include "reference/kernel/predicates/intersection.hpp"

#include <algorithm>

#include <doctest/doctest.h>

namespace circumspect {
namespace {

using Corners = std::vector<Point>;

Corners sorted_corners(Corners corners) {
  std::sort(corners.begin(), corners.end());
  return corners;
}

TEST_CASE("intersection: a segment and a vertex against a triangle in space") {
  const Corners triangle = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  CHECK(intersection(triangle, {{1, 1, -1}, {1, 1, 1}}) == Corners{{1, 1, 0}});
  CHECK(intersection(triangle, {{1, 1, 1}, {1, 1, 2}}).empty());
  CHECK(sorted_corners(intersection(triangle, {{-1, 1, 0}, {9, 1, 0}})) ==
        Corners{{0, 1, 0}, {3, 1, 0}});
  CHECK(intersection({{2, 2, 0}}, triangle) == Corners{{2, 2, 0}});
  CHECK(intersection({{2, 2, Rational(1, 1000)}}, triangle).empty());
}

TEST_CASE("intersection: two triangles, crossing, coplanar and touching") {
  const Corners triangle = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  CHECK(sorted_corners(intersection(triangle, {{1, 1, -1}, {1, 1, 1}, {9, 1, 0}})) ==
        Corners{{1, 1, 0}, {3, 1, 0}});
  CHECK(intersection(triangle, {{1, 1, 0}, {5, 1, 0}, {1, 5, 0}}).size() == 3);
  CHECK(intersection(triangle, {{-1, -1, 0}, {3, 1, 0}, {1, 3, 0}}).size() >= 3);
  CHECK(intersection(triangle, {{4, 0, 0}, {5, 0, 1}, {5, 1, 0}}) == Corners{{4, 0, 0}});
}

TEST_CASE("intersection: in the plane") {
  const Corners triangle = {{0, 0}, {4, 0}, {0, 4}};
  CHECK(sorted_corners(intersection(triangle, {{1, 1}, {5, 1}})) == Corners{{1, 1}, {3, 1}});
  CHECK(intersection({{0, 0}, {4, 0}}, {{1, 0}}) == Corners{{1, 0}});
  CHECK(intersection({{0, 0}, {4, 0}}, {{2, -1}, {2, 1}}) == Corners{{2, 0}});
  CHECK(intersection({{1, 2}}, {{1, 2}}) == Corners{{1, 2}});
  CHECK(intersection({{1, 2}}, {{2, 1}}).empty());
}

}  // namespace
}  // namespace circumspect
