// The harness for programs in process: it finds nothing in right programs, and what is planted in
// wrong ones, each by the property that it breaks, made as small as can be.
#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>

#include <circumspect/properties.hpp>
#include <circumspect/sequences.hpp>
#include <doctest/doctest.h>
#include <signal.h>

#include "properties/faulty/plain_delaunay.hpp"

namespace circumspect::properties {
namespace {

SimplexArray right(const PointArray& points) { return faulty::plain_delaunay(points); }

// The first failure of each property, or nothing.
std::optional<Finding> failure(const Triangulator& subject, Property property,
                               const PropertyOptions& options) {
  const auto finding = find_failure(subject, property, options);
  if (finding) {
    CHECK(finding->property == property);
    CHECK(finding->points.size() <= finding->original.size());
    CHECK(finding->report.find(finding->rule) != std::string::npos);
  }
  return finding;
}

constexpr Property kAll[] = {Property::kClaim, Property::kDeterministic, Property::kOrder,
                             Property::kSimilarity};

TEST_CASE("nothing is found in a right program") {
  for (const std::size_t dimension : {1, 2, 3, 4}) {
    for (const Property property : kAll) {
      CAPTURE(dimension);
      CAPTURE(name(property));
      const auto finding =
          failure(right, property, {.dimension = dimension, .max_points = 9, .cases = 150});
      CAPTURE((finding ? finding->report : ""));
      CHECK_FALSE(finding.has_value());
    }
  }
  for (const Property property : kAll) {
    const auto finding =
        failure(right, property, {.claim = "weighted-delaunay", .max_points = 9, .cases = 150});
    CAPTURE((finding ? finding->report : ""));
    CHECK_FALSE(finding.has_value());
  }
}

TEST_CASE("a wrong claim is found, and made small") {
  const Triangulator naive = [](const PointArray& points) {
    return faulty::plain_delaunay(points, {.arithmetic = {.numbers = faulty::Numbers::kFloat}});
  };
  const auto finding = failure(naive, Property::kClaim, {.dimension = 2});
  REQUIRE(finding.has_value());
  CHECK(finding->points.size() <= 5);
  CHECK(judge("delaunay", finding->points, naive(finding->points)).rule == finding->rule);
  // The same again.
  const auto again = failure(naive, Property::kClaim, {.dimension = 2});
  REQUIRE(again.has_value());
  CHECK(again->report == finding->report);
  CHECK(again->original.coordinates == finding->original.coordinates);
}

TEST_CASE("a program that remembers is not deterministic") {
  std::size_t calls = 0;
  const Triangulator moody = [&](const PointArray& points) {
    SimplexArray simplices = right(points);
    if (++calls % 2 == 0 && points.size() >= 5) simplices.pop_back();
    return simplices;
  };
  const auto finding = failure(moody, Property::kDeterministic, {.dimension = 2});
  REQUIRE(finding.has_value());
  CHECK(finding->rule == "deterministic");
  CHECK(finding->points.size() == 5);
}

TEST_CASE("a program that depends on the order is found where only one answer is right") {
  // Forgets a simplex where the first point is not the leftmost.
  const Triangulator sorted_only = [](const PointArray& points) {
    SimplexArray simplices = right(points);
    for (std::size_t i = 1; i < points.size(); ++i) {
      if (points.point(i)[0] < points.point(0)[0]) {
        simplices.pop_back();
        break;
      }
    }
    return simplices;
  };
  const auto finding = failure(sorted_only, Property::kOrder, {.dimension = 2});
  REQUIRE(finding.has_value());
  CHECK(finding->rule == "order");
  CHECK(finding->points.size() <= 3);
}

TEST_CASE("a program with an absolute tolerance is not scale-invariant") {
  const Triangulator tolerant = [](const PointArray& points) {
    return faulty::plain_delaunay(points, {.arithmetic = {.in_ball_tolerance = 1e-3}});
  };
  const auto finding = failure(tolerant, Property::kClaim, {.dimension = 2});
  REQUIRE(finding.has_value());
  // Right near 1, wrong far from it.
  const Triangulator near_one = [](const PointArray& points) {
    SimplexArray simplices = right(points);
    for (const double x : points.coordinates) {
      if (x > 8 && points.size() > 3) {
        simplices.front().front() = 0;
        break;
      }
    }
    return simplices;
  };
  const auto similar = failure(near_one, Property::kSimilarity, {.dimension = 2, .cases = 3000});
  REQUIRE(similar.has_value());
  CHECK(similar->rule == "similarity");
  CHECK(similar->points.size() <= 6);
}

TEST_CASE("in a process of its own a crash and a hang are findings") {
  const Triangulator crashes = [](const PointArray& points) {
    if (points.size() > 6) raise(SIGSEGV);
    return right(points);
  };
  const auto crash = failure(crashes, Property::kClaim, {.dimension = 2, .isolated = true});
  REQUIRE(crash.has_value());
  CHECK(crash->rule == "signal 11");
  CHECK(crash->points.size() == 7);

  const Triangulator hangs = [](const PointArray& points) {
    volatile bool for_ever = points.size() == 2;
    while (for_ever) {
    }
    return right(points);
  };
  const auto hang = failure(hangs, Property::kClaim,
                            {.dimension = 2,
                             .max_points = 3,
                             .cases = 100,
                             .isolated = true,
                             .time_limit = std::chrono::milliseconds(50)});
  REQUIRE(hang.has_value());
  CHECK(hang->rule == "hang");
}

TEST_CASE("options choose the inputs") {
  std::set<std::size_t> sizes;
  bool flat = false;
  const Triangulator watches = [&](const PointArray& points) {
    sizes.insert(points.size());
    SimplexArray simplices = right(points);
    flat = flat || (!simplices.empty() && simplices.front().size() < 4);
    return simplices;
  };
  CHECK_FALSE(failure(watches, Property::kClaim,
                      {.min_points = 5, .max_points = 8, .flat_sets = false, .cases = 500}));
  CHECK(*sizes.begin() == 5);
  CHECK(*sizes.rbegin() == 8);
  CHECK_FALSE(flat);
  CHECK_FALSE(failure(watches, Property::kClaim, {.max_points = 8, .cases = 500}));
  CHECK(*sizes.begin() == 1);
  CHECK(flat);

  const Triangulator nothing = [](const PointArray&) { return SimplexArray(); };
  const auto finding = failure(nothing, Property::kClaim, {.families = {"grid"}});
  REQUIRE(finding.has_value());
  CHECK(finding->family == "grid");
  CHECK(finding->points.size() == 1);
}

TEST_CASE("wrong options are refused") {
  const auto with = [](const PropertyOptions& options) {
    return find_failure(right, Property::kClaim, options);
  };
  CHECK_THROWS_AS(with({.claim = "cdt"}), std::invalid_argument);
  CHECK_THROWS_AS(with({.dimension = 0}), std::invalid_argument);
  CHECK_THROWS_AS(with({.dimension = 5}), std::invalid_argument);
  CHECK_THROWS_AS(with({.families = {"nonesuch"}}), std::invalid_argument);
}

TEST_CASE("a program that takes vectors of arrays") {
  const auto subject = from_arrays<2>([](const std::vector<std::array<double, 2>>& points) {
    std::vector<std::array<int, 3>> triangles;
    if (points.size() == 3) triangles.push_back({0, 1, 2});
    return triangles;
  });
  CHECK(subject({2, {0, 0, 1, 0, 0, 1}, {}}) == SimplexArray{{0, 1, 2}});
}

// Makes its triangulation anew after each step; or, after a removal, only forgets simplices.
class RebuiltFromScratch : public DynamicTriangulation {
 public:
  RebuiltFromScratch(std::size_t dimension, bool fills_cavities)
      : dimension_(dimension), fills_cavities_(fills_cavities) {}

