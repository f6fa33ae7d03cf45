#include "kernel/exact/number_text.hpp"

#include <cassert>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>

#include <gmp.h>
#include <mpfr.h>

#include "kernel/exact/float.hpp"

namespace circumspect {

namespace {

using Result = tl::expected<Rational, NumberError>;

// A scanned number: sign, digits without the point, how many of them follow the point, and the
// written exponent (to base 10 or 2).
struct Scan {
  bool negative = false;
  bool hexadecimal = false;
  std::string digits;
  long fraction_digits = 0;
  long exponent = 0;  // one of half its range if it is out of range
  bool exponent_out_of_range = false;
};

bool is_digit(char c, bool hexadecimal) {
  const auto u = static_cast<unsigned char>(c);
  return hexadecimal ? std::isxdigit(u) != 0 : std::isdigit(u) != 0;
}

bool take_sign(std::string_view& rest) {
  if (rest.empty() || (rest.front() != '+' && rest.front() != '-')) return false;
  const bool negative = rest.front() == '-';
  rest.remove_prefix(1);
  return negative;
}

std::string take_digits(std::string_view& rest, bool hexadecimal) {
  std::size_t length = 0;
  while (length < rest.size() && is_digit(rest[length], hexadecimal)) ++length;
  std::string digits(rest.substr(0, length));
  rest.remove_prefix(length);
  return digits;
}

// The exponent after 'e' or 'p'; false if it is missing although required.
bool take_exponent(std::string_view& rest, Scan& scan) {
  rest.remove_prefix(1);
  const bool negative = take_sign(rest);
  const std::string digits = take_digits(rest, false);
  if (digits.empty()) return false;
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), scan.exponent);
  scan.exponent_out_of_range = error != std::errc();
  if (scan.exponent_out_of_range) scan.exponent = std::numeric_limits<long>::max() / 2;
  if (negative) scan.exponent = -scan.exponent;
  return true;
}

bool scan_number(std::string_view rest, Scan& scan) {
  scan.negative = take_sign(rest);
  if (rest.size() > 1 && rest[0] == '0' && (rest[1] == 'x' || rest[1] == 'X')) {
    scan.hexadecimal = true;
    rest.remove_prefix(2);
  }
  scan.digits = take_digits(rest, scan.hexadecimal);
  if (!rest.empty() && rest.front() == '.') {
    rest.remove_prefix(1);
    const std::string fraction = take_digits(rest, scan.hexadecimal);
    scan.fraction_digits = static_cast<long>(fraction.size());
    scan.digits += fraction;
  }
  if (scan.digits.empty()) return false;
  const char marker = scan.hexadecimal ? 'p' : 'e';
  if (!rest.empty() && std::tolower(static_cast<unsigned char>(rest.front())) == marker &&
      !take_exponent(rest, scan)) {
    return false;
  }
  return rest.empty();
}

Integer integer_power(unsigned long base, unsigned long exponent) {
  Integer result;
  mpz_ui_pow_ui(result.get_mpz_t(), base, exponent);
  return result;
}

Result exact_from_scan(const Scan& scan) {
  const long largest = scan.hexadecimal ? kLargestBinaryExponent : kLargestDecimalExponent;
  if (scan.exponent_out_of_range || scan.exponent > largest || scan.exponent < -largest) {
    return tl::unexpected(NumberError{"an exponent between -" + std::to_string(largest) + " and " +
                                      std::to_string(largest)});
  }
  Integer mantissa(scan.digits, scan.hexadecimal ? 16 : 10);
  if (scan.negative) mantissa = -mantissa;
  const long exponent = scan.exponent - (scan.hexadecimal ? 4 : 1) * scan.fraction_digits;
  const unsigned long base = scan.hexadecimal ? 2 : 10;
  const Integer scale = integer_power(base, static_cast<unsigned long>(std::labs(exponent)));
  if (exponent >= 0) return Rational(mantissa * scale);
  Rational value(mantissa, scale);
  value.canonicalize();
  return value;
}

// What strtod gives, whatever the locale of the program that links us, and however the system's C
// library rounds. Requires: scan is that of a decimal token.
double nearest_double(std::string_view token, const Scan& scan) {
  if (token.front() == '+') token.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (error != std::errc::result_out_of_range) return value;
  // It is far from one, on one side or the other: how many places before the point does it begin?
  const std::size_t zeros = scan.digits.find_first_not_of('0');
  const long places = static_cast<long>(scan.digits.size() - zeros) - scan.fraction_digits;
  return places + scan.exponent > 0 ? std::numeric_limits<double>::infinity() : 0;
}

Result read_fraction(std::string_view token, std::size_t slash) {
  std::string_view numerator = token.substr(0, slash);
  std::string_view denominator = token.substr(slash + 1);
  const bool negative = take_sign(numerator);
  const std::string above = take_digits(numerator, false);
  const std::string below = take_digits(denominator, false);
  if (above.empty() || below.empty() || !numerator.empty() || !denominator.empty()) {
    return tl::unexpected(NumberError{"a fraction of two integers such as -1/3"});
  }
  const Integer divisor(below, 10);
  if (sign(divisor) == 0) return tl::unexpected(NumberError{"a denominator other than zero"});
  Rational value(Integer(above, 10), divisor);
  value.canonicalize();
  if (negative) value = -value;
  return value;
}

}  // namespace

