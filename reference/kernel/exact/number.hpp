// Exact numbers. This folder is the only place that names the number library (GMP, MPFR): every
// other file says Integer and Rational, so that the library could be replaced here alone.
#pragma once

#include <cstddef>

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

// The exact value of a finite double. Requires: value is finite.
Rational exact_value(double value);

// Number of bits of |value|; 0 for zero.
std::size_t bit_length(const Integer& value);

// Least common multiple, always positive. Requires: a, b nonzero.
Integer least_common_multiple(const Integer& a, const Integer& b);

// sum += a · b and sum −= a · b, without a number in between.
void add_product(Integer& sum, const Integer& a, const Integer& b);
void subtract_product(Integer& sum, const Integer& a, const Integer& b);

// Quotient of a division that is known to leave no remainder.
Integer exact_quotient(const Integer& dividend, const Integer& divisor);

}  // namespace circumspect