  void insert(const double* point) override {
    present_[next_++] = {point, point + dimension_};
    rebuild();
  }
  void remove(std::int64_t number) override {
    present_.erase(number);
    if (fills_cavities_) return rebuild();
    std::erase_if(simplices_, [number](const auto& simplex) {
      return std::find(simplex.begin(), simplex.end(), number) != simplex.end();
    });
  }
  SimplexArray simplices() const override { return simplices_; }

 private:
  void rebuild() {
    PointArray points{dimension_, {}, {}};
    std::vector<std::int64_t> numbers;
    for (const auto& [number, point] : present_) {
      numbers.push_back(number);
      points.coordinates.insert(points.coordinates.end(), point.begin(), point.end());
    }
    simplices_ = right(points);
    for (auto& simplex : simplices_) {
      for (std::int64_t& v : simplex) v = numbers[static_cast<std::size_t>(v)];
    }
  }

  std::size_t dimension_;
  bool fills_cavities_;
  std::map<std::int64_t, std::vector<double>> present_ = {};
  SimplexArray simplices_ = {};
  std::int64_t next_ = 0;
};

TEST_CASE("sequences: a structure rebuilt from scratch is right, one that leaves cavities is not") {
  for (const std::size_t dimension : {std::size_t{2}, std::size_t{3}}) {
    const auto make = [dimension](bool fills_cavities) {
      return [=] { return std::make_unique<RebuiltFromScratch>(dimension, fills_cavities); };
    };
    const SequenceOptions options{.dimension = dimension, .max_steps = 12, .cases = 60};
    const auto none = find_wrong_sequence(make(true), options);
    CAPTURE((none ? none->report : ""));
    CHECK_FALSE(none.has_value());
    const auto finding = find_wrong_sequence(make(false), options);
    REQUIRE(finding.has_value());
    // A cavity in the middle of a few points; which ones, the first input that fails says.
    CHECK(finding->steps.size() <= 7);
    CHECK(finding->steps.back().is_removal);
  }
}

CIRCUMSPECT_DELAUNAY_PROPERTIES("the macro makes a case of each property", right,
                                {.dimension = 2, .max_points = 8, .cases = 50})

}  // namespace
}  // namespace circumspect::properties
