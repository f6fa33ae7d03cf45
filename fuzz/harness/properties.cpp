#include <sstream>
#include <stdexcept>

#include <circumspect/properties.hpp>

#include "fuzz/harness/cases.hpp"
#include "fuzz/harness/node_text.hpp"
#include "fuzz/harness/property_rule.hpp"
#include "inputs/arrays.hpp"
#include "inputs/minimise.hpp"
#include "oracle/report/wording.hpp"
#include "reference/kernel/exact/affine_hull.hpp"

namespace circumspect {
namespace {

using generators::PointsCase;
using harness::Broken;

// Is the set one that the options ask for?
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
  judge(options.claim, {options.dimension, {}, {}}, {});  // throws if the claim is unknown
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
