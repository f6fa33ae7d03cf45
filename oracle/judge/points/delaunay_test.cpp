// Delaunay and weighted Delaunay triangulations, by lemma and by definition.
#include "oracle/judge/points/delaunay.hpp"

#include <algorithm>
#include <random>
#include <set>
#include <stdexcept>

#include <doctest/doctest.h>

#include "oracle/judge/domain/judge_exactly.hpp"

namespace circumspect::check {

// Whether a triangulation is Delaunay: the two rules, their witnesses and margins, and the facts
// `unique` and `canonical`.

namespace {

// A kite cut along its longer diagonal. The balls of both triangles hold the other's apex.
//   {0, 1, 2}: centre (0, −3/2), r² = 25/4; vertex 3 at squared distance 1.
//   {0, 1, 3}: centre (0, 15/4), r² = 289/16; vertex 2 at squared distance 121/16.
ExactMesh kite() {
  return {PointSet({{-2, 0}, {2, 0}, {0, 1}, {0, Rational(-1, 2)}}), {{0, 1, 2}, {3, 1, 0}}};
}

void check_facts(const ExactMesh& mesh, bool unique, bool canonical) {
  for (const By by : {By::kLemma, By::kDefinition}) {
    const Verdict verdict = judge_exactly(Claim::kDelaunay, mesh, nullptr, {.by = by});
    CHECK(verdict.holds());
    CHECK(verdict.unique == unique);
    CHECK(verdict.canonical == canonical);
  }
}

TEST_CASE("facet not local: the wrong diagonal, with the ball, the distance and the margin") {
  const Verdict verdict = judge_points(Claim::kDelaunay, kite());
  REQUIRE(verdict.violations().size() == 1);
  CHECK(verdict.violations()[0].rule == Rule::kFacetNotLocal);
  const Witness& witness = verdict.violations()[0].witness;
  CHECK(witness.simplices == std::vector<Simplex>{{0, 1, 2}});
  CHECK(witness.face == Simplex{0, 1});
  CHECK(witness.vertices == std::vector<Vertex>{3});
  REQUIRE(witness.values.size() == 3);
  CHECK(witness.values[0].name == "squared distance from centre");
  CHECK(witness.values[0].value == 1);
  CHECK(witness.values[1].name == "squared radius");
  CHECK(witness.values[1].value == Rational(25, 4));
  CHECK(witness.values[2].name == "squared radius less squared distance");
  CHECK(witness.values[2].value == Rational(21, 4));
  REQUIRE(witness.ball.has_value());
  CHECK(witness.ball->centre == Point{0, Rational(-3, 2)});
  CHECK(witness.ball->squared_radius == Rational(25, 4));
  CHECK(verdict.tallies().size() == 1);
  CHECK(verdict.tallies().at(Rule::kFacetNotLocal).count == 1);
  CHECK(verdict.tallies().at(Rule::kFacetNotLocal).worst_margin == Rational(21, 25));
  CHECK(!verdict.unique);
  CHECK(!verdict.canonical);
  CHECK(judge_points(Claim::kTriangulation, kite()).holds());
}

TEST_CASE("vertex in ball: the same by definition, once for each ball, and the worst margin") {
  const Verdict verdict = judge_exactly(Claim::kDelaunay, kite(), nullptr, {.by = By::kDefinition});
  REQUIRE(verdict.violations().size() == 2);
  const Witness& first = verdict.violations()[0].witness;
  const Witness& second = verdict.violations()[1].witness;
  CHECK(verdict.violations()[0].rule == Rule::kVertexInBall);
  CHECK(!first.face);
  CHECK(first.vertices == std::vector<Vertex>{3});
  CHECK(second.simplices == std::vector<Simplex>{{3, 1, 0}});
  CHECK(second.vertices == std::vector<Vertex>{2});
  CHECK(second.ball->centre == Point{0, Rational(15, 4)});
  CHECK(second.values[0].value == Rational(121, 16));
  CHECK(second.values[1].value == Rational(289, 16));
  const Tally& tally = verdict.tallies().at(Rule::kVertexInBall);
  CHECK(tally.count == 2);
  CHECK(tally.worst_margin == Rational(21, 25));
  CHECK(!verdict.unique);
}

TEST_CASE(
    "by definition the first point is looked at like every other, in balls and beyond facets") {
  const ExactMesh crossed{PointSet({{0, -1}, {-3, 0}, {3, 0}, {0, 1}}), {{0, 1, 2}, {1, 2, 3}}};
  CHECK(judge_exactly(Claim::kDelaunay, crossed, nullptr, {.by = By::kDefinition})
            .tallies()
            .at(Rule::kVertexInBall)
            .count == 2);
  const ExactMesh notched{PointSet({{0, 4}, {1, 1}, {4, 0}, {0, 0}}), {{0, 3, 1}, {3, 2, 1}}};
  const Verdict verdict =
      judge_exactly(Claim::kTriangulation, notched, nullptr, {.by = By::kDefinition});
  CHECK(verdict.tallies().at(Rule::kHullNotConvex).count == 2);
}

TEST_CASE("vertex in ball: the worst margin is the worst, whichever comes first") {
  ExactMesh mesh = kite();
  std::swap(mesh.simplices[0], mesh.simplices[1]);
  CHECK(judge_exactly(Claim::kDelaunay, mesh, nullptr, {.by = By::kDefinition})
            .tallies()
            .at(Rule::kVertexInBall)
            .worst_margin == Rational(21, 25));
  // By lemma one ball represents the facet: that of the simplex listed first.
  CHECK(judge_points(Claim::kDelaunay, mesh).tallies().at(Rule::kFacetNotLocal).worst_margin ==
        Rational(168, 289));
}

TEST_CASE("a point on the sphere is not in the open ball, and one a hair inside is") {
  const auto square_with = [](const Rational& x) {
    return ExactMesh{PointSet({{0, 0}, {1, 0}, {x, 1}, {0, 1}}), {{0, 1, 3}, {1, 2, 3}}};
  };
  CHECK(judge_points(Claim::kDelaunay, square_with(1)).holds());
  const Rational hair = exact_value(0x1p-52);
  CHECK(!judge_points(Claim::kDelaunay, square_with(1 - hair)).holds());
  CHECK(!judge_exactly(Claim::kDelaunay, square_with(1 - hair), nullptr, {.by = By::kDefinition})
             .holds());
  CHECK(judge_points(Claim::kDelaunay, square_with(1 + hair)).unique == true);
}

TEST_CASE("facts: a triangle is unique and canonical; a square has two triangulations") {
  check_facts({PointSet({{0, 0}, {3, 0}, {0, 4}}), {{2, 1, 0}}}, true, true);
  check_facts({PointSet({{-2, 0}, {2, 0}, {0, 1}, {0, -1}}), {{0, 2, 3}, {1, 2, 3}}}, true, true);
  const PointSet square({{1, 1}, {0, 1}, {1, 0}, {0, 0}});
  check_facts({square, {{0, 1, 3}, {0, 2, 3}}}, false, true);
  check_facts({square, {{0, 1, 2}, {1, 2, 3}}}, false, false);
}

TEST_CASE("facts: a cube cut into six tetrahedra at its smallest corner, and into five") {
  const PointSet cube(
      {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {0, 1, 1}, {1, 0, 0}, {1, 0, 1}, {1, 1, 0}, {1, 1, 1}});
  // Corner 0 with the two triangles of each face that it is not on, cut at their smallest corners.
  check_facts(
      {cube, {{0, 1, 3, 7}, {0, 1, 5, 7}, {0, 2, 3, 7}, {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 4, 6, 7}}},
      false, true);
  check_facts({cube, {{0, 3, 5, 6}, {1, 0, 3, 5}, {2, 0, 3, 6}, {4, 0, 5, 6}, {7, 3, 5, 6}}}, false,
              false);
}

TEST_CASE("facts: an octahedron has three triangulations, one of them canonical") {
  const PointSet octahedron({{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}});
  check_facts({octahedron, {{0, 1, 2, 4}, {0, 1, 4, 3}, {0, 1, 3, 5}, {0, 1, 5, 2}}}, false, true);
  check_facts({octahedron, {{2, 3, 0, 4}, {2, 3, 4, 1}, {2, 3, 1, 5}, {2, 3, 5, 0}}}, false, false);
  check_facts({octahedron, {{4, 5, 0, 2}, {4, 5, 2, 1}, {4, 5, 1, 3}, {4, 5, 3, 0}}}, false, false);
}

// Two squares side by side: one cut canonically, the other not, in either order.
TEST_CASE("facts: canonical means every cell, not the last one looked at") {
  const PointSet points({{0, 0}, {1, 0}, {2, 0}, {0, 1}, {1, 1}, {2, 1}});
  check_facts({points, {{0, 1, 4}, {0, 3, 4}, {1, 2, 5}, {1, 4, 5}}}, false, true);
  check_facts({points, {{0, 1, 3}, {1, 3, 4}, {1, 2, 5}, {1, 4, 5}}}, false, false);
  check_facts({points, {{0, 1, 4}, {0, 3, 4}, {1, 2, 4}, {2, 4, 5}}}, false, false);
}

// oracle/judge/judge_test.cpp compares it with judge_points() on large meshes.
TEST_CASE("facets that somebody found not to be locally Delaunay are asked again, in their order") {
  // The kite twice, and the triangles between.
  const PointSet points({{-2, 0},
                         {2, 0},
                         {0, 1},
                         {0, Rational(-1, 2)},
                         {-2, 10},
                         {2, 10},
                         {0, 9},
                         {0, Rational(21, 2)}});
  const ExactMesh mesh{
      points,
      {{4, 5, 6}, {0, 1, 2}, {3, 1, 0}, {0, 2, 4}, {2, 4, 6}, {2, 5, 6}, {1, 2, 5}, {4, 5, 7}}};
  const SharedFacet below{{0, 1}, 1, 3};
  const SharedFacet above{{4, 5}, 0, 7};
  const Verdict first = not_locally_delaunay(Claim::kDelaunay, mesh, {below});
  REQUIRE(first.violations().size() == 1);
  CHECK(first.violations()[0].witness.face == Simplex{0, 1});
  CHECK(first.violations()[0].witness.vertices == std::vector<Vertex>{3});
  CHECK_FALSE(first.unique.has_value());
  const Verdict of_mesh = judge_points(Claim::kDelaunay, mesh);
  const Verdict both =
      not_locally_delaunay(Claim::kDelaunay, mesh, {above, below}, {.max_violations = 1});
  REQUIRE(both.violations().size() == 1);
  CHECK(both.violations()[0].witness.face == Simplex{0, 1});
  CHECK(both.tallies().at(Rule::kFacetNotLocal).count == 2);
  CHECK(of_mesh.tallies().at(Rule::kFacetNotLocal).count == 2);
  CHECK(both.tallies().at(Rule::kFacetNotLocal).worst_margin ==
        of_mesh.tallies().at(Rule::kFacetNotLocal).worst_margin);
  CHECK(both.points == 8);
  const SharedFacet good{{0, 2}, 1, 4};
  CHECK_THROWS_AS(not_locally_delaunay(Claim::kDelaunay, mesh, {below, good}), std::logic_error);
}

// The claim weighted-delaunay: each of its rules broken alone, by the smallest mesh.
// Book: Sections 4.1 and 5.2.

// Three collinear points. The middle one, lifted, is above the edge between the others for weight
// −2, on it for −1, and below it for 1.
ExactMesh line(const Rational& weight, const std::vector<Simplex>& edges) {
  return {PointSet({{0}, {1}, {2}}, {0, weight, 0}), edges};
}

const std::vector<Simplex> kTwoEdges = {{0, 1}, {1, 2}};
const std::vector<Simplex> kOneEdge = {{0, 2}};

std::set<Rule> broken_weighted(const ExactMesh& mesh, By by) {
  std::set<Rule> rules;
  const Verdict verdict = judge_exactly(Claim::kWeightedDelaunay, mesh, nullptr, {.by = by});
  for (const auto& [rule, tally] : verdict.tallies()) rules.insert(rule);
  return rules;
}

bool holds(const ExactMesh& mesh) {
  const bool by_lemma = broken_weighted(mesh, By::kLemma).empty();
  CHECK(by_lemma == broken_weighted(mesh, By::kDefinition).empty());
  return by_lemma;
}

TEST_CASE("weighted: a point above the lower hull must be left out, one below must not") {
  CHECK(holds(line(-2, kOneEdge)));
  CHECK(!holds(line(-2, kTwoEdges)));
  CHECK(!holds(line(1, kOneEdge)));
  CHECK(holds(line(1, kTwoEdges)));
}

TEST_CASE("weighted: a point on the lower hull may be a vertex or not") {
  for (const auto& edges : {kOneEdge, kTwoEdges}) {
    CHECK(holds(line(-1, edges)));
    CHECK(judge_points(Claim::kWeightedDelaunay, line(-1, edges)).unique == false);
  }
  CHECK(judge_points(Claim::kWeightedDelaunay, line(-1, kOneEdge)).canonical == true);
  CHECK(judge_points(Claim::kWeightedDelaunay, line(-1, kTwoEdges)).canonical == false);
}

TEST_CASE("weighted: a vertex above the witness plane of the simplex around it is submerged") {
  const ExactMesh mesh = line(-2, kTwoEdges);
  CHECK(broken_weighted(mesh, By::kLemma) == std::set{Rule::kVertexSubmerged});
  const Verdict verdict = judge_points(Claim::kWeightedDelaunay, mesh);
  REQUIRE(verdict.violations().size() == 1);
  const Witness& witness = verdict.violations()[0].witness;
  REQUIRE(witness.simplices.size() == 1);
  CHECK(sorted(witness.simplices[0]) == Simplex{0, 2});
  CHECK(witness.vertices == std::vector<Vertex>{1});
  REQUIRE(witness.values.size() == 1);
  CHECK(witness.values[0].value == 1);
  REQUIRE(witness.ball.has_value());
  CHECK(witness.ball->centre == Point{1});
}

TEST_CASE("weighted: a point below the witness plane of the simplex that contains it") {
  const ExactMesh mesh = line(1, kOneEdge);
  CHECK(broken_weighted(mesh, By::kLemma) == std::set{Rule::kPointBelowPlane});
  CHECK(broken_weighted(mesh, By::kDefinition) == std::set{Rule::kPointBelowPlane});
  const Verdict verdict = judge_points(Claim::kWeightedDelaunay, mesh);
  REQUIRE(verdict.violations().size() == 1);
  const Witness& witness = verdict.violations()[0].witness;
  CHECK(witness.simplices == kOneEdge);
  CHECK(witness.vertices == std::vector<Vertex>{1});
  REQUIRE(witness.values.size() == 4);
  CHECK(witness.values[0].value == 0);
  CHECK(witness.values[1].value == 1);
  CHECK(witness.values[2].value == 1);
  CHECK(witness.values[3].value == 2);
  CHECK(verdict.tallies().at(Rule::kPointBelowPlane).worst_margin == Rational(2));
}

TEST_CASE("weighted: a point beyond all simplices is unused, whatever its weight") {
  for (const Rational& weight : {Rational(-9), Rational(0), Rational(9)}) {
    const ExactMesh mesh{PointSet({{0}, {1}, {2}}, {0, 0, weight}), {{0, 1}}};
    CHECK(broken_weighted(mesh, By::kLemma) == std::set{Rule::kUnusedPoint});
    CHECK(!holds(mesh));
  }
}

TEST_CASE("weighted: weights turn the right diagonal into the wrong one") {
  const PointSet kite({{-2, 0}, {2, 0}, {0, 1}, {0, -1}}, {4, 4, 0, 0});
  CHECK(holds({kite, {{0, 1, 2}, {0, 1, 3}}}));
  const ExactMesh wrong{kite, {{0, 2, 3}, {1, 2, 3}}};
  CHECK(!holds(wrong));
  CHECK(broken_weighted(wrong, By::kLemma) == std::set{Rule::kFacetNotLocal});
  CHECK(judge_points(Claim::kTriangulation, wrong).holds());
}

TEST_CASE("weighted: a walk to the points left out, in a fan around a centre") {
  std::vector<Point> points = {{0, 0}, {4, 0}, {0, 4}, {-4, 0}, {0, -4}};
  const std::vector<Simplex> fan = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}};
  std::vector<Rational> weights(5, Rational(0));
  for (const int x : {-1, 1}) {
    for (const int y : {-1, 1}) {
      points.push_back({x, y});
      weights.push_back(-100);
    }
  }
  CHECK(holds({PointSet(points, weights), fan}));
  weights.back() = 100;
  const ExactMesh below{PointSet(points, weights), fan};
  CHECK(broken_weighted(below, By::kLemma) == std::set{Rule::kPointBelowPlane});
  const Verdict verdict = judge_points(Claim::kWeightedDelaunay, below);
  REQUIRE(verdict.violations().size() == 1);
  CHECK(verdict.violations()[0].witness.simplices == std::vector<Simplex>{{0, 1, 2}});
  CHECK(verdict.violations()[0].witness.vertices == std::vector<Vertex>{8});
}

