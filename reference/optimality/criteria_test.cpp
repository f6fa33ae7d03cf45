// Interpolation errors and min-containment balls of simplices that can be checked by hand.
#include "reference/optimality/criteria.hpp"

#include <doctest/doctest.h>

#include "reference/optimality/barycentric.hpp"
#include "reference/optimality/faces.hpp"

namespace circumspect::optimality {
namespace {

TEST_CASE("barycentric coordinates: inside, outside, off the affine hull, degenerate") {
  const PointSet points({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {4, 0, 0}});
  const auto inside = barycentric_coordinates(points, {0, 1, 2}, {Rational(1, 2), 1, 0});
  REQUIRE(inside.has_value());
  CHECK(*inside == std::vector<Rational>{Rational(1, 4), Rational(1, 4), Rational(1, 2)});
  CHECK(is_convex(*inside));
  CHECK_FALSE(is_convex(*barycentric_coordinates(points, {0, 1, 2}, {3, 0, 0})));
  CHECK_FALSE(barycentric_coordinates(points, {0, 1, 2}, {0, 0, 1}).has_value());
  CHECK_FALSE(barycentric_coordinates(points, {0, 1, 3}, {0, 0, 0}).has_value());
}

TEST_CASE("faces: of a triangle, and of two that share an edge") {
  CHECK(faces({4, 7, 9}) == std::vector<Simplex>{{4}, {7}, {9}, {4, 7}, {4, 9}, {7, 9}, {4, 7, 9}});
  const Triangulation two(2, {{0, 1, 2}, {1, 2, 3}});
  CHECK(simplicial_complex(two).size() == 4 + 5 + 2);
}

TEST_CASE("interpolation error: on an edge it is a parabola with its top over the middle") {
  const PointSet points(std::vector<Point>{Point{0}, Point{4}});
  const Triangulation edge(1, {{0, 1}});
  CHECK(*lifted_height(points, edge, {1}) == 4);
  CHECK(*interpolation_error(points, edge, {1}) == 3);
  CHECK(*interpolation_error(points, edge, {0}) == 0);
  CHECK_FALSE(interpolation_error(points, edge, {5}).has_value());
  const GreatestError greatest = greatest_interpolation_error(points, edge);
  CHECK(greatest.where == Point{2});
  CHECK(greatest.error == 4);
  CHECK(lifted_integral(points, edge) == 64);  // 2! · 4 · 8
}

TEST_CASE("min-containment ball: an acute triangle has its circumball, an obtuse its long edge's") {
  const PointSet points({{0, 0}, {4, 0}, {2, 3}, {2, 1}});
  const Ball acute = min_containment_ball(points, {0, 1, 2});
  CHECK(acute.centre == Point{2, Rational(5, 6)});
  CHECK(acute.squared_radius == Rational(169, 36));
  const Ball obtuse = min_containment_ball(points, {0, 1, 3});
  CHECK(obtuse.centre == Point{2, 0});
  CHECK(obtuse.squared_radius == 4);
  CHECK(min_containment_ball(points, {2}).squared_radius == 0);
  const Triangulation all(2, {{0, 1, 3}, {0, 2, 3}, {1, 2, 3}});
  CHECK(largest_min_containment_ball(points, all).squared_radius == 4);
}

TEST_CASE("nearest point: in the interior, on an edge, at a vertex") {
  const PointSet points({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}});
  CHECK(nearest_point(points, {0, 1, 2}, {Rational(1, 2), Rational(1, 2), 7}) ==
        Point{Rational(1, 2), Rational(1, 2), 0});
  CHECK(nearest_point(points, {0, 1, 2}, {2, 2, 1}) == Point{1, 1, 0});
  CHECK(nearest_point(points, {0, 1, 2}, {-1, -1, 0}) == Point{0, 0, 0});
}

}  // namespace
}  // namespace circumspect::optimality
