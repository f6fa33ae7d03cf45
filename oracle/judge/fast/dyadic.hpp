// A double as what it is: an integer times a power of two.
#pragma once

#include <bit>
#include <cstdint>

namespace circumspect::fast {

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

}  // namespace circumspect::fast
