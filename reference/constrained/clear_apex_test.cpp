// What reaches into a simplex. Book: Section 5.6.
#include "reference/constrained/clear_apex.hpp"

#include <array>

#include <doctest/doctest.h>

namespace circumspect::constrained {
namespace {

constexpr std::array<std::size_t, 3> kAxes = {0, 1, 2};
constexpr std::array<std::size_t, 2> kPlane = {0, 1};

TEST_CASE("triangles that reach into a tetrahedron, and triangles that touch it") {
  const PointSet points({{0, 0, 0},
                         {4, 0, 0},
                         {0, 4, 0},
                         {0, 0, 4},  // the tetrahedron
                         {1, 1, 1},
                         {9, 9, 9},
                         {9, 0, 9},  // 4 inside
                         {2, 2, 0},
                         {0, 2, 2},
                         {2, 0, 2},  // on edges
                         {-1, 1, 1},
                         {9, 1, 1},
                         {9, 9, 0},
                         {-1, -1, 0},
                         {5, -1, 0},
                         {-1, 5, 0},
                         {8, 8, -2},
                         {-8, -8, 18},
                         {4, -4, 4}});
  const auto meets = [&](const Simplex& facet) {
    return meets_interior(points, kAxes, {0, 1, 2, 3}, facet);
  };
  CHECK(meets({4, 5, 6}));
  CHECK(meets({0, 4, 6}));
  CHECK(meets({7, 8, 9}) == false);  // in the facet 1 2 3
  CHECK(meets({0, 7, 8}));           // through the inside, corners on the boundary
  CHECK(meets({10, 11, 12}));        // an edge passes, all corners outside
  CHECK(!meets({13, 14, 15}));       // covers a facet
  CHECK(!meets({0, 1, 2}));          // is one
  CHECK(!meets({1, 2, 5}));          // shares an edge, leads away
  CHECK(meets({1, 2, 4}));           // shares an edge, leads inside
  CHECK(!meets({16, 17, 18}));       // apart, but not by a plane through a facet of either
  CHECK(meets({0, 4}));              // a segment
  CHECK(!meets({7, 8}));
  CHECK(meets({4}));  // a point
}

TEST_CASE("the same in the plane") {
  const PointSet points({{0, 0}, {4, 0}, {0, 4}, {1, 1}, {-1, 1}, {5, 1}, {2, 2}, {5, -1}});
  const auto meets = [&](const Simplex& facet) {
    return meets_interior(points, kPlane, {0, 1, 2}, facet);
  };
  CHECK(meets({3, 5}));
  CHECK(meets({4, 5}));
  CHECK(meets({0, 6}));
  CHECK(!meets({1, 6}));
  CHECK(!meets({1, 7}));
  CHECK(!meets({5, 7}));
}

}  // namespace
}  // namespace circumspect::constrained
