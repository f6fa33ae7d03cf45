#include "properties/faulty/hunt.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <sstream>

#include "inputs/cases.hpp"
#include "inputs/complex_families.hpp"
#include "inputs/dice.hpp"
#include "inputs/families.hpp"
#include "inputs/in_doubles.hpp"
#include "inputs/minimise.hpp"
#include "inputs/triangulated/domain_families.hpp"
#include "kernel/piecewise_linear/validity.hpp"
#include "oracle/judge/domain/judge_exactly.hpp"
#include "properties/faulty/plain_predicates.hpp"

namespace circumspect::faulty {

namespace {

using generators::ComplexCase;
using generators::PointsCase;

constexpr std::chrono::hours kNoTimeLimit{1000};  // what comes out must not depend on it
constexpr std::size_t kMostVertices = 9;          // of domains
constexpr std::size_t kTrialsOfMany = 15;         // of large inputs, for each takes long

// Any two inputs of any two seeds are unrelated.
using generators::mixed;

// FNV-1a.
std::uint64_t hash_of(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return hash;
}

template <typename Choices>
const auto& choice(const Choices& choices, std::uint64_t seed) {
  return choices[mixed(seed) % choices.size()];
}

// The rule broken first; empty if none is.
std::string rule_of(const Verdict& verdict) {
  return verdict.holds() ? "" : std::string(identifier(verdict.violations().front().rule));
}

std::string broken_rule(const Fault& fault, const PointsCase& set, check::By by) {
  const PointArray points = generators::array(set, fault.dimensions.front());
  ExactMesh mesh{PointSet(set.points, set.weights), {}};
  try {
    const SimplexArray rows = fault.triangulate(points);
    mesh.simplices.assign(rows.begin(), rows.end());
  } catch (const std::exception& error) {
    return std::string("crash: ") + error.what();
  }
  return rule_of(check::judge_exactly(fault.claim, mesh, nullptr,
                                      {.by = by, .oriented = fault.oriented, .max_violations = 1}));
}

std::string broken_rule(const Fault& fault, const ComplexCase& domain, check::By by) {
  const auto complex = validated(domain.input, 1);
  if (!complex) return "";
  const std::optional<ExactMesh> mesh = fault.mesh(domain.input);
  if (!mesh) return "";
  const Domain about{*complex};
  return rule_of(check::judge_exactly(fault.claim, *mesh, &about, {.by = by, .max_violations = 1}));
}

std::size_t size_of(const PointsCase& set) { return set.points.size(); }
std::size_t size_of(const ComplexCase& domain) { return domain.input.points.size(); }

// The input, if a rule is broken, and what is left of it when it is minimised while that rule is.
template <typename Case>
std::optional<Catch> caught(const Fault& fault, const Case& whole, const HuntOptions& options) {
  const std::string rule = broken_rule(fault, whole, check::By::kLemma);
  if (rule.empty()) return std::nullopt;
  const generators::StillFails<Case> breaks_it = [&](const Case& smaller) {
    return broken_rule(fault, generators::in_doubles(smaller), check::By::kLemma) == rule;
  };
  const std::size_t most_trials =
      fault.needs_many ? std::min(options.most_trials, kTrialsOfMany) : options.most_trials;
  const Case least = generators::minimised(whole, breaks_it, {most_trials, kNoTimeLimit});
  const bool by_definition =
      !broken_rule(fault, generators::in_doubles(least), check::By::kDefinition).empty();
  return Catch{0, "", rule, size_of(whole), size_of(least), by_definition};
}

std::vector<const generators::Family*> point_families(const Fault& fault, std::size_t dimension) {
  std::vector<const generators::Family*> all;
  for (const generators::Family& family : generators::modified_families()) {
    if (family.weighted == (fault.claim == Claim::kWeightedDelaunay) &&
        family.exists_in(dimension)) {
      all.push_back(&family);
    }
  }
  return all;
}

std::optional<Catch> caught_in_points(const Fault& fault, std::uint64_t seed,
                                      const HuntOptions& options) {
  const std::size_t dimension = choice(fault.dimensions, seed);
  const auto families = point_families(fault, dimension);
  if (families.empty()) return std::nullopt;
  const generators::Family& family = *choice(families, seed + 1);
  const generators::Count count = fault.needs_many
                                      ? generators::count_of_a_campaign(dimension, seed)
                                      : generators::Count{fault.most_points};
  if (count.most > fault.most_points) return std::nullopt;
  const PointsCase set = generators::drawn(family, dimension, count, seed);
  auto found = caught(fault, generators::in_doubles(set), options);
  if (found) found->family = family.name;
  return found;
}

std::optional<Catch> caught_in_a_domain(const Fault& fault, std::uint64_t seed,
                                        const HuntOptions& options) {
  const std::size_t dimension = choice(fault.dimensions, seed);
  std::vector<const generators::ComplexFamily*> families;
  for (const generators::ComplexFamily& family : properties::domain_families()) {
    if (family.dimension == dimension) families.push_back(&family);
  }
  const generators::ComplexFamily& family = *choice(families, seed + 1);
  const ComplexCase domain = generators::drawn(family, kMostVertices, seed);
  auto found = caught(fault, domain, options);
  if (found) found->family = family.name;
  return found;
}

}  // namespace

std::optional<Catch> hunt(const Fault& fault, const HuntOptions& options) {
  const std::uint64_t first = options.seed ^ hash_of(fault.name);
  for (std::size_t i = 0; i < options.most_inputs; ++i) {
    const std::uint64_t seed = mixed(first ^ mixed(i));
    auto found = fault.mesh ? caught_in_a_domain(fault, seed, options)
                            : caught_in_points(fault, seed, options);
    if (!found) continue;
    found->inputs = i + 1;
    return found;
  }
  return std::nullopt;
}

namespace {

// With the bars of |p|² escaped, which would part the cells of a table.
std::string in_a_cell(const std::string& text) {
  std::string escaped;
  for (const char c : text) escaped += c == '|' ? "\\|" : std::string(1, c);
  return escaped;
}

std::string row(const Found& found) {
  const Fault& fault = *found.fault;
  std::ostringstream line;
  line << "| `" << fault.name << "` | " << name(fault.kind) << " | " << in_a_cell(fault.about)
       << " | `" << name(fault.claim) << "` | ";
  if (!found.caught) {
    line << "not caught | | | |\n";
    return line.str();
  }
  const Catch& caught = *found.caught;
  line << caught.inputs << " | `" << caught.family << "` | `" << caught.rule << "` | "
       << caught.points << " → " << caught.least_points << " |\n";
  return line.str();
}

}  // namespace

std::vector<Found> hunt_all(const HuntOptions& options) {
  std::vector<Found> all;
  for (const Fault& fault : faults()) all.push_back({&fault, hunt(fault, options)});
  return all;
}

std::string table(const std::vector<Found>& all) {
  std::vector<std::size_t> inputs;
  for (const Found& found : all) {
    if (found.caught) inputs.push_back(found.caught->inputs);
  }
  std::sort(inputs.begin(), inputs.end());
  std::ostringstream text;
  text << "| fault | kind | the mistake | claim | inputs | family | rule | points |\n"
       << "|---|---|---|---|---:|---|---|---:|\n";
  for (const Found& found : all) text << row(found);
  text << "\n" << inputs.size() << " of " << all.size() << " caught";
  if (!inputs.empty()) {
    text << "; inputs until caught: median " << inputs[inputs.size() / 2] << ", at most "
         << inputs.back();
  }
  text << ".\n";
  return text.str();
}

}  // namespace circumspect::faulty
