// Refutations: proofs that a formula is unsatisfiable, and a checker of them that shares nothing
// with the solver that found them. E. Goldberg and Y. Novikov, Verification of proofs of
// unsatisfiability for CNF formulas, DATE 2003.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "reference/existence/formula.hpp"

namespace circumspect::existence {

// One line of a proof in the format DRAT: a clause that follows from those before it, or one that
// is no longer needed.
struct ProofStep {
  bool deletes = false;
  Clause clause;
};
using Refutation = std::vector<ProofStep>;

// A variable that no clause names only wastes memory: a file that names a larger one is malformed.
inline constexpr Literal kLargestVariable = 50'000'000;

// A line of a file that is not one of the format, counted from 1, what was expected there, and what
// was found instead: the line or the word at fault between quotes, or "the end of the file".
struct MalformedProof {
  std::size_t line;
  std::string expected;
  std::string found;
};

// A text from a file between quotes: short enough for a message, and printable on a terminal.
std::string in_quotes(std::string_view text);

// Reads DRAT's text: a line a step, the clause's literals and 0, after `d` for a deletion.
tl::expected<Refutation, MalformedProof> read_refutation(std::string_view text);
std::string to_text(const Refutation& refutation);

// Why a proof fails: the first step that does not follow (its place from 0), or the number of steps
// if the empty clause does not follow from all of them.
struct ProofFault {
  std::size_t step;
};

// Replays a proof. Each clause must follow from those before it by reverse unit propagation (RUP):
// assume all of its literals false; as long as some clause has but one literal that is not false,
// make that one true; some clause must become false. A clause that passes does follow, because each
// propagation is forced; so if the empty clause passes, as a step or after the last one, nothing
// satisfies the formula. Deletions only save time; deleting a clause that is not there is ignored.
tl::expected<void, ProofFault> replay(const Formula& formula, const Refutation& refutation);

// A step with the clauses that become unit in turn if its literals are false, and at last the one
// that becomes false: by their numbers from 0, the formula's before the steps'.
struct HintedStep {
  Clause clause;
  std::vector<std::size_t> hints;
};
// A proof in a form that can be replayed without search; its last step is the empty clause. Nothing
// if it does not replay.
std::optional<std::vector<HintedStep>> with_hints(const Formula& formula,
                                                  const Refutation& refutation);

}  // namespace circumspect::existence