TEST_CASE("weighted: of several simplices that contain a point, the first in the list is shown") {
  // Both points lie on the edge of both triangles.
  const PointSet points({{0, 0}, {4, 0}, {0, 4}, {4, 4}, {2, 2}, {1, 3}}, {0, 0, 0, 0, 9, 9});
  std::vector<Simplex> square = {{0, 1, 2}, {3, 2, 1}};
  for (int turn = 0; turn < 2; ++turn) {
    const Verdict verdict = judge_points(Claim::kWeightedDelaunay, {points, square});
    REQUIRE(verdict.violations().size() == 2);
    for (const Violation& violation : verdict.violations()) {
      CHECK(violation.rule == Rule::kPointBelowPlane);
      CHECK(violation.witness.simplices == std::vector<Simplex>{square[0]});
    }
    std::swap(square[0], square[1]);
  }
  // An edge of four tetrahedra, to which the search comes from above: whichever it finds, the way
  // to the first leads past later ones.
  const PointSet bipyramid(
      {{0, 0, -1}, {0, 0, 1}, {0, 0, 3}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 0}},
      {0, 0, 0, 0, 0, 0, 0, 9});
  std::vector<Simplex> around = {{0, 1, 3, 4}, {0, 1, 3, 6}, {0, 1, 4, 5}, {0, 1, 5, 6}};
  do {
    const std::vector<Simplex> all = {{1, 2, 3, 4}, around[0], around[1],    around[2],
                                      {1, 2, 4, 5}, around[3], {1, 2, 3, 6}, {1, 2, 5, 6}};
    const Verdict verdict = judge_points(Claim::kWeightedDelaunay, {bipyramid, all});
    REQUIRE(verdict.violations().size() == 1);
    CHECK(verdict.violations().front().witness.simplices == std::vector<Simplex>{around[0]});
  } while (std::next_permutation(around.begin(), around.end()));
}

