// Which simplices have to be left out for the others to form a complex.
#include "oracle/judge/complex/by_boundary.hpp"

#include <doctest/doctest.h>

namespace circumspect::check {
namespace {

using Places = std::vector<std::size_t>;

Places left_out(const std::vector<Point>& points, const std::vector<Simplex>& simplices) {
  return left_out_of_complex(Configuration(points), points, simplices);
}

// A grid of n × n points, its squares cut in two.
std::vector<Point> grid(int n) {
  std::vector<Point> points;
  for (int i = 0; i < n * n; ++i) points.push_back({i % n, i / n});
  return points;
}
std::vector<Simplex> cut_squares(Vertex n) {
  std::vector<Simplex> simplices;
  for (Vertex y = 0; y + 1 < n; ++y) {
    for (Vertex x = 0; x + 1 < n; ++x) {
      const Vertex at = y * n + x;
      simplices.push_back({at, at + 1, at + n});
      simplices.push_back({at + 1, at + n, at + n + 1});
    }
  }
  return simplices;
}

TEST_CASE("none, of a complex: of one part, of several, with a hole, in space") {
  CHECK(left_out(grid(5), cut_squares(5)).empty());
  std::vector<Simplex> with_hole = cut_squares(5);
  with_hole.erase(with_hole.begin() + 10, with_hole.begin() + 12);
  CHECK(left_out(grid(5), with_hole).empty());
  CHECK(left_out({{0}, {1}, {2}, {5}, {7}}, {{0, 1}, {1, 2}, {3, 4}}).empty());
  const std::vector<Point> corners = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {4, 4, 4}};
  CHECK(left_out(corners, {{0, 1, 2, 3}, {1, 2, 3, 4}}).empty());
}

TEST_CASE("few, where a few are at fault") {
  std::vector<Point> points = grid(9);
  points[40] = {Rational(11, 2), 4};  // beyond its neighbour 41
  const Places moved = left_out(points, cut_squares(9));
  CHECK(!moved.empty());
  CHECK(moved.size() < 30);
  // A triangle of its own inside others.
  std::vector<Simplex> simplices = cut_squares(9);
  points = grid(9);
  const auto first = static_cast<Vertex>(points.size());
  for (const Point& corner : {Point{3, 3}, Point{4, 3}, Point{3, 4}}) {
    points.push_back(corner);
    for (Rational& x : points.back()) x += Rational(1, 3);
  }
  simplices.push_back({first, first + 1, first + 2});
  const Places inside = left_out(points, simplices);
  CHECK(!inside.empty());
  CHECK(inside.size() < 30);
}

TEST_CASE("next to the centre of a facet: the simplex beyond, not its own, not one at the side") {
  const std::vector<Point> edge = {{0, 0}, {4, 0}};
  const Point apex = {1, 3};
  CHECK(!has_just_outside({{0, 0}, {4, 0}, {1, 3}}, edge, apex));
  CHECK(has_just_outside({{0, 0}, {4, 0}, {1, -3}}, edge, apex));
  CHECK(has_just_outside({{-9, 1}, {9, 1}, {1, -9}}, edge, apex));
  CHECK(!has_just_outside({{2, 0}, {3, 1}, {4, 0}}, edge, apex));
  CHECK(!has_just_outside({{2, 0}, {3, -1}, {4, 0}}, edge, {0, -3}));
  // The points next to the centre are on the line through it and the apex, an edge of this one.
  CHECK(has_just_outside({{2, 0}, {3, -3}, {6, -3}}, edge, apex));
}

}  // namespace
}  // namespace circumspect::check
