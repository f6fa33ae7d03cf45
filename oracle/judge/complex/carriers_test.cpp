// Where two simplices meet: the least faces of theirs that hold it.
#include "oracle/judge/complex/carriers.hpp"

#include <doctest/doctest.h>

namespace circumspect::check {
namespace {

std::pair<Simplex, Simplex> meeting(const std::vector<Point>& points, const Simplex& a,
                                    const Simplex& b) {
  const Configuration configuration(points);
  const OrientationSigns orientation(configuration);
  const Carriers there = carriers(orientation, a, b), back = carriers(orientation, b, a);
  CHECK(there.of_a == back.of_b);
  CHECK(there.of_b == back.of_a);
  // Thirds are not doubles: the same by the predicates of the kernel.
  std::vector<Point> thirds = points;
  for (Point& p : thirds) {
    for (Rational& x : p) x /= 3;
  }
  const Configuration scaled(thirds);
  const Carriers exactly = carriers(OrientationSigns(scaled), a, b);
  CHECK(exactly.of_a == there.of_a);
  CHECK(exactly.of_b == there.of_b);
  return {there.of_a, there.of_b};
}

using Faces = std::pair<Simplex, Simplex>;

TEST_CASE("in the plane: apart, at a vertex, along an edge, in an edge, inside") {
  const std::vector<Point> points = {{0, 0}, {4, 0}, {0, 4}, {4, 4}, {2, 2}, {9, 9},
                                     {9, 8}, {2, 0}, {1, 1}, {6, 0}, {1, -3}};
  CHECK(meeting(points, {0, 1, 2}, {3, 5, 6}) == Faces{});
  CHECK(meeting(points, {0, 1, 2}, {1, 3, 5}) == Faces{{1}, {1}});
  CHECK(meeting(points, {0, 1, 2}, {1, 2, 3}) == Faces{{1, 2}, {1, 2}});
  CHECK(meeting(points, {0, 1, 2}, {3, 4, 6}) == Faces{{1, 2}, {4}});
  CHECK(meeting(points, {0, 1, 2}, {3, 6, 8}) == Faces{{0, 1, 2}, {3, 6, 8}});
  CHECK(meeting(points, {0, 1, 2}, {7, 9, 10}) == Faces{{0, 1}, {7, 9}});
  CHECK(meeting(points, {0, 1}, {7, 9}) == Faces{{0, 1}, {7, 9}});
  CHECK(meeting(points, {0, 1, 2}, {0, 1, 8}) == Faces{{0, 1, 2}, {0, 1, 8}});
  CHECK(meeting(points, {0, 1, 2}, {0, 1}) == Faces{{0, 1}, {0, 1}});
  CHECK(meeting(points, {0}, {8}) == Faces{});
}

TEST_CASE("in space: two edges that cross, and tetrahedra that only an edge of each separates") {
  const std::vector<Point> points = {{2, 0, 0},  {-2, 0, 0}, {0, 2, 0},   {0, -2, 0}, {0, 0, 3},
                                     {0, 0, -3}, {1, 1, 5},  {-1, -1, 5}, {1, 1, -5}, {0, 0, 1}};
  CHECK(meeting(points, {0, 1}, {2, 3}) == Faces{{0, 1}, {2, 3}});
  CHECK(meeting(points, {0, 1, 4}, {2, 3, 5}) == Faces{{0, 1}, {2, 3}});
  CHECK(meeting(points, {0, 1, 2, 4}, {0, 2, 3, 5}) == Faces{{0, 1, 2}, {0, 2, 3}});
  CHECK(meeting(points, {0, 1, 6, 7}, {2, 3, 5, 8}) == Faces{{0, 1}, {2, 3}});
  CHECK(meeting(points, {0, 1, 2}, {4, 6, 9}) == Faces{});
}

}  // namespace
}  // namespace circumspect::check
