// The inputs of a run in process: points drawn from a family, as text, and sequences of
// insertions and deletions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <circumspect/judgement.hpp>
#include <circumspect/sequences.hpp>
#include <circumspect/subject.hpp>

#include "inputs/cases.hpp"
#include "inputs/dice.hpp"
#include "inputs/families.hpp"

namespace circumspect::harness {

using generators::Dice;

// Points as the text of a .node file that any reader turns back into the same doubles.

std::string node_text(const PointArray& points);

// Is every number a double?
bool are_doubles(const generators::PointsCase& set);

// The inputs of a run in process: the order of cases, and the family of each.

// A harness has drawn the points itself: there are equal ones only if the user names a family that
// repeats points, and none if a sequence has removed all.
inline constexpr JudgeOptions kJudgeOfCases{.merge_equal_points = true, .allow_empty = true};

// The families with these names; without names, all families of the dimension that have distinct
// points, and weights if the claim is about them. Throws std::invalid_argument: a name that is
// unknown, or a family that does not exist in the dimension.
std::vector<const generators::Family*> chosen_families(const std::vector<std::string>& names,
                                                       std::size_t dimension, bool weighted);

struct DrawnCase {
  std::string family;
  std::uint64_t seed = 0;
  generators::PointsCase set;  // of doubles
};

// Case number `index` of a run, the families in turn.
DrawnCase drawn_case(const std::vector<const generators::Family*>& families, std::size_t dimension,
                     std::size_t max_points, std::uint64_t run_seed, std::uint64_t index);

// A number made of two; neighbouring arguments give unrelated results.
std::uint64_t mixed_seed(std::uint64_t run_seed, std::uint64_t index);

// Random sequences of insertions and deletions, and ways to make them shorter.

// Sequence number `index` of a run: at most max_steps steps, which insert points of one set of a
// family in its order and, if asked for, remove some in between, or all of them in the end.
struct DrawnSequence {
  std::string family;
  std::vector<Step> steps;
};
DrawnSequence drawn_sequence(const std::vector<const generators::Family*>& families,
                             const SequenceOptions& options, std::uint64_t index);

// Without the steps whose mark is false; a removal whose insertion is left out goes too. Points are
// renumbered in the order of insertion.
std::vector<Step> kept_steps(const std::vector<Step>& steps, const std::vector<bool>& marks);

}  // namespace circumspect::harness
