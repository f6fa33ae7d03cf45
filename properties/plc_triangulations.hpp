// All triangulations of a small complex, CDTs or not. Book: Definition 4.4.
#pragma once

#include <algorithm>
#include <vector>

#include "reference/existence/existence.hpp"
#include "reference/existence/matching.hpp"

namespace circumspect::properties {

// Triangulations of the polyhedra of a complex that consist of some of the candidates, each with its
// tetrahedra ascending, in no particular order: all of them, or as many as `limit`. Each is a solution
// of the formula; a clause that forbids it lets the solver find the next.
// Requires: every candidate respects the complex.
inline std::vector<std::vector<Simplex>> plc_triangulations(const PiecewiseLinearComplex& complex,
                                                            const Regions& regions,
                                                            const std::vector<Simplex>& candidates,
                                                            std::size_t limit) {
  existence::Formula formula = existence::matching_formula(complex, regions, candidates);
  std::vector<std::vector<Simplex>> all;
  while (all.size() < limit) {
    const auto answer = existence::solve(formula);
    const auto* satisfied = std::get_if<existence::Satisfied>(&answer);
    if (satisfied == nullptr) break;
    std::vector<Simplex> tetrahedra;
    existence::Clause another;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if (!satisfied->assignment[i]) continue;
      tetrahedra.push_back(candidates[i]);
      another.push_back(-static_cast<existence::Literal>(i) - 1);
    }
    all.push_back(std::move(tetrahedra));
    formula.clauses.push_back(std::move(another));
  }
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace circumspect::properties
