// Cospherical points. Book: Definition 4.2, Theorem 4.4.
#include "reference/delaunay/genericity.hpp"

#include <doctest/doctest.h>

#include "inputs/plain_algebra.hpp"
#include "kernel/complex/circumball.hpp"
#include "kernel/complex/point_set.hpp"
#include "properties/arguments/laws.hpp"
#include "properties/arguments/run.hpp"
#include "reference/delaunay/bowyer_watson.hpp"

namespace circumspect::delaunay {
namespace {

std::optional<Simplex> any_ball(const std::vector<Point>& points) {
  return cospherical_points(PointSet(points));
}

std::optional<Simplex> empty_ball(const std::vector<Point>& points) {
  const PointSet set(points);
  return cospherical_points_of_an_empty_ball(set, bowyer_watson(set));
}

TEST_CASE("genericity: few points, and points on a line, always are generic") {
  for (const std::vector<Point>& points : {std::vector<Point>{},
                                           {{1, 2}},
                                           {{1, 2}, {0, 0}},
                                           {{0, 0}, {1, 0}, {0, 1}},
                                           {{0}, {1}, {2}, {3}},
                                           {{0, 0, 1}, {1, 1, 1}, {2, 2, 1}, {4, 4, 1}}}) {
    CHECK(!any_ball(points));
    CHECK(!empty_ball(points));
  }
}

TEST_CASE("genericity: a square is not generic, and has two Delaunay triangulations") {
  const std::vector<Point> square = {{7, 9}, {0, 0}, {1, 0}, {1, 1}, {0, 1}};
  CHECK(any_ball(square) == Simplex{1, 2, 3, 4});
  CHECK(empty_ball(square) == Simplex{1, 2, 3, 4});
}

TEST_CASE("genericity: a square with its centre is not generic, but no empty ball says so") {
  const std::vector<Point> points = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}};
  CHECK(any_ball(points) == Simplex{0, 1, 2, 3});
  CHECK(!empty_ball(points));
}

TEST_CASE("genericity: a square in space lies on a sphere with any fifth point off its plane") {
  const std::vector<Point> points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {3, 4, 5}};
  CHECK(any_ball(points) == Simplex{0, 1, 2, 3, 4});
  CHECK(empty_ball(points) == Simplex{0, 1, 2, 3, 4});
  // Collinear points lie on no sphere, and coplanar ones only if on a circle.
  CHECK(!any_ball({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 1}, {5, 2, 0}}));
  CHECK(!any_ball({{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {5, 7, 0}, {1, 1, 1}}));
}

TEST_CASE("genericity: within a plane in space, four points of a circle suffice") {
  CHECK(any_ball({{5, 0, 1}, {0, 5, 1}, {9, 9, 1}, {-3, 4, 1}, {4, -3, 1}}) == Simplex{0, 1, 3, 4});
}

// Do k+2 points lie on one sphere? Some affine basis of them has a ball with the rest on it.
bool lie_on_one_sphere(const PointSet& points, const Simplex& subset) {
  const auto dimension = generators::dimension_by_minors(coordinates(points, subset));
  for (const auto& places :
       generators::subsets(subset.size(), static_cast<std::size_t>(dimension) + 1)) {
    Simplex basis;
    for (const std::size_t place : places) basis.push_back(subset[place]);
    if (generators::dimension_by_minors(coordinates(points, basis)) != dimension) continue;
    const Ball ball = circumball(points, basis);
    for (const Vertex q : subset) {
      if (sign(power(points, ball, q)) != 0) return false;
    }
    return true;
  }
  return false;
}

TEST_CASE("genericity: the first cospherical subset in lexicographic order, or none at all") {
  for (const std::size_t d : {2U, 3U}) {
    CHECK(properties::holds("dimension " + std::to_string(d), [d] {
      const auto set = *generators::unweighted(generators::any_point_set(d, 7));
      const PointSet points(set.points);
      const auto size = static_cast<std::size_t>(points.dimension() + 2);
      std::optional<Simplex> expected;
      for (const auto& places : points.size() < size ? std::vector<std::vector<std::size_t>>{}
                                                     : generators::subsets(points.size(), size)) {
        const Simplex subset(places.begin(), places.end());
        if (lie_on_one_sphere(points, subset) && (!expected || subset < *expected)) {
          expected = subset;
        }
      }
      RC_ASSERT(cospherical_points(points) == expected);
      const auto on_empty = cospherical_points_of_an_empty_ball(points, bowyer_watson(points));
      if (!on_empty) return;
      RC_ASSERT(expected.has_value());
      RC_ASSERT(lie_on_one_sphere(points, *on_empty));
    }));
  }
}

}  // namespace
}  // namespace circumspect::delaunay
