// What the filters assume of the machine's arithmetic: IEEE 754 binary64, every operation rounded
// by itself, to nearest, with gradual underflow.
#pragma once

#include <cfloat>
#include <limits>

#ifdef __FAST_MATH__
#error "The bounds of the filters are proved for IEEE 754: do not compile with -ffast-math."
#endif
#if FLT_EVAL_METHOD != 0
#error "The bounds of the filters are proved for doubles that are rounded after each operation."
#endif

namespace circumspect::fast {

static_assert(std::numeric_limits<double>::is_iec559 && std::numeric_limits<double>::digits == 53);

// Is a·b − c computed with two roundings? If products are contracted into fused multiply-adds, or
// kept in wider registers, the result is the error of the product.
[[gnu::always_inline]] inline bool rounds_products(double a, double b, double rounded_product) {
  return a * b - rounded_product == 0;
}

// Ties go to even and denormal numbers are kept. Requires: one == 1, half_ulp == 2^-53,
// least == 2^-1074 (as variables, so that the compiler cannot fold the answer).
[[gnu::always_inline]] inline bool rounds_to_nearest(double one, double half_ulp, double least) {
  return one + half_ulp == one && -one - half_ulp == -one &&
         one + 3 * half_ulp == one + 4 * half_ulp && (one + 2 * half_ulp) - one == 2 * half_ulp &&
         least / 2 == 0 && 3 * least - least == 2 * least && least != 0 &&
         0x1p-1022 * one - 3 * least != 0x1p-1022 * one;
}

// The self-test: true if machine, compiler and rounding mode are as the proofs of the bounds
// assume. Call it once before using the predicates, in the thread that will use them.
bool arithmetic_is_as_proved();

}  // namespace circumspect::fast
