// One property of one program on one set of points.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

#include <circumspect/properties.hpp>

#include "fuzz/harness/answer.hpp"
#include "fuzz/harness/cases.hpp"
#include "inputs/cases.hpp"
#include "inputs/dice.hpp"
#include "inputs/minimise.hpp"
#include "kernel/exact/point.hpp"
#include "oracle/judge/arrays/mesh_of.hpp"
#include "oracle/judge/judge.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::harness {

// The broken rule, and how it is broken; an empty rule if none is.
struct Broken {
  std::string rule = {};
  std::string report = {};
};

// The properties other than the claim compare answers, and only if the first answer is right: the
// claim covers wrong answers. `seed` is for the order in which the points are passed. Requires: the
// numbers of `set` are doubles.
Broken broken_rule(const Triangulator& subject, Property property, const PropertyOptions& options,
                   const generators::PointsCase& set, std::uint64_t seed);

namespace {

Answer answer_to(const Triangulator& subject, const PropertyOptions& options,
                 const PointArray& points) {
  return options.isolated ? isolated_answer(subject, points, options.time_limit)
                          : answer(subject, points);
}

Broken broken_by_ending(const Answer& given) {
  return {given.failure, given.text.empty() ? "the program ended by: " + given.failure + "\n"
                                            : "the program threw: " + given.text + "\n"};
}

Broken broken_claim(const PropertyOptions& options, const PointArray& points, const Answer& given) {
  if (!given.failure.empty()) return broken_by_ending(given);
  const Judgement judgement = judge(options.claim, points, given.simplices, harness::kJudgeOfCases);
  return {judgement.rule, judgement.report};
}

// Rows and indices in ascending order, under other numbers for the points.
SimplexArray as_a_set(SimplexArray simplices, const std::vector<std::int64_t>& numbers) {
  for (auto& simplex : simplices) {
    for (std::int64_t& v : simplex) {
      if (v >= 0 && v < static_cast<std::int64_t>(numbers.size())) {
        v = numbers[static_cast<std::size_t>(v)];
      }
    }
    std::sort(simplex.begin(), simplex.end());
  }
  std::sort(simplices.begin(), simplices.end());
  return simplices;
}

std::vector<std::int64_t> same_numbers(const PointArray& points) {
  std::vector<std::int64_t> numbers(points.size());
  std::iota(numbers.begin(), numbers.end(), std::int64_t{0});
  return numbers;
}

// The points in another order; numbers[i] is the old number of the new point i.
PointArray reordered(const PointArray& points, const std::vector<std::int64_t>& numbers) {
  PointArray moved{points.dimension, {}, {}};
  for (const std::int64_t old : numbers) {
    const double* point = points.point(static_cast<std::size_t>(old));
    moved.coordinates.insert(moved.coordinates.end(), point, point + points.dimension);
    if (!points.weights.empty()) {
      moved.weights.push_back(points.weights[static_cast<std::size_t>(old)]);
    }
  }
  return moved;
}

bool survives(double value, int exponent) {
  const double image = std::ldexp(value, exponent);
  return std::isfinite(image) && std::ldexp(image, -exponent) == value;
}

// The axes rotated by one place, and every length times 8 (weights, which are squared lengths,
// times 64): exact, or the points themselves if a number would overflow.
PointArray similar(const PointArray& points) {
  PointArray image = points;
  for (std::size_t i = 0; i < points.coordinates.size(); ++i) {
    const std::size_t row = i / points.dimension * points.dimension;
    const std::size_t axis = (i - row + 1) % points.dimension;
    if (!survives(points.coordinates[i], 3)) return points;
    image.coordinates[row + axis] = std::ldexp(points.coordinates[i], 3);
  }
  for (double& weight : image.weights) {
    if (!survives(weight, 6)) return points;
    weight = std::ldexp(weight, 6);
  }
  return image;
}

// Is the answer right, and the only right one? Book: Theorem 4.4; sets that are not generic have
// only one, too, if their Delaunay subdivision is simplicial (Section 4.2).
bool is_the_only_answer(const PropertyOptions& options, const PointArray& points,
                        const Answer& given) {
  if (!given.failure.empty() || options.claim == "triangulation") return false;
  const bool weighted = options.claim == "weighted-delaunay";
  Mesh mesh = arrays::mesh_of(points, given.simplices, weighted);
  const Claim claim = weighted ? Claim::kWeightedDelaunay : Claim::kDelaunay;
  const Verdict verdict = check::judge(claim, check::Merging{mesh}, nullptr, {.threads = 1});
  return verdict.holds() && verdict.unique.value_or(false);
}

Broken compared(Property property, const Answer& first, const Answer& again,
                const PointArray& points, const std::vector<std::int64_t>& numbers) {
  if (!again.failure.empty()) return broken_by_ending(again);
  if (as_a_set(first.simplices, same_numbers(points)) == as_a_set(again.simplices, numbers)) {
    return {};
  }
  return {std::string(name(property)),
          "two answers differ: " + report::counted(first.simplices.size(), "simplex", "simplices") +
              " and " + std::to_string(again.simplices.size()) + ", not the same ones\n"};
}

}  // namespace

