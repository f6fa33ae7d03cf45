#include "fuzz/harness/exact_signs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/kernel/exact/determinant.hpp"

namespace circumspect::harness {
namespace {

// The exponent of the unit in which a double is surely an integer.
int unit_exponent(double x) { return std::max(std::ilogb(x) - 52, -1074); }

// All coordinates times one power of two that makes them integers, which changes no sign.
std::vector<Integer> integers(const std::vector<double>& coordinates) {
  int least = std::numeric_limits<int>::max();
  for (const double x : coordinates) {
    if (x != 0) least = std::min(least, unit_exponent(x));
  }
  std::vector<Integer> values;
  values.reserve(coordinates.size());
  for (const double x : coordinates) {
    if (x == 0) {
      values.emplace_back(0);
      continue;
    }
    const int unit = unit_exponent(x);
    values.emplace_back(std::ldexp(x, -unit));
    values.back() <<= static_cast<unsigned long>(unit - least);
  }
  return values;
}

}  // namespace

std::size_t argument_count(PredicateKind kind, std::size_t dimension) {
  return dimension + (kind == PredicateKind::kInSphere ? 2 : 1);
}

int exact_sign(PredicateKind kind, std::size_t dimension, const std::vector<double>& coordinates) {
  const std::vector<Integer> values = integers(coordinates);
  const std::size_t order = argument_count(kind, dimension) - 1;
  SquareMatrix matrix(order);
  for (std::size_t row = 0; row < order; ++row) {
    // |p|² − |q|² = |p − q|² + 2 ⟨p − q, q⟩: the second term is a combination of the other columns.
    Integer squared_distance = 0;
    for (std::size_t axis = 0; axis < dimension; ++axis) {
      matrix(row, axis) = values[row * dimension + axis] - values[order * dimension + axis];
      add_product(squared_distance, matrix(row, axis), matrix(row, axis));
    }
    if (kind == PredicateKind::kInSphere) matrix(row, dimension) = squared_distance;
  }
  return sign(determinant(std::move(matrix)));
}

}  // namespace circumspect::harness
