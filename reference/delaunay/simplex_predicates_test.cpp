// Simplices that are strongly Delaunay, Delaunay, and not, with the ball or the obstruction.
#include "reference/delaunay/simplex_predicates.hpp"

#include <doctest/doctest.h>

#include "kernel/complex/circumball.hpp"
#include "kernel/complex/point_set.hpp"
#include "properties/arguments/laws.hpp"

namespace circumspect::delaunay {
namespace {

TEST_CASE("simplex predicates: a square with both diagonals") {
  const PointSet square({{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  for (const Simplex& diagonal : {Simplex{0, 2}, Simplex{1, 3}, Simplex{0, 1, 2}}) {
    const SimplexDelaunayhood answer = delaunayhood(square, diagonal);
    CHECK(answer.delaunayhood == Delaunayhood::kDelaunay);
    CHECK(answer.ball->centre == Point{1, 1});
    CHECK(answer.ball->squared_radius == 2);
    CHECK(answer.obstruction->power == 0);
  }
  CHECK(is_strongly_delaunay(square, {0, 1}));
  CHECK(is_strongly_delaunay(square, {3}));
  CHECK(is_delaunay(square, Triangulation(2, {{0, 1, 2}, {0, 2, 3}})));
}

TEST_CASE("simplex predicates: the long diagonal of a rhombus, and why it is not Delaunay") {
  const PointSet rhombus({{-3, 0}, {0, -1}, {3, 0}, {0, 1}});
  CHECK(is_strongly_delaunay(rhombus, {1, 3}));
  const SimplexDelaunayhood answer = delaunayhood(rhombus, {0, 2});
  CHECK(answer.delaunayhood == Delaunayhood::kNotDelaunay);
  CHECK_FALSE(answer.ball.has_value());
  // The middle of points 1 and 3 is on the diagonal, and they are 8 deep in its smallest ball:
  // moving the ball away from one moves it towards the other.
  CHECK(sorted(answer.obstruction->points) == Simplex{1, 3});
  CHECK(answer.obstruction->coefficients == std::vector<Rational>{Rational(1, 2), Rational(1, 2)});
  CHECK(answer.obstruction->power == -8);
  CHECK_FALSE(is_delaunay(rhombus, Triangulation(2, {{0, 1, 2}, {0, 2, 3}})));
}

TEST_CASE("simplex predicates: an edge whose smallest ball is not empty but another is") {
  const PointSet points({{-2, 0}, {2, 0}, {0, 1}, {0, 9}});
  const SimplexDelaunayhood answer = delaunayhood(points, {0, 1});
  CHECK(answer.delaunayhood == Delaunayhood::kStronglyDelaunay);
  for (Vertex q = 0; q < 4; ++q) {
    CHECK(sign(power(points, *answer.ball, q)) == (q < 2 ? 0 : 1));
  }
}

TEST_CASE("simplex predicates: a point set in a plane of space keeps its centres there") {
  const PointSet points({{0, 0, 1}, {2, 0, 1}, {0, 2, 1}, {Rational(1, 2), Rational(1, 2), 1}});
  CHECK(is_delaunay(points, {0, 1}));
  CHECK(delaunayhood(points, {0, 1}).ball->centre[2] == 1);
  CHECK_FALSE(is_delaunay(points, {0, 1, 2}));
}

TEST_CASE("simplex predicates: points on a line, an edge over a point") {
  const PointSet points({{0, 0}, {1, 1}, {2, 2}});
  CHECK(is_strongly_delaunay(points, {0, 1}));
  const SimplexDelaunayhood answer = delaunayhood(points, {0, 2});
  CHECK(answer.delaunayhood == Delaunayhood::kNotDelaunay);
  CHECK(answer.obstruction->points == Simplex{1});
}

TEST_CASE("simplex predicates: a submerged point is not a weighted Delaunay vertex") {
  const std::vector<Point> line{Point{0}, Point{1}, Point{2}};
  CHECK(is_delaunay(PointSet(line), Simplex{1}));
  CHECK_FALSE(is_delaunay(PointSet(line, {0, -2, 0}), Simplex{1}));
  const SimplexDelaunayhood on_the_hull = delaunayhood(PointSet(line, {0, -1, 0}), {1});
  CHECK(on_the_hull.delaunayhood == Delaunayhood::kDelaunay);
  CHECK(is_strongly_delaunay(PointSet(line, {0, -1, 0}), {0, 2}) == false);
  CHECK(is_strongly_delaunay(PointSet(line, {0, -2, 0}), {0, 2}));
}

}  // namespace
}  // namespace circumspect::delaunay
