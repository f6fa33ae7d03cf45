// The claims on small and flat sets, neighbours, and how violations are kept and counted.
#include <algorithm>

#include <doctest/doctest.h>

#include "oracle/judge/domain/judge_exactly.hpp"
#include "oracle/judge/points/delaunay.hpp"

namespace circumspect::check {
namespace {

void check_both_ways(const ExactMesh& mesh, bool holds) {
  for (const By by : {By::kLemma, By::kDefinition}) {
    CHECK(judge_exactly(Claim::kTriangulation, mesh, nullptr, {.by = by}).holds() == holds);
    CHECK(judge_exactly(Claim::kDelaunay, mesh, nullptr, {.by = by}).holds() == holds);
  }
}

Rule only_rule(const ExactMesh& mesh) {
  const Verdict verdict = judge_points(Claim::kDelaunay, mesh);
  REQUIRE(verdict.tallies().size() == 1);
  return verdict.tallies().begin()->first;
}

TEST_CASE("the empty set: no simplices are its triangulation, and nothing else is") {
  check_both_ways({PointSet({}), {}}, true);
  check_both_ways({PointSet({}), {{0}}}, false);
  CHECK(only_rule({PointSet({}), {{0}}}) == Rule::kUnknownVertex);
  const Verdict verdict = judge_points(Claim::kDelaunay, {PointSet({}), {}});
  CHECK(verdict.points == 0);
  CHECK(verdict.simplices == 0);
  CHECK(verdict.dimension == -1);
  CHECK(verdict.unique == true);
  CHECK(verdict.canonical == true);
}

TEST_CASE("one point, in whatever dimension, is one vertex") {
  const PointSet point({{3, 1, 4}});
  check_both_ways({point, {{0}}}, true);
  check_both_ways({point, {}}, false);
  check_both_ways({point, {{0}, {0}}}, false);
  check_both_ways({point, {{0, 0}}}, false);
  CHECK(only_rule({point, {}}) == Rule::kUnusedPoint);
  CHECK(only_rule({point, {{0}, {0}}}) == Rule::kDuplicateSimplex);
}

TEST_CASE("two points are an edge") {
  const PointSet points({{3, 1}, {4, 1}});
  check_both_ways({points, {{1, 0}}}, true);
  check_both_ways({points, {{0}, {1}}}, false);
  check_both_ways({points, {}}, false);
}

TEST_CASE("three points are a triangle, or two edges of a line") {
  check_both_ways({PointSet({{0, 0}, {1, 0}, {0, 1}}), {{0, 1, 2}}}, true);
  check_both_ways({PointSet({{0, 0}, {1, 0}, {0, 1}}), {{0, 1}, {1, 2}, {0, 2}}}, false);
  const PointSet line({{0, 0}, {2, 2}, {1, 1}});
  check_both_ways({line, {{0, 2}, {2, 1}}}, true);
  check_both_ways({line, {{0, 1}}}, false);
  CHECK(only_rule({line, {{0, 1}}}) == Rule::kUnusedPoint);
  CHECK(only_rule({line, {{0, 1}, {0, 2}}}) == Rule::kOverlap);
  CHECK(only_rule({line, {{0, 1, 2}}}) == Rule::kWrongDimension);
}

TEST_CASE("a plane in space and a space in four dimensions: all happens in the affine hull") {
  const PointSet square({{0, 0, 0}, {1, 2, 1}, {1, 0, 3}, {2, 2, 4}});
  check_both_ways({square, {{0, 1, 2}, {1, 3, 2}}}, true);
  check_both_ways({square, {{0, 1, 2}, {0, 3, 2}}}, false);
  check_both_ways({square, {{0, 1, 2, 3}}}, false);
  CHECK(judge_points(Claim::kDelaunay, {square, {{0, 1, 2}, {1, 3, 2}}}).dimension == 2);
  // A planar kite whose longer diagonal is not Delaunay, tilted in space by a similarity.
  const PointSet kite({{-2, -2, 0}, {2, 2, 0}, {1, -1, 0}, {-1, 1, 0}});
  CHECK(judge_points(Claim::kTriangulation, {kite, {{0, 1, 2}, {0, 1, 3}}}).holds());
  CHECK(only_rule({kite, {{0, 1, 2}, {0, 1, 3}}}) == Rule::kFacetNotLocal);
  check_both_ways({kite, {{0, 2, 3}, {1, 2, 3}}}, true);
  const PointSet solid({{0, 0, 0, 9}, {1, 0, 0, 9}, {0, 1, 0, 9}, {0, 0, 1, 9}, {-1, -1, -1, 9}});
  check_both_ways({solid, {{0, 1, 2, 3}, {0, 1, 2, 4}, {0, 1, 3, 4}, {0, 2, 3, 4}}}, true);
  check_both_ways({solid, {{0, 1, 2, 3}, {0, 1, 2, 4}, {0, 1, 3, 4}}}, false);
}

TEST_CASE("witnesses are kept up to a maximum, and counted beyond it") {
  const ExactMesh mesh{PointSet({{0, 0}, {1, 0}, {0, 1}, {5, 5}, {6, 5}, {5, 6}, {9, 9}}),
                       {{0, 1, 2}}};
  for (const By by : {By::kLemma, By::kDefinition}) {
    CHECK(judge_exactly(Claim::kTriangulation, mesh, nullptr, {.by = by, .max_violations = 1})
              .violations()
              .size() == 1);
    CHECK(judge_exactly(Claim::kTriangulation, mesh, nullptr, {.by = by, .max_violations = 3})
              .violations()
              .size() == 3);
    const Verdict all =
        judge_exactly(Claim::kTriangulation, mesh, nullptr, {.by = by, .max_violations = 0});
    std::size_t counted = 0;
    for (const auto& [rule, tally] : all.tallies()) counted += tally.count;
    CHECK(all.violations().size() == counted);
    CHECK(all.tallies().at(Rule::kUnusedPoint).count == 4);
    CHECK(judge_exactly(Claim::kTriangulation, mesh, nullptr, {.by = by, .max_violations = 1})
              .tallies()
              .size() == all.tallies().size());
  }
  const Verdict few = judge_points(Claim::kTriangulation, mesh, {.max_violations = 2});
  CHECK(few.tallies().at(Rule::kUnusedPoint).count == 4);
  CHECK(few.violations()[1].witness.vertices == std::vector<Vertex>{4});
}

TEST_CASE("a verdict counts what it drops, with the worst margin of all") {
  Verdict verdict(Claim::kDelaunay, {PointSet({}), {}}, 1);
  CHECK(verdict.holds());
  CHECK(verdict.keeps_more());
  verdict.add(Rule::kVertexInBall, {.vertices = {7}}, Rational(1, 3));
  CHECK(!verdict.keeps_more());
  verdict.add(Rule::kVertexInBall, {.vertices = {8}}, Rational(1, 2));
  verdict.count(Rule::kVertexInBall, Rational(1, 5));
  verdict.count(Rule::kOverlap);
  CHECK(!verdict.holds());
  REQUIRE(verdict.violations().size() == 1);
  CHECK(verdict.violations()[0].witness.vertices == std::vector<Vertex>{7});
  CHECK(verdict.tallies().at(Rule::kVertexInBall).count == 3);
  CHECK(verdict.tallies().at(Rule::kVertexInBall).worst_margin == Rational(1, 2));
  CHECK(!verdict.tallies().at(Rule::kOverlap).worst_margin);
}

TEST_CASE("neighbours: the true ones pass, each false one is named with what it should be") {
  ExactMesh mesh{PointSet({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), {{0, 1, 2}, {0, 2, 3}}};
  mesh.neighbors = Neighbors{{{-1, 1, -1}, {-1, -1, 0}}};
  check_both_ways(mesh, true);
  mesh.neighbors = Neighbors{{{-1, 6, -1}, {-1, -1, 5}}, 5};
  check_both_ways(mesh, true);
  mesh.neighbors = Neighbors{{{6, -1, -1}, {-1, -1, 5}}, 5};
  check_both_ways(mesh, false);
  CHECK(only_rule(mesh) == Rule::kWrongNeighbor);
  const Verdict swapped = judge_points(Claim::kDelaunay, mesh);
  REQUIRE(swapped.violations().size() == 2);
  const Witness& missing = swapped.violations()[0].witness;  // in order of the facets
  CHECK(missing.face == Simplex{0, 2});
  CHECK(missing.simplices == std::vector<Simplex>{{0, 1, 2}, {0, 2, 3}});
  REQUIRE(missing.values.size() == 2);
  CHECK(missing.values[0].name == "neighbour listed");
  CHECK(missing.values[0].value == -1);
  CHECK(missing.values[1].name == "neighbour across the face");
  CHECK(missing.values[1].value == 6);
  const Witness& extra = swapped.violations()[1].witness;
  CHECK(extra.face == Simplex{1, 2});
  CHECK(extra.values[0].value == 6);
  CHECK(extra.values[1].value == -1);
  mesh.neighbors = Neighbors{{{-1, 1, -1}, {-1, -1, -1}}};
  const Verdict none = judge_points(Claim::kDelaunay, mesh);
  REQUIRE(none.violations().size() == 1);
  CHECK(none.violations()[0].witness.simplices == std::vector<Simplex>{{0, 2, 3}, {0, 1, 2}});
  mesh.neighbors = Neighbors{{{-1, 7, -1}, {-1, -1, 0}}};
  CHECK(only_rule(mesh) == Rule::kWrongNeighbor);
}

}  // namespace
}  // namespace circumspect::check
