// The lexicographic triangulation is a triangulation, the one that the definition of Section 2.1
// says, whatever the order of the input. D6 for triangulations that are not Delaunay. Book:
// Sections 2.1 and 4.1.
#include <set>

#include <doctest/doctest.h>

#include "kernel/complex/point_set.hpp"
#include "oracle/judge/domain/judge_exactly.hpp"
#include "oracle/judge/points/delaunay.hpp"
#include "properties/arguments/laws.hpp"
#include "properties/arguments/point_sets.hpp"
#include "properties/arguments/run.hpp"
#include "reference/delaunay/lexicographic.hpp"
#include "reference/delaunay/lifted_hull.hpp"

namespace circumspect::properties {
namespace {

using generators::PointsCase;

PointSet any_set(std::size_t d, std::size_t max_points) {
  const PointsCase set = *generators::any_unweighted_case(d, max_points);
  return PointSet(set.points);
}

TEST_CASE("the lexicographic triangulation is a triangulation (Sections 2.1, 4.1)") {
  for (const std::size_t d : {1u, 2u, 3u, 4u}) {
    CAPTURE(d);
    std::size_t not_delaunay = 0;
    CHECK(holds("lexicographic triangulation", d == 4 ? 90 : 120, [&] {
      const PointSet points = any_set(d, d == 4 ? 8 : 11);
      const Triangulation triangulation = delaunay::lexicographic(points);
      const ExactMesh mesh{points, triangulation.simplices()};
      RC_ASSERT(check::judge_points(Claim::kTriangulation, mesh).holds());
      RC_ASSERT(
          check::judge_exactly(Claim::kTriangulation, mesh, nullptr, {.by = check::By::kDefinition})
              .holds());
      not_delaunay += check::judge_points(Claim::kDelaunay, mesh).holds() ? 0u : 1u;
    }));
    if (d == 1) CHECK(not_delaunay == 0);
    if (d > 1) CHECK(occurs(not_delaunay));
  }
}

// Joining each point to what it sees of those before it is what a lower hull does whose heights
// grow fast enough: 2^(200 i) for the i-th point, far more than these coordinates can balance.
TEST_CASE("the lexicographic triangulation is that of heights that grow without bound") {
  for (const std::size_t d : {1u, 2u, 3u}) {
    CAPTURE(d);
    CHECK(holds("lexicographic triangulation as a lower hull", 100, [d] {
      const auto sets = rc::gen::oneOf(generators::sets_of(generators::integer_points, d, 8),
                                       generators::sets_of(generators::grid_points, d, 8),
                                       generators::sets_of(generators::cube_points, d, 8),
                                       generators::sets_of(generators::rational_points, d, 8));
      const PointsCase set = *generators::unweighted(sets);
      const PointSet points(set.points);
      std::vector<Rational> weights;
      for (Vertex v = 0; points.names(v); ++v) {
        const Integer height = Integer(1) << (200 * points.configuration().rank(v));
        weights.push_back(squared_length(points[v]) - height);
      }
      RC_ASSERT(delaunay::lexicographic(points) ==
                delaunay::by_definition(PointSet(set.points, weights)));
    }));
  }
}

TEST_CASE("the lexicographic triangulation does not depend on the order of the input") {
  for (const std::size_t d : {2u, 3u}) {
    CAPTURE(d);
    CHECK(holds("independence of input order", 100, [d] {
      const PointSet points = any_set(d, 14);
      const std::vector<Vertex> order = generators::shuffled(all_vertices(points));
      const PointSet moved(coordinates(points, order));
      std::vector<Simplex> simplices = delaunay::lexicographic(moved).simplices();
      for (Simplex& simplex : simplices) {
        for (Vertex& v : simplex) v = order[static_cast<std::size_t>(v)];
      }
      RC_ASSERT(Triangulation(points.dimension(), simplices) == delaunay::lexicographic(points));
    }));
  }
}

TEST_CASE("D6 t = e - n - h + 3 for the lexicographic triangulation (Section 4.1)") {
  CHECK(holds("Euler", 200, [] {
    const PointSet points = any_set(3, 14);
    RC_PRE(points.dimension() == 3);
    const Triangulation triangulation = delaunay::lexicographic(points);
    std::set<Vertex> on_hull;
    std::set<Simplex> edges;
    for (const auto& [triangle, apexes] : apexes_by_facet(triangulation)) {
      if (apexes.size() == 1) on_hull.insert(triangle.begin(), triangle.end());
      for (std::size_t place = 0; place < 3; ++place) edges.insert(facet_opposite(triangle, place));
    }
    RC_ASSERT(triangulation.simplices().size() + points.size() + on_hull.size() ==
              edges.size() + 3);
  }));
}

}  // namespace
}  // namespace circumspect::properties
