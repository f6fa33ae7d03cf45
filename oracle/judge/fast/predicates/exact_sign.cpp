#include "oracle/judge/fast/predicates/exact_sign.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "kernel/exact/number.hpp"
#include "oracle/judge/fast/predicates/fixed_width.hpp"
#include "oracle/judge/fast/predicates/lattice.hpp"
#include "oracle/judge/fast/predicates/polynomials.hpp"

namespace circumspect::fast {

namespace {

// An integer of any size whose operations return values, as polynomials.hpp requires: those of
// Integer itself return references to their operands.
struct Unbounded {
  Integer value;

  int sign() const { return circumspect::sign(value); }
  friend Unbounded operator+(const Unbounded& a, const Unbounded& b) { return {a.value + b.value}; }
  friend Unbounded operator-(const Unbounded& a, const Unbounded& b) { return {a.value - b.value}; }
  friend Unbounded operator*(const Unbounded& a, const Unbounded& b) { return {a.value * b.value}; }
};

// The sites but the simplex's last, as seen from there: T holds differences, H (two factors)
// heights.
template <std::size_t kDimension, std::size_t kCount, typename T, typename H>
struct Rows {
  std::array<std::array<T, kDimension>, kCount - 1> at;
  std::array<H, kCount - 1> weight;
};

template <typename T, typename H>
auto row(const std::array<T, 2>& at, const H& weight, bool weighted) {
  const H lifted = height(at[0], at[1]);
  return Row2<T, H>{at[0], at[1], weighted ? lifted - weight : lifted};
}
template <typename T, typename H>
auto row(const std::array<T, 3>& at, const H& weight, bool weighted) {
  const H lifted = height(at[0], at[1], at[2]);
  return Row3<T, H>{at[0], at[1], at[2], weighted ? lifted - weight : lifted};
}

template <typename T, typename H>
int polynomial_sign(const Rows<2, 3, T, H>& rows, bool) {
  return minor(rows.at[0][0], rows.at[0][1], rows.at[1][0], rows.at[1][1]).sign();
}

template <typename T, typename H>
int polynomial_sign(const Rows<3, 4, T, H>& rows, bool) {
  const auto without_height = [&rows](std::size_t i) {
    return Row3<T, int>{rows.at[i][0], rows.at[i][1], rows.at[i][2], 0};
  };
  return volume(without_height(0), without_height(1), without_height(2)).sign();
}

template <typename T, typename H>
int polynomial_sign(const Rows<2, 4, T, H>& rows, bool weighted) {
  const auto lifted = [&](std::size_t i) { return row(rows.at[i], rows.weight[i], weighted); };
  return in_circle(cofactors(lifted(0), lifted(1)), lifted(2)).sign();
}

template <typename T, typename H>
int polynomial_sign(const Rows<3, 5, T, H>& rows, bool weighted) {
  const auto lifted = [&](std::size_t i) { return row(rows.at[i], rows.weight[i], weighted); };
  return in_sphere(cofactors(lifted(0), lifted(1), lifted(2)), lifted(3)).sign();
}

// The index in the sites of row i: all but that of the simplex's last vertex.
template <std::size_t kDimension>
constexpr std::size_t site_of_row(std::size_t i) {
  return i < kDimension ? i : i + 1;
}

// The bits of a difference of weights, if differences of coordinates are in a Fixed<1>. Heights are
// then at most 4 · 2^124, and the polynomial of degree five at most 24 · 4 · 2^(5 · 62) < 2^319.
constexpr int kWeightBits = 2 * kLimbBits;

// value / 2^unit, if that is an integer of less than kWeightBits bits, so that differences have no
// more.
std::optional<Int128> weight_in(double value, int unit) {
  const Dyadic parts = dyadic(value);
  if (parts.mantissa == 0) return Int128{0};
  if (parts.exponent < unit || parts.bits_above(unit) >= kWeightBits) return std::nullopt;
  return static_cast<Int128>(parts.mantissa) * (Int128{1} << (parts.exponent - unit));
}

// The number of bits of a number, of |value|.
int width(std::uint64_t value) { return static_cast<int>(std::bit_width(value)); }
int width(Int128 value) {
  const auto magnitude = static_cast<UInt128>(value < 0 ? -value : value);
  const auto high = static_cast<std::uint64_t>(magnitude >> 64);
  return high != 0 ? 64 + width(high) : width(static_cast<std::uint64_t>(magnitude));
}

int trailing_zeros(Int128 value) {
  const auto low = static_cast<std::uint64_t>(value);
  return low != 0
             ? std::countr_zero(low)
             : 64 + std::countr_zero(static_cast<std::uint64_t>(static_cast<UInt128>(value) >> 64));
}

template <std::size_t kDimension, std::size_t kCount>
struct Grid {
  Rows<kDimension, kCount, std::int64_t, Int128> rows;
  int bits = 0;         // of the largest difference
  int weight_bits = 0;  // of the largest difference of weights
};

// Divides the differences by their common powers of two, and the weights by the corresponding
// powers of four.
template <std::size_t kDimension, std::size_t kCount>
void reduce(Grid<kDimension, kCount>& grid, bool weighted) {
  std::uint64_t any = 0, widest = 0;
  for (const auto& at : grid.rows.at) {
    for (const std::int64_t x : at) {
      any |= static_cast<std::uint64_t>(x);
      widest |= static_cast<std::uint64_t>(x < 0 ? -x : x);
    }
  }
  int shift = any == 0 ? 0 : std::countr_zero(any);
  if (weighted) {
    for (const Int128 weight : grid.rows.weight) {
      if (weight != 0) shift = std::min(shift, trailing_zeros(weight) / 2);
      grid.weight_bits = std::max(grid.weight_bits, width(weight));
    }
    for (Int128& weight : grid.rows.weight) weight >>= 2 * shift;
    grid.weight_bits = std::max(grid.weight_bits - 2 * shift, 0);
  }
  for (auto& at : grid.rows.at) {
    for (std::int64_t& x : at) x >>= shift;
  }
  grid.bits = width(widest >> shift);
}

// The differences as integers in a GridUnit; false if there is none, or a coordinate or weight is
// not a multiple of it.
template <std::size_t kDimension, std::size_t kCount>
bool differences(const Sites<kDimension, kCount>& sites, bool weighted,
                 Grid<kDimension, kCount>& grid) {
  double largest = 0;
  for (const auto* site : sites) largest = std::max(largest, largest_coordinate(*site));
  const std::optional<GridUnit> unit = GridUnit::of(largest);
  if (!unit) return false;
  std::array<std::array<std::int64_t, kDimension>, kCount> whole;
  bool exact = true;
  for (std::size_t i = 0; i < kCount; ++i) exact &= unit->divide(*sites[i], whole[i]);
  if (!exact) return false;
  for (std::size_t i = 0; i + 1 < kCount; ++i) {
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      grid.rows.at[i][axis] = whole[site_of_row<kDimension>(i)][axis] - whole[kDimension][axis];
    }
  }
  if (!weighted) return true;
  const std::optional<Int128> base = weight_in(sites[kDimension]->weight, 2 * unit->exponent);
  for (std::size_t i = 0; i + 1 < kCount && base; ++i) {
    const auto weight = weight_in(sites[site_of_row<kDimension>(i)]->weight, 2 * unit->exponent);
    if (!weight) return false;
    grid.rows.weight[i] = *weight - *base;
  }
  return base.has_value();
}

Fixed<1> limb(std::int64_t value) { return {{static_cast<std::uint64_t>(value)}}; }
Fixed<2> limbs(Int128 value) {
  return {{static_cast<std::uint64_t>(value),
           static_cast<std::uint64_t>(static_cast<UInt128>(value) >> 64)}};
}

template <typename T, typename H, std::size_t kDimension, std::size_t kCount, typename Number,
          typename Weight>
Rows<kDimension, kCount, T, H> as(const Rows<kDimension, kCount, std::int64_t, Int128>& rows,
                                  Number&& number, Weight&& weight, bool weighted) {
  Rows<kDimension, kCount, T, H> result;
  for (std::size_t i = 0; i + 1 < kCount; ++i) {
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      result.at[i][axis] = number(rows.at[i][axis]);
    }
    if (weighted) result.weight[i] = weight(rows.weight[i]);
  }
  return result;
}

