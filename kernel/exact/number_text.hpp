// Exact numbers and text, both ways.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "kernel/exact/number.hpp"

namespace circumspect {

// How a decimal such as "0.1" is meant. Other programs read it into a double, so that is what they
// saw; `kDecimal` takes the text literally. Fractions (1/3) and hexadecimal floats (0x1.8p-3) are
// exact in both.
enum class NumberReading { kDouble, kDecimal };

// Why a token is not a number: what was expected in its place, for a message
// "expected <this>, found <token>".
struct NumberError {
  std::string expected;
};

// Exact readings refuse decimal exponents beyond this, and binary ones beyond
// kLargestBinaryExponent: ten bytes of text must not become a gigabyte of digits.
inline constexpr long kLargestDecimalExponent = 1000;
inline constexpr long kLargestBinaryExponent = 5000;

// Reads the whole token: [+-]digits[.digits][e[+-]digits], [+-]0xhex[.hex][p[+-]digits], or
// [+-]digits/digits. A decimal that overflows to infinity as a double is an error; one that
// underflows becomes what strtod gives. "nan" and "inf" are errors.
tl::expected<Rational, NumberError> read_number(std::string_view token, NumberReading reading);

// The exact value, in lowest terms: "7", "-1/3".
std::string to_string(const Integer& value);
std::string to_string(const Rational& value);

// The shortest text that read_number(…, kDouble) turns back into exactly this value: a decimal if
// the value is a double, else a fraction.
std::string to_text_of_double_or_fraction(const Rational& value);

// A point, "(0, 1/3, 0.125)", each coordinate written so; a long fraction is "~" and its decimal.
std::string point_text(std::span<const Rational> coordinates);

// "5", "1/3 ~ 0.3333333333333333": the exact value and its decimal, unless they are the same; of a
// long one only the decimal.
std::string value_text(const Rational& value);

// Correctly rounded (to nearest, ties to even) to 53 bits and written as the shortest decimal that
// identifies that double; beyond the range of double, 17 significant digits. For people: never
// read back in a verdict.
std::string to_decimal(const Rational& value);

// The same for the square root of a value. Requires: value >= 0.
std::string square_root_to_decimal(const Rational& value);

// The same for the sum of the square roots of many values; where 4096 bits do not tell which of two
// doubles is nearer, either of them. Requires: all values >= 0.
std::string sum_of_roots_to_decimal(std::span<const Rational> values);

}  // namespace circumspect
