#include "reference/existence/formula.hpp"

#include <algorithm>
#include <vector>

namespace circumspect::existence {

bool is_satisfied(const Formula& formula, const std::vector<bool>& assignment) {
  const auto is_true = [&](Literal literal) {
    return assignment.at(static_cast<std::size_t>(std::abs(literal) - 1)) == (literal > 0);
  };
  return std::all_of(formula.clauses.begin(), formula.clauses.end(), [&](const Clause& clause) {
    return std::any_of(clause.begin(), clause.end(), is_true);
  });
}

}  // namespace circumspect::existence
