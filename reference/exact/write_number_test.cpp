// Laws of writing: exact text comes back as it was, decimals are the nearest ones.
#include "reference/exact/write_number.hpp"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "reference/exact/read_number.hpp"

namespace circumspect {
namespace {

constexpr NumberReading kDouble = NumberReading::kDouble;

Rational fraction(const Integer& above, const Integer& below) {
  Rational value(above, below);
  value.canonicalize();
  return value;
}

double from_bits(std::uint64_t bits) {
  double result;
  std::memcpy(&result, &bits, sizeof result);
  return result;
}

Integer power_of_two(unsigned long exponent) { return Integer(1) << exponent; }

}  // namespace

TEST_CASE("exact values in lowest terms") {
  CHECK(to_string(Integer(-7)) == "-7");
  CHECK(to_string(fraction(-2, 6)) == "-1/3");
  CHECK(to_string(Rational(4)) == "4");
}

TEST_CASE("doubles as short decimals, all else as fractions") {
  CHECK(to_text_of_double_or_fraction(exact_value(0.1)) == "0.1");
  CHECK(to_text_of_double_or_fraction(0) == "0");
  CHECK(to_text_of_double_or_fraction(-3) == "-3");
  CHECK(to_text_of_double_or_fraction(Rational(1, 10)) == "1/10");
  CHECK(to_text_of_double_or_fraction(exact_value(5e-324)) == "5e-324");
  CHECK(to_text_of_double_or_fraction(exact_value(1e300)) == "1e+300");
}

TEST_CASE("an integer that is no double keeps a denominator, or it would be read as one") {
  const Rational odd = power_of_two(53) + 1;
  CHECK(to_text_of_double_or_fraction(odd) == "9007199254740993/1");
  CHECK(read_number(to_text_of_double_or_fraction(odd), kDouble) == odd);
  const Rational huge = power_of_two(2000);
  CHECK(read_number(to_text_of_double_or_fraction(huge), kDouble) == huge);
  const Rational tiny(1, power_of_two(1075));
  CHECK(read_number(to_text_of_double_or_fraction(tiny), kDouble) == tiny);
}

TEST_CASE("what is written is read back as the same value") {
  CHECK(rc::check("doubles", [](std::uint64_t bits) {
    const double x = from_bits(bits);
    RC_PRE(std::isfinite(x));
    const std::string text = to_text_of_double_or_fraction(exact_value(x));
    RC_ASSERT(text.find('/') == std::string::npos);
    RC_ASSERT(read_number(text, kDouble) == exact_value(x));
  }));
  CHECK(rc::check("subnormal doubles", [](std::uint32_t bits) {
    const std::string text = to_text_of_double_or_fraction(exact_value(from_bits(bits)));
    RC_ASSERT(text.find('/') == std::string::npos);
    RC_ASSERT(read_number(text, kDouble) == exact_value(from_bits(bits)));
  }));
  CHECK(rc::check("fractions of all magnitudes",
                  [](std::int64_t above, std::uint32_t below, std::uint8_t shift) {
                    RC_PRE(below > 0U);
                    const Integer scale = power_of_two(shift * 8UL);
                    const Integer numerator = static_cast<long>(above);
                    for (const Rational& x :
                         {fraction(numerator * scale, below), fraction(numerator, below * scale)}) {
                      RC_ASSERT(read_number(to_text_of_double_or_fraction(x), kDouble) == x);
                    }
                  }));
}

TEST_CASE("decimals are correctly rounded") {
  CHECK(to_decimal(Rational(1, 3)) == "0.3333333333333333");
  CHECK(to_decimal(Rational(2, 3)) == "0.6666666666666666");
  CHECK(to_decimal(Rational(1, 10)) == "0.1");
  CHECK(to_decimal(Rational(-7, 2)) == "-3.5");
  CHECK(to_decimal(0) == "0");
  // Ties go to the even neighbour.
  CHECK(to_decimal(power_of_two(53) + 1) == "9007199254740992");
  CHECK(to_decimal(power_of_two(53) + 3) == "9007199254740996");
  CHECK(to_decimal(power_of_two(2000)) == "1.1481306952742545e+602");
  CHECK(to_decimal(Rational(1, power_of_two(1074))) == "4.9406564584124654e-324");
  CHECK(rc::check("as strtod rounds the same decimal", [](std::int64_t digits, std::int16_t e) {
    const std::string token = std::to_string(digits) + "e" + std::to_string(e % 280);
    const Rational exact = *read_number(token, NumberReading::kDecimal);
    RC_ASSERT(std::strtod(to_decimal(exact).c_str(), nullptr) ==
              std::strtod(token.c_str(), nullptr));
  }));
}

TEST_CASE("square roots are correctly rounded") {
  CHECK(square_root_to_decimal(0) == "0");
  CHECK(square_root_to_decimal(Rational(9, 4)) == "1.5");
  CHECK(square_root_to_decimal(2) == "1.4142135623730951");
  CHECK(square_root_to_decimal(3) == "1.7320508075688772");
  CHECK(square_root_to_decimal(Rational(1, 2)) == "0.7071067811865476");
  // The root lies just above a midpoint of two doubles: a first guess at 53 bits would miss it.
  const Rational midpoint = power_of_two(53) + 1;
  const Rational just_above = midpoint * midpoint + Rational(1, power_of_two(300));
  CHECK(square_root_to_decimal(midpoint * midpoint) == "9007199254740992");
  CHECK(square_root_to_decimal(just_above) == "9007199254740994");
  CHECK(square_root_to_decimal(midpoint * midpoint - Rational(1, power_of_two(300))) ==
        "9007199254740992");
  CHECK(rc::check("as sqrt rounds the root of a double", [](std::uint64_t bits) {
    const double x = std::fabs(from_bits(bits));
    RC_PRE(std::isfinite(x));
    RC_ASSERT(std::strtod(square_root_to_decimal(exact_value(x)).c_str(), nullptr) == std::sqrt(x));
  }));
}

}  // namespace circumspect
