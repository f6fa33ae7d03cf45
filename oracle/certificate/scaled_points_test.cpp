#include "oracle/certificate/scaled_points.hpp"

#include <doctest/doctest.h>

namespace circumspect::certificate {
namespace {

using Integers = std::vector<Integer>;

void check_scale(const ScaledPoints& points, long numerator, long denominator) {
  CHECK(points.scale_numerator == numerator);
  CHECK(points.scale_denominator == denominator);
}

TEST_CASE("fractions are multiplied by their least common denominator") {
  const auto points = scaled_to_integers(PointSet({{0, 0}, {Rational(1, 2), Rational(-1, 3)}}));
  CHECK(points->coordinates == Integers{0, 0, 3, -2});
  check_scale(*points, 1, 6);
  CHECK(points->size() == 2);
  CHECK(points->weights.empty());
}

TEST_CASE("what all coordinates have in common is divided out") {
  const auto points = scaled_to_integers(PointSet({{0, 0}, {6, 4}, {Rational(-2, 5), 0}}));
  CHECK(points->coordinates == Integers{0, 0, 15, 10, -1, 0});
  check_scale(*points, 2, 5);
  const auto origin = scaled_to_integers(PointSet({{0, 0}}));
  CHECK(origin->coordinates == Integers{0, 0});
  check_scale(*origin, 1, 1);
}

TEST_CASE("doubles become integers whatever their exponents") {
  const auto points = scaled_to_integers(PointSet({{exact_value(0x1p-1074), 0}, {0, 3}}));
  CHECK(points->scale_denominator == Integer(1) << 1074);
  CHECK(points->coordinates == Integers{1, 0, 0, Integer(3) << 1074});
}

// Weights are integers over the square of the scale.
TEST_CASE("weights make the scale no finer than they must") {
  const std::vector<Point> corners = {{0, 0}, {2, 0}, {0, 2}};
  const auto even = scaled_to_integers(PointSet(corners, {4, 0, -8}));
  CHECK(even->coordinates == Integers{0, 0, 1, 0, 0, 1});
  CHECK(even->weights == Integers{1, 0, -2});
  check_scale(*even, 2, 1);
  // 1/2 is 1/8 of the square of 2, and 4² a multiple of 8.
  const auto half = scaled_to_integers(PointSet(corners, {Rational(1, 2), 0, 1}));
  CHECK(half->coordinates == Integers{0, 0, 4, 0, 0, 4});
  CHECK(half->weights == Integers{2, 0, 4});
  check_scale(*half, 1, 2);
  const auto large_prime = scaled_to_integers(PointSet(corners, {Rational(4, 1009L * 1009), 0, 0}));
  CHECK(large_prime->coordinates == Integers{0, 0, 1009, 0, 0, 1009});
  CHECK(large_prime->weights == Integers{1, 0, 0});
  const auto no_square = scaled_to_integers(PointSet(corners, {Rational(4, 1009), 0, 0}));
  CHECK(no_square->weights == Integers{1009, 0, 0});
}

TEST_CASE("denominators with too little in common are refused") {
  const PointSet points({{Rational(1, 1009), 0}, {Rational(1, 1013), 1}});
  CHECK(scaled_to_integers(points, 100));
  const auto refused = scaled_to_integers(points, 50);
  REQUIRE(!refused);
  CHECK(refused.error().find("so little in common") != std::string::npos);
}

TEST_CASE("points among the integers are in lowest terms") {
  const auto points = *scaled_to_integers(PointSet({{0, 0}, {2, 0}, {0, 2}}));
  const HomogeneousPoint middle = barycentre(points, {1, 2});
  CHECK(middle.numerators == Integers{1, 1});
  CHECK(middle.denominator == 2);
  const HomogeneousPoint corner = barycentre(points, {1});
  CHECK(corner.numerators == Integers{1, 0});
  CHECK(corner.denominator == 1);
  const HomogeneousPoint moved = scaled(points, {Rational(1, 3), 1});
  CHECK(moved.numerators == Integers{1, 3});
  CHECK(moved.denominator == 6);
}

}  // namespace
}  // namespace circumspect::certificate
