// The laws of kernel/predicates/in_ball.hpp, under their numbers.
#include "kernel/predicates/in_ball.hpp"

#include <utility>

#include <doctest/doctest.h>

#include "inputs/plain_algebra.hpp"
#include "kernel/predicates/orientation.hpp"
#include "properties/arguments/generated.hpp"
#include "properties/arguments/laws.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect {
namespace {

using generators::holds_for_simplices;
using generators::PointsCase;
using generators::Scaling;
using generators::Scene;

using Vertices = std::vector<Vertex>;

Rational weight(const PointsCase& set, Vertex v) {
  return set.weights.empty() ? Rational(0) : set.weights[static_cast<std::size_t>(v)];
}

TEST_CASE("in_ball: inside, on and outside of a triangle's circumcircle, in both orientations") {
  const Configuration points({{0, 0}, {2, 0}, {0, 2}, {1, 1}, {2, 2}, {3, 2}});
  for (const Vertices& triangle : {Vertices{0, 1, 2}, Vertices{0, 2, 1}}) {
    CHECK(in_ball(points, triangle, 3) == 1);
    CHECK(in_ball(points, triangle, 4) == 0);
    CHECK(in_ball(points, triangle, 5) == -1);
  }
}

TEST_CASE("in_ball: a weight lowers the lifted point, a heavy vertex raises the witness plane") {
  const std::vector<Point> square = {{0, 0}, {2, 0}, {0, 2}, {2, 2}};
  CHECK(in_ball(Configuration(square, {0, 0, 0, 1}), Vertices{0, 1, 2}, 3) == 1);
  CHECK(in_ball(Configuration(square, {0, 0, 0, -1}), Vertices{0, 1, 2}, 3) == -1);
  CHECK(in_ball(Configuration(square, {0, 1, 0, 0}), Vertices{0, 1, 2}, 3) == -1);
  CHECK(in_ball(Configuration(square, {1, 0, 0, 0}), Vertices{0, 1, 2}, 3) == 1);
}

TEST_CASE("B1 no permutation of the simplex changes in_ball") {
  CHECK(holds_for_simplices(1, 5, [](const PointsCase& set, Scaling scaling) {
    const Scene scene = generators::scene(set, scaling);
    const Vertices shuffled = generators::shuffled(scene.simplex);
    for (const Vertex q : scene.queries) {
      RC_ASSERT(in_ball(scene.points, scene.axes, shuffled, q) ==
                in_ball(scene.points, scene.axes, scene.simplex, q));
    }
  }));
}

TEST_CASE("B2 in_ball is the sign of r² − |q − o|², from the exact circumcentre and radius") {
  CHECK(holds_for_simplices(1, 4, [](const PointsCase& set, Scaling scaling) {
    const Scene scene = generators::scene(set, scaling);
    std::vector<Point> vertices;
    std::vector<Rational> weights;
    for (const Vertex v : scene.simplex) {
      vertices.push_back(set.points[static_cast<std::size_t>(v)]);
      weights.push_back(weight(set, v));
    }
    const auto [centre, squared_radius] = generators::power_ball(vertices, weights);
    for (const Vertex q : scene.queries) {
      const Point& point = set.points[static_cast<std::size_t>(q)];
      const Rational power = squared_distance(point, centre) - weight(set, q);
      const Rational inside = squared_radius - power;
      RC_ASSERT(in_ball(scene.points, scene.axes, scene.simplex, q) == sign(inside));
    }
  }));
}

TEST_CASE("B3 translation and positive uniform scaling keep in_ball") {
  CHECK(holds_for_simplices(1, 5, [](const PointsCase& set, Scaling scaling) {
    const std::size_t dimension = set.points.front().size();
    const Rational factor = abs(*generators::small_rational()) + Rational(1, 7);
    const Point translation = *rc::gen::container<Point>(dimension, generators::small_rational());
    const PointsCase image = generators::scaled_and_moved(set, factor, translation);
    const Scene before = generators::scene(set, scaling);
    const Scene after = generators::scene(image, scaling);
    for (const Vertex q : before.queries) {
      RC_ASSERT(in_ball(before.points, before.axes, before.simplex, q) ==
                in_ball(after.points, after.axes, after.simplex, q));
    }
  }));
}

TEST_CASE("B5 of two simplices at a facet, both apexes are in the other's ball or neither") {
  CHECK(holds_for_simplices(1, 5, [](const PointsCase& set, Scaling scaling) {
    const Scene scene = generators::scene(set, scaling);
    const Configuration& points = scene.points;
    for (const Vertex q : scene.queries) {
      for (std::size_t place = 0; place < scene.simplex.size(); ++place) {
        Vertices other = scene.simplex;
        const Vertex apex = std::exchange(other[place], q);
        const int opposite =
            orientation(points, scene.axes, other) * orientation(points, scene.axes, scene.simplex);
        if (opposite >= 0) continue;
        RC_ASSERT(in_ball(points, scene.axes, scene.simplex, q) ==
                  in_ball(points, scene.axes, other, apex));
      }
    }
  }));
}

TEST_CASE("B6 one constant on all weights, or an affine function on all heights, keeps in_ball") {
  CHECK(holds_for_simplices(1, 5, [](const PointsCase& set, Scaling scaling) {
    const std::size_t dimension = set.points.front().size();
    const Rational constant = *generators::small_rational();
    const Point slope = *rc::gen::container<Point>(dimension, generators::small_rational());
    PointsCase raised = set;
    PointsCase tilted = set;
    raised.weights.resize(set.points.size());
    tilted.weights.resize(set.points.size());
    for (std::size_t v = 0; v < set.points.size(); ++v) {
      raised.weights[v] += constant;
      tilted.weights[v] += constant + inner_product(slope, set.points[v]);
    }
    const Scene scene = generators::scene(set, scaling);
    const Configuration raised_points = generators::configuration(raised, scaling);
    const Configuration tilted_points = generators::configuration(tilted, scaling);
    for (const Vertex q : scene.queries) {
      const int side = in_ball(scene.points, scene.axes, scene.simplex, q);
      RC_ASSERT(in_ball(raised_points, scene.axes, scene.simplex, q) == side);
      RC_ASSERT(in_ball(tilted_points, scene.axes, scene.simplex, q) == side);
    }
  }));
}

TEST_CASE("B7 in_ball does not depend on the axes chosen for the flat") {
  const auto law = [](const PointsCase& set, Scaling scaling) {
    const Scene scene = generators::scene(set, scaling);
    const std::size_t dimension = set.points.front().size();
    for (const auto& axes : generators::subsets(dimension, scene.axes.size())) {
      if (orientation(scene.points, axes, scene.simplex) == 0) continue;
      for (const Vertex q : scene.queries) {
        RC_ASSERT(in_ball(scene.points, axes, scene.simplex, q) ==
                  in_ball(scene.points, scene.axes, scene.simplex, q));
      }
    }
  };
  for (std::size_t d = 2; d <= 5; ++d) {
    for (std::size_t k = 1; k < d; ++k) {
      const auto flats = generators::embedded(generators::any_point_set(k, k + 6), d);
      const auto cases = rc::gen::oneOf(generators::unweighted(flats), generators::weighted(flats));
      CHECK(generators::holds(std::to_string(k) + "-flats in dimension " + std::to_string(d),
                              generators::simplex_first(cases), law));
    }
  }
}

TEST_CASE("in_ball within the hull of all points is taken on the hull's axes") {
  CHECK(properties::holds([] {
    const Scene scene = generators::scene(*generators::simplex_and_queries(3), Scaling::kCommon);
    for (const Vertex q : scene.queries) {
      RC_ASSERT(in_ball(scene.points, scene.simplex, q) ==
                in_ball(scene.points, scene.axes, scene.simplex, q));
    }
  }));
}

TEST_CASE("B2 in_ball is exact on a set that has no common scale") {
  CHECK(properties::holds([] {
    const auto sets = generators::sets_of(generators::unrelated_denominator_points, 3, 9);
    const PointsCase set = *generators::simplex_first(generators::unweighted(sets));
    const Scene scene = generators::scene(set, Scaling::kCommon);
    RC_PRE(!scene.points.has_common_denominator());
    std::vector<Point> vertices(set.points.begin(),
                                set.points.begin() + static_cast<Vertex>(scene.simplex.size()));
    const auto [centre, squared_radius] =
        generators::power_ball(vertices, std::vector<Rational>(vertices.size()));
    for (const Vertex q : scene.queries) {
      const Rational inside =
          squared_radius - squared_distance(set.points[static_cast<std::size_t>(q)], centre);
      RC_ASSERT(in_ball(scene.points, scene.axes, scene.simplex, q) == sign(inside));
    }
  }));
}

}  // namespace
}  // namespace circumspect
