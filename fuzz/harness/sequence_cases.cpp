#include "fuzz/harness/sequence_cases.hpp"

#include <array>
#include <map>
#include <utility>

#include "inputs/arrays.hpp"
#include "inputs/dice.hpp"

namespace circumspect::harness {
namespace {

using generators::Dice;

// What is removed in between: nothing, a few points, about as many as are inserted.
std::size_t removals_in_ten(const SequenceOptions& options, Dice& dice) {
  return options.removes ? std::array<std::size_t, 3>{0, 2, 5}[dice.below(3)] : 0;
}

}  // namespace

DrawnSequence drawn_sequence(const std::vector<const generators::Family*>& families,
                             const SequenceOptions& options, std::uint64_t index) {
  const DrawnCase drawn =
      drawn_case(families, options.dimension, options.max_steps, options.seed, index);
  const PointArray points = generators::array(drawn.set, options.dimension);
  Dice dice(mixed_seed(drawn.seed, 1));
  const std::size_t rate = removals_in_ten(options, dice);
  const bool empties = options.removes && dice.below(4) == 0;
  DrawnSequence sequence{drawn.family, {}};
  std::vector<std::int64_t> present;
  const auto remove_one = [&] {
    const std::size_t at = dice.below(present.size());
    sequence.steps.push_back({true, present[at], {}});
    std::swap(present[at], present.back());
    present.pop_back();
  };
  for (std::size_t next = 0; next < points.size() && sequence.steps.size() < options.max_steps;) {
    if (!present.empty() && dice.below(10) < rate) {
      remove_one();
      continue;
    }
    const auto number = static_cast<std::int64_t>(next);
    const double* const point = points.point(next);
    sequence.steps.push_back({false, number, {point, point + options.dimension}});
    present.push_back(number);
    ++next;
  }
  while (empties && !present.empty() && sequence.steps.size() < options.max_steps) remove_one();
  return sequence;
}

std::vector<Step> kept_steps(const std::vector<Step>& steps, const std::vector<bool>& marks) {
  std::vector<Step> kept;
  std::map<std::int64_t, std::int64_t> number_of;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (!marks[i]) continue;
    Step step = steps[i];
    if (step.is_removal) {
      const auto found = number_of.find(step.number);
      if (found == number_of.end()) continue;
      step.number = found->second;
    } else {
      const auto next = static_cast<std::int64_t>(number_of.size());
      number_of[step.number] = next;
      step.number = next;
    }
    kept.push_back(std::move(step));
  }
  return kept;
}

}  // namespace circumspect::harness
