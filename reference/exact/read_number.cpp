#include "reference/exact/read_number.hpp"

#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include <locale.h>

namespace circumspect {
namespace {

using Result = tl::expected<Rational, NumberError>;

// A scanned number: sign, digits without the point, how many of them stand behind the point, and
// the written exponent (to base 10 or 2).
struct Scan {
  bool negative = false;
  bool hexadecimal = false;
  std::string digits;
  long fraction_digits = 0;
  long exponent = 0;
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

// The exponent behind 'e' or 'p'; false if there is none to read where one must be.
bool take_exponent(std::string_view& rest, Scan& scan) {
  rest.remove_prefix(1);
  const bool negative = take_sign(rest);
  const std::string digits = take_digits(rest, false);
  if (digits.empty()) return false;
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), scan.exponent);
  scan.exponent_out_of_range = error != std::errc();
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

Integer power(unsigned long base, unsigned long exponent) {
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
  const Integer scale = power(base, static_cast<unsigned long>(std::labs(exponent)));
  if (exponent >= 0) return Rational(mantissa * scale);
  Rational value(mantissa, scale);
  value.canonicalize();
  return value;
}

// strtod whatever the locale of the program that links us.
double strtod_in_c_locale(const std::string& token) {
  static const locale_t c_locale = newlocale(LC_ALL_MASK, "C", nullptr);
  return strtod_l(token.c_str(), nullptr, c_locale);
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
  const double value = strtod_in_c_locale(std::string(token));
  if (!std::isfinite(value)) {
    return tl::unexpected(
        NumberError{"a number within the range of double (--coordinates decimal reads more)"});
  }
  return exact_value(value);
}

}  // namespace circumspect