Broken broken_rule(const Triangulator& subject, Property property, const PropertyOptions& options,
                   const generators::PointsCase& set, std::uint64_t seed) {
  const PointArray points = generators::array(set, options.dimension);
  const Answer given = answer_to(subject, options, points);
  if (property == Property::kClaim) return broken_claim(options, points, given);
  if (!given.failure.empty()) return {};
  const std::vector<std::int64_t> numbers = same_numbers(points);
  if (property == Property::kDeterministic) {
    return compared(property, given, answer_to(subject, options, points), points, numbers);
  }
  if (!is_the_only_answer(options, points, given)) return {};
  if (property == Property::kSimilarity) {
    return compared(property, given, answer_to(subject, options, similar(points)), points, numbers);
  }
  std::vector<std::int64_t> order = numbers;
  generators::Dice dice(seed);
  generators::shuffle(order, dice);
  return compared(property, given, answer_to(subject, options, reordered(points, order)), points,
                  order);
}

}  // namespace circumspect::harness

namespace circumspect {

namespace {

using generators::PointsCase;
using harness::Broken;

// Do the options ask for such a set?
bool is_wanted(const PropertyOptions& options, const PointsCase& set) {
  if (set.points.size() < options.min_points) return false;
  if (options.flat_sets) return true;
  return affine_hull(set.points).dimension == static_cast<int>(options.dimension);
}

Finding finding(const Triangulator& subject, Property property, const PropertyOptions& options,
                const harness::DrawnCase& drawn, const std::string& rule) {
  const auto still_fails = [&](const PointsCase& smaller) {
    return is_wanted(options, smaller) && harness::are_doubles(smaller) &&
           harness::broken_rule(subject, property, options, smaller, drawn.seed).rule == rule;
  };
  const PointsCase smallest = generators::minimised(drawn.set, still_fails);
  const Broken broken = harness::broken_rule(subject, property, options, smallest, drawn.seed);
  Finding result{property,
                 drawn.family,
                 drawn.seed,
                 generators::array(drawn.set, options.dimension),
                 generators::array(smallest, options.dimension),
                 rule,
                 ""};
  std::ostringstream report;
  report << name(property) << ": " << rule << " on "
         << report::counted(smallest.points.size(), "point") << ", made of "
         << drawn.set.points.size() << ":\n"
         << "  circumspect generate " << drawn.family << " --fewer --points " << options.max_points
         << " --dimension " << options.dimension << " --seed " << drawn.seed << "\n"
         << harness::node_text(result.points) << broken.report;
  result.report = report.str();
  return result;
}

}  // namespace

std::string_view name(Property property) {
  switch (property) {
    case Property::kClaim:
      return "claim";
    case Property::kDeterministic:
      return "deterministic";
    case Property::kOrder:
      return "order";
    case Property::kSimilarity:
      return "similarity";
  }
  return "";
}

std::optional<Finding> find_failure(const Triangulator& subject, Property property,
                                    const PropertyOptions& options) {
  if (options.dimension < 1 || options.dimension > 4) {
    throw std::invalid_argument("expected a dimension from 1 to 4, found " +
                                std::to_string(options.dimension));
  }
  arrays::claim_named(options.claim);  // throws if it is unknown
  const auto families = harness::chosen_families(options.families, options.dimension,
                                                 options.claim == "weighted-delaunay");
  for (std::uint64_t index = 0; index < options.cases; ++index) {
    const harness::DrawnCase drawn =
        harness::drawn_case(families, options.dimension, options.max_points, options.seed, index);
    if (!is_wanted(options, drawn.set)) continue;
    const Broken broken = harness::broken_rule(subject, property, options, drawn.set, drawn.seed);
    if (!broken.rule.empty()) return finding(subject, property, options, drawn, broken.rule);
  }
  return std::nullopt;
}

}  // namespace circumspect
