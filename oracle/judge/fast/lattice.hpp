// Where doubles are exact: differences of at most 512 units, on a lattice that all points lie on.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "oracle/judge/fast/dyadic.hpp"
#include "oracle/judge/fast/site.hpp"

namespace circumspect::fast {

// In units of a lattice differences are integers; if none is above 2^9, and no difference of weights
// above 2^18, the heights are below 2^20, and whatever occurs in a polynomial of degree five is an
// integer below 2^(5·9 + 7) < 2^53: each operation is exact. So zeros on a grid cost nothing extra.
struct Lattice {
  // A power of two that divides every coordinate, its square every weight that counts; 0: none is known.
  double unit = 0;

  [[gnu::always_inline]] bool keeps_exact(double largest, double largest_weight = 0) const {
    const double reach = kReach * unit;
    return (largest <= reach) & (largest_weight <= reach * reach);  // no branch
  }

  static constexpr double kReach = 512;
  // Within these, neither the square of the reach nor a product of five differences leaves the doubles.
  static constexpr int kLeastExponent = -199;
  static constexpr int kGreatestExponent = 190;
};

// The coarsest lattice that the sites lie on; none if its unit would be out of bounds.
// Requires: finite coordinates (and weights, if weighted).
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

// The coarsest lattice that all points of a mesh lie on, and their weights if those count; none if
// it is so fine that simplices of 512 units would not make up the mesh: 2^-40 of its largest
// coordinate. Almost all meshes are off such a lattice within a few points. Requires: finite
// numbers.
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

}  // namespace circumspect::fast