// The orientations that it takes to find n submerged points in a fan of n triangles.
std::uint64_t work_in_fan(int n) {
  std::vector<Point> points;
  std::vector<Simplex> fan;
  for (int x = 0; x <= n; ++x) points.push_back({Rational(x) / 3, 0});
  points.push_back({Rational(n) / 6, n});
  for (int x = 0; x < n; ++x) fan.push_back({x, x + 1, n + 1});
  std::vector<Rational> weights(points.size(), Rational(0));
  std::mt19937 random(7);
  const auto next = [&]() -> Rational {
    return Rational(1 + static_cast<int>(random() % 1000000)) / 1000001;
  };
  for (int i = 0; i < n; ++i) {
    const Rational y = next() * n;
    points.push_back({y / 6 + (n - y) / 3 * next(), y});
    weights.push_back(-4 * n * n);
  }
  const ExactMesh mesh{PointSet(points, weights), fan};
  Verdict verdict(Claim::kWeightedDelaunay, mesh, 0);
  Ambiguity ambiguity;
  const std::uint64_t work =
      judge_submerged_points(mesh, facet_uses(mesh.simplices), verdict, ambiguity);
  CHECK(verdict.holds());
  return work;
}

TEST_CASE("weighted: as many submerged points as triangles, in a fan, take near-linear work") {
  CHECK(work_in_fan(2000) < 2000 * 150);
  CHECK(work_in_fan(4000) < 5 * work_in_fan(1000));
}

TEST_CASE("weighted: a submerged vertex is named where it lies on an edge of the hull") {
  // One barycentric coordinate of each apex in the other triangle is zero.
  const ExactMesh mesh{PointSet({{0, 0}, {1, 0}, {2, 0}, {1, 1}}, {0, -10, 0, 0}),
                       {{0, 1, 3}, {1, 2, 3}}};
  CHECK(broken_weighted(mesh, By::kLemma) == std::set{Rule::kVertexSubmerged});
  const Verdict verdict = judge_points(Claim::kWeightedDelaunay, mesh);
  REQUIRE(verdict.violations().size() == 1);
  CHECK(verdict.violations()[0].witness.vertices == std::vector<Vertex>{1});
}

TEST_CASE("weighted: without weights it is the claim delaunay, if every point is a vertex") {
  const PointSet square({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  CHECK(holds({square, {{0, 1, 2}, {0, 2, 3}}}));
  CHECK(holds({PointSet({}), {}}));
  CHECK(holds({PointSet({{5}}, {3}), {{0}}}));
  CHECK(!holds({PointSet({{5}}, {3}), {}}));
}

}  // namespace

}  // namespace circumspect::check
