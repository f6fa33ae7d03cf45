#include "reference/existence/solver.hpp"

#include <cstdlib>
#include <stdexcept>
#include <string>
#include <variant>

#include <cadical.hpp>

#include "reference/existence/formula.hpp"
#include "reference/existence/refutation.hpp"

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

}  // namespace circumspect::existence
