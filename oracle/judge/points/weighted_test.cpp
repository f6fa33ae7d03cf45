// The claim weighted-delaunay: each of its rules broken alone, by the smallest mesh.
// Book: Sections 4.1 and 5.2.
#include <random>
#include <set>

#include <doctest/doctest.h>

#include "oracle/judge/points/check.hpp"
#include "oracle/judge/points/submerged_points.hpp"

namespace circumspect::check {
namespace {

// Three points of a line. The middle one, lifted, is above the edge between the others for weight −2,
// on it for −1, and below it for 1.
ExactMesh line(const Rational& weight, const std::vector<Simplex>& edges) {
  return {PointSet({{0}, {1}, {2}}, {0, weight, 0}), edges};
}

const std::vector<Simplex> kTwoEdges = {{0, 1}, {1, 2}};
const std::vector<Simplex> kOneEdge = {{0, 2}};

std::set<Rule> broken_weighted(const ExactMesh& mesh, By by) {
  std::set<Rule> rules;
  const Verdict verdict = weighted_delaunay(mesh, {.by = by});
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
    CHECK(weighted_delaunay(line(-1, edges)).unique == false);
  }
  CHECK(weighted_delaunay(line(-1, kOneEdge)).canonical == true);
  CHECK(weighted_delaunay(line(-1, kTwoEdges)).canonical == false);
}

TEST_CASE("weighted: a vertex above the witness plane of the simplex around it is submerged") {
  const ExactMesh mesh = line(-2, kTwoEdges);
  CHECK(broken_weighted(mesh, By::kLemma) == std::set{Rule::kVertexSubmerged});
  const Verdict verdict = weighted_delaunay(mesh);
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
  const Verdict verdict = weighted_delaunay(mesh);
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
  CHECK(triangulation(wrong).holds());
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
  const Verdict verdict = weighted_delaunay(below);
  REQUIRE(verdict.violations().size() == 1);
  CHECK(verdict.violations()[0].witness.simplices == std::vector<Simplex>{{0, 1, 2}});
  CHECK(verdict.violations()[0].witness.vertices == std::vector<Vertex>{8});
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
  const Verdict verdict = weighted_delaunay(mesh);
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
