// Where doubles are exact: differences of at most 512 units, on a lattice that all points lie on.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "oracle/fast/dyadic.hpp"
#include "oracle/fast/site.hpp"

namespace circumspect::fast {

// In units of a lattice differences are integers; if none is above 2^9, and no difference of weights
// above 2^18, the heights are below 2^20, and whatever occurs in a polynomial of degree five is an
// integer below 2^(5·9 + 7) < 2^53: each operation is exact. So zeros on a grid cost nothing extra.
struct Lattice {
  // A power of two that divides every coordinate, its square every weight that counts; 0: none is known.
  double unit = 0;

  bool keeps_exact(double largest, double largest_weight = 0) const {
    const double reach = kReach * unit;
    return largest <= reach && largest_weight <= reach * reach;
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

}  // namespace circumspect::fast
