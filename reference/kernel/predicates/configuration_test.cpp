// A configuration is its points: exact, whatever integers they are scaled to.
#include "reference/kernel/predicates/configuration.hpp"

#include <doctest/doctest.h>

#include "properties/arguments/laws.hpp"

namespace circumspect {
namespace {

using generators::PointsCase;
using generators::Scaling;

TEST_CASE("configuration: numerators and heights over their denominators are the points") {
  CHECK(generators::holds_for_sets(1, 4, [](const PointsCase& set, Scaling scaling) {
    const Configuration points = generators::configuration(set, scaling);
    for (std::size_t i = 0; i < set.points.size(); ++i) {
      const auto v = static_cast<Vertex>(i);
      const Rational denominator = points.denominator(v);
      RC_ASSERT(sign(denominator) > 0);
      for (std::size_t axis = 0; axis < points.ambient_dimension(); ++axis) {
        RC_ASSERT(points.numerator(v, axis) / denominator == set.points[i][axis]);
      }
      Rational height = squared_length(set.points[i]);
      if (!set.weights.empty()) height -= set.weights[i];
      RC_ASSERT(points.height(v) / (denominator * denominator) == height);
    }
  }));
}

TEST_CASE("configuration: ranks are the lexicographic order of the coordinates") {
  CHECK(generators::holds_for_sets(1, 4, [](const PointsCase& set, Scaling scaling) {
    const Configuration points = generators::configuration(set, scaling);
    for (std::size_t i = 0; i < set.points.size(); ++i) {
      for (std::size_t j = 0; j < set.points.size(); ++j) {
        RC_ASSERT((points.rank(static_cast<Vertex>(i)) < points.rank(static_cast<Vertex>(j))) ==
                  (set.points[i] < set.points[j]));
      }
    }
  }));
}

TEST_CASE("configuration: doubles always share a denominator, unrelated fractions do not") {
  CHECK(Configuration(std::vector<Point>{{exact_value(0x1p-1074)}, {exact_value(0x1p1023)}})
            .has_common_denominator());
  CHECK(rc::check([] {
    const std::vector<Point> doubles = *generators::sets_of(generators::extreme_points, 3, 8);
    RC_ASSERT(Configuration(doubles).has_common_denominator());
  }));
  std::vector<Point> fractions;
  for (const unsigned long exponent : {907, 911, 919}) {
    fractions.push_back({Rational(Integer(1), Integer((Integer(1) << exponent) - 1))});
  }
  CHECK_FALSE(Configuration(fractions).has_common_denominator());
}

TEST_CASE("configuration: of no point, of one, and of a flat set") {
  CHECK(Configuration({}).dimension() == -1);
  CHECK(Configuration({}).size() == 0);
  CHECK(Configuration({}).ambient_dimension() == 0);
  CHECK(Configuration(std::vector<Point>{{1, 2}}).dimension() == 0);
  const Configuration flat({{0, 0, 5}, {1, 0, 5}, {0, 1, 5}, {1, 1, 5}});
  CHECK(flat.dimension() == 2);
  CHECK(flat.ambient_dimension() == 3);
  CHECK(std::vector<std::size_t>(flat.axes().begin(), flat.axes().end()) ==
        std::vector<std::size_t>{0, 1});
}

}  // namespace
}  // namespace circumspect
