// Wrong predicates are caught, right ones are not.
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <string>

#include <circumspect/predicates.hpp>
#include <doctest/doctest.h>

#include "fuzz/harness/predicate_arguments.hpp"
#include "kernel/predicates/in_ball.hpp"
#include "kernel/predicates/orientation.hpp"

namespace circumspect {
namespace {

using generators::Dice;

std::vector<Vertex> first(std::size_t count) {
  std::vector<Vertex> vertices;
  for (std::size_t v = 0; v < count; ++v) vertices.push_back(static_cast<Vertex>(v));
  return vertices;
}

Configuration configuration(std::size_t dimension, const std::vector<double>& coordinates) {
  std::vector<Point> points(coordinates.size() / dimension);
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    points[i / dimension].push_back(exact_value(coordinates[i]));
  }
  return Configuration(points);
}

Predicate exact(PredicateKind kind, std::size_t dimension) {
  return [=](const double* coordinates) -> double {
    const std::size_t count = harness::argument_count(kind, dimension) * dimension;
    return harness::exact_sign(kind, dimension, {coordinates, coordinates + count});
  };
}

// As in every textbook, over a number type of choice.
template <typename Number>
double naive_orientation(const double* p) {
  Number row[3][3];
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      row[i][j] = static_cast<Number>(p[3 * i + j]) - static_cast<Number>(p[9 + j]);
    }
  }
  const Number det = row[0][0] * (row[1][1] * row[2][2] - row[1][2] * row[2][1]) -
                     row[0][1] * (row[1][0] * row[2][2] - row[1][2] * row[2][0]) +
                     row[0][2] * (row[1][0] * row[2][1] - row[1][1] * row[2][0]);
  return static_cast<double>(det);
}

double naive_in_circle(const double* p) {
  double row[3][3];
  for (int i = 0; i < 3; ++i) {
    row[i][0] = p[2 * i] - p[6];
    row[i][1] = p[2 * i + 1] - p[7];
    row[i][2] = row[i][0] * row[i][0] + row[i][1] * row[i][1];
  }
  return row[0][2] * (row[1][0] * row[2][1] - row[2][0] * row[1][1]) -
         row[1][2] * (row[0][0] * row[2][1] - row[2][0] * row[0][1]) +
         row[2][2] * (row[0][0] * row[1][1] - row[1][0] * row[0][1]);
}

bool is_exact_difference(double a, double b) {
  const double x = a - b;
  const double b_again = a - x;
  return (a - (x + b_again)) + (b_again - b) == 0;
}

// Rounding is monotone: if differences are exact and the rounded products differ, the exact
// products differ in the same direction. A compiler that contracts the difference of products
// compares an exact one with a rounded one.
double orientation_by_rounded_products(const double* p, bool contracted) {
  const double ax = p[0] - p[4], ay = p[1] - p[5], bx = p[2] - p[4], by = p[3] - p[5];
  const bool differences_are_exact =
      is_exact_difference(p[0], p[4]) && is_exact_difference(p[1], p[5]) &&
      is_exact_difference(p[2], p[4]) && is_exact_difference(p[3], p[5]);
  if (differences_are_exact) {
    const double det = contracted ? std::fma(ax, by, -(ay * bx)) : ax * by - ay * bx;
    if (det != 0) return det;
  }
  return exact(PredicateKind::kOrientation, 2)(p);
}

TEST_CASE("the exact signs are those of the reference, in all families") {
  for (const PredicateKind kind : {PredicateKind::kOrientation, PredicateKind::kInSphere}) {
    for (const std::size_t d : {std::size_t{2}, std::size_t{3}}) {
      const PredicateOptions options{.kind = kind, .dimension = d};
      std::map<std::string, std::set<int>> signs;
      for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        const auto& family = harness::argument_families()[seed % 5];
        Dice dice(seed);
        const std::vector<double> coordinates = family.made(options, dice);
        REQUIRE(coordinates.size() == harness::argument_count(kind, d) * d);
        REQUIRE(harness::is_within_limits(options, coordinates));
        const Configuration points = configuration(d, coordinates);
        const std::vector<std::size_t> axes =
            d == 2 ? std::vector<std::size_t>{0, 1} : std::vector<std::size_t>{0, 1, 2};
        const std::vector<Vertex> simplex = first(d + 1);
        int expected = orientation(points, axes, simplex);
        if (kind == PredicateKind::kInSphere) {
          if (expected == 0) continue;
          expected *= in_ball(points, axes, simplex, static_cast<Vertex>(d + 1));
        }
        REQUIRE(harness::exact_sign(kind, d, coordinates) == expected);
        signs[std::string(family.name)].insert(expected);
      }
      CHECK(signs.size() == 5);
      for (const auto& entry : signs) {
        const std::string& family = entry.first;
        const std::set<int>& occurring = entry.second;
        CAPTURE(family);
        if (family == "degenerate") {
          CHECK(occurring.count(0) == 1);
        } else {
          CHECK(occurring.count(1) == 1);
          CHECK(occurring.count(-1) == 1);
        }
      }
    }
  }
}

