// The first stage: polynomials with doubles, and when their signs are certain.
#pragma once

#include <cmath>

#include "oracle/judge/fast/arithmetic.hpp"
#include "oracle/judge/fast/filter_bounds.hpp"
#include "oracle/judge/fast/lattice.hpp"
#include "oracle/judge/fast/polynomials.hpp"
#include "oracle/judge/fast/site.hpp"

namespace circumspect::fast {

inline constexpr int kUncertain = 2;

// The largest entry of each column of coordinates, and of weights (0 without).
struct Scale2 {
  double x, y, weight = 0;
};
struct Scale3 {
  double x, y, z, weight = 0;
};

// All that follows is inlined always, and has no branch, so that loops over many simplices become
// vector instructions (block.cpp).
[[gnu::always_inline]] inline double larger(double a, double b) { return a < b ? b : a; }
[[gnu::always_inline]] inline double smaller(double a, double b) { return b < a ? b : a; }
[[gnu::always_inline]] inline Scale2 larger(const Scale2& a, const Scale2& b) {
  return {larger(a.x, b.x), larger(a.y, b.y), larger(a.weight, b.weight)};
}
[[gnu::always_inline]] inline Scale3 larger(const Scale3& a, const Scale3& b) {
  return {larger(a.x, b.x), larger(a.y, b.y), larger(a.z, b.z), larger(a.weight, b.weight)};
}

// A site as seen from the simplex's last vertex, and the size of what is in it. As operations:
// differences of coordinates, the height, and if kWeighted the difference of the weights off the height.
struct FilterRow2 {
  Row2<double, double> row;
  Scale2 scale;
};
struct FilterRow3 {
  Row3<double, double> row;
  Scale3 scale;
};

template <bool kWeighted>
[[gnu::always_inline]] inline FilterRow2 row_from(const Site<2>& origin, const Site<2>& site) {
  const double x = site.at[0] - origin.at[0], y = site.at[1] - origin.at[1];
  const double w = height(x, y);
  if constexpr (!kWeighted) return {{x, y, w}, {std::fabs(x), std::fabs(y)}};
  const double weight = site.weight - origin.weight;
  return {{x, y, w - weight}, {std::fabs(x), std::fabs(y), std::fabs(weight)}};
}
template <bool kWeighted>
[[gnu::always_inline]] inline FilterRow3 row_from(const Site<3>& origin, const Site<3>& site) {
  const double x = site.at[0] - origin.at[0], y = site.at[1] - origin.at[1],
               z = site.at[2] - origin.at[2];
  const double w = height(x, y, z);
  if constexpr (!kWeighted) return {{x, y, z, w}, {std::fabs(x), std::fabs(y), std::fabs(z)}};
  const double weight = site.weight - origin.weight;
  return {{x, y, z, w - weight}, {std::fabs(x), std::fabs(y), std::fabs(z), std::fabs(weight)}};
}

// The sign of a polynomial whose computed value is `value`, if it is certain. `columns` is the product
// of the largest entries of its columns, `smallest` and `largest` those of the columns of coordinates.
// A column of zeros makes the polynomial zero. Differences that overflowed fail the second test, and
// NaN (from infinities) the comparisons. If `exact`, nothing was rounded.
template <typename Sign>
[[gnu::always_inline]] inline Sign certain_sign(double value, double bound, double columns,
                                                double smallest, double largest,
                                                double largest_height, bool exact) {
  const double error = columns * (bound * kRoundedBound);
  const bool in_range = (smallest >= kSmallestScale) & (largest <= kLargestScale) &
                        (largest_height <= kLargestHeight);
  const bool certain = exact | (value > error) | (value < -error);
  const Sign sign = static_cast<Sign>(value > 0) - static_cast<Sign>(value < 0);
  const Sign uncertain = kUncertain, zero = 0;
  const Sign computed = certain ? sign : uncertain;
  const Sign of_zeros = smallest == 0 ? zero : uncertain;
  return in_range ? computed : of_zeros;
}

template <typename Sign>
[[gnu::always_inline]] inline Sign certain_sign(double value, double bound, const Scale2& scale,
                                                Lattice lattice) {
  const double largest = larger(scale.x, scale.y);
  return certain_sign<Sign>(value, bound, scale.x * scale.y, smaller(scale.x, scale.y), largest, 0,
                            lattice.keeps_exact(largest));
}
template <typename Sign>
[[gnu::always_inline]] inline Sign certain_sign(double value, double bound, const Scale3& scale,
                                                Lattice lattice) {
  const double largest = larger(larger(scale.x, scale.y), scale.z);
  return certain_sign<Sign>(value, bound, scale.x * scale.y * scale.z,
                            smaller(smaller(scale.x, scale.y), scale.z), largest, 0,
                            lattice.keeps_exact(largest));
}

// With a column of heights: paraboloid and weights, whichever is larger.
template <typename Sign>
[[gnu::always_inline]] inline Sign certain_lifted_sign(double value, double bound,
                                                       const Scale2& scale, Lattice lattice) {
  const double largest = larger(scale.x, scale.y);
  const double heights = larger(largest * largest, scale.weight);
  return certain_sign<Sign>(value, bound, scale.x * scale.y * heights, smaller(scale.x, scale.y),
                            largest, heights, lattice.keeps_exact(largest, scale.weight));
}
template <typename Sign>
[[gnu::always_inline]] inline Sign certain_lifted_sign(double value, double bound,
                                                       const Scale3& scale, Lattice lattice) {
  const double largest = larger(larger(scale.x, scale.y), scale.z);
  const double heights = larger(largest * largest, scale.weight);
  return certain_sign<Sign>(value, bound, scale.x * scale.y * scale.z * heights,
                            smaller(smaller(scale.x, scale.y), scale.z), largest, heights,
                            lattice.keeps_exact(largest, scale.weight));
}

}  // namespace circumspect::fast
