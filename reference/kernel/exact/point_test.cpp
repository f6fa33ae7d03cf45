// Points as vectors.
#include "reference/kernel/exact/point.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "inputs/scalars.hpp"

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
  CHECK(rc::check([] {
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

TEST_CASE("point: the barycentre balances the vertices, in any order of them") {
  CHECK(rc::check([] {
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

}  // namespace
}  // namespace circumspect
