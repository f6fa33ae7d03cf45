// The table of rules: in the order in which they are judged, whatever the order of its rows.
#include "oracle/model/rule.hpp"

#include <algorithm>
#include <vector>

#include <doctest/doctest.h>

#include "oracle/model/claim.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect {
namespace {

// The rows in the order of the file.
constexpr Rule kRows[] = {
#define RULE(number, name, ...) Rule::name,
#include "oracle/model/rules.def"
};

TEST_CASE("rules: every row is found by its rule, and all are in the order of stages and numbers") {
  REQUIRE(rules().size() == std::size(kRows));
  for (const Rule rule : kRows) {
    CHECK(entry(rule).rule == rule);
    CHECK(identifier(rule) == entry(rule).identifier);
    CHECK(meaning(rule) == entry(rule).meaning);
    CHECK(stage(rule) == entry(rule).stage);
    CHECK(identifier(rule).find('.') != std::string_view::npos);
    CHECK(!meaning(rule).empty());
    CHECK(!entry(rule).sentence.empty());
    CHECK(!name(stage(rule)).empty());
  }
  const auto all = rules();
  CHECK(std::is_sorted(all.begin(), all.end(), [](const RuleEntry& a, const RuleEntry& b) {
    return JudgedBefore()(a.rule, b.rule);
  }));
}

// Stored files of cells contain these numbers.
TEST_CASE("rules: a number that was once given stays") {
  CHECK(static_cast<int>(Rule::kUnknownVertex) == 1);
  CHECK(static_cast<int>(Rule::kOverlap) == 8);
  CHECK(static_cast<int>(Rule::kCoveredTwice) == 13);
  CHECK(static_cast<int>(Rule::kOutside) == 21);
  CHECK(static_cast<int>(Rule::kVertexInBall) == 23);
  CHECK(static_cast<int>(Rule::kDanglingNotDelaunay) == 29);
}

TEST_CASE("a verdict names the rule of the earliest stage first, and of one stage by number") {
  Verdict verdict(Claim::kDelaunay, 0);
  for (const Rule rule : {Rule::kFacetNotLocal, Rule::kOverlap, Rule::kFacetOverused,
                          Rule::kUnusedPoint, Rule::kDegenerateSimplex}) {
    verdict.count(rule);
  }
  std::vector<Rule> named;
  for (const auto& [rule, tally] : verdict.tallies()) named.push_back(rule);
  CHECK(named == std::vector{Rule::kDegenerateSimplex, Rule::kFacetOverused, Rule::kOverlap,
                             Rule::kUnusedPoint, Rule::kFacetNotLocal});
}

TEST_CASE("claims: each has a name of its own, and says whether it needs a domain") {
  std::vector<std::string_view> seen;
  for (const ClaimEntry& one : claims()) {
    CHECK(name(one.claim) == one.name);
    CHECK(is_about_a_domain(one.claim) == one.is_about_a_domain);
    CHECK(std::find(seen.begin(), seen.end(), one.name) == seen.end());
    seen.push_back(one.name);
  }
  CHECK(!is_about_a_domain(Claim::kWeightedDelaunay));
  CHECK(is_about_a_domain(Claim::kPlcTriangulation));
}

}  // namespace
}  // namespace circumspect
