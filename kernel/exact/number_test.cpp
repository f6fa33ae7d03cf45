// Numbers in text, and numbers too large for the memory.
#include "kernel/exact/number.hpp"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>

#include <doctest/doctest.h>
#include <rapidcheck.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "kernel/exact/int64.hpp"
#include "kernel/exact/number_text.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect {

// Exact numbers and text, both ways.

namespace {

constexpr NumberReading kDouble = NumberReading::kDouble;
constexpr NumberReading kDecimal = NumberReading::kDecimal;

Rational value(const std::string& token, NumberReading reading) {
  const auto number = read_number(token, reading);
  REQUIRE_MESSAGE(number.has_value(), token);
  return *number;
}

std::string expected_instead(const std::string& token, NumberReading reading) {
  const auto number = read_number(token, reading);
  return number ? "a number" : number.error().expected;
}

double from_bits(std::uint64_t bits) {
  double result;
  std::memcpy(&result, &bits, sizeof result);
  return result;
}

}  // namespace

TEST_CASE("decimals at their word") {
  CHECK(value("0.1", kDecimal) == Rational(1, 10));
  CHECK(value("-12.50e-1", kDecimal) == Rational(-5, 4));
  CHECK(value("+3.", kDecimal) == 3);
  CHECK(value(".5E+2", kDecimal) == 50);
  CHECK(value("-0.0", kDecimal) == 0);
  CHECK(value("007", kDecimal) == 7);
  CHECK(value("1e1000", kDecimal) == Integer("1" + std::string(1000, '0')));
  CHECK(value("0e1000", kDecimal) == 0);
}

TEST_CASE("integers of 64 bits and no others are converted back") {
  constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();
  for (const std::int64_t value : {std::int64_t{0}, std::int64_t{-1}, kMost, -kMost, -kMost - 1,
                                   std::int64_t{1} << 32U, -(std::int64_t{1} << 31U) - 1}) {
    CHECK(to_int64(to_integer(value)) == value);
  }
  CHECK(!to_int64(to_integer(kMost) + 1));
  CHECK(!to_int64(-to_integer(kMost) - 2));
  CHECK(!to_int64(Integer(1) << 64U));
}

TEST_CASE("decimals as doubles") {
  CHECK(value("0.1", kDouble) == exact_value(0.1));
  CHECK(value("0.1", kDouble) != Rational(1, 10));
  CHECK(value("9007199254740993", kDouble) == Integer("9007199254740992"));
  CHECK(value("4.9e-324", kDouble) == exact_value(std::strtod("4.9e-324", nullptr)));
  CHECK(value("2.2250738585072011e-308", kDouble) == exact_value(2.2250738585072011e-308));
  CHECK(value("1e-400", kDouble) == 0);
  CHECK(value("-1e-99999999999999999999", kDouble) == 0);
  CHECK(value("0." + std::string(400, '0') + "1e50", kDouble) == 0);
  CHECK(value("0." + std::string(400, '0') + "1e410", kDouble) == exact_value(1e9));
  CHECK(!read_number("+" + std::string(310, '9'), kDouble));
  CHECK(!read_number("0.001e99999999999999999999", kDouble));
  CHECK(value("1.7976931348623157e308", kDouble) == exact_value(1.7976931348623157e308));
}

TEST_CASE("hexadecimal floats and fractions are exact in both readings") {
  for (const NumberReading reading : {kDouble, kDecimal}) {
    CHECK(value("0x1.8p+0", reading) == Rational(3, 2));
    CHECK(value("-0X.8P1", reading) == -1);
    CHECK(value("0x1.00000000000000001p0", reading) ==
          Rational(Integer("0x100000000000000001"), Integer("0x100000000000000000")));
    CHECK(value("0xff", reading) == 255);
    CHECK(value("0x1e5", reading) == 485);
    CHECK(value("1/3", reading) == Rational(1, 3));
    CHECK(value("-2/4", reading) == Rational(-1, 2));
    CHECK(value("+0/7", reading) == 0);
    CHECK(value("9007199254740993/1", reading) == Integer("9007199254740993"));
  }
}

