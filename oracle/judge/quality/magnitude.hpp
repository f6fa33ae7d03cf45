// A bound on what rounding does to a polynomial of measures.hpp that is evaluated with plain
// doubles, before anything is known of the simplex but its longest edge.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>

#include "oracle/judge/quality/enclosed.hpp"

namespace circumspect::quality {

// Of a homogeneous polynomial in squared lengths that are at most 1: |x| ≤ size, and the number
// that doubles compute is off by at most `error`. With squared lengths of at most s both are
// multiplied by s^degree. It runs through the very operations of the polynomial, once for a
// requirement.
struct Magnitude {
  double size = 0;
  double error = 0;
  int degree = 0;

  // A squared length: see squared_distance of enclosed.hpp.
  static Magnitude of_squared_length() { return {1, 8 * Enclosed::kUnit, 1}; }
};

inline Magnitude operator+(const Magnitude& a, const Magnitude& b) {
  assert(a.degree == b.degree);
  const double size = a.size + b.size, error = a.error + b.error;
  return {size, error + (size + error) * Enclosed::kUnit, a.degree};
}
inline Magnitude operator-(const Magnitude& a, const Magnitude& b) { return a + b; }
inline Magnitude operator*(const Magnitude& a, const Magnitude& b) {
  const double size = a.size * b.size;
  const double error = a.size * b.error + b.size * a.error + a.error * b.error;
  return {size, error + (size + error) * Enclosed::kUnit, a.degree + b.degree};
}
inline Magnitude operator*(int power, const Magnitude& a) {
  return {power * a.size, power * a.error, a.degree};
}
inline Magnitude signed_square(const Magnitude& a) { return a * a; }
inline Magnitude larger(const Magnitude& a, const Magnitude& b) {
  assert(a.degree == b.degree);
  return {std::max(a.size, b.size), std::max(a.error, b.error), a.degree};
}
inline Magnitude smaller(const Magnitude& a, const Magnitude& b) { return larger(a, b); }

// The same operations on the doubles themselves.
[[gnu::always_inline]] inline double signed_square(double a) { return a * std::fabs(a); }
[[gnu::always_inline]] inline double larger(double a, double b) { return a < b ? b : a; }
[[gnu::always_inline]] inline double smaller(double a, double b) { return b < a ? b : a; }

// Between these no product of four squared lengths overflows, and what underflow loses of one is
// far below `error`.
inline constexpr double kLeastScale = 0x1p-100;
inline constexpr double kLargestScale = 0x1p100;

}  // namespace circumspect::quality
