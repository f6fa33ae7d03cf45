// The first stage: polynomials with doubles, bounds on their errors, and whether their signs are
// certain.
#pragma once

#include <cmath>
#include <cstddef>

#include "oracle/judge/fast/predicates/arithmetic.hpp"
#include "oracle/judge/fast/predicates/lattice.hpp"
#include "oracle/judge/fast/predicates/polynomials.hpp"
#include "oracle/judge/fast/predicates/site.hpp"

namespace circumspect::fast {

// Bounds on the errors of the polynomials of polynomials.hpp when evaluated with doubles.

// Each is proved by the script proofs/filters/NAME.gappa, for differences (and weights) scaled so
// that the largest in its column is 1. Columns have degree one in the polynomials, so that for
// others the bound is multiplied by the largest entry of each column; see proofs/filters/README.md.
inline constexpr double kOrientation2 = 0x1.001p-50;      // orientation_2.gappa
inline constexpr double kOrientation3 = 0x1.701p-48;      // orientation_3.gappa
inline constexpr double kInCircle = 0x1.001p-46;          // in_circle.gappa
inline constexpr double kInCircleWeighted = 0x1.801p-46;  // in_circle_weighted.gappa
inline constexpr double kInSphere = 0x1.189p-43;          // in_sphere.gappa
inline constexpr double kInSphereWeighted = 0x1.781p-43;  // in_sphere_weighted.gappa

// The loss from rounding when the bound is multiplied by the largest entries: at most five
// products, each rounded, are low by a factor of at most (1 − 2^-53)^5 > 1 − 2^-50.
inline constexpr double kRoundedBound = 1 + 0x1p-40;

// Within these limits of the largest entry of each column of coordinates (their squares: of
// heights) nothing overflows, and what underflow adds to one product is at most 2^-125 after
// scaling, which is what the scripts assume. Largest: 2^(5·190) times at most 2^7.
inline constexpr double kSmallestScale = 0x1p-190;
inline constexpr double kLargestScale = 0x1p190;
inline constexpr double kLargestHeight = 0x1p380;

inline constexpr int kUncertain = 2;

// The largest entry of each column of coordinates, and of weights (0 without).
struct Scale2 {
  double x, y, weight = 0;
};
struct Scale3 {
  double x, y, z, weight = 0;
};

// Everything that follows is always inlined, and has no branch, so that loops over many simplices
// become vector instructions (block.cpp).
[[gnu::always_inline]] inline double larger(double a, double b) { return a < b ? b : a; }
[[gnu::always_inline]] inline double smaller(double a, double b) { return b < a ? b : a; }
[[gnu::always_inline]] inline Scale2 larger(const Scale2& a, const Scale2& b) {
  return {larger(a.x, b.x), larger(a.y, b.y), larger(a.weight, b.weight)};
}
[[gnu::always_inline]] inline Scale3 larger(const Scale3& a, const Scale3& b) {
  return {larger(a.x, b.x), larger(a.y, b.y), larger(a.z, b.z), larger(a.weight, b.weight)};
}

// A site relative to the simplex's last vertex, and the sizes of its entries. The operations are:
// differences of coordinates, the height, and if kWeighted, the height minus the difference of the
// weights.
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

// The sign of a polynomial whose computed value is `value`, if it is certain. `columns` is the
// product of the largest entries of its columns, `smallest` and `largest` those of the columns of
// coordinates. A column of zeros makes the polynomial zero. Differences that overflowed fail the
// second test, and NaN (from infinities) fails the comparisons. If `exact`, nothing was rounded.
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

// With a column of heights: the larger of paraboloid and weights.
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

// The first stage for a simplex and its queries: what depends on the simplex alone is computed
// once. Single simplices (predicates.hpp) and many (block.cpp) share this code, which has to be
// inlined.

template <std::size_t kDimension>
struct SimplexFilter;
template <>
struct SimplexFilter<2> {
  Scale2 scale;
  TriangleCofactors<double, double> cofactors;
};
template <>
struct SimplexFilter<3> {
  Scale3 scale;
  TetrahedronCofactors<double, double, double> cofactors;
};

template <bool kWeighted>
[[gnu::always_inline]] inline SimplexFilter<2> simplex_filter(const Site<2>& a, const Site<2>& b,
                                                              const Site<2>& c) {
  const FilterRow2 from_a = row_from<kWeighted>(c, a), from_b = row_from<kWeighted>(c, b);
  return {larger(from_a.scale, from_b.scale), cofactors(from_a.row, from_b.row)};
}
template <bool kWeighted>
[[gnu::always_inline]] inline SimplexFilter<3> simplex_filter(const Site<3>& a, const Site<3>& b,
                                                              const Site<3>& c, const Site<3>& d) {
  const FilterRow3 from_a = row_from<kWeighted>(d, a), from_b = row_from<kWeighted>(d, b),
                   from_c = row_from<kWeighted>(d, c);
  return {larger(larger(from_a.scale, from_b.scale), from_c.scale),
          cofactors(from_a.row, from_b.row, from_c.row)};
}

// The orientation, or kUncertain.
template <typename Sign>
[[gnu::always_inline]] inline Sign filtered_orientation(const SimplexFilter<2>& simplex,
                                                        Lattice lattice) {
  return certain_sign<Sign>(simplex.cofactors.xy, kOrientation2, simplex.scale, lattice);
}
template <typename Sign>
[[gnu::always_inline]] inline Sign filtered_orientation(const SimplexFilter<3>& simplex,
                                                        Lattice lattice) {
  return certain_sign<Sign>(simplex.cofactors.xyz, kOrientation3, simplex.scale, lattice);
}

// Ball::contains (predicates.hpp), or kUncertain. `last` is the simplex's last vertex.
template <bool kWeighted, typename Sign>
[[gnu::always_inline]] inline Sign filtered_ball(const SimplexFilter<2>& simplex,
                                                 const Site<2>& last, const Site<2>& query,
                                                 Lattice lattice) {
  const FilterRow2 from = row_from<kWeighted>(last, query);
  return certain_lifted_sign<Sign>(in_circle(simplex.cofactors, from.row),
                                   kWeighted ? kInCircleWeighted : kInCircle,
                                   larger(simplex.scale, from.scale), lattice);
}
template <bool kWeighted, typename Sign>
[[gnu::always_inline]] inline Sign filtered_ball(const SimplexFilter<3>& simplex,
                                                 const Site<3>& last, const Site<3>& query,
                                                 Lattice lattice) {
  const FilterRow3 from = row_from<kWeighted>(last, query);
  return certain_lifted_sign<Sign>(in_sphere(simplex.cofactors, from.row),
                                   kWeighted ? kInSphereWeighted : kInSphere,
                                   larger(simplex.scale, from.scale), lattice);
}

}  // namespace circumspect::fast
