// Numbers for random point sets. All shrink towards 0.
#pragma once

#include <vector>

#include <rapidcheck.h>

#include "reference/kernel/exact/number.hpp"

namespace circumspect::generators {

// Uniform in [0, count), whatever RapidCheck's size. Requires: count > 0.
rc::Gen<long> below(long count);

// Uniform in [-bound, bound].
rc::Gen<long> integer_within(long bound);
rc::Gen<Rational> integer_number(long bound);

// Numerator at most 12 in absolute value, denominator at most 6.
rc::Gen<Rational> small_rational();

// A double: a mantissa of up to 53 bits over a power of two of up to 60.
rc::Gen<Rational> dyadic_number();

// A double between 2^-300 and 2^302 in absolute value, or 0.
rc::Gen<Rational> extreme_number();

// One weight for each of `count` points (Book: Section 5.2, weighted Delaunay triangulations).
rc::Gen<std::vector<Rational>> small_weights(std::size_t count);

}  // namespace circumspect::generators
