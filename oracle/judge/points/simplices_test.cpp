// What can be wrong with one simplex, with a pair of equal ones, and with the set of vertices: each
// rule broken alone, by the smallest mesh.
#include "oracle/judge/points/simplices.hpp"

#include <set>

#include <doctest/doctest.h>

#include "oracle/judge/domain/judge_exactly.hpp"
#include "oracle/judge/points/delaunay.hpp"

namespace circumspect::check {
namespace {

const std::vector<Point> kSquare = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

// The rules that a mesh breaks as a Delaunay triangulation. If there are any, nothing else is said.
std::set<Rule> broken_delaunay(const ExactMesh& mesh, By by, bool oriented = false) {
  std::set<Rule> rules;
  const Verdict verdict =
      judge_exactly(Claim::kDelaunay, mesh, nullptr, {.by = by, .oriented = oriented});
  CHECK((verdict.holds() || (!verdict.unique && !verdict.canonical)));
  for (const auto& [rule, tally] : verdict.tallies()) {
    rules.insert(rule);
  }
  return rules;
}

// The only violation of a mesh, after a check that there is only one both ways.
Violation only_violation(Rule rule, const ExactMesh& mesh, bool oriented = false) {
  CHECK(broken_delaunay(mesh, By::kLemma, oriented) == std::set{rule});
  CHECK(broken_delaunay(mesh, By::kDefinition, oriented) == std::set{rule});
  const Verdict verdict = judge_points(Claim::kDelaunay, mesh, {.oriented = oriented});
  CHECK(!verdict.holds());
  REQUIRE(verdict.violations().size() == 1);
  CHECK(verdict.tallies().at(rule).count == 1);
  CHECK(!verdict.tallies().at(rule).worst_margin);
  CHECK(!verdict.unique);
  CHECK(!verdict.canonical);
  return verdict.violations().front();
}

TEST_CASE("unknown vertex: an index beyond the last point, and a negative one") {
  for (const Vertex v : {Vertex{4}, Vertex{-1}, Vertex{1'000'000'000'000}}) {
    const ExactMesh mesh{PointSet(kSquare), {{0, 1, 2}, {0, 2, 3}, {0, v, 3}}};
    const Witness witness = only_violation(Rule::kUnknownVertex, mesh).witness;
    CHECK(witness.simplices == std::vector<Simplex>{{0, v, 3}});
    CHECK(witness.vertices == std::vector<Vertex>{v});
  }
}

TEST_CASE("wrong dimension: an edge among triangles, and tetrahedra of a plane") {
  const Witness edge =
      only_violation(Rule::kWrongDimension, {PointSet(kSquare), {{0, 1, 2}, {0, 2, 3}, {1, 3}}})
          .witness;
  CHECK(edge.simplices == std::vector<Simplex>{{1, 3}});
  REQUIRE(edge.values.size() == 2);
  CHECK(edge.values[0].name == "vertices");
  CHECK(edge.values[0].value == 2);
  CHECK(edge.values[1].name == "vertices expected");
  CHECK(edge.values[1].value == 3);
  const PointSet flat({{0, 0, 5}, {1, 0, 5}, {1, 1, 5}, {0, 1, 5}});
  const Witness solid = only_violation(Rule::kWrongDimension, {flat, {{0, 1, 2, 3}}}).witness;
  CHECK(solid.values[0].value == 4);
}

TEST_CASE("repeated vertex: named, even where the simplex would be flat anyhow") {
  const ExactMesh mesh{PointSet(kSquare), {{0, 1, 2}, {0, 2, 3}, {3, 1, 3}}};
  const Witness witness = only_violation(Rule::kRepeatedVertex, mesh).witness;
  CHECK(witness.simplices == std::vector<Simplex>{{3, 1, 3}});
  CHECK(witness.vertices == std::vector<Vertex>{3});
}

TEST_CASE("degenerate: a flat triangle that fills nothing, between good ones") {
  const PointSet points({{0, 0}, {1, 0}, {2, 0}, {1, 1}});
  const ExactMesh mesh{points, {{0, 1, 3}, {1, 2, 3}, {2, 0, 1}}};
  const Witness witness = only_violation(Rule::kDegenerateSimplex, mesh).witness;
  CHECK(witness.simplices == std::vector<Simplex>{{2, 0, 1}});
  REQUIRE(witness.values.size() == 1);
  CHECK(witness.values[0].name == "orientation determinant");
  CHECK(witness.values[0].value == 0);
}

TEST_CASE("degenerate: exactly flat, not nearly") {
  const Rational tiny = exact_value(0x1p-1000);
  const ExactMesh mesh{PointSet({{0, 0}, {1, tiny}, {2, 0}}), {{0, 1, 2}}};
  CHECK(broken_delaunay(mesh, By::kLemma).empty());
  CHECK(broken_delaunay(mesh, By::kDefinition).empty());
}

TEST_CASE("orientation: as many are wrong in any order of the list") {
  const PointSet points({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {0, 1}, {1, 1}, {2, 1}, {3, 1}});
  // Three are counterclockwise, one is not.
  std::vector<Simplex> triangles = {{4, 1, 0}, {1, 5, 4}, {1, 2, 5}, {2, 6, 5}};
  for (std::size_t turn = 0; turn < triangles.size(); ++turn) {
    std::rotate(triangles.begin(), triangles.begin() + 1, triangles.end());
    CAPTURE(turn);
    Verdict verdict(Claim::kTriangulation, 20);
    judge_simplices({points, triangles}, true, verdict);
    CHECK(verdict.tallies().at(Rule::kOrientation).count == 1);
  }
}

TEST_CASE("orientation: matters only if asked for; most simplices give the example") {
  const ExactMesh mixed{PointSet(kSquare), {{0, 1, 2}, {0, 3, 2}}};
  CHECK(broken_delaunay(mixed, By::kLemma).empty());
  CHECK(broken_delaunay(mixed, By::kDefinition).empty());
  const Witness witness = only_violation(Rule::kOrientation, mixed, true).witness;
  CHECK(witness.simplices == mixed.simplices);
  REQUIRE(witness.values.size() == 2);
  CHECK(witness.values[0].name == "orientation of most");
  CHECK(witness.values[0].value == 1);
  CHECK(witness.values[1].name == "orientation of the other");
  CHECK(witness.values[1].value == -1);
  // Counterclockwise all over, or clockwise all over: either is one orientation.
  CHECK(broken_delaunay({PointSet(kSquare), {{0, 1, 2}, {2, 3, 0}}}, By::kLemma, true).empty());
  CHECK(broken_delaunay({PointSet(kSquare), {{1, 0, 2}, {0, 3, 2}}}, By::kLemma, true).empty());
}

TEST_CASE("duplicate simplex: the same vertices in another order, each repetition once") {
  const ExactMesh twice{PointSet(kSquare), {{0, 1, 2}, {0, 2, 3}, {2, 1, 0}}};
  const Witness witness = only_violation(Rule::kDuplicateSimplex, twice).witness;
  CHECK(witness.simplices == std::vector<Simplex>{{0, 1, 2}, {2, 1, 0}});
  const ExactMesh thrice{PointSet(kSquare), {{0, 1, 2}, {0, 2, 3}, {2, 1, 0}, {1, 0, 2}}};
  CHECK(judge_points(Claim::kDelaunay, thrice).tallies().at(Rule::kDuplicateSimplex).count == 2);
}

TEST_CASE("unused point: inside, on an edge of the hull, outside") {
  const std::vector<Simplex> triangles = {{0, 1, 2}, {0, 2, 3}};
  for (const Point& more :
       std::vector<Point>{{Rational(1, 3), Rational(2, 3)}, {Rational(1, 2), 0}}) {
    std::vector<Point> points = kSquare;
    points.push_back(more);
    const ExactMesh mesh{PointSet(points), triangles};
    const Verdict verdict = judge_points(Claim::kTriangulation, mesh);
    REQUIRE(verdict.violations().size() == 1);
    CHECK(verdict.violations()[0].rule == Rule::kUnusedPoint);
    CHECK(verdict.violations()[0].witness.vertices == std::vector<Vertex>{4});
    CHECK(verdict.violations()[0].witness.point == more);
    CHECK(judge_exactly(Claim::kTriangulation, mesh, nullptr, {.by = By::kDefinition})
              .tallies()
              .size() == 1);
  }
  // By lemma, nothing else is wrong with a point outside; by definition, it lies beyond the hull.
  const ExactMesh outside{PointSet({{0, 0}, {4, 0}, {0, 4}, {9, 9}}), {{0, 1, 2}}};
  CHECK(broken_delaunay(outside, By::kLemma) == std::set{Rule::kUnusedPoint});
  CHECK(broken_delaunay(outside, By::kDefinition) ==
        std::set{Rule::kUnusedPoint, Rule::kHullNotConvex});
}

TEST_CASE("simplices that cannot be worked with are all reported, and keep the rest unjudged") {
  const ExactMesh mesh{PointSet(kSquare), {{0, 1}, {0, 1, 1}, {0, 1, 9}, {0, 1, 2}, {0, 1, 3}}};
  const std::set expected = {Rule::kWrongDimension, Rule::kRepeatedVertex, Rule::kUnknownVertex};
  CHECK(broken_delaunay(mesh, By::kLemma) == expected);  // and not the overlap of the last two
  CHECK(broken_delaunay(mesh, By::kDefinition) == expected);
}

}  // namespace
}  // namespace circumspect::check
