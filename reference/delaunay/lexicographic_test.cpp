// The lexicographic triangulation of sets small enough to do by hand. Book: Section 4.1.
#include "reference/delaunay/lexicographic.hpp"

#include <doctest/doctest.h>

namespace circumspect::delaunay {
namespace {

TEST_CASE("lexicographic: no point, one, points on a line in any order") {
  CHECK(lexicographic(PointSet({})) == Triangulation(-1, {}));
  CHECK(lexicographic(PointSet({{4, 4}})) == Triangulation(0, {{0}}));
  CHECK(lexicographic(PointSet({{3, 3}, {1, 1}, {2, 2}})) == Triangulation(1, {{0, 2}, {1, 2}}));
}

TEST_CASE("lexicographic: each point is joined to the edges it sees") {
  const PointSet points({{0, 0}, {1, 3}, {2, -2}, {3, 0}, {9, 0}});
  CHECK(lexicographic(points) == Triangulation(2, {{0, 1, 2}, {1, 2, 3}, {1, 3, 4}, {2, 3, 4}}));
}

TEST_CASE(
    "lexicographic: a point that leaves the line is joined to all edges, in the plane to all") {
  const PointSet points({{0, 0}, {1, 0}, {2, 0}, {3, 1}});
  CHECK(lexicographic(points) == Triangulation(2, {{0, 1, 3}, {1, 2, 3}}));
  const PointSet raised({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 1, 0}, {4, 0, 1}, {5, 0, 0}});
  CHECK(lexicographic(raised) == Triangulation(3, {{0, 1, 3, 4}, {1, 2, 3, 4}, {2, 3, 4, 5}}));
}

TEST_CASE("lexicographic: hull facets coplanar with the new point are not seen") {
  const PointSet square({{0, 0}, {0, 1}, {1, 0}, {1, 1}, {2, 0}});
  CHECK(lexicographic(square) == Triangulation(2, {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}}));
}

}  // namespace
}  // namespace circumspect::delaunay
