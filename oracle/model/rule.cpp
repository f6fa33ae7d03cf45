#include "oracle/model/rule.hpp"

#include <algorithm>
#include <array>
#include <tuple>

namespace circumspect {
namespace {

constexpr std::tuple<Stage, Rule> turn(const RuleEntry& entry) { return {entry.stage, entry.rule}; }

constexpr auto sorted_rules() {
  std::array all = {
#define RULE(number, name, identifier, stage, of, mark, ...) \
  RuleEntry{Rule::name, identifier, Stage::stage, JudgedOf::of, Mark::mark, __VA_ARGS__},
#include "oracle/model/rules.def"
  };
  std::sort(all.begin(), all.end(),
            [](const RuleEntry& a, const RuleEntry& b) { return turn(a) < turn(b); });
  return all;
}

constexpr std::array kRules = sorted_rules();

// No two rows have the same value in this column.
template <typename Column>
constexpr bool is_unique(Column column) {
  for (std::size_t i = 0; i < kRules.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (kRules[i].*column == kRules[j].*column) return false;
    }
  }
  return true;
}
static_assert(is_unique(&RuleEntry::rule), "rules.def: a number is given twice");
static_assert(is_unique(&RuleEntry::identifier), "rules.def: an identifier is given twice");

// The row of each number: verdicts with a million violations look rules up a million times.
constexpr auto places_of_numbers() {
  constexpr Rule kLast = std::max_element(kRules.begin(), kRules.end(), [](auto& a, auto& b) {
                           return a.rule < b.rule;
                         })->rule;
  std::array<std::size_t, static_cast<std::size_t>(kLast) + 1> places{};
  for (std::size_t i = 0; i < kRules.size(); ++i) {
    places[static_cast<std::size_t>(kRules[i].rule)] = i;
  }
  return places;
}
constexpr std::array kPlaces = places_of_numbers();

}  // namespace

std::span<const RuleEntry> rules() { return kRules; }

const RuleEntry& entry(Rule rule) { return kRules[kPlaces[static_cast<std::size_t>(rule)]]; }

std::string_view identifier(Rule rule) { return entry(rule).identifier; }
std::string_view meaning(Rule rule) { return entry(rule).meaning; }
Stage stage(Rule rule) { return entry(rule).stage; }

std::string_view name(Stage stage) {
  switch (stage) {
    case Stage::kSimplices:
      return "simplices";
    case Stage::kFacets:
      return "facets";
    case Stage::kVertices:
      return "vertices";
    case Stage::kHull:
      return "hull";
    case Stage::kDomain:
      return "domain";
    case Stage::kDelaunay:
      return "delaunay";
    case Stage::kQuality:
      return "quality";
  }
  return "";
}

bool JudgedBefore::operator()(Rule a, Rule b) const { return turn(entry(a)) < turn(entry(b)); }

}  // namespace circumspect
