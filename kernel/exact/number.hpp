// Exact numbers. This folder is the only place that names the number library (GMP, MPFR): every
// other file says Integer and Rational, so that the library could be replaced here alone.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include <gmpxx.h>

#ifdef __FAST_MATH__
#error "Circumspect reads doubles exactly and must not be compiled with -ffast-math."
#endif

namespace circumspect {

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
// The double that equals the value; none if the value is not one.
std::optional<double> as_double(const Rational& value);

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

// The number libraries in use, with their versions: "GMP 6.2.1, MPFR 4.2.0".
std::string number_libraries();

// When a number needs more memory than there is, GMP and MPFR end the process with SIGABRT; after
// this call they call `end` instead, which must not return: both are written in C, so nothing could
// continue. The memory still comes from malloc.
void end_where_numbers_exhaust_memory(void (*end)());

}  // namespace circumspect
