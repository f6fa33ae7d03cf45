// Propositional formulas in conjunctive normal form.
#pragma once

#include <vector>

namespace circumspect::existence {

// A variable v > 0 or its negation −v, as SAT solvers write them.
using Literal = int;
// True iff one of its literals is.
using Clause = std::vector<Literal>;

// True iff every clause is. Variables are 1 … variables.
struct Formula {
  int variables = 0;
  std::vector<Clause> clauses;
};

// Is every clause true where exactly the variables v with assignment[v − 1] are?
bool is_satisfied(const Formula& formula, const std::vector<bool>& assignment);

}  // namespace circumspect::existence
