// Point sets, and the duplicates that keep a list of points from being one.
#include "reference/kernel/complex/point_set.hpp"

#include <algorithm>

#include <doctest/doctest.h>

#include "properties/arguments/laws.hpp"
#include "properties/arguments/numbers.hpp"

namespace circumspect {
namespace {

using generators::PointsCase;

// Each point that is equal to an earlier one, with the first of those.
std::vector<Duplicate> duplicates_by_definition(const std::vector<Point>& points) {
  std::vector<Duplicate> found;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto first = std::find(points.begin(), points.end(), points[i]) - points.begin();
    const auto again = static_cast<Vertex>(i);
    if (first < again) found.push_back({first, again});
  }
  return found;
}

TEST_CASE("duplicates: equal numbers written differently, three of a kind, none at all") {
  const std::vector<Point> points = {{1, 2}, {3, 4}, {Rational(2, 2), 2}, {3, 5}, {1, 2}};
  std::vector<Point> canonical = points;
  for (Point& point : canonical) {
    for (Rational& x : point) x.canonicalize();
  }
  const std::vector<Duplicate> found = duplicates(canonical);
  REQUIRE(found.size() == 2);
  CHECK(found[0].kept == 0);
  CHECK(found[0].again == 2);
  CHECK(found[1].kept == 0);
  CHECK(found[1].again == 4);
  CHECK(duplicates({}).empty());
  CHECK(duplicates({{1, 2}, {2, 1}}).empty());
}

TEST_CASE("duplicates: all of them, each with the first point it repeats, in order") {
  CHECK(rc::check([] {
    const auto points = *rc::gen::container<std::vector<Point>>(
        rc::gen::container<Point>(2, generators::integer_number(2)));
    const auto expected = duplicates_by_definition(points);
    const auto found = duplicates(points);
    RC_ASSERT(found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      RC_ASSERT(found[i].kept == expected[i].kept);
      RC_ASSERT(found[i].again == expected[i].again);
    }
  }));
}

TEST_CASE("point set: it is the points and weights it was given") {
  CHECK(rc::check([] {
    const auto sets = generators::any_point_set(3, 7);
    const PointsCase set =
        *rc::gen::oneOf(generators::unweighted(sets), generators::weighted(sets));
    const PointSet points(set.points, set.weights);
    RC_ASSERT(points.size() == set.points.size());
    RC_ASSERT(points.empty() == set.points.empty());
    RC_ASSERT(points.is_weighted() == !set.weights.empty());
    RC_ASSERT(points.ambient_dimension() == (set.points.empty() ? 0U : 3U));
    RC_ASSERT(points.dimension() == affine_hull(set.points).dimension);
    RC_ASSERT(!points.names(-1));
    RC_ASSERT(!points.names(static_cast<Vertex>(set.points.size())));
    Simplex all;
    for (std::size_t i = 0; i < set.points.size(); ++i) {
      const auto v = static_cast<Vertex>(i);
      RC_ASSERT(points.names(v));
      RC_ASSERT(points[v] == set.points[i]);
      RC_ASSERT(points.weight(v) == (set.weights.empty() ? Rational(0) : set.weights[i]));
      all.push_back(v);
    }
    RC_ASSERT(coordinates(points, all) == set.points);
  }));
}

const PointSet kPoints({{0, 0, 1}, {2, 0, 1}, {4, 0, 1}, {0, 3, 1}, {0, 0, 5}});

TEST_CASE("flat: a point, a line, a plane, space") {
  CHECK(flat_through(kPoints, {3}).dimension() == 0);
  CHECK(flat_through(kPoints, {3}).basis == Simplex{3});
  const Flat line = flat_through(kPoints, {2, 0, 1});
  CHECK(line.basis == Simplex{2, 0});
  CHECK(line.axes == std::vector<std::size_t>{0});
  const Flat plane = flat_through(kPoints, {0, 1, 2, 3});
  CHECK(plane.basis == Simplex{0, 1, 3});
  CHECK(plane.axes == std::vector<std::size_t>{0, 1});
  CHECK(flat_through(kPoints, all_vertices(kPoints)).basis == Simplex{0, 1, 3, 4});
}

TEST_CASE("flat: of a projection on some axes") {
  const Flat shadow = flat_through(kPoints, {1, 2}, {0, 1, 3, 4});
  CHECK(shadow.basis == Simplex{0, 3, 4});  // 0 and 1 have one shadow
  CHECK(shadow.axes == std::vector<std::size_t>{1, 2});
  CHECK(flat_through(kPoints, {2}, {0, 1, 2, 3}).dimension() == 0);
}

}  // namespace
}  // namespace circumspect
