// Doubles as integers: times a power of two, on a lattice, or in a common unit.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "oracle/judge/fast/predicates/site.hpp"

namespace circumspect::fast {

// A double as an integer times a power of two.
struct Dyadic {
  std::int64_t mantissa;  // odd, or 0
  int exponent;           // 0 if the mantissa is

  // The number of bits of |value| / 2^unit. Requires: unit <= exponent.
  int bits_above(int unit) const {
    const auto magnitude = static_cast<std::uint64_t>(mantissa < 0 ? -mantissa : mantissa);
    return mantissa == 0 ? 0 : static_cast<int>(std::bit_width(magnitude)) + exponent - unit;
  }
};

// Requires: value is finite.
inline Dyadic dyadic(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const int field = static_cast<int>(bits >> 52 & 0x7ff);
  std::uint64_t magnitude = bits & 0xf'ffff'ffff'ffff;
  if (field != 0) magnitude |= std::uint64_t{1} << 52;
  if (magnitude == 0) return {0, 0};
  const int zeros = std::countr_zero(magnitude);
  const auto odd = static_cast<std::int64_t>(magnitude >> zeros);
  return {bits >> 63 ? -odd : odd, (field == 0 ? 1 : field) - 1075 + zeros};
}

// Doubles are exact on differences of at most 512 units of a lattice that contains all points.

// In units of a lattice, differences are integers; if none is above 2^9, and no difference of
// weights above 2^18, the heights are below 2^20, and every intermediate value of a polynomial of
// degree five is an integer below 2^(5·9 + 7) < 2^53: each operation is exact. So zeros on a grid
// cost nothing extra.
struct Lattice {
  // A power of two that divides every coordinate, and whose square divides every weight that
  // counts; 0: none is known.
  double unit = 0;

  [[gnu::always_inline]] bool keeps_exact(double largest, double largest_weight = 0) const {
    const double reach = kReach * unit;
    return (largest <= reach) & (largest_weight <= reach * reach);  // no branch
  }

  static constexpr double kReach = 512;
  // Within these limits, neither the square of the reach nor a product of five differences
  // overflows or underflows.
  static constexpr int kLeastExponent = -199;
  static constexpr int kGreatestExponent = 190;
};

// The coarsest lattice that contains the sites; none if its unit would be out of bounds. Requires:
// finite coordinates (and weights, if weighted).
template <std::size_t kDimension>
Lattice lattice_of(std::span<const Site<kDimension>> sites, bool weighted) {
  int exponent = Lattice::kGreatestExponent;
  const auto divide = [&exponent](double value, int degree) {
    if (value != 0) exponent = std::min(exponent, dyadic(value).exponent >> (degree - 1));
  };
  for (const auto& site : sites) {
    for (const double x : site.at) divide(x, 1);
    if (weighted) divide(site.weight, 2);
  }
  return exponent < Lattice::kLeastExponent ? Lattice{} : Lattice{std::ldexp(1, exponent)};
}

// The coarsest lattice that contains all points of a mesh, and their weights if those count; none
// if it is so fine, 2^-40 of the largest coordinate, that a mesh cannot consist of simplices of 512
// units. For almost all meshes a few points rule such a lattice out. Requires: finite numbers.
inline Lattice lattice_of_all(std::span<const double> coordinates,
                              std::span<const double> weights) {
  constexpr int kFinest = 40;
  int least = Lattice::kGreatestExponent, greatest = -2000;
  const auto divide = [&](double value, int degree) {
    if (value == 0) return true;
    const Dyadic parts = dyadic(value);
    least = std::min(least, parts.exponent >> (degree - 1));
    greatest = std::max(greatest, (parts.exponent + parts.bits_above(parts.exponent)) / degree);
    return greatest - least <= kFinest;
  };
  for (const double x : coordinates) {
    if (!divide(x, 1)) return {};
  }
  for (const double weight : weights) {
    if (!divide(weight, 2)) return {};
  }
  return least < Lattice::kLeastExponent ? Lattice{} : Lattice{std::ldexp(1, least)};
}

// Coordinates as integers in a common unit, which decide most exact signs.

// The bits of a difference in one limb.
inline constexpr int kLimbBits = 62;

// The power of two in which the largest coordinate has 61 bits, so that differences have at most
// 62.
struct GridUnit {
  int largest_exponent;  // of that coordinate
  int exponent;
  double value, inverse;

  // Nothing if there is no convenient unit. Requires: finite.
  static std::optional<GridUnit> of(double largest) {
    const int largest_exponent = exponent_of(largest);
    if (largest_exponent < -900 || largest_exponent > 900) return std::nullopt;
    const int exponent = largest_exponent - (kLimbBits - 2);
    return GridUnit{largest_exponent, exponent, power(exponent), power(-exponent)};
  }

  // The binary logarithm of |value|, rounded down.
  static int exponent_of(double value) {
    return static_cast<int>(std::bit_cast<std::uint64_t>(std::fabs(value)) >> 52) - 1023;
  }

  // The coordinates in this unit; false if one is not a multiple of it. Requires: none is larger
  // than the coordinate that the unit was made for.
  template <std::size_t kDimension>
  [[gnu::always_inline]] bool divide(const Site<kDimension>& site,
                                     std::array<std::int64_t, kDimension>& whole) const {
    bool exact = true;
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      const double x = site.at[axis];
      whole[axis] = static_cast<std::int64_t>(x * inverse);
      exact &= static_cast<double>(whole[axis]) * value == x;
    }
    return exact;
  }

 private:
  static double power(int e) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + e) << 52);
  }
};

template <std::size_t kDimension>
double largest_coordinate(const Site<kDimension>& site) {
  double largest = 0;
  for (const double x : site.at) largest = std::fabs(x) > largest ? std::fabs(x) : largest;
  return largest;
}

// Widths of differences for which a Narrow (fixed_width.hpp) of the polynomial's degree suffices.
template <std::size_t kDimension, std::size_t kCount>
constexpr int kNarrowBits = kDimension == 3 && kCount == 5 ? 23 : 30;

}  // namespace circumspect::fast