TEST_CASE("what is not a number") {
  for (const char* token :
       {"",     "+",    "-",         ".",   "e5",    "1e",  "1e+",   "0x",   "0x.",
        "0xp1", "0x1p", "1.2.3",     "1,5", "--1",   "+-1", " 1",    "1 ",   "nan",
        "NAN",  "inf",  "-infinity", "1d3", "1e5.5", "0b1", "1'000", "1_000"}) {
    for (const NumberReading reading : {kDouble, kDecimal}) {
      CHECK_MESSAGE(expected_instead(token, reading) == "a finite number", token);
    }
  }
  CHECK(expected_instead(std::string("1\0", 2), kDouble) == "a finite number");
  const std::string fraction = "a fraction of two integers such as -1/3";
  for (const char* token : {"/", "1/", "/3", "1/-3", "1/+3", "1/2/3", "1.5/2", "1/0x2", "x/2"}) {
    CHECK_MESSAGE(expected_instead(token, kDouble) == fraction, token);
  }
  CHECK(expected_instead("1/0", kDouble) == "a denominator other than zero");
  CHECK(expected_instead("0/00", kDecimal) == "a denominator other than zero");
}

TEST_CASE("ten bytes do not become a gigabyte of digits") {
  const std::string decimal = "an exponent between -1000 and 1000";
  const std::string binary = "an exponent between -5000 and 5000";
  CHECK(expected_instead("1e1001", kDecimal) == decimal);
  CHECK(expected_instead("1e-1001", kDecimal) == decimal);
  CHECK(expected_instead("1e999999999", kDecimal) == decimal);
  CHECK(expected_instead("0e99999999999999999999", kDecimal) == decimal);
  CHECK(expected_instead("1e-99999999999999999999", kDecimal) == decimal);
  CHECK(expected_instead("0x1p5001", kDouble) == binary);
  CHECK(expected_instead("0x1p-99999999999999999999", kDouble) == binary);
  CHECK(expected_instead("1e400", kDouble) ==
        "a number within the range of double (--coordinates decimal reads more)");
  CHECK(value("1e-999999999", kDouble) == 0);
}

TEST_CASE("no double equals a third, one that has too many bits, or one that is too large") {
  const Rational large = exact_value(0x1p1023);
  CHECK(as_double(large) == 0x1p1023);
  for (const Rational& value : {Rational(1, 3), Rational(1 + 1 / large), Rational(2 * large)}) {
    CHECK(!as_double(value));
    CHECK(!as_double(-value));
  }
}

TEST_CASE("any double, printed with 17 digits or in hexadecimal, is read as itself") {
  CHECK(properties::holds("doubles of all magnitudes, subnormal ones too", [] {
    const auto bits = *rc::gen::arbitrary<std::uint64_t>();
    const double x = from_bits(bits);
    RC_PRE(std::isfinite(x));
    char text[64];
    std::snprintf(text, sizeof text, "%.17g", x);
    RC_ASSERT(read_number(text, kDouble) == exact_value(x));
    std::snprintf(text, sizeof text, "%a", x);
    RC_ASSERT(read_number(text, kDouble) == exact_value(x));
    RC_ASSERT(read_number(text, kDecimal) == exact_value(x));
    RC_ASSERT(as_double(exact_value(x)) == x);
    const Rational beside = exact_value(x) * (1 + 1 / exact_value(0x1p70));  // of too many bits
    RC_ASSERT(x == 0 || !as_double(beside));
  }));
  CHECK(properties::holds("subnormal doubles", [] {
    const auto bits = *rc::gen::arbitrary<std::uint32_t>();
    char text[64];
    std::snprintf(text, sizeof text, "%.17g", from_bits(bits));
    RC_ASSERT(read_number(text, kDouble) == exact_value(from_bits(bits)));
  }));
}

TEST_CASE("a double reading is the decimal reading, rounded as strtod rounds") {
  CHECK(properties::holds("short decimals", [] {
    const auto digits = *rc::gen::arbitrary<std::int64_t>();
    const auto exponent = *rc::gen::arbitrary<std::int16_t>();
    const std::string token = std::to_string(digits) + "e" + std::to_string(exponent % 280);
    const double nearest = std::strtod(token.c_str(), nullptr);
    RC_ASSERT(read_number(token, kDouble) == exact_value(nearest));
    // Nearest: neither neighbour is closer to what was written.
    const Rational exact = *read_number(token, kDecimal);
    const Rational error = abs(exact - exact_value(nearest));
    RC_ASSERT(error <= abs(exact - exact_value(std::nextafter(nearest, INFINITY))));
    RC_ASSERT(error <= abs(exact - exact_value(std::nextafter(nearest, -INFINITY))));
  }));
}

