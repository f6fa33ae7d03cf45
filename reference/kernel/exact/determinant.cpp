#include "reference/kernel/exact/determinant.hpp"

#include <cassert>
#include <utility>

namespace circumspect {

namespace {

// The 2 by 2 minor of rows `top` and `top` + 1 and two columns. It goes into a number that the
// caller has, as do all intermediate values here: an allocation takes as long as a product.
void minor2(const SquareMatrix& m, std::size_t top, std::size_t left, std::size_t right,
            Integer& result) {
  result = m(top, left) * m(top + 1, right);
  subtract_product(result, m(top, right), m(top + 1, left));
}

Integer determinant3(const SquareMatrix& m) {
  Integer result;
  Integer minor;
  minor2(m, 1, 1, 2, minor);
  result = m(0, 0) * minor;
  minor2(m, 1, 0, 2, minor);
  subtract_product(result, m(0, 1), minor);
  minor2(m, 1, 0, 1, minor);
  add_product(result, m(0, 2), minor);
  return result;
}

// Laplace's expansion along the first two rows: complementary 2 by 2 minors, those of two columns
// whose sum is even with a minus sign.
Integer determinant4(const SquareMatrix& m) {
  Integer result;
  Integer upper;
  Integer lower;
  for (std::size_t left = 0; left < 3; ++left) {
    for (std::size_t right = left + 1; right < 4; ++right) {
      minor2(m, 0, left, right, upper);
      // The other two columns.
      const std::size_t other = left == 0 ? (right == 1 ? 2 : 1) : 0;
      minor2(m, 2, other, 6 - left - right - other, lower);
      if ((left + right) % 2 == 1) {
        add_product(result, upper, lower);
      } else {
        subtract_product(result, upper, lower);
      }
    }
  }
  return result;
}

// Brings a nonzero entry of column `pivot` to the diagonal. False if there is none.
bool bring_up_pivot(SquareMatrix& m, std::size_t pivot, bool& negated) {
  for (std::size_t row = pivot; row < m.order(); ++row) {
    if (sign(m(row, pivot)) == 0) continue;
    if (row != pivot) {
      for (std::size_t column = 0; column < m.order(); ++column) {
        std::swap(m(row, column), m(pivot, column));
      }
      negated = !negated;
    }
    return true;
  }
  return false;
}

}  // namespace

Integer determinant_by_laplace(const SquareMatrix& m) {
  switch (m.order()) {
    case 0:
      return 1;
    case 1:
      return m(0, 0);
    case 2: {
      Integer result;
      minor2(m, 0, 0, 1, result);
      return result;
    }
    case 3:
      return determinant3(m);
    default:
      assert(m.order() == 4);
      return determinant4(m);
  }
}

Integer determinant_by_bareiss(SquareMatrix m) {
  const std::size_t n = m.order();
  Integer previous = 1;
  bool negated = false;
  for (std::size_t pivot = 0; pivot + 1 < n; ++pivot) {
    if (!bring_up_pivot(m, pivot, negated)) return 0;
    for (std::size_t row = pivot + 1; row < n; ++row) {
      for (std::size_t column = pivot + 1; column < n; ++column) {
        m(row, column) = exact_quotient(
            m(row, column) * m(pivot, pivot) - m(row, pivot) * m(pivot, column), previous);
      }
    }
    previous = m(pivot, pivot);
  }
  const Integer result = n == 0 ? Integer(1) : m(n - 1, n - 1);
  return negated ? Integer(-result) : result;
}

Integer determinant(SquareMatrix matrix) {
  if (matrix.order() <= 4) return determinant_by_laplace(matrix);
  return determinant_by_bareiss(std::move(matrix));
}

// ---- Linear system ----

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