template <std::size_t kDimension, std::size_t kCount>
std::optional<int> sign_on_grid(const Sites<kDimension, kCount>& sites, bool weighted,
                                Stages& stages) {
  Grid<kDimension, kCount> grid;
  if (!differences(sites, weighted, grid)) return std::nullopt;
  reduce(grid, weighted);
  constexpr int kBits = kNarrowBits<kDimension, kCount>;
  if (grid.bits <= kBits && grid.weight_bits <= 2 * kBits) {
    ++stages.narrow;
    return polynomial_sign(
        as<Narrow<1>, Narrow<2>>(
            grid.rows, [](std::int64_t x) { return Narrow<1>{x}; },
            [](Int128 w) { return Narrow<2>{static_cast<std::int64_t>(w)}; }, weighted),
        weighted);
  }
  ++stages.fixed;
  return polynomial_sign(as<Fixed<1>, Fixed<2>>(grid.rows, limb, limbs, weighted), weighted);
}

// The largest power of two that divides every coordinate and whose square divides every weight, and
// how many bits coordinates and weights have in these units.
struct Extent {
  int unit = 2000;
  int bits = 0;
  int weight_bits = 0;
};

template <std::size_t kDimension, std::size_t kCount>
Extent extent_of(const Sites<kDimension, kCount>& sites, bool weighted) {
  Extent extent;
  for (const auto* site : sites) {
    for (const double x : site->at) {
      if (x != 0) extent.unit = std::min(extent.unit, dyadic(x).exponent);
    }
    if (weighted && site->weight != 0) {
      extent.unit = std::min(extent.unit, dyadic(site->weight).exponent >> 1);  // rounded down
    }
  }
  for (const auto* site : sites) {
    for (const double x : site->at) {
      extent.bits = std::max(extent.bits, dyadic(x).bits_above(extent.unit));
    }
    if (!weighted) continue;
    const int bits = dyadic(site->weight).bits_above(2 * extent.unit);
    extent.weight_bits = std::max(extent.weight_bits, bits);
  }
  return extent;
}

