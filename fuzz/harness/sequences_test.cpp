// Dynamic structures: one that is rebuilt from scratch is right, and others are not. They live on a
// line, where a triangulation is the points in order; properties/harness_property.cpp has some in
// the plane and in space.
#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include <circumspect/sequences.hpp>
#include <doctest/doctest.h>

#include "fuzz/harness/cases.hpp"

namespace circumspect {
namespace {

struct Mistakes {
  bool forgets_to_fill = false;  // the edge between the neighbours of the removed point
  bool throws_when_empty = false;
  bool reuses_numbers = false;
};

class SortedLine : public DynamicTriangulation {
 public:
  explicit SortedLine(Mistakes mistakes) : mistakes_(mistakes) {}

  void insert(const double* point) override {
    gaps_.erase(
        std::remove_if(gaps_.begin(), gaps_.end(),
                       [&](const auto& gap) { return gap.first < *point && *point < gap.second; }),
        gaps_.end());
    if (mistakes_.reuses_numbers) next_ = static_cast<std::int64_t>(present_.size());
    present_[*point] = next_++;
  }
  void remove(std::int64_t number) override {
    const auto place = std::find_if(present_.begin(), present_.end(),
                                    [&](const auto& one) { return one.second == number; });
    if (place == present_.end()) throw std::logic_error("no such point");
    if (mistakes_.forgets_to_fill && place != present_.begin() &&
        std::next(place) != present_.end()) {
      gaps_.emplace_back(std::prev(place)->first, std::next(place)->first);
    }
    present_.erase(place);
    if (present_.empty() && mistakes_.throws_when_empty) throw std::runtime_error("no points");
  }
  SimplexArray simplices() const override {
    SimplexArray edges;
    if (present_.size() == 1) return {{present_.begin()->second}};
    for (auto a = present_.begin(); a != present_.end() && std::next(a) != present_.end(); ++a) {
      const auto b = std::next(a);
      if (std::find(gaps_.begin(), gaps_.end(), std::pair(a->first, b->first)) == gaps_.end()) {
        edges.push_back({a->second, b->second});
      }
    }
    return edges;
  }

 private:
  Mistakes mistakes_;
  std::map<double, std::int64_t> present_ = {};
  std::vector<std::pair<double, double>> gaps_ = {};
  std::int64_t next_ = 0;
};

auto line(Mistakes mistakes = {}) {
  return [mistakes] { return std::make_unique<SortedLine>(mistakes); };
}

TEST_CASE("nothing is found in a right structure") {
  CHECK_FALSE(find_wrong_sequence(line(), {.dimension = 1, .cases = 100}));
  CHECK_FALSE(find_wrong_sequence(line(), {.dimension = 1, .cases = 100, .removes = false}));
}

TEST_CASE("a cavity that is not filled is found, and shown by few steps") {
  const auto finding = find_wrong_sequence(line({.forgets_to_fill = true}), {.dimension = 1});
  REQUIRE(finding.has_value());
  CAPTURE(finding->report);
  REQUIRE(finding->steps.size() <= 6);
  CHECK(finding->steps.back().is_removal);
  for (const Step& step : finding->steps) {
    if (step.is_removal) continue;
    CHECK(step.point.front() >= 0);
    CHECK(step.point.front() < 5);
  }
  CHECK(finding->report.find("insert 0 ") != std::string::npos);
  CHECK(finding->report.find("remove ") != std::string::npos);
  CHECK(finding->report ==
        find_wrong_sequence(line({.forgets_to_fill = true}), {.dimension = 1})->report);
  CHECK_FALSE(
      find_wrong_sequence(line({.forgets_to_fill = true}), {.dimension = 1, .removes = false}));
}

TEST_CASE("what is thrown is a finding") {
  const auto finding = find_wrong_sequence(line({.throws_when_empty = true}), {.dimension = 1});
  REQUIRE(finding.has_value());
  CHECK(finding->rule == "crash");
  CHECK(finding->steps.size() == 2);
  CHECK(finding->report.find("no points") != std::string::npos);
}

TEST_CASE("a number that is used again is found") {
  const auto finding = find_wrong_sequence(line({.reuses_numbers = true}), {.dimension = 1});
  REQUIRE(finding.has_value());
  CHECK(finding->rule == "triangulation.unknown-vertex");
  CHECK(finding->steps.size() == 3);
}

TEST_CASE("a removal goes with the insertion that it undoes, and numbers follow") {
  const std::vector<Step> steps = {
      {false, 0, {5}}, {false, 1, {6}}, {true, 0, {}}, {false, 2, {7}}, {true, 1, {}}};
  const auto kept = harness::kept_steps(steps, {false, true, true, true, true});
  REQUIRE(kept.size() == 3);
  CHECK(kept[0].number == 0);
  CHECK(kept[0].point == std::vector<double>{6});
  CHECK(kept[1].number == 1);
  CHECK(kept[2].is_removal);
  CHECK(kept[2].number == 0);
}

TEST_CASE("wrong options are refused") {
  CHECK_THROWS_AS(find_wrong_sequence(line(), {.claim = "weighted-delaunay"}),
                  std::invalid_argument);
  CHECK_THROWS_AS(find_wrong_sequence(line(), {.claim = "cdt"}), std::invalid_argument);
  CHECK_THROWS_AS(find_wrong_sequence(line(), {.dimension = 0}), std::invalid_argument);
  CHECK_THROWS_AS(find_wrong_sequence(line(), {.families = {"nonesuch"}}), std::invalid_argument);
}

}  // namespace
}  // namespace circumspect
