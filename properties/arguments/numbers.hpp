// Random numbers for properties. All shrink towards 0.
#pragma once

#include <utility>

#include <rapidcheck.h>

#include "reference/kernel/exact/number.hpp"

namespace circumspect::generators {

// Uniform in [0, count), whatever RapidCheck's size. Requires: count > 0.
inline rc::Gen<long> below(long count) {
  return rc::gen::resize(rc::kNominalSize, rc::gen::inRange<long>(0, count));
}

// Uniform in [-bound, bound].
inline rc::Gen<long> integer_within(long bound) {
  // 0, 1, −1, 2, −2, …: RapidCheck shrinks the place in this row towards 0.
  return rc::gen::map(below(2 * bound + 1),
                      [](long place) { return place % 2 == 0 ? -place / 2 : (place + 1) / 2; });
}

inline rc::Gen<Rational> integer_number(long bound) {
  return rc::gen::map(integer_within(bound), [](long value) { return Rational(value); });
}

// Numerator at most 12 in absolute value, denominator at most 6.
inline rc::Gen<Rational> small_rational() {
  return rc::gen::map(rc::gen::pair(integer_within(12), below(6)),
                      [](const std::pair<long, long>& parts) {
                        Rational value(parts.first, parts.second + 1);
                        value.canonicalize();
                        return value;
                      });
}

}  // namespace circumspect::generators