namespace {

Rational fraction(const Integer& above, const Integer& below) {
  Rational value(above, below);
  value.canonicalize();
  return value;
}

Integer power_of_two(unsigned long exponent) { return Integer(1) << exponent; }

}  // namespace

TEST_CASE("numbers over a common denominator are integers, and no smaller one will do") {
  const std::vector<Rational> numbers = {Rational(-3, 4), Rational(5, 6), 7};
  const Integer common = common_denominator(numbers);
  CHECK(common == 12);
  CHECK(common_denominator({}) == 1);
  CHECK(common_denominator(numbers, 10) == 60);
  CHECK(common_denominator(numbers, 24) == 24);
  CHECK(numerator_over(common, numbers[0]) == -9);
  CHECK(numerator_over(common, numbers[1]) == 10);
  CHECK(numerator_over(common, numbers[2]) == 84);
}

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

TEST_CASE("an integer that is not a double keeps a denominator, or it would be read as one") {
  const Rational odd = power_of_two(53) + 1;
  CHECK(to_text_of_double_or_fraction(odd) == "9007199254740993/1");
  CHECK(read_number(to_text_of_double_or_fraction(odd), kDouble) == odd);
  const Rational huge = power_of_two(2000);
  CHECK(read_number(to_text_of_double_or_fraction(huge), kDouble) == huge);
  const Rational tiny(1, power_of_two(1075));
  CHECK(read_number(to_text_of_double_or_fraction(tiny), kDouble) == tiny);
}

TEST_CASE("what is written is read back as the same value") {
  CHECK(properties::holds("doubles", [] {
    const auto bits = *rc::gen::arbitrary<std::uint64_t>();
    const double x = from_bits(bits);
    RC_PRE(std::isfinite(x));
    const std::string text = to_text_of_double_or_fraction(exact_value(x));
    RC_ASSERT(text.find('/') == std::string::npos);
    RC_ASSERT(read_number(text, kDouble) == exact_value(x));
  }));
  CHECK(properties::holds("subnormal doubles", [] {
    const auto bits = *rc::gen::arbitrary<std::uint32_t>();
    const std::string text = to_text_of_double_or_fraction(exact_value(from_bits(bits)));
    RC_ASSERT(text.find('/') == std::string::npos);
    RC_ASSERT(read_number(text, kDouble) == exact_value(from_bits(bits)));
  }));
  CHECK(properties::holds("fractions of all magnitudes", [] {
    const auto above = *rc::gen::arbitrary<std::int64_t>();
    const auto below = *rc::gen::arbitrary<std::uint32_t>();
    const auto shift = *rc::gen::arbitrary<std::uint8_t>();
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
  CHECK(properties::holds("as strtod rounds the same decimal", [] {
    const auto digits = *rc::gen::arbitrary<std::int64_t>();
    const auto e = *rc::gen::arbitrary<std::int16_t>();
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
  CHECK(properties::holds("as sqrt rounds the root of a double", [] {
    const auto bits = *rc::gen::arbitrary<std::uint64_t>();
    const double x = std::fabs(from_bits(bits));
    RC_PRE(std::isfinite(x));
    RC_ASSERT(std::strtod(square_root_to_decimal(exact_value(x)).c_str(), nullptr) == std::sqrt(x));
  }));
}

// AddressSanitizer takes more address space than any limit.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__clang__)
#define HAS_LIMITS true
#else
#define HAS_LIMITS false
#endif

TEST_CASE("a number that exhausts the memory ends the process as it was told" *
          doctest::skip(!HAS_LIMITS)) {
  const pid_t child = fork();
  if (child == 0) {
    const rlimit limit = {rlim_t{1} << 30, rlim_t{1} << 30};
    setrlimit(RLIMIT_AS, &limit);
    end_where_numbers_exhaust_memory([] { _exit(5); });
    Integer large = 1;
    large <<= std::size_t{1} << 35;  // bits
    _exit(0);
  }
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  REQUIRE(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 5);
}

}  // namespace circumspect
