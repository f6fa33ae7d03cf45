// From text to exact numbers.
#pragma once

#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "reference/exact/number.hpp"

namespace circumspect {

// How a decimal such as "0.1" is meant. Other programs read it into a double, so that is what they
// saw; `kDecimal` takes the text at its word. Fractions (1/3) and hexadecimal floats (0x1.8p-3) are
// exact in both.
enum class NumberReading { kDouble, kDecimal };

// Why a token is not a number: what was expected in its place, for a message
// "expected <this>, found <token>".
struct NumberError {
  std::string expected;
};

// Decimal exponents beyond this, and binary ones beyond kLargestBinaryExponent, are refused in exact
// readings: ten bytes of text must not become a gigabyte of digits.
inline constexpr long kLargestDecimalExponent = 1000;
inline constexpr long kLargestBinaryExponent = 5000;

// Reads the whole token: [+-]digits[.digits][e[+-]digits], [+-]0xhex[.hex][p[+-]digits], or
// [+-]digits/digits. A decimal that overflows to infinity as a double is an error; one that
// underflows becomes what strtod gives. "nan" and "inf" are errors.
tl::expected<Rational, NumberError> read_number(std::string_view token, NumberReading reading);

}  // namespace circumspect
