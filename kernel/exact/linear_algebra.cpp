// Elimination by Bareiss and by Gauss, and the simplex method with Bland's rule.
#include "kernel/exact/linear_algebra.hpp"

#include <cassert>
#include <utility>

#include "kernel/exact/interruption.hpp"

namespace circumspect {

namespace {

// The 2 by 2 minor of rows `top` and `top` + 1 and two columns. The caller provides the number that
// it is stored in, as for all intermediate values here, because an allocation takes as long as a
// product.
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
        m(row, column) *= m(pivot, pivot);
        subtract_product(m(row, column), m(row, pivot), m(pivot, column));
        m(row, column) /= previous;  // without a remainder
      }
    }
    previous = m(pivot, pivot);
  }
  const Integer result = n == 0 ? Integer(1) : m(n - 1, n - 1);
  return negated ? Integer(-result) : result;
}

Integer determinant(SquareMatrix matrix) {
  end_if_interrupted();
  if (matrix.order() <= 4) return determinant_by_laplace(matrix);
  return determinant_by_bareiss(std::move(matrix));
}

std::optional<std::vector<Rational>> solve(RationalMatrix a, std::vector<Rational> b) {
  end_if_interrupted();
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

namespace {

// Rows B⁻¹[A | b] for the current basis; basis[i] is the variable that row i determines.
struct Tableau {
  RationalMatrix rows;  // the last column is the right side
  std::vector<std::size_t> basis;
  std::size_t variables;

  const Rational& right_side(std::size_t row) const { return rows[row][variables]; }
};

void pivot(Tableau& tableau, std::size_t row, std::size_t column) {
  end_if_interrupted();
  const Rational scale = tableau.rows[row][column];
  for (Rational& entry : tableau.rows[row]) entry /= scale;
  for (std::size_t other = 0; other < tableau.rows.size(); ++other) {
    const Rational factor = tableau.rows[other][column];
    if (other == row || sign(factor) == 0) continue;
    for (std::size_t j = 0; j <= tableau.variables; ++j) {
      tableau.rows[other][j] -= factor * tableau.rows[row][j];
    }
  }
  tableau.basis[row] = column;
}

// How fast the objective grows with a variable when the basic variables adapt.
Rational reduced_cost(const Tableau& tableau, const std::vector<Rational>& objective,
                      std::size_t column) {
  Rational cost = objective[column];
  for (std::size_t row = 0; row < tableau.rows.size(); ++row) {
    cost -= objective[tableau.basis[row]] * tableau.rows[row][column];
  }
  return cost;
}

// Bland's rule: among the rows that bind the entering variable first, the one with the smallest
// basic variable; nothing if none binds it.
std::optional<std::size_t> leaving_row(const Tableau& tableau, std::size_t column) {
  std::optional<std::size_t> best;
  Rational best_ratio;
  for (std::size_t row = 0; row < tableau.rows.size(); ++row) {
    if (sign(tableau.rows[row][column]) <= 0) continue;
    const Rational ratio = tableau.right_side(row) / tableau.rows[row][column];
    if (!best || ratio < best_ratio ||
        (ratio == best_ratio && tableau.basis[row] < tableau.basis[*best])) {
      best = row;
      best_ratio = ratio;
    }
  }
  return best;
}

// Pivots until no variable below `eligible` improves the objective. False if it is unbounded.
bool improve(Tableau& tableau, const std::vector<Rational>& objective, std::size_t eligible) {
  for (std::size_t column = 0; column < eligible;) {
    if (sign(reduced_cost(tableau, objective, column)) <= 0) {
      ++column;
      continue;
    }
    const std::optional<std::size_t> row = leaving_row(tableau, column);
    if (!row) return false;
    pivot(tableau, *row, column);
    column = 0;  // Bland's rule: always the smallest variable that improves.
  }
  return true;
}

// The tableau with one artificial variable a row, all of them basic.
Tableau artificial_start(const LinearProgram& program) {
  const std::size_t m = program.equations.size();
  const std::size_t n = program.objective.size();
  Tableau tableau{RationalMatrix(m, std::vector<Rational>(n + m + 1)), {}, n + m};
  for (std::size_t i = 0; i < m; ++i) {
    assert(program.equations[i].size() == n);
    const int flip = sign(program.right_sides[i]) < 0 ? -1 : 1;
    for (std::size_t j = 0; j < n; ++j) tableau.rows[i][j] = flip * program.equations[i][j];
    tableau.rows[i][n + i] = 1;
    tableau.rows[i][n + m] = flip * program.right_sides[i];
    tableau.basis.push_back(n + i);
  }
  return tableau;
}

// Makes artificial variables that stayed basic at zero leave, where a row allows it; in the other
// rows every real entry is zero, so they stay harmless.
void drive_out_artificial(Tableau& tableau, std::size_t real_variables) {
  for (std::size_t row = 0; row < tableau.rows.size(); ++row) {
    if (tableau.basis[row] < real_variables) continue;
    for (std::size_t column = 0; column < real_variables; ++column) {
      if (sign(tableau.rows[row][column]) == 0) continue;
      pivot(tableau, row, column);
      break;
    }
  }
}

Rational value_at(const Tableau& tableau, const std::vector<Rational>& objective) {
  Rational value = 0;
  for (std::size_t row = 0; row < tableau.rows.size(); ++row) {
    value += objective[tableau.basis[row]] * tableau.right_side(row);
  }
  return value;
}

}  // namespace

LinearProgramAnswer maximize(const LinearProgram& program) {
  const std::size_t n = program.objective.size();
  Tableau tableau = artificial_start(program);
  std::vector<Rational> phase_one(tableau.variables, Rational(0));
  for (std::size_t j = n; j < tableau.variables; ++j) phase_one[j] = -1;
  improve(tableau, phase_one, n);
  if (sign(value_at(tableau, phase_one)) < 0) return {};
  drive_out_artificial(tableau, n);

  std::vector<Rational> objective = program.objective;
  objective.resize(tableau.variables, Rational(0));
  LinearProgramAnswer answer;
  answer.status = improve(tableau, objective, n) ? LinearProgramStatus::kOptimal
                                                 : LinearProgramStatus::kUnbounded;
  answer.value = value_at(tableau, objective);
  answer.solution.assign(n, Rational(0));
  for (std::size_t row = 0; row < tableau.rows.size(); ++row) {
    if (tableau.basis[row] < n) answer.solution[tableau.basis[row]] = tableau.right_side(row);
  }
  return answer;
}

// Asked is for the largest ε that the positive unknowns can all reach: the program's unknowns are
// x_i − ε for these, the others, and ε.
bool is_solvable(RationalMatrix equations, std::vector<Rational> right_sides,
                 std::size_t positive) {
  LinearProgram program{std::move(equations), std::move(right_sides), {}};
  std::size_t unknowns = 0;
  for (std::vector<Rational>& row : program.equations) {
    unknowns = row.size();
    Rational sum = 0;
    for (std::size_t i = 0; i < positive; ++i) sum += row[i];
    row.push_back(sum);
  }
  program.objective.assign(unknowns, 0);
  program.objective.emplace_back(1);
  const LinearProgramAnswer answer = maximize(program);
  if (answer.status != LinearProgramStatus::kOptimal || positive == 0) {
    return answer.status != LinearProgramStatus::kInfeasible;
  }
  return sign(answer.value) > 0;
}

}  // namespace circumspect