Result read_number(std::string_view token, NumberReading reading) {
  if (const std::size_t slash = token.find('/'); slash != std::string_view::npos) {
    return read_fraction(token, slash);
  }
  Scan scan;
  if (!scan_number(token, scan)) return tl::unexpected(NumberError{"a finite number"});
  if (reading == NumberReading::kDecimal || scan.hexadecimal) return exact_from_scan(scan);
  const double value = nearest_double(token, scan);
  if (!std::isfinite(value)) {
    return tl::unexpected(
        NumberError{"a number within the range of double (--coordinates decimal reads more)"});
  }
  return exact_value(value);
}

namespace {

constexpr mpfr_prec_t kDoublePrecision = 53;

std::string shortest(double value) {
  char buffer[64];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value);
  assert(error == std::errc());
  return std::string(buffer, end);
}

// Requires: value has 53 bits, so within the range of normal doubles its conversion is exact.
std::string print(Float& value) {
  const double nearest = mpfr_get_d(value.get(), MPFR_RNDN);
  const bool is_normal_or_zero = std::isnormal(nearest) || mpfr_zero_p(value.get()) != 0;
  if (is_normal_or_zero) return shortest(nearest);
  char buffer[64];
  mpfr_snprintf(buffer, sizeof buffer, "%.16Re", value.get());
  return buffer;
}

bool is_square(const Integer& value) { return mpz_perfect_square_p(value.get_mpz_t()) != 0; }

// One end of an enclosure of sqrt(value), computed with the given precision and rounded to 53 bits.
void rounded_root(Float& result, const Rational& value, mpfr_prec_t precision, mpfr_rnd_t toward) {
  Float wide(precision);
  mpfr_set_q(wide.get(), value.get_mpq_t(), toward);
  mpfr_sqrt(wide.get(), wide.get(), toward);
  mpfr_set(result.get(), wide.get(), MPFR_RNDN);
}

}  // namespace

std::string to_string(const Integer& value) { return value.get_str(); }
std::string to_string(const Rational& value) { return value.get_str(); }

std::string to_text_of_double_or_fraction(const Rational& value) {
  if (const auto same = as_double(value)) return shortest(*same);
  // A denominator keeps an integer that is not a double from being read as the nearest one.
  return value.get_den() == 1 ? value.get_str() + "/1" : value.get_str();
}

namespace {

// The decimal is what a person reads; JSON has what is longer.
constexpr std::size_t kLongestExact = 60;

}  // namespace

std::string point_text(std::span<const Rational> coordinates) {
  std::string text;
  for (const Rational& coordinate : coordinates) {
    const std::string exact = to_text_of_double_or_fraction(coordinate);
    text += text.empty() ? "(" : ", ";
    text += exact.size() > kLongestExact ? "~ " + to_decimal(coordinate) : exact;
  }
  return text + ")";
}

std::string value_text(const Rational& value) {
  const std::string exact = to_string(value);
  const std::string decimal = to_decimal(value);
  if (exact == decimal) return exact;
  return exact.size() > kLongestExact ? "~ " + decimal : exact + " ~ " + decimal;
}

std::string to_decimal(const Rational& value) {
  Float nearest(kDoublePrecision);
  mpfr_set_q(nearest.get(), value.get_mpq_t(), MPFR_RNDN);
  return print(nearest);
}

std::string square_root_to_decimal(const Rational& value) {
  assert(sign(value) >= 0);
  if (is_square(value.get_num()) && is_square(value.get_den())) {
    const Rational root(sqrt(value.get_num()), sqrt(value.get_den()));
    return to_decimal(root);
  }
  // The root is irrational, so it is not a midpoint of two doubles: widening the precision makes
  // both ends of the enclosure round to the same double.
  for (mpfr_prec_t precision = 2 * kDoublePrecision;; precision *= 2) {
    Float low(kDoublePrecision);
    Float high(kDoublePrecision);
    rounded_root(low, value, precision, MPFR_RNDD);
    rounded_root(high, value, precision, MPFR_RNDU);
    if (mpfr_equal_p(low.get(), high.get()) != 0) return print(low);
  }
}

namespace {

// One end of an enclosure of a sum of roots, rounded to 53 bits.
void rounded_sum_of_roots(Float& result, std::span<const Rational> values, mpfr_prec_t precision,
                          mpfr_rnd_t toward) {
  Float sum(precision), root(precision);
  mpfr_set_zero(sum.get(), 1);
  for (const Rational& value : values) {
    mpfr_set_q(root.get(), value.get_mpq_t(), toward);
    mpfr_sqrt(root.get(), root.get(), toward);
    mpfr_add(sum.get(), sum.get(), root.get(), toward);
  }
  mpfr_set(result.get(), sum.get(), MPFR_RNDN);
}

}  // namespace

std::string sum_of_roots_to_decimal(std::span<const Rational> values) {
  constexpr mpfr_prec_t kMost = 4096;
  for (mpfr_prec_t precision = 4 * kDoublePrecision;; precision *= 2) {
    Float low(kDoublePrecision), high(kDoublePrecision);
    rounded_sum_of_roots(low, values, precision, MPFR_RNDD);
    rounded_sum_of_roots(high, values, precision, MPFR_RNDU);
    if (mpfr_equal_p(low.get(), high.get()) != 0 || precision > kMost) return print(low);
  }
}

}  // namespace circumspect
