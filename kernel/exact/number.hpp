// Exact numbers: their types, their conversion from and to text, and what happens when they exhaust
// the memory. This folder is the only place that names the number library (GMP, MPFR).
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include <gmpxx.h>
#include <tl/expected.hpp>

#ifdef __FAST_MATH__
#error "Circumspect reads doubles exactly and must not be compiled with -ffast-math."
#endif

namespace circumspect {

// Exact numbers. This folder is the only place that names the number library (GMP, MPFR): every
// other file says Integer and Rational, so that the library could be replaced here alone.

using Integer = mpz_class;
using Rational = mpq_class;

// Sign of a number: -1, 0 or 1.
inline int sign(const Integer& value) { return sgn(value); }
inline int sign(const Rational& value) { return sgn(value); }

// Converts an integer of the language. GMP's constructors end at `long`, which does not have 64
// bits on every machine.
template <std::integral Number>
Integer to_integer(Number value) {
  if constexpr (sizeof(Number) <= sizeof(long)) {
    return Integer(value);
  } else {
    const bool negative = value < 0;
    const auto size =
        negative ? 0 - static_cast<std::uint64_t>(value) : static_cast<std::uint64_t>(value);
    Integer result = static_cast<unsigned long>(size >> 32U);
    result <<= 32;
    result += static_cast<unsigned long>(size & 0xffffffffU);
    return negative ? Integer(-result) : result;
  }
}

// The exact value of a finite double. Requires: value is finite.
Rational exact_value(double value);

// Number of bits of |value|; 0 for zero.
std::size_t bit_length(const Integer& value);

// Least common multiple, always positive. Requires: a, b nonzero.
Integer least_common_multiple(const Integer& a, const Integer& b);

// The least common multiple of `of_others` and the denominators of some numbers.
Integer common_denominator(std::span<const Rational> numbers, Integer of_others = 1);

// The numerator of a number over this denominator. Requires: a multiple of the number's own.
Integer numerator_over(const Integer& denominator, const Rational& value);

// sum += a · b and sum −= a · b, without a number in between.
void add_product(Integer& sum, const Integer& a, const Integer& b);
void subtract_product(Integer& sum, const Integer& a, const Integer& b);

// Quotient of a division that is known to leave no remainder.
Integer exact_quotient(const Integer& dividend, const Integer& divisor);

// Exact numbers and text, both ways.

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

// Correctly rounded (to nearest, ties to even) to 53 bits and written as the shortest decimal that
// identifies that double; beyond the range of double, 17 significant digits. For people: never
// read back in a verdict.
std::string to_decimal(const Rational& value);

// The same for the square root of a value. Requires: value >= 0.
std::string square_root_to_decimal(const Rational& value);

// The same for the sum of the square roots of many values; where 4096 bits do not tell which of two
// doubles is nearer, either of them. Requires: all values >= 0.
std::string sum_of_roots_to_decimal(std::span<const Rational> values);

// The number libraries in use, with their versions: "GMP 6.2.1, MPFR 4.2.0".
std::string number_libraries();

// What happens when a number needs more memory than there is.

// By default GMP and MPFR then end the process with SIGABRT; after this call they call `end`
// instead, which must not return: both are written in C, so nothing could continue. The memory
// still comes from malloc.
void end_where_numbers_exhaust_memory(void (*end)());

}  // namespace circumspect
