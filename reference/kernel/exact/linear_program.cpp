#include "reference/kernel/exact/linear_program.hpp"

#include <cassert>

namespace circumspect {
namespace {

// Rows B⁻¹[A | b] for the current basis; basis[i] is the variable that row i determines.
struct Tableau {
  RationalMatrix rows;  // the last column is the right side
  std::vector<std::size_t> basis;
  std::size_t variables;

  const Rational& right_side(std::size_t row) const { return rows[row][variables]; }
};

void pivot(Tableau& tableau, std::size_t row, std::size_t column) {
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

// How fast the objective grows with a variable, the basic variables giving way.
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

}  // namespace circumspect
