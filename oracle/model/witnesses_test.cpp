// Witnesses that more than one judge gives.
#include "oracle/model/witnesses.hpp"

#include <random>

#include <doctest/doctest.h>

#include "kernel/predicates/in_ball.hpp"
#include "kernel/predicates/orientation.hpp"

namespace circumspect {
namespace {

TEST_CASE("the worst margin is the worst also where there is no room for its witness") {
  std::mt19937 random(20261123);
  for (int round = 0; round < 20; ++round) {
    std::vector<Point> points;
    for (int i = 0; i < 12; ++i) {
      Point point;
      for (int axis = 0; axis < 3; ++axis) {
        point.push_back(Rational(static_cast<int>(random() % 2000)) / (1 + round));
      }
      points.push_back(std::move(point));
    }
    const ExactMesh mesh{PointSet(points), {}};
    Verdict all(Claim::kDelaunay, mesh, 0), few(Claim::kDelaunay, mesh, 1);
    for (Simplex simplex = first_subset(4); next_subset(simplex, points.size());) {
      const Simplex front = positively_oriented(mesh.points, simplex);
      if (orientation(mesh.points.configuration(), front) == 0) continue;
      for (Vertex q = 0; mesh.points.names(q); ++q) {
        if (contains(front, q) || in_ball(mesh.points.configuration(), front, q) <= 0) continue;
        for (Verdict* const verdict : {&all, &few}) {
          add_vertex_in_ball(mesh.points, Rule::kVertexInBall, front, std::nullopt, q, *verdict);
        }
      }
    }
    REQUIRE(few.violations().size() == 1);
    const Tally& of_all = all.tallies().at(Rule::kVertexInBall);
    CHECK(few.tallies().at(Rule::kVertexInBall).count == of_all.count);
    CHECK(few.tallies().at(Rule::kVertexInBall).worst_margin == of_all.worst_margin);
  }
}

}  // namespace
}  // namespace circumspect
