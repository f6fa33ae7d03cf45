// Tests properties that Delaunay triangulations must have, on inputs made to break the program
// under test; a failing input is made as small as possible. For any test framework; macros for
// doctest, Catch2 and GoogleTest are at the end.
//
//   #include <doctest/doctest.h>
//   #include <circumspect/properties.hpp>
//   CIRCUMSPECT_DELAUNAY_PROPERTIES("my library", my_triangulate, {.dimension = 3})
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <circumspect/judgement.hpp>
#include <circumspect/subject.hpp>

namespace circumspect {

enum class Property {
  // What it returns is what was claimed. Book: Definitions 2.1 and 4.1, Section 5.2.
  kClaim,
  // The same points give the same complex.
  kDeterministic,
  // Where there is only one Delaunay triangulation, it does not depend on the order of the points.
  // Book: Theorem 4.4; Section 4.2, where the Delaunay subdivision is simplicial.
  kOrder,
  // Nor does it depend on the coordinate system, up to exact scaling by a power of two and exchange
  // of the axes: these maps take balls to balls.
  kSimilarity,
};
std::string_view name(Property property);

struct PropertyOptions {
  std::string claim = "delaunay";  // or "triangulation", "weighted-delaunay"
  std::size_t dimension = 3;       // 1 to 4
  std::size_t min_points = 1;
  std::size_t max_points = 20;
  // Whether to try points that span only a flat of lower dimension, where k+1 indices a row are the
  // answer (Book: Section 4.1, "if the affine hull of S is k-dimensional").
  bool flat_sets = true;
  std::size_t cases = 1000;
  std::uint64_t seed = 20260101;
  // The names of families as `circumspect generate --list` prints them. None: every family of the
  // dimension whose points are distinct doubles.
  std::vector<std::string> families = {};
  // Runs the program in a process of its own for each case, so that a crash or a hang is a finding
  // and does not end the test. This costs one fork for each case.
  bool isolated = false;
  std::chrono::milliseconds time_limit{10'000};  // a case, if isolated
};

// A case in which a property does not hold.
struct Finding {
  Property property = Property::kClaim;
  std::string family;
  // `circumspect generate FAMILY --fewer --points MAX --dimension D --seed SEED` makes the
  // original.
  std::uint64_t seed = 0;
  PointArray original;
  PointArray points;  // the smallest found that breaks the same rule
  // The verdict on `points`. For properties other than the claim, the property's name, or how the
  // program ended when it was asked again.
  std::string rule;
  std::string report;  // for people: the rule, the points as a .node file, the witness
};

// The first case among options.cases in which the property does not hold, minimised; nothing if
// there is none. Every machine tries the same cases in the same order. Throws
// std::invalid_argument: a claim or a family that is unknown, or a family that does not exist in
// the dimension.
std::optional<Finding> find_failure(const Triangulator& subject, Property property,
                                    const PropertyOptions& options = {});

// A program that takes and returns vectors of std::array, as most do, as a Triangulator.
template <std::size_t D, typename Function>
Triangulator from_arrays(Function function) {
  return [function = std::move(function)](const PointArray& points) {
    std::vector<std::array<double, D>> rows(points.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (std::size_t axis = 0; axis < D; ++axis) rows[i][axis] = points.point(i)[axis];
    }
    SimplexArray simplices;
    for (const auto& simplex : function(rows)) {
      simplices.emplace_back();
      for (const auto v : simplex) simplices.back().push_back(static_cast<std::int64_t>(v));
    }
    return simplices;
  };
}

}  // namespace circumspect

// The title is a literal; __VA_ARGS__ are PropertyOptions in braces. Each property is a test.

// doctest, Catch2:
//   CIRCUMSPECT_DELAUNAY_PROPERTIES("my library", my_triangulate, {.dimension = 3})
#define CIRCUMSPECT_DELAUNAY_PROPERTIES(title, subject, ...)                           \
  CIRCUMSPECT_TEST_CASE(title ": claim", kClaim, subject, __VA_ARGS__)                 \
  CIRCUMSPECT_TEST_CASE(title ": deterministic", kDeterministic, subject, __VA_ARGS__) \
  CIRCUMSPECT_TEST_CASE(title ": order", kOrder, subject, __VA_ARGS__)                 \
  CIRCUMSPECT_TEST_CASE(title ": similarity", kSimilarity, subject, __VA_ARGS__)
#define CIRCUMSPECT_TEST_CASE(title, property, subject, ...)                                     \
  TEST_CASE(title) {                                                                             \
    const auto circumspect_finding = ::circumspect::find_failure(                                \
        subject, ::circumspect::Property::property, ::circumspect::PropertyOptions __VA_ARGS__); \
    if (circumspect_finding) FAIL(circumspect_finding->report);                                  \
  }

// GoogleTest:
//   CIRCUMSPECT_DELAUNAY_TESTS(MyLibrary, my_triangulate, {.dimension = 3})
#define CIRCUMSPECT_DELAUNAY_TESTS(suite, subject, ...)                               \
  CIRCUMSPECT_GOOGLE_TEST(suite, Claim, kClaim, subject, __VA_ARGS__)                 \
  CIRCUMSPECT_GOOGLE_TEST(suite, Deterministic, kDeterministic, subject, __VA_ARGS__) \
  CIRCUMSPECT_GOOGLE_TEST(suite, Order, kOrder, subject, __VA_ARGS__)                 \
  CIRCUMSPECT_GOOGLE_TEST(suite, Similarity, kSimilarity, subject, __VA_ARGS__)
#define CIRCUMSPECT_GOOGLE_TEST(suite, name, property, subject, ...)                             \
  TEST(suite, name) {                                                                            \
    const auto circumspect_finding = ::circumspect::find_failure(                                \
        subject, ::circumspect::Property::property, ::circumspect::PropertyOptions __VA_ARGS__); \
    if (circumspect_finding) FAIL() << circumspect_finding->report;                              \
  }
