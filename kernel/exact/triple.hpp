// Vectors of space whose coordinates are numbers of any one kind: doubles, integers, intervals.
// Filters compute with these, and exact sums over one denominator; a Point has fractions.
#pragma once

#include <array>
#include <cstddef>

#include "kernel/exact/number.hpp"

namespace circumspect {

template <typename Number>
using Triple = std::array<Number, 3>;

template <typename Number>
Triple<Number> difference(const Triple<Number>& a, const Triple<Number>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

template <typename Number>
Number inner_product(const Triple<Number>& a, const Triple<Number>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <typename Number>
Triple<Number> cross_product(const Triple<Number>& a, const Triple<Number>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Integers need memory for each number in between; these need none.
inline Integer inner_product(const Triple<Integer>& a, const Triple<Integer>& b) {
  Integer sum;
  for (std::size_t i = 0; i < 3; ++i) add_product(sum, a[i], b[i]);
  return sum;
}
inline Triple<Integer> cross_product(const Triple<Integer>& a, const Triple<Integer>& b) {
  Triple<Integer> product;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    add_product(product[i], a[j], b[k]);
    subtract_product(product[i], a[k], b[j]);
  }
  return product;
}

}  // namespace circumspect
