// Linear algebra over the rationals: determinants, systems of linear equations, small linear
// programs.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "kernel/exact/number.hpp"

namespace circumspect {

// Determinants of integer matrices. Laplace's expansion, written out for small orders, is here for
// speed alone: `build delaunay` takes 50 % longer with elimination, which would suffice, and 130 %
// longer with cofactors.

// A square matrix of integers, row by row.
class SquareMatrix {
 public:
  explicit SquareMatrix(std::size_t order) : order_(order), entries_(order * order) {}
  std::size_t order() const { return order_; }
  Integer& operator()(std::size_t row, std::size_t column) {
    return entries_[row * order_ + column];
  }
  const Integer& operator()(std::size_t row, std::size_t column) const {
    return entries_[row * order_ + column];
  }

 private:
  std::size_t order_;
  std::vector<Integer> entries_;
};

// The determinant; 1 for the empty matrix. Orders up to 4 by Laplace's expansion, above that by
// Bareiss's fraction-free elimination (E. Bareiss, Math. Comp. 22, 1968), in which every division
// is exact and every intermediate value is a minor of the matrix.
Integer determinant(SquareMatrix matrix);

// The two methods separately, so that tests can compare them.
Integer determinant_by_laplace(const SquareMatrix& matrix);  // Requires: order <= 4.
Integer determinant_by_bareiss(SquareMatrix matrix);

// Systems of linear equations over the rationals.

using RationalMatrix = std::vector<std::vector<Rational>>;

// The solution x of A x = b by Gaussian elimination; nothing if A is singular.
// Requires: A is square, b as long as A.
std::optional<std::vector<Rational>> solve(RationalMatrix a, std::vector<Rational> b);

// Small linear programs over the rationals.

// Maximise objective·x subject to equations·x = right_sides, x ≥ 0.
struct LinearProgram {
  RationalMatrix equations;  // one row an equation
  std::vector<Rational> right_sides;
  std::vector<Rational> objective;
};

enum class LinearProgramStatus { kInfeasible, kUnbounded, kOptimal };

// `value` and `solution` are the optimum if there is one, and for an unbounded program some
// feasible point.
struct LinearProgramAnswer {
  LinearProgramStatus status = LinearProgramStatus::kInfeasible;
  Rational value = 0;
  std::vector<Rational> solution = {};
};

// The simplex method with Bland's rule (R. Bland, Math. Oper. Res. 2, 1977), which cannot cycle,
// from an artificial basis. Requires: all rows have the length of the objective.
LinearProgramAnswer maximize(const LinearProgram& program);

// Have the equations a solution in which the first `positive` unknowns are positive and the others
// are not negative? Requires: as many right sides as equations, which all have one length.
bool is_solvable(RationalMatrix equations, std::vector<Rational> right_sides,
                 std::size_t positive = 0);

}  // namespace circumspect
