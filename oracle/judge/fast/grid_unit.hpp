// Coordinates as integers in a common unit: what most exact signs are decided with.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "oracle/judge/fast/site.hpp"

namespace circumspect::fast {

// Of a difference in one limb.
inline constexpr int kLimbBits = 62;

// The power of two in which the largest coordinate has 61 bits, so that differences have at most
// 62.
struct GridUnit {
  int largest_exponent;  // of that coordinate
  int exponent;
  double value, inverse;

  // None if it is hard to name. Requires: finite.
  static std::optional<GridUnit> of(double largest) {
    const int largest_exponent = exponent_of(largest);
    if (largest_exponent < -900 || largest_exponent > 900) return std::nullopt;
    const int exponent = largest_exponent - (kLimbBits - 2);
    return GridUnit{largest_exponent, exponent, power(exponent), power(-exponent)};
  }

  // Of |value|, rounded down.
  static int exponent_of(double value) {
    return static_cast<int>(std::bit_cast<std::uint64_t>(std::fabs(value)) >> 52) - 1023;
  }

  // The coordinates in this unit; false if one is no multiple of it. Requires: none is larger than
  // what the unit was made for.
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
