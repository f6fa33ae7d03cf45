// Small linear programs over the rationals.
#pragma once

#include <optional>
#include <vector>

#include "reference/kernel/exact/determinant.hpp"

namespace circumspect {

// Maximise objective·x subject to equations·x = right_sides, x ≥ 0.
struct LinearProgram {
  RationalMatrix equations;  // one row an equation
  std::vector<Rational> right_sides;
  std::vector<Rational> objective;
};

enum class LinearProgramStatus { kInfeasible, kUnbounded, kOptimal };

// `value` and `solution` say the optimum if there is one, and for an unbounded program some
// feasible point.
struct LinearProgramAnswer {
  LinearProgramStatus status = LinearProgramStatus::kInfeasible;
  Rational value = 0;
  std::vector<Rational> solution = {};
};

// The simplex method with Bland's rule (R. Bland, Math. Oper. Res. 2, 1977), which cannot cycle,
// from an artificial basis. Requires: rows of one length, that of the objective.
LinearProgramAnswer maximize(const LinearProgram& program);

}  // namespace circumspect
