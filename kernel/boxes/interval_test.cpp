// Every number that an interval stands for is in the interval.
#include "kernel/boxes/interval.hpp"

#include <cmath>
#include <random>

#include <doctest/doctest.h>

namespace circumspect {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

bool holds(Interval interval, const Rational& value) {
  const bool from = interval.low == -kUnbounded || exact_value(interval.low) <= value;
  return from && (interval.high == kUnbounded || exact_value(interval.high) >= value);
}

// Doubles of all sizes: small integers, any bits near one, and near the ends of the range.
class Doubles {
 public:
  double next() {
    const int size = static_cast<int>(random_() % 5);
    if (size == 0) return static_cast<double>(random_() % 7) - 3;
    const double part = static_cast<double>(random_() >> 11) * 0x1p-53 * (random_() % 2 ? 1 : -1);
    const int exponents[] = {0, 3, 40, -530, -1070};
    return std::ldexp(part, exponents[size]);
  }
  std::size_t below(std::size_t n) { return random_() % n; }

 private:
  std::mt19937_64 random_{7};
};

TEST_CASE("interval: the result of each operation holds the exact one") {
  Doubles doubles;
  int strict = 0;
  for (int round = 0; round < 20000; ++round) {
    const double a = doubles.next(), b = doubles.next();
    const Rational x = exact_value(a), y = exact_value(b);
    REQUIRE(holds(exactly(a) + exactly(b), x + y));
    REQUIRE(holds(exactly(a) - exactly(b), x - y));
    REQUIRE(holds(exactly(a) * exactly(b), x * y));
    if (b != 0) REQUIRE(holds(exactly(a) / exactly(b), x / y));
    const Interval third = enclosing(x / 3);
    REQUIRE(holds(third, x / 3));
    REQUIRE(holds(third * third - exactly(b), x * x / 9 - y));
    strict += third.low < third.high ? 1 : 0;
  }
  CHECK(strict > 10000);
}

TEST_CASE("interval: a step of the rounding is not enough at the ends of the range") {
  // 2^-1074 is the least double above 0: a third of it is rounded to 0.
  const double least = 0x1p-1074;
  CHECK(holds(exactly(least) * exactly(0x1.5p-2), exact_value(least) * exact_value(0x1.5p-2)));
  CHECK(
      holds(exactly(0x1p-600) * exactly(0x1p-600), exact_value(0x1p-600) * exact_value(0x1p-600)));
  CHECK((exactly(0x1p1023) + exactly(0x1p1023)).high == kUnbounded);
  CHECK((exactly(0x1p1023) + exactly(0x1p1023)).low == -kUnbounded);
}

TEST_CASE("interval: what is infinite makes nothing certain") {
  const Interval unknown = {-kUnbounded, kUnbounded};
  CHECK(certain_sign(unknown + exactly(0)) == 0);
  for (const Interval other : {exactly(3), Interval{-1, 0}, unknown}) {
    for (const Interval result : {unknown + other, unknown - other, unknown * other}) {
      CHECK(certain_sign(result) == 0);
      CHECK_FALSE(std::isnan(result.low));
      CHECK_FALSE(std::isnan(result.high));
    }
  }
  CHECK(certain_sign(Interval{0, kUnbounded} * Interval{-kUnbounded, -1}) == 0);
  CHECK(certain_sign(exactly(NAN) * exactly(1)) == 0);
}

TEST_CASE("interval: a sign is certain if all numbers have it") {
  CHECK(certain_sign({1, 2}) == 1);
  CHECK(certain_sign({-2, -1}) == -1);
  CHECK(certain_sign({0, 1}) == 0);
  CHECK(certain_sign({-1, 1}) == 0);
  CHECK(certain_sign(exactly(0)) == 0);
}

TEST_CASE("interval: the distance to a box is never taken for larger than it is") {
  Doubles doubles;
  int positive = 0;
  for (int round = 0; round < 5000; ++round) {
    Triple<double> low, high;
    Triple<Interval> centre;
    Rational exact = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double a = doubles.next(), b = doubles.next();
      low[i] = std::min(a, b);
      high[i] = std::max(a, b);
      const Rational at = exact_value(doubles.next()) / (doubles.below(2) == 0 ? 1 : 3);
      centre[i] = enclosing(at);
      const Rational below = exact_value(low[i]) - at, above = at - exact_value(high[i]);
      if (below > 0) exact += below * below;
      if (above > 0) exact += above * above;
    }
    const double found = least_squared_distance(low, high, centre);
    REQUIRE(exact_value(found) <= exact);
    positive += found > 0 ? 1 : 0;
  }
  CHECK(positive > 1000);
}

}  // namespace
}  // namespace circumspect
