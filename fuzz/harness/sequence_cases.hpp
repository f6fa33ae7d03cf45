// Random sequences of insertions and deletions, and ways to make them shorter.
#pragma once

#include <cstdint>
#include <vector>

#include <circumspect/sequences.hpp>

#include "fuzz/harness/cases.hpp"

namespace circumspect::harness {

// Sequence number `index` of a run: at most max_steps steps, which insert points of one set of a
// family in its order and, if asked for, remove some in between, or all of them in the end.
struct DrawnSequence {
  std::string family;
  std::vector<Step> steps;
};
DrawnSequence drawn_sequence(const std::vector<const generators::Family*>& families,
                             const SequenceOptions& options, std::uint64_t index);

// Without the steps whose mark is false; a removal whose insertion is left out goes too. Numbers are
// given anew, in the order of insertion.
std::vector<Step> kept_steps(const std::vector<Step>& steps, const std::vector<bool>& marks);

}  // namespace circumspect::harness
