// Doubles with proved bounds on their errors: the filter before exact measures.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace circumspect::quality {

// A real number x and a double near it: |x − value| ≤ error · (1 + kLoss), unless either is NaN or
// infinite, which decides no comparison.
//
// Each operation adds what rounding its result to the nearest double loses, at most 2^-53 of the
// result or, where it underflows, 2^-1075; each product also adds kTiny, which is more than what
// underflow takes from its result and from its error. The sums and products that make up an error
// are rounded themselves. They are of numbers that are not negative, so that n roundings leave them
// at least (1 − 2^-53)^n of what they should be. The formulas of measures.hpp have n < 1000, and
// kLoss is more than 1000 · 2^-53.
struct Enclosed {
  double value = 0;
  double error = 0;

  static constexpr double kUnit = 0x1p-53;
  static constexpr double kTiny = 0x1p-1020;
  static constexpr double kLoss = 0x1p-40;

  // Around a number between two doubles.
  static Enclosed between(double low, double high) {
    const double middle = low / 2 + high / 2;
    return {middle, std::max(high - middle, middle - low) + kTiny};
  }

  bool is_surely_positive() const { return value > error * (1 + kLoss); }
  bool is_surely_negative() const { return -value > error * (1 + kLoss); }
};

[[gnu::always_inline]] inline Enclosed operator+(const Enclosed& a, const Enclosed& b) {
  const double value = a.value + b.value;
  return {value, a.error + b.error + std::fabs(value) * Enclosed::kUnit};
}
[[gnu::always_inline]] inline Enclosed operator-(const Enclosed& a, const Enclosed& b) {
  const double value = a.value - b.value;
  return {value, a.error + b.error + std::fabs(value) * Enclosed::kUnit};
}
[[gnu::always_inline]] inline Enclosed operator*(const Enclosed& a, const Enclosed& b) {
  const double value = a.value * b.value;
  return {value, std::fabs(a.value) * b.error + (std::fabs(b.value) + b.error) * a.error +
                     std::fabs(value) * Enclosed::kUnit + Enclosed::kTiny};
}
// By a power of two.
[[gnu::always_inline]] inline Enclosed operator*(int power, const Enclosed& a) {
  return {power * a.value, power * a.error};
}

// x · |x|. Its slope between x and the value is at most twice the larger of their sizes.
[[gnu::always_inline]] inline Enclosed signed_square(const Enclosed& a) {
  const double size = std::fabs(a.value);
  const double value = a.value * size;
  return {value,
          2 * (size + a.error) * a.error + std::fabs(value) * Enclosed::kUnit + Enclosed::kTiny};
}

// Uncertain unless the divisor is far from zero: then |a/b − a'/b'| ≤ (|a − a'| + |a'/b'| · |b −
// b'|)/|b|.
[[gnu::always_inline]] inline Enclosed operator/(const Enclosed& a, const Enclosed& b) {
  const double value = a.value / b.value;
  const double least = b.value - 2 * b.error;
  if (!(least > 0)) return {value, std::numeric_limits<double>::infinity()};
  return {value, (a.error + std::fabs(value) * b.error) / least +
                     2 * std::fabs(value) * Enclosed::kUnit + Enclosed::kTiny};
}

// The larger of two numbers is no further from the larger value than one of them is from its own.
// The sum of the errors, which is more, keeps NaN and infinity.
[[gnu::always_inline]] inline Enclosed larger(const Enclosed& a, const Enclosed& b) {
  return {std::max(a.value, b.value), a.error + b.error};
}
[[gnu::always_inline]] inline Enclosed smaller(const Enclosed& a, const Enclosed& b) {
  return {std::min(a.value, b.value), a.error + b.error};
}

// The sum of the squares of two or three differences of doubles. Each difference is rounded once,
// and never underflows; its square is rounded once more, and so are at most two sums: together at
// most (1 + 2^-53)^5, with 2^-1075 for the underflow of each square.
template <std::size_t kCount>
[[gnu::always_inline]] inline double rounded_squared_distance(const double* a, const double* b) {
  double sum = 0;
  for (std::size_t axis = 0; axis < kCount; ++axis) {
    const double difference = a[axis] - b[axis];
    sum += difference * difference;
  }
  return sum;
}
[[gnu::always_inline]] inline Enclosed enclosed_squared_distance(double rounded) {
  return {rounded, rounded * (6 * Enclosed::kUnit) + Enclosed::kTiny};
}

}  // namespace circumspect::quality
