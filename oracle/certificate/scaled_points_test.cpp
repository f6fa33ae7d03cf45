// Points over one scale, and the sides of facets.
#include "oracle/certificate/scaled_points.hpp"

#include <array>
#include <random>

#include <doctest/doctest.h>

#include "oracle/certificate/separators.hpp"

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

// The same integers over the same scale as of the points, exactly.
TEST_CASE("doubles in rows are scaled like points") {
  std::mt19937_64 random(7);
  const double units[] = {0x1p-1074, 0x1p-60, 0.75, 6, 0x1p80};
  for (const double unit : units) {
    for (const bool has_zero : {false, true}) {
      UninitializedVector<double> values;
      std::vector<Point> points;
      for (std::size_t i = 0; i < 5; ++i) {
        Point point;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const auto x = static_cast<double>(static_cast<std::int64_t>(random() % 2000) - 1000);
          values.push_back(i == 0 && has_zero ? -0.0 : x * unit);
          point.push_back(exact_value(values.back()));
        }
        points.push_back(point);
      }
      const auto expected = scaled_to_integers(PointSet(points));
      const Rows<double> rows(std::move(values), 3);
      const auto found = scaled_to_integers(rows);
      CHECK(found->coordinates == expected->coordinates);
      CHECK(found->dimension == 3);
      CHECK(found->scale_numerator == expected->scale_numerator);
      CHECK(found->scale_denominator == expected->scale_denominator);
      // Refused where points are.
      for (const double most : {15., 150., 1500., 15000., 16124., 16125., 16126.}) {
        CHECK(scaled_to_integers(rows, most).has_value() ==
              scaled_to_integers(PointSet(points), most).has_value());
      }
    }
  }
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

TEST_CASE("orientations in the plane, with a rational point in each place") {
  const auto points = *scaled_to_integers(PointSet({{0, 0}, {4, 0}, {0, 4}, {7, 1}}));
  Sidedness sidedness(points);
  const Simplex triangle = {0, 1, 2};
  CHECK(sidedness.orientation(triangle) == 1);
  CHECK(sidedness.orientation(Simplex{1, 0, 2}) == -1);
  CHECK(sidedness.orientation(Simplex{0, 1, 1}) == 0);
  const HomogeneousPoint inside{{3, 2}, 2};
  const HomogeneousPoint on_edge{{5, 3}, 2};
  const HomogeneousPoint beyond{{9, 1}, 2};
  for (std::size_t place = 0; place < 3; ++place) {
    CHECK(sidedness.orientation_with(triangle, place, inside) == 1);
    CHECK(sidedness.orientation_with(triangle, place, on_edge) == (place == 0 ? 0 : 1));
    CHECK(sidedness.orientation_with(triangle, place, beyond) == (place == 0 ? -1 : 1));
  }
  for (const std::size_t first : {0u, 1u, 2u}) {
    CHECK(!sidedness.separating_place(triangle, 1, inside, first));
    CHECK(!sidedness.separating_place(triangle, 1, on_edge, first));
    CHECK(sidedness.separating_place(triangle, 1, beyond, first) == 0);
    CHECK(sidedness.separating_place(Simplex{0, 2, 1}, -1, beyond, first) == 0);
  }
}

TEST_CASE("orientations in space, with a rational point in each place") {
  const auto points = *scaled_to_integers(PointSet({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}));
  Sidedness sidedness(points);
  const Simplex simplex = {0, 1, 2, 3};
  CHECK(sidedness.orientation(simplex) == 1);
  CHECK(sidedness.orientation(Simplex{0, 1, 3, 2}) == -1);
  const HomogeneousPoint inside{{1, 1, 1}, 4};
  const HomogeneousPoint beyond{{-1, 1, 1}, 3};
  for (std::size_t place = 0; place < 4; ++place) {
    CHECK(sidedness.orientation_with(simplex, place, inside) == 1);
    CHECK(sidedness.orientation_with(simplex, place, beyond) == (place == 0 ? -1 : 1));
  }
  CHECK(!sidedness.separating_place(simplex, 1, inside));
  CHECK(sidedness.separating_place(simplex, 1, beyond) == 0);
}

// A fresh one asks integers alone.
TEST_CASE("orientations are the same whether doubles are asked first or not") {
  std::mt19937_64 random(5);
  std::size_t zeros = 0;
  for (const std::size_t d : {2u, 3u}) {
    for (int round = 0; round < 60; ++round) {
      ScaledPoints points{d};
      const int bits = std::array{2, 40, 54, 200}[static_cast<std::size_t>(round) % 4];
      for (std::size_t i = 0; i < 6 * d; ++i) {
        Integer x = to_integer(static_cast<std::int64_t>(random() % 4));
        x <<= static_cast<unsigned>(bits);
        points.coordinates.push_back(x + to_integer(static_cast<std::int64_t>(random() % 2)));
      }
      Sidedness used(points);
      for (int call = 0; call < 40; ++call) {
        Simplex simplex;
        for (std::size_t i = 0; i <= d; ++i) simplex.push_back(static_cast<Vertex>(random() % 6));
        const int expected = Sidedness(points).orientation(simplex);
        CHECK(used.orientation(simplex) == expected);
        zeros += expected == 0 ? 1u : 0u;
        // A third of a sum is no double.
        const auto some = static_cast<std::ptrdiff_t>(1 + random() % (d + 1));
        const HomogeneousPoint q =
            barycentre(points, Simplex(simplex.begin(), simplex.begin() + some));
        const std::size_t place = random() % (d + 1);
        CHECK(used.orientation_with(simplex, place, q) ==
              Sidedness(points).orientation_with(simplex, place, q));
      }
    }
  }
  CHECK(zeros > 100);
  CHECK(zeros < 4000);
}

TEST_CASE("separators: a way past a segment and a vertex, up to a vertex, and through a wall") {
  const std::vector<std::vector<Point>> parts = {{{0, 1}, {4, 0}}, {{0, 1}}};
  const auto past = separators(parts, {0, 0}, {3, 0}, true);
  REQUIRE(past);
  CHECK(past->count == 1);  // one line does for both
  CHECK(!separators(parts, {0, 0}, {4, 0}, true));
  CHECK(separators(parts, {0, 0}, {4, 0}, false));
  CHECK(!separators(parts, {0, 0}, {4, 4}, false));
}

TEST_CASE("separators: beside and through a triangle") {
  const std::vector<std::vector<Point>> parts = {{{0, 0, 0}, {6, 0, 0}, {0, 6, 0}}};
  CHECK(separators(parts, {4, 4, 1}, {4, 4, -1}, true));
  CHECK(separators(parts, {1, 1, 1}, {2, 2, Rational(1, 9)}, true));
  CHECK(!separators(parts, {1, 1, 1}, {2, 2, -1}, true));
  CHECK(!separators(parts, {1, 1, 1}, {2, 2, 0}, true));
  CHECK(separators(parts, {1, 1, 1}, {2, 2, 0}, false));
}

}  // namespace

}  // namespace circumspect::certificate
