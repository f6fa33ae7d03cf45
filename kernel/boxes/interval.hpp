// What doubles know of a number: two of them that enclose it. A filter computes with these, and
// whatever they leave open is decided by exact numbers.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/exact/number.hpp"
#include "kernel/exact/triple.hpp"

namespace circumspect {

// All numbers from `low` to `high`; −∞ and +∞ where a bound is not known.
struct Interval {
  double low = 0, high = 0;
};

// The largest double that is at most the value and the smallest that is at least the value; −∞ and
// +∞ count as doubles.
double lower_double(const Rational& value);
double upper_double(const Rational& value);

// Both.
Interval enclosing(const Rational& value);
inline Interval exactly(double value) { return {value, value}; }

// A result rounded to nearest is off by a part 2^-53 of it at most, or by 2^-1075 if a product
// vanishes; a sum that small is exact. Bounds are moved outward by more, which the rounding of the
// move itself cannot undo: proofs/filters/outward.gappa.
inline constexpr double kOutward = 0x1p-51;
inline constexpr double kVanishing = 0x1p-1060;
inline Interval outward(double low, double high, double vanishing = 0) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  low -= std::fabs(low) * kOutward + vanishing;
  high += std::fabs(high) * kOutward + vanishing;
  return {std::isnan(low) ? -kInfinity : low, std::isnan(high) ? kInfinity : high};
}
// The results of an operation for the bounds of both numbers.
inline Interval outward_of_all(double p, double q, double r, double s) {
  // Where a number is infinite one may be NaN, of which std::min and std::max know nothing.
  if (!std::isfinite(p + q + r + s)) return outward(NAN, NAN);
  return outward(std::min({p, q, r, s}), std::max({p, q, r, s}), kVanishing);
}

inline Interval operator+(Interval a, Interval b) {
  return outward(a.low + b.low, a.high + b.high);
}
inline Interval operator-(Interval a, Interval b) {
  return outward(a.low - b.high, a.high - b.low);
}
// Nothing is added to a product with zero: coordinates are often equal, and arithmetic with
// numbers as small as what would be added is slow.
inline Interval operator*(Interval a, Interval b) {
  const bool is_zero = (a.low == 0 && a.high == 0) || (b.low == 0 && b.high == 0);
  if (is_zero) return {};
  return outward_of_all(a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high);
}
// Requires: 0 is not in b.
inline Interval operator/(Interval a, Interval b) {
  return outward_of_all(a.low / b.low, a.low / b.high, a.high / b.low, a.high / b.high);
}

// The sign of every number in the interval; 0 if they have not all the same.
inline int certain_sign(Interval a) { return a.low > 0 ? 1 : (a.high < 0 ? -1 : 0); }

// The smallest interval that holds both.
inline Interval hull(Interval a, Interval b) {
  return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

// At most the squared distance from the centre to the box with these corners. A gap along an axis,
// its square and the two sums are too large by a part 2^-53 or 2^-1075 each, and are positive: so
// the sum is too large by less than a part 2^-49 and 2^-1060.
inline double least_squared_distance(const Triple<double>& low, const Triple<double>& high,
                                     const Triple<Interval>& centre) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double gap = std::max({0.0, low[i] - centre[i].high, centre[i].low - high[i]});
    sum += gap * gap;
  }
  return std::isfinite(sum) ? sum * (1 - 0x1p-49) - kVanishing : 0;
}

}  // namespace circumspect
