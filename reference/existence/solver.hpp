// Deciding a formula by the solver CaDiCaL (A. Biere).
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "reference/existence/formula.hpp"
#include "reference/existence/refutation.hpp"

namespace circumspect::existence {

struct Satisfied {
  std::vector<bool> assignment;  // of variable v in place v − 1
};
struct Refuted {
  Refutation refutation;
};
struct Undecided {};  // within the limit

// Satisfied, refuted, or undecided after so many conflicts (0: no limit). The answer is the
// solver's claim until `is_satisfied` or `replay` has confirmed it. Throws std::runtime_error if
// there is no memory for the solver's proof, or if the proof that it has written cannot be read.
std::variant<Satisfied, Refuted, Undecided> solve(const Formula& formula, int conflict_limit = 0);

// The name and the version of the solver.
std::string solver_version();

}  // namespace circumspect::existence
