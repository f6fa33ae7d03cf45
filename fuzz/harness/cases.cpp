#include "fuzz/harness/cases.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>
#include <utility>

#include <circumspect/inputs.hpp>
#include <fmt/format.h>

#include "inputs/cases.hpp"
#include "inputs/family_faults.hpp"
#include "inputs/in_doubles.hpp"

namespace circumspect::harness {

std::string node_text(const PointArray& points) {
  const bool weighted = !points.weights.empty();
  std::string text = fmt::format("{} {} {} 0\n", points.size(), points.dimension, weighted ? 1 : 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    text += std::to_string(i);
    for (std::size_t axis = 0; axis < points.dimension; ++axis) {
      text += fmt::format(" {}", points.point(i)[axis]);
    }
    if (weighted) text += fmt::format(" {}", points.weights[i]);
    text += '\n';
  }
  return text;
}

bool are_doubles(const generators::PointsCase& set) {
  using generators::is_double;
  return std::all_of(set.weights.begin(), set.weights.end(), is_double) &&
         std::all_of(set.points.begin(), set.points.end(), [&](const Point& point) {
           return std::all_of(point.begin(), point.end(), is_double);
         });
}

namespace {

const generators::Family& existing_family(const std::string& name, std::size_t dimension) {
  const generators::Family* family = generators::find_family(name);
  if (family == nullptr) {
    throw std::invalid_argument(generators::unknown_family_text("points", name));
  }
  if (!family->exists_in(dimension)) {
    throw std::invalid_argument(generators::no_sets_text(name, generators::dimensions_text(*family),
                                                         static_cast<std::int64_t>(dimension)));
  }
  return *family;
}

}  // namespace

std::vector<const generators::Family*> chosen_families(const std::vector<std::string>& names,
                                                       std::size_t dimension, bool weighted) {
  std::vector<const generators::Family*> chosen;
  for (const std::string& name : names) chosen.push_back(&existing_family(name, dimension));
  if (!names.empty()) return chosen;
  for (const generators::Family& family : generators::modified_families()) {
    if (family.exists_in(dimension) && !family.repeats_points && family.weighted == weighted) {
      chosen.push_back(&family);
    }
  }
  return chosen;
}

DrawnCase drawn_case(const std::vector<const generators::Family*>& families, std::size_t dimension,
                     std::size_t max_points, std::uint64_t run_seed, std::uint64_t index) {
  const generators::Family& family = *families[index % families.size()];
  const std::uint64_t seed = mixed_seed(run_seed, index);
  return {family.name, seed,
          generators::in_doubles(generators::drawn(family, dimension, {max_points}, seed),
                                 family.repeats_points)};
}

std::uint64_t mixed_seed(std::uint64_t run_seed, std::uint64_t index) {
  return generators::mixed(run_seed + index * generators::kMixingStep);
}

namespace {

// How much is removed in between: nothing, a few points, or about as many as are inserted.
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

namespace circumspect {

std::vector<std::string> families(std::size_t dimension) {
  std::vector<std::string> names;
  for (const auto* family : harness::chosen_families({}, dimension, false)) {
    names.push_back(family->name);
  }
  return names;
}

PointArray drawn_points(const std::string& family, std::size_t dimension, std::size_t max_points,
                        std::uint64_t seed) {
  const generators::Family& drawn_from = harness::existing_family(family, dimension);
  if (max_points == 0) throw std::invalid_argument("expected at least 1 point, found 0");
  const auto set = generators::drawn(drawn_from, dimension, {max_points}, seed);
  return generators::array(generators::in_doubles(set, drawn_from.repeats_points), dimension);
}

bool are_flat(const PointArray& points) {
  return affine_hull(generators::from(points).points).dimension <
         static_cast<int>(points.dimension);
}

}  // namespace circumspect
