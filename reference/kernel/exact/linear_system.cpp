#include "reference/kernel/exact/linear_system.hpp"

#include <cassert>
#include <utility>

namespace circumspect {

std::optional<std::vector<Rational>> solve(RationalMatrix a, std::vector<Rational> b) {
  const std::size_t n = a.size();
  assert(b.size() == n);
  for (std::size_t column = 0; column < n; ++column) {
    std::size_t pivot = column;
    while (pivot < n && sign(a[pivot][column]) == 0) ++pivot;
    if (pivot == n) return std::nullopt;
    std::swap(a[pivot], a[column]);
    std::swap(b[pivot], b[column]);
    for (std::size_t row = 0; row < n; ++row) {
      if (row == column || sign(a[row][column]) == 0) continue;
      const Rational factor = a[row][column] / a[column][column];
      for (std::size_t j = column; j < n; ++j) a[row][j] -= factor * a[column][j];
      b[row] -= factor * b[column];
    }
  }
  for (std::size_t i = 0; i < n; ++i) b[i] /= a[i][i];
  return b;
}

}  // namespace circumspect
