#include "reference/existence/existence.hpp"

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <stdexcept>

#include <cadical.hpp>

#include "reference/existence/matching.hpp"

namespace circumspect::existence {

namespace {

// A file in memory to which the solver writes its proof.
class ProofFile {
 public:
  ProofFile() : file_(open_memstream(&bytes_, &size_)) {
    if (file_ == nullptr) throw std::runtime_error("no memory for the solver's proof");
  }
  ~ProofFile() {
    std::fclose(file_);
    std::free(bytes_);
  }
  ProofFile(const ProofFile&) = delete;
  ProofFile& operator=(const ProofFile&) = delete;

  FILE* file() { return file_; }
  std::string_view text() {
    std::fflush(file_);
    return {bytes_, size_};
  }

 private:
  char* bytes_ = nullptr;
  std::size_t size_ = 0;
  FILE* file_;
};

}  // namespace

std::variant<Satisfied, Refuted, Undecided> solve(const Formula& formula, int conflict_limit) {
  constexpr int kSatisfiable = 10, kUnsatisfiable = 20;
  ProofFile proof;
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

// ---- Existence ----

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
