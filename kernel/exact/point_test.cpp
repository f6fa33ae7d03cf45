// Points as vectors, and their affine hull.
#include "kernel/exact/point.hpp"

#include <algorithm>
#include <type_traits>

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "inputs/plain_algebra.hpp"
#include "kernel/exact/triple.hpp"
#include "properties/arguments/generated.hpp"
#include "properties/arguments/point_sets.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect {
namespace {

rc::Gen<Point> vectors() { return rc::gen::container<Point>(3, generators::small_rational()); }

TEST_CASE("point: worked examples") {
  const Point a = {1, Rational(1, 2), -3};
  const Point b = {2, Rational(1, 3), 5};
  CHECK(a + b == Point{3, Rational(5, 6), 2});
  CHECK(a - b == Point{-1, Rational(1, 6), -8});
  CHECK(Rational(-2) * a == Point{-2, -1, 6});
  CHECK(inner_product(a, b) == Rational(-77, 6));
  CHECK(squared_length(a) == Rational(41, 4));
  CHECK(squared_distance(a, b) == Rational(2341, 36));
  CHECK(barycentre({a, b}) == Point{Rational(3, 2), Rational(5, 12), 1});
  CHECK(barycentre({a}) == a);
}

TEST_CASE("point: the operators make a vector space with an inner product") {
  CHECK(properties::holds([] {
    const Point a = *vectors();
    const Point b = *vectors();
    const Point c = *vectors();
    const Rational s = *generators::small_rational();
    RC_ASSERT((a + b) == (b + a));
    RC_ASSERT(((a + b) + c) == (a + (b + c)));
    RC_ASSERT(((a - b) + b) == a);
    RC_ASSERT((s * (a + b)) == (s * a + s * b));
    RC_ASSERT(inner_product(a, b) == inner_product(b, a));
    RC_ASSERT(inner_product(s * a + b, c) == s * inner_product(a, c) + inner_product(b, c));
    RC_ASSERT(squared_length(a) == inner_product(a, a));
    RC_ASSERT(squared_distance(a, b) == squared_length(b - a));
    RC_ASSERT((sign(squared_distance(a, b)) == 0) == (a == b));
  }));
}

TEST_CASE("point: the cross product is at right angles to both, by the right hand") {
  CHECK(cross_product(Point{1, 0, 0}, Point{0, 1, 0}) == Point{0, 0, 1});
  CHECK(cross_product(Point{3, 0, 9}, Point{4, 7, 2}, 0, 1) == 21);
  CHECK(cross_product(Point{3, 0, 9}, Point{4, 7, 2}, 0, 2) == -30);
  CHECK(properties::holds([] {
    const Point a = *vectors();
    const Point b = *vectors();
    const Point across = cross_product(a, b);
    RC_ASSERT(sign(inner_product(across, a)) == 0);
    RC_ASSERT(sign(inner_product(across, b)) == 0);
    const Rational of_both = inner_product(a, b);
    RC_ASSERT(squared_length(across) == squared_length(a) * squared_length(b) - of_both * of_both);
    RC_ASSERT(across == Rational(-1) * cross_product(b, a));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      RC_ASSERT(cross_product(a, b, (axis + 1) % 3, (axis + 2) % 3) == across[axis]);
    }
  }));
}

TEST_CASE("point: the distance of a point from a segment is that of the nearest point of it") {
  const Point a = {0, 0}, b = {4, 2};
  CHECK(squared_distance_to_segment({-3, -4}, a, b) == 25);
  CHECK(squared_distance_to_segment({7, 6}, a, b) == 25);
  CHECK(squared_distance_to_segment({1, 3}, a, b) == 5);
  CHECK(squared_distance_to_segment({1, Rational(1, 2)}, a, b) == 0);
}

TEST_CASE("point: the longest axis is the first of those that no other exceeds") {
  CHECK(longest_axis({0}) == 0);
  CHECK(longest_axis({1, -3, 3}) == 1);
  CHECK(longest_axis({Rational(-1, 3), Rational(1, 3), Rational(1, 4)}) == 0);
}

TEST_CASE("triple: numbers of every kind have the products that points have") {
  CHECK(properties::holds([] {
    const auto numbers = rc::gen::container<std::vector<int>>(3, rc::gen::inRange(-999, 1000));
    const std::vector<int> a = *numbers, b = *numbers;
    const Point p(a.begin(), a.end()), q(b.begin(), b.end());
    const auto is_that_of_points = [&](const auto& zero) {
      using Number = std::decay_t<decltype(zero)>;
      const Triple<Number> u = {a[0], a[1], a[2]}, v = {b[0], b[1], b[2]};
      const auto point = [](const Triple<Number>& t) { return Point{t[0], t[1], t[2]}; };
      return point(difference(u, v)) == p - q && inner_product(u, v) == inner_product(p, q) &&
             point(cross_product(u, v)) == cross_product(p, q);
    };
    RC_ASSERT(is_that_of_points(Integer(0)));
    RC_ASSERT(is_that_of_points(Rational(0)));
    RC_ASSERT(is_that_of_points(long{0}));
  }));
}