// parts / 2^unit. Requires: it fits.
template <std::size_t kLimbs>
void assign(Fixed<kLimbs>& result, const Dyadic& parts, int unit) {
  result = {};
  if (parts.mantissa == 0) return;
  const auto shift = static_cast<std::size_t>(parts.exponent - unit);
  const auto magnitude = static_cast<std::uint64_t>(std::abs(parts.mantissa));
  result.limbs[shift / 64] = magnitude << shift % 64;
  if (shift % 64 != 0 && shift / 64 + 1 < kLimbs) {
    result.limbs[shift / 64 + 1] = magnitude >> (64 - shift % 64);
  }
  if (parts.mantissa < 0) result = Fixed<kLimbs>{} - result;
}

void assign(Unbounded& result, const Dyadic& parts, int unit) {
  result.value = to_integer(parts.mantissa);
  if (parts.mantissa != 0) result.value <<= static_cast<unsigned long>(parts.exponent - unit);
}

template <typename T, typename H, std::size_t kDimension, std::size_t kCount>
int sign_in_unit(const Sites<kDimension, kCount>& sites, bool weighted, int unit) {
  Rows<kDimension, kCount, T, H> rows;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    T base, here;
    assign(base, dyadic(sites[kDimension]->at[axis]), unit);
    for (std::size_t i = 0; i + 1 < kCount; ++i) {
      assign(here, dyadic(sites[site_of_row<kDimension>(i)]->at[axis]), unit);
      rows.at[i][axis] = here - base;
    }
  }
  H base, here;
  if (weighted) assign(base, dyadic(sites[kDimension]->weight), 2 * unit);
  for (std::size_t i = 0; i + 1 < kCount && weighted; ++i) {
    assign(here, dyadic(sites[site_of_row<kDimension>(i)]->weight), 2 * unit);
    rows.weight[i] = here - base;
  }
  return polynomial_sign(rows, weighted);
}

}  // namespace

template <std::size_t kDimension, std::size_t kCount>
int exact_sign(const Sites<kDimension, kCount>& sites, bool weighted, Stages& stages) {
  weighted = weighted && kCount == kDimension + 2;
  if (const auto sign = sign_on_grid(sites, weighted, stages)) return *sign;
  const Extent extent = extent_of(sites, weighted);
  if (extent.bits <= 125 && extent.weight_bits <= 250) {
    ++stages.wide;
    return sign_in_unit<Fixed<2>, Fixed<4>>(sites, weighted, extent.unit);
  }
  ++stages.unbounded;
  return sign_in_unit<Unbounded, Unbounded>(sites, weighted, extent.unit);
}

template int exact_sign(const Sites<2, 3>&, bool, Stages&);
template int exact_sign(const Sites<2, 4>&, bool, Stages&);
template int exact_sign(const Sites<3, 4>&, bool, Stages&);
template int exact_sign(const Sites<3, 5>&, bool, Stages&);

}  // namespace circumspect::fast
