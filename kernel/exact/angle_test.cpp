// Angles against degrees: equal where they are, and told apart where they all but are.
#include "kernel/exact/angle.hpp"

#include <cmath>

#include <doctest/doctest.h>

#include "kernel/exact/number_text.hpp"

namespace circumspect {
namespace {

Rational decimal(const char* text) { return read_number(text, NumberReading::kDecimal).value(); }

TEST_CASE("angles with rational degrees and rational squares are equal to them") {
  const std::pair<int, Rational> kAngles[] = {
      {0, Rational(1)},       {30, Rational(3, 4)},   {45, Rational(1, 2)},
      {60, Rational(1, 4)},   {90, Rational(0)},      {120, Rational(-1, 4)},
      {135, Rational(-1, 2)}, {150, Rational(-3, 4)}, {180, Rational(-1)}};
  const Rational little = decimal("1e-200");
  for (const auto& angle : kAngles) {
    const int degrees = angle.first;
    const Rational& square = angle.second;
    CAPTURE(degrees);
    CHECK(compare_angle(square, degrees) == 0);
    CHECK(degrees_to_decimal(square) == std::to_string(degrees));
    // Near misses, on both sides.
    if (degrees < 180) CHECK(compare_angle(square - little, degrees) == 1);
    if (degrees < 180) CHECK(compare_angle(square, degrees + little) == -1);
    if (degrees > 0) CHECK(compare_angle(square + little, degrees) == -1);
    if (degrees > 0) CHECK(compare_angle(square, degrees - little) == 1);
  }
}

TEST_CASE("angles are in the order of their degrees") {
  const Rational squares[] = {Rational(1), Rational(9, 10), Rational(1, 3),  Rational(1, 1000000),
                              Rational(0), Rational(-1, 9), Rational(-2, 3), Rational(-1)};
  for (const Rational& square : squares) {
    const double size = std::sqrt(std::fabs(square.get_d()));
    const double angle = std::acos(sign(square) < 0 ? -size : size) * (180 / M_PI);
    for (int degrees = 0; degrees <= 180; ++degrees) {
      CAPTURE(square.get_str());
      CAPTURE(degrees);
      const int expected = angle > degrees + 1e-9 ? 1 : angle < degrees - 1e-9 ? -1 : 0;
      CHECK(compare_angle(square, degrees) == expected);
    }
  }
}

// The arc cosine of 1/3 begins 70.52877936550930863075400066003756403699315689909205…
TEST_CASE("an angle is told from its first fifty digits") {
  const Rational below = decimal("70.52877936550930863075400066003756403699315689909205");
  const Rational above = decimal("70.52877936550930863075400066003756403699315689909206");
  CHECK(compare_angle(Rational(1, 9), below) == 1);
  CHECK(compare_angle(Rational(1, 9), above) == -1);
  CHECK(compare_angle(Rational(-1, 9), 180 - below) == -1);
  CHECK(compare_angle(Rational(-1, 9), 180 - above) == 1);
  CHECK(degrees_to_decimal(Rational(1, 9)) == "70.52877936550931");
  CHECK(degrees_to_decimal(Rational(-1, 9)) == "109.47122063449069");
  CHECK(degrees_to_decimal(Rational(9, 10)) == "18.43494882292201");
}

TEST_CASE("doubles enclose the square of a number of degrees") {
  for (int tenths = 0; tenths <= 1800; ++tenths) {
    const Rational degrees = Rational(tenths) / 10;
    const auto [low, high] = signed_square_of_degrees(degrees);
    CHECK(low <= high);
    CHECK(high - low <= 0x1p-52);
    CHECK(compare_angle(exact_value(low), degrees) >= 0);
    CHECK(compare_angle(exact_value(high), degrees) <= 0);
  }
}

TEST_CASE("excess in degrees: angles with rational degrees, and their sums, exactly") {
  const Rational half(1, 2), quarter(1, 4), three_quarters(3, 4);
  CHECK(excess_in_degrees(0, 0) == "0");
  CHECK(excess_in_degrees(-1, 0) == "90");                      // 180 + 90
  CHECK(excess_in_degrees(-half, -half) == "90");               // 135 + 135
  CHECK(excess_in_degrees(-quarter, -three_quarters) == "90");  // 120 + 150
  CHECK(excess_in_degrees(-quarter, half) == "-15");            // 120 + 45
  CHECK(excess_in_degrees(half, -half) == "0");
  CHECK(excess_in_degrees(1, 1) == "-180");
  CHECK(excess_in_degrees(-1, -1) == "180");
}

TEST_CASE("excess in degrees: tiny ones are not lost among the sum") {
  // cos² differ by 10^-40, at 90 degrees: the angle is about 10^-20 of a radian.
  const Rational tiny(1, Integer("10000000000000000000000000000000000000000"));
  CHECK(excess_in_degrees(0, -tiny) == "5.729577951308232e-19");
  CHECK(excess_in_degrees(tiny, 0) == "-5.729577951308232e-19");
}

}  // namespace
}  // namespace circumspect