TEST_CASE("point: the barycentre balances the vertices, in any order of them") {
  CHECK(properties::holds([] {
    std::vector<Point> points =
        *rc::gen::nonEmpty(rc::gen::container<std::vector<Point>>(vectors()));
    const Point centre = barycentre(points);
    Point sum(3);
    for (const Point& point : points) sum = sum + (point - centre);
    RC_ASSERT(sum == Point(3));
  }));
}

TEST_CASE("point: operator< is the lexicographic order of exact coordinates") {
  CHECK(Point{1, 9} < Point{2, 0});
  CHECK(Point{1, 2} < Point{1, 3});
  CHECK_FALSE(Point{1, 2} < Point{1, 2});
  CHECK(Point{Rational(1, 3)} < Point{exact_value(0.33333333333333337)});
  CHECK(Point{exact_value(0.33333333333333331)} < Point{Rational(1, 3)});
}

std::vector<Point> some(const std::vector<Point>& points, const std::vector<std::size_t>& which) {
  std::vector<Point> chosen;
  for (const std::size_t i : which) chosen.push_back(points[i]);
  return chosen;
}

// Runs the law on sets of each dimension, among them flats of every lower dimension.
template <typename Law>
bool holds_for_hulls(const Law& law) {
  bool all = true;
  for (std::size_t d = 1; d <= 4; ++d) {
    for (std::size_t k = 1; k <= d; ++k) {
      const auto sets =
          generators::unweighted(generators::embedded(generators::any_point_set(k, 6), d));
      all = properties::holds(std::to_string(k) + "-flats in dimension " + std::to_string(d),
                              [&] { law((*sets).points); }) &&
            all;
    }
  }
  return all;
}

TEST_CASE("affine_hull: of no point, one point, and points that repeat") {
  CHECK(affine_hull({}).dimension == -1);
  CHECK(affine_hull({}).basis.empty());
  const AffineHull one = affine_hull({{1, 2, 3}, {1, 2, 3}});
  CHECK(one.dimension == 0);
  CHECK(one.basis == std::vector<std::size_t>{0});
  CHECK(one.axes.empty());
}

TEST_CASE("affine_hull: a vertical segment and a tilted plane in space") {
  const AffineHull segment = affine_hull({{1, 2, 3}, {1, 2, 5}, {1, 2, -7}});
  CHECK(segment.dimension == 1);
  CHECK(segment.axes == std::vector<std::size_t>{2});
  const AffineHull plane = affine_hull({{0, 0, 0}, {1, 1, 0}, {2, 2, 0}, {0, 0, 1}, {1, 1, 1}});
  CHECK(plane.dimension == 2);
  CHECK(plane.basis == std::vector<std::size_t>{0, 1, 3});
}

TEST_CASE("affine_hull: the dimension is the rank by minors") {
  CHECK(holds_for_hulls([](const std::vector<Point>& points) {
    RC_ASSERT(affine_hull(points).dimension == generators::dimension_by_minors(points));
  }));
}

TEST_CASE("affine_hull: the basis is affinely independent, and the first such") {
  CHECK(holds_for_hulls([](const std::vector<Point>& points) {
    const AffineHull hull = affine_hull(points);
    RC_ASSERT(static_cast<int>(hull.basis.size()) == hull.dimension + 1);
    // They are the first such points: each point that is left out depends on those of the basis
    // before it.
    std::vector<std::size_t> greedy;
    for (std::size_t i = 0; i < points.size(); ++i) {
      greedy.push_back(i);
      const int dimension = generators::dimension_by_minors(some(points, greedy));
      if (dimension + 1 < static_cast<int>(greedy.size())) greedy.pop_back();
    }
    RC_ASSERT(hull.basis == greedy);
  }));
}

TEST_CASE("affine_hull: dropping all other coordinates is injective on the hull") {
  CHECK(holds_for_hulls([](const std::vector<Point>& points) {
    const AffineHull hull = affine_hull(points);
    RC_ASSERT(static_cast<int>(hull.axes.size()) == std::max(hull.dimension, 0));
    RC_ASSERT(std::is_sorted(hull.axes.begin(), hull.axes.end()));
    const auto images = generators::projected(points, hull.axes);
    RC_ASSERT(generators::dimension_by_minors(images) == hull.dimension);
  }));
}

}  // namespace

}  // namespace circumspect
