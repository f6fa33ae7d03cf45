#include "reference/exact/determinant.hpp"

#include <cassert>
#include <utility>

namespace circumspect {
namespace {

// The 2 by 2 minor of two rows and two columns.
Integer minor2(const SquareMatrix& m, std::size_t top, std::size_t left, std::size_t right) {
  Integer result = m(top, left) * m(top + 1, right);
  result -= m(top, right) * m(top + 1, left);
  return result;
}

Integer determinant3(const SquareMatrix& m) {
  Integer result = m(0, 0) * minor2(m, 1, 1, 2);
  result -= m(0, 1) * minor2(m, 1, 0, 2);
  result += m(0, 2) * minor2(m, 1, 0, 1);
  return result;
}

// Laplace's expansion along the first two rows: complementary 2 by 2 minors.
Integer determinant4(const SquareMatrix& m) {
  Integer result = minor2(m, 0, 0, 1) * minor2(m, 2, 2, 3);
  result -= minor2(m, 0, 0, 2) * minor2(m, 2, 1, 3);
  result += minor2(m, 0, 0, 3) * minor2(m, 2, 1, 2);
  result += minor2(m, 0, 1, 2) * minor2(m, 2, 0, 3);
  result -= minor2(m, 0, 1, 3) * minor2(m, 2, 0, 2);
  result += minor2(m, 0, 2, 3) * minor2(m, 2, 0, 1);
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
    case 2:
      return minor2(m, 0, 0, 1);
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

}  // namespace circumspect