TEST_CASE("the signs are those that the header promises") {
  const auto sign_of = [](PredicateKind kind, std::size_t d, const std::vector<double>& p) {
    return harness::exact_sign(kind, d, p);
  };
  // Counterclockwise; then a point in the circle.
  CHECK(sign_of(PredicateKind::kOrientation, 2, {0, 0, 1, 0, 0, 1}) == 1);
  CHECK(sign_of(PredicateKind::kInSphere, 2, {0, 0, 1, 0, 0, 1, 0.5, 0.5}) == 1);
  CHECK(sign_of(PredicateKind::kInSphere, 2, {0, 0, 1, 0, 0, 1, 1, 1}) == 0);
  CHECK(sign_of(PredicateKind::kInSphere, 2, {0, 0, 0, 1, 1, 0, 0.5, 0.5}) == -1);
  // The last point is below the plane in which the others turn counterclockwise as seen from above.
  CHECK(sign_of(PredicateKind::kOrientation, 3, {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, -1}) == 1);
  CHECK(sign_of(PredicateKind::kInSphere, 3,
                {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, -1, 0.5, 0.5, -0.5}) == 1);
  CHECK(sign_of(PredicateKind::kInSphere, 3, {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, -1, 1, 1, 1}) == -1);
}

TEST_CASE("nothing is found in exact predicates") {
  for (const PredicateKind kind : {PredicateKind::kOrientation, PredicateKind::kInSphere}) {
    for (const std::size_t d : {std::size_t{2}, std::size_t{3}}) {
      CHECK_FALSE(find_wrong_sign(exact(kind, d), {.kind = kind, .dimension = d, .cases = 5000}));
    }
  }
}

TEST_CASE("naive predicates are caught, on simple arguments") {
  const auto caught = [](const Predicate& predicate, const PredicateOptions& options) {
    const auto finding = find_wrong_sign(predicate, options);
    REQUIRE(finding.has_value());
    CHECK(finding->expected ==
          harness::exact_sign(options.kind, options.dimension, finding->coordinates));
    const double again = predicate(finding->coordinates.data());
    CHECK((finding->found == again || std::isnan(again)));
    CHECK(finding->report.find(" 0x") != std::string::npos);
    return *finding;
  };
  caught(naive_orientation<double>, {});
  caught(naive_orientation<long double>, {});
  const auto of_floats =
      caught(naive_orientation<float>, {.max_exponent = 20, .min_exponent = -40});
  CHECK(of_floats.report.find("orientation in dimension 3: expected") == 0);
  caught(naive_in_circle, {.kind = PredicateKind::kInSphere, .dimension = 2});
  // Always positive: the simplest arguments are all 0.
  const auto constant = caught([](const double*) { return 1.0; }, {.dimension = 2});
  CHECK(constant.coordinates == std::vector<double>(6, 0.0));
  caught([](const double*) { return std::nan(""); }, {});
}

TEST_CASE("a build that contracts products is caught, the same source without is right") {
  const auto by_products = [](bool contracted) {
    return [contracted](const double* p) { return orientation_by_rounded_products(p, contracted); };
  };
  CHECK_FALSE(find_wrong_sign(by_products(false), {.dimension = 2, .cases = 20000}));
  const auto finding = find_wrong_sign(by_products(true), {.dimension = 2, .cases = 20000});
  REQUIRE(finding.has_value());
  CHECK(finding->expected == 0);
}

TEST_CASE("the same finding again, and wrong options refused") {
  const auto one = find_wrong_sign(naive_orientation<double>);
  const auto again = find_wrong_sign(naive_orientation<double>);
  CHECK(one->report == again->report);
  const Predicate right = exact(PredicateKind::kOrientation, 3);
  CHECK_THROWS_AS(find_wrong_sign(right, {.dimension = 4}), std::invalid_argument);
  CHECK_THROWS_AS(find_wrong_sign(right, {.max_exponent = 301}), std::invalid_argument);
  CHECK_THROWS_AS(find_wrong_sign(right, {.max_exponent = 9, .min_exponent = 0}),
                  std::invalid_argument);
}

}  // namespace
}  // namespace circumspect
