#include "reference/existence/existence.hpp"

#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include <cadical.hpp>

#include "kernel/piecewise_linear/regions.hpp"
#include "reference/existence/formula.hpp"
#include "reference/existence/matching.hpp"
#include "reference/existence/refutation.hpp"
#include "reference/existence/solver.hpp"

namespace circumspect::existence {
namespace {

Existence decide(const PiecewiseLinearComplex& complex, const Regions& regions,
                 const Limits& limits, decltype(respecting_tetrahedra)* candidates_of) {
  if (complex.points.size() > limits.vertices) {
    return Unknown{"more than " + std::to_string(limits.vertices) + " vertices"};
  }
  std::vector<Simplex> candidates = candidates_of(complex, regions);
  if (candidates.size() > limits.candidates) {
    return Unknown{"more than " + std::to_string(limits.candidates) + " candidates"};
  }
  Formula formula = matching_formula(complex, regions, candidates);
  auto answer = solve(formula, limits.conflicts);
  if (const auto* satisfied = std::get_if<Satisfied>(&answer)) {
    if (!is_satisfied(formula, satisfied->assignment)) {
      throw std::logic_error("the solver's assignment does not satisfy the formula");
    }
    Exists exists;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if (satisfied->assignment[i]) exists.tetrahedra.push_back(candidates[i]);
    }
    return exists;
  }
  if (auto* refuted = std::get_if<Refuted>(&answer)) {
    if (!replay(formula, refuted->refutation)) {
      throw std::logic_error("the solver's refutation proves nothing");
    }
    return Impossible{std::move(candidates), std::move(formula), std::move(refuted->refutation)};
  }
  return Unknown{"after " + std::to_string(limits.conflicts) + " conflicts of the solver"};
}

}  // namespace

Existence any_triangulation(const PiecewiseLinearComplex& complex, const Regions& regions,
                            const Limits& limits) {
  return decide(complex, regions, limits, respecting_tetrahedra);
}

Existence any_cdt(const PiecewiseLinearComplex& complex, const Regions& regions,
                  const Limits& limits) {
  return decide(complex, regions, limits, constrained_delaunay_tetrahedra);
}

}  // namespace circumspect::existence
