#include "reference/existence/solver.hpp"

#include <stdexcept>
#include <string>
#include <variant>

#include <cadical.hpp>

#include "platform/scratch_file.hpp"
#include "reference/existence/formula.hpp"
#include "reference/existence/refutation.hpp"

namespace circumspect::existence {

std::variant<Satisfied, Refuted, Undecided> solve(const Formula& formula, int conflict_limit) {
  constexpr int kSatisfiable = 10, kUnsatisfiable = 20;
  platform::ScratchFile proof;
  CaDiCaL::Solver solver;
  // Plain search, so that each clause it learns follows by unit propagation.
  solver.configure("plain");
  solver.set("quiet", 1);
  solver.set("binary", 0);
  solver.trace_proof(proof.file(), "proof");
  for (const Clause& clause : formula.clauses) {
    for (const Literal literal : clause) solver.add(literal);
    solver.add(0);
  }
  if (conflict_limit > 0) solver.limit("conflicts", conflict_limit);
  const int answer = solver.solve();
  if (answer == kSatisfiable) {
    Satisfied satisfied;
    for (int v = 1; v <= formula.variables; ++v) {
      satisfied.assignment.push_back(v <= solver.vars() && solver.val(v) > 0);
    }
    return satisfied;
  }
  if (answer != kUnsatisfiable) return Undecided{};
  solver.close_proof_trace();
  auto refutation = read_refutation(proof.text());
  if (!refutation) throw std::runtime_error("the solver's proof cannot be read");
  return Refuted{*std::move(refutation)};
}

std::string solver_version() { return std::string("CaDiCaL ") + CaDiCaL::Solver::version(); }

}  // namespace circumspect::existence
