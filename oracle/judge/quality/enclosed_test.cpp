// The bounds of the filter before exact measures: each operation encloses what exact numbers say of
// it, and nothing depends on the scale.
#include "oracle/judge/quality/enclosed.hpp"

#include <cmath>
#include <random>

#include <doctest/doctest.h>

#include "kernel/exact/number.hpp"
#include "oracle/judge/quality/enclosed_mesh.hpp"
#include "oracle/judge/quality/filtered.hpp"
#include "oracle/judge/quality/magnitude.hpp"
#include "oracle/model/mesh.hpp"

namespace circumspect::quality {
namespace {

// Of many sizes, some so small that products of them underflow.
double drawn_double(std::mt19937_64& random) {
  const double mantissa = 1 + std::ldexp(static_cast<double>(random() >> 12), -52);
  const int exponent = random() % 4 == 0 ? -520 - static_cast<int>(random() % 20)
                                         : static_cast<int>(random() % 8) - 4;
  return std::ldexp(random() % 2 == 0 ? mantissa : -mantissa, exponent);
}

// A number and where it may be: at either end of an interval, or at its middle.
struct Somewhere {
  Enclosed enclosed;
  Rational exact;
};
Somewhere drawn_somewhere(std::mt19937_64& random, double most_error) {
  const double value = drawn_double(random);
  const double error = random() % 2 == 0 ? 0 : std::fabs(value) * most_error;
  const long end = static_cast<long>(random() % 3) - 1;
  return {{value, error}, exact_value(value) + end * exact_value(error)};
}

bool encloses(const Enclosed& enclosed, const Rational& exact) {
  if (!std::isfinite(enclosed.value) || !std::isfinite(enclosed.error)) return true;
  return abs(exact - exact_value(enclosed.value)) <=
         exact_value(enclosed.error) * (1 + exact_value(Enclosed::kLoss));
}

TEST_CASE("each operation on enclosed numbers encloses what it is of exact ones") {
  std::mt19937_64 random(1);
  std::size_t divided = 0;
  for (int round = 0; round < 4000; ++round) {
    const double most_error = std::ldexp(1.0, -static_cast<int>(random() % 50));
    const Somewhere a = drawn_somewhere(random, most_error),
                    b = drawn_somewhere(random, most_error);
    CAPTURE(round);
    CHECK(encloses(a.enclosed + b.enclosed, a.exact + b.exact));
    CHECK(encloses(a.enclosed - b.enclosed, a.exact - b.exact));
    CHECK(encloses(a.enclosed * b.enclosed, a.exact * b.exact));
    CHECK(encloses(4 * a.enclosed, 4 * a.exact));
    CHECK(encloses(signed_square(a.enclosed), a.exact * abs(a.exact)));
    CHECK(encloses(larger(a.enclosed, b.enclosed), std::max(a.exact, b.exact)));
    CHECK(encloses(smaller(a.enclosed, b.enclosed), std::min(a.exact, b.exact)));
    const Enclosed quotient = a.enclosed / b.enclosed;
    if (sign(b.exact) != 0) CHECK(encloses(quotient, a.exact / b.exact));
    divided += std::isfinite(quotient.error) ? 1 : 0;
  }
  CHECK(divided > 1000);
}

TEST_CASE("what bounds a measure is within what doubles know of it") {
  for (long tenth = 1; tenth < 1800; tenth += 7) {
    const Rational bound(tenth, 10);
    CHECK(encloses(enclosed_bound(Measure::kEdge, bound), bound));
    const DoubleRange angle = signed_square_of_degrees(bound);
    for (const double end : {angle.low, angle.high}) {
      CHECK(encloses(enclosed_bound(Measure::kMinAngle, bound), exact_value(end)));
    }
  }
}

TEST_CASE("nothing is certain of a quotient whose divisor may be half of what it is taken for") {
  for (const double divisor : {1.0, 0x1p-500, 3e200}) {
    CHECK(std::isfinite((Enclosed{1, 0} / Enclosed{divisor, divisor * 0.49}).error));
    CHECK(!std::isfinite((Enclosed{1, 0} / Enclosed{divisor, divisor * 0.5}).error));
  }
}

TEST_CASE("a squared length is within its bounds, of one edge and of all edges up to the longest") {
  std::mt19937_64 random(1);
  for (int round = 0; round < 4000; ++round) {
    double a[3], b[3];
    Rational exact = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      a[axis] = drawn_double(random);
      b[axis] = drawn_double(random);
      const Rational difference = exact_value(a[axis]) - exact_value(b[axis]);
      exact += difference * difference;
    }
    const double rounded = rounded_squared_distance<3>(a, b);
    CHECK(encloses(enclosed_squared_distance(rounded), exact));
    if (rounded < kLeastScale) continue;
    CHECK(abs(exact - exact_value(rounded)) <=
          exact_value(Magnitude::of_squared_length().error) * exact_value(rounded));
  }
}

// Ratios and angles do not change, wherever doubles begin to underflow or overflow.
TEST_CASE("what keeps a ratio or an angle keeps it at every scale") {
  std::mt19937_64 random(1);
  for (int round = 0; round < 4; ++round) {
    std::vector<Point> points;
    for (int i = 0; i < 6; ++i) {
      points.push_back({static_cast<long>(random() % 8), static_cast<long>(random() % 8),
                        Rational(static_cast<long>(random() % 8), 1 << (random() % 20))});
    }
    const std::vector<Simplex> simplices = {{0, 1, 2, 3}, {1, 2, 3, 4}, {2, 3, 4, 5}, {0, 2, 4, 5}};
    const auto broken = [&](int exponent) {
      std::vector<Point> scaled;
      const Rational unit = exact_value(std::ldexp(1.0, exponent));
      for (const Point& point : points) scaled.push_back(circumspect::operator*(unit, point));
      Mesh mesh;
      mesh.coordinates = numbers_of(scaled, 3);
      mesh.simplices = IndexLists(simplices);
      std::vector<Requirement> requirements;
      for (const char* const text : {"min-dihedral:30deg", "max-dihedral:90deg", "min-angle:30deg",
                                     "max-angle:90deg", "radius-edge:1", "aspect-ratio:2"}) {
        requirements.push_back(read_requirement(text).value());
      }
      return violators(mesh, requirements, 1);
    };
    const auto expected = broken(0);
    for (int exponent = -980; exponent <= 980; exponent += 70) {
      CAPTURE(exponent);
      CHECK(broken(exponent) == expected);
    }
  }
}

}  // namespace
}  // namespace circumspect::quality
