// Without a mistake, the plain predicates are the predicates: on numbers small enough that doubles
// are exact.
#include "properties/faulty/plain_predicates.hpp"

#include <iterator>
#include <set>

#include <doctest/doctest.h>

#include "kernel/predicates/in_ball.hpp"
#include "kernel/predicates/orientation.hpp"

namespace circumspect::faulty {
namespace {

// d + 2 of eight points in a row, for every row of a small table.
PointArray some_points(std::size_t dimension, std::size_t from, bool weighted) {
  constexpr double kNumbers[] = {0, 3, 1, 4, -1, 5, 9, 2, -6, 5, 3, 5, -8, 9, 7, 9, 3};
  PointArray points{dimension};
  for (std::size_t i = 0; i < dimension + 2; ++i) {
    for (std::size_t axis = 0; axis < dimension; ++axis) {
      points.coordinates.push_back(kNumbers[(from + 3 * i + 5 * axis) % std::size(kNumbers)]);
    }
    if (weighted) points.weights.push_back(kNumbers[(from + 7 * i) % std::size(kNumbers)]);
  }
  return points;
}

bool repeats_a_point(const PointArray& points) {
  std::set<std::vector<double>> distinct;
  for (std::size_t i = 0; i < points.size(); ++i) {
    distinct.insert({points.point(i), points.point(i) + points.dimension});
  }
  return distinct.size() < points.size();
}

struct Signs {
  int orientation = 0;
  int in_ball = 0;
  bool operator==(const Signs&) const = default;
};

Signs signs(const PointArray& points, const Arithmetic& arithmetic) {
  const PointSet exact = exact_points(points);
  const PlainPredicates predicates(points, exact, arithmetic);
  std::vector<Vertex> simplex = every_index(points);
  const Vertex q = simplex.back();
  simplex.pop_back();
  const auto axes = exact.configuration().axes();
  return {predicates.orientation(axes, simplex), predicates.in_ball(axes, simplex, q)};
}

TEST_CASE("plain predicates without a mistake are right on small numbers") {
  std::size_t compared = 0;
  for (const std::size_t dimension : {1u, 2u, 3u}) {
    for (const bool weighted : {false, true}) {
      for (std::size_t from = 0; from < 17; ++from) {
        const PointArray points = some_points(dimension, from, weighted);
        if (repeats_a_point(points)) continue;
        const Signs exact = signs(points, {});
        if (exact.orientation == 0) continue;
        ++compared;
        for (const Numbers numbers : {Numbers::kFloat, Numbers::kDouble, Numbers::kLongDouble}) {
          CHECK(signs(points, {.numbers = numbers}) == exact);
        }
        CHECK(signs(points, {.numbers = Numbers::kDouble, .trusted_beyond = 1e9}) == exact);
        if (!weighted && exact.in_ball != 0) {
          CHECK(signs(points, {.by_circumcentre = true}) == exact);
        }
      }
    }
  }
  CHECK(compared > 40);
}

TEST_CASE("each mistake in arithmetic gives a wrong sign") {
  const PointArray small{2, {0, 0, 1e-3, 0, 0, 1e-3, 5e-4, 5e-4}};
  CHECK(signs(small, {}) == Signs{1, 1});
  CHECK(signs(small, {.in_ball_tolerance = 1e-10}).in_ball == 0);
  CHECK(signs(small, {.orientation_tolerance = 1e-5}).orientation == 0);
  const PointArray deep{3, {0, 0, 0, 4, 0, 0, 0, 4, 0, 0, 0, 4, 2, 2, 6}};
  CHECK(signs(deep, {}).in_ball < 0);
  CHECK(signs(deep, {.forgets_last_axis = true}).in_ball > 0);
  const PointArray clockwise{2, {0, 0, 0, 4, 4, 0, 1, 1}};
  CHECK(signs(clockwise, {}) == Signs{-1, 1});
}

}  // namespace
}  // namespace circumspect::faulty
