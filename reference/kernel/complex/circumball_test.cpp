// Circumballs and orthoballs.
#include "reference/kernel/complex/circumball.hpp"

#include <doctest/doctest.h>

#include "inputs/plain_algebra.hpp"
#include "properties/arguments/laws.hpp"
#include "reference/kernel/predicates/in_ball.hpp"

namespace circumspect {
namespace {

using generators::PointsCase;

TEST_CASE("circumball: of a right triangle, an edge, a vertex, a tetrahedron") {
  const PointSet triangle({{0, 0}, {4, 0}, {0, 2}});
  const Ball ball = circumball(triangle, {0, 1, 2});
  CHECK(ball.centre == Point{2, 1});
  CHECK(ball.squared_radius == 5);
  const Ball edge = circumball(triangle, {1, 2});
  CHECK(edge.centre == Point{2, 1});
  const Ball vertex = circumball(triangle, {1});
  CHECK(vertex.centre == Point{4, 0});
  CHECK(vertex.squared_radius == 0);
  const PointSet corner({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  const Rational half(1, 2);
  CHECK(circumball(corner, {3, 1, 0, 2}).centre == Point{half, half, half});
  CHECK(circumball(corner, {3, 1, 0, 2}).squared_radius == Rational(3, 4));
}

TEST_CASE("circumball: of a triangle in space, its centre lies in the triangle's plane") {
  const PointSet points({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  const Rational third(1, 3);
  CHECK(circumball(points, {0, 1, 2}).centre == Point{third, third, third});
  CHECK(circumball(points, {0, 1, 2}).squared_radius == Rational(2, 3));
}

TEST_CASE("circumball: an orthoball may have a negative squared radius; power") {
  const PointSet points({{0}, {2}, {1}}, {4, 4, -1});
  const Ball ball = circumball(points, {0, 1});
  CHECK(ball.centre == Point{1});
  CHECK(ball.squared_radius == -3);
  CHECK(power(points, ball, 0) == 0);
  CHECK(power(points, ball, 2) == 4);  // 0 + 1 + 3: above the witness plane
}

TEST_CASE("circumball: it agrees with Cramer's rule, and power has the sign of the predicate") {
  for (const std::size_t d : {1U, 2U, 3U, 4U}) {
    CHECK(rc::check("dimension " + std::to_string(d), [d] {
      const PointsCase set = *generators::simplex_and_queries(d);
      const PointSet points(set.points, set.weights);
      const Simplex simplex =
          generators::first_vertices(static_cast<std::size_t>(points.dimension()) + 1);
      std::vector<Rational> weights;
      for (const Vertex v : simplex) weights.push_back(points.weight(v));
      const auto expected = generators::power_ball(coordinates(points, simplex), weights);
      const Ball ball = circumball(points, simplex);
      RC_ASSERT(ball.centre == expected.centre);
      RC_ASSERT(ball.squared_radius == expected.squared_radius);
      for (Vertex q = 0; points.names(q); ++q) {
        const int side = contains(simplex, q) ? 0 : in_ball(points.configuration(), simplex, q);
        RC_ASSERT(sign(power(points, ball, q)) == -side);
      }
    }));
  }
}

}  // namespace
}  // namespace circumspect
