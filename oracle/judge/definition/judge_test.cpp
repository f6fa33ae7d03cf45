// The claims about points by definition: each rule broken alone, by the smallest mesh.
#include "oracle/judge/definition/judge.hpp"

#include <map>
#include <set>

#include <doctest/doctest.h>

#include "oracle/judge/definition/delaunay.hpp"
#include "oracle/judge/definition/simplicial_complex.hpp"

namespace circumspect::definition {
namespace {

using Broken = std::map<Rule, std::size_t>;

Broken broken(const Verdict& verdict) {
  Broken rules;
  for (const auto& [rule, tally] : verdict.tallies()) rules[rule] = tally.count;
  return rules;
}
Broken broken(Claim claim, const ExactMesh& mesh) { return broken(judge(claim, mesh, 0)); }

const PointSet kSquare({{0, 0}, {1, 0}, {1, 1}, {0, 1}});

TEST_CASE("each simplex by itself") {
  const Claim claim = Claim::kTriangulation;
  const PointSet points({{0, 0}, {1, 0}, {2, 0}, {1, 1}});
  const std::vector<Simplex> good = {{0, 1, 3}, {1, 2, 3}};
  CHECK(broken(claim, {points, good}).empty());
  const auto with = [&](const Simplex& another) {
    std::vector<Simplex> simplices = good;
    simplices.push_back(another);
    return broken(claim, {points, simplices});
  };
  CHECK(with({0, 1, 4}) == Broken{{Rule::kUnknownVertex, 1}});
  CHECK(with({0, 1, -1}) == Broken{{Rule::kUnknownVertex, 1}});
  CHECK(with({0, 3}) == Broken{{Rule::kWrongDimension, 1}});
  CHECK(with({0, 1, 2, 3}) == Broken{{Rule::kWrongDimension, 1}});
  CHECK(with({}) == Broken{{Rule::kWrongDimension, 1}});
  CHECK(with({0, 1, 1}) == Broken{{Rule::kRepeatedVertex, 1}});
  CHECK(with({0, 1, 2}) == Broken{{Rule::kDegenerateSimplex, 1}});
  CHECK(with({3, 1, 0}) == Broken{{Rule::kDuplicateSimplex, 1}});
  const auto said_of = [&](const Simplex& another) {
    std::vector<Simplex> simplices = good;
    simplices.push_back(another);
    const Verdict verdict = judge(claim, {points, simplices}, 0);
    REQUIRE(verdict.violations().size() == 1);
    const Witness& witness = verdict.violations()[0].witness;
    CHECK(witness.places == std::vector<std::size_t>{2});
    CHECK(witness.simplices == std::vector<Simplex>{another});
    std::string said;
    for (const NamedValue& value : witness.values)
      said += value.name + " " + value.value.get_str() + ";";
    return said;
  };
  CHECK(said_of({0, 3}) == "vertices 2;vertices expected 3;");
  CHECK(said_of({0, 1, 2}) == "orientation determinant 0;");
  CHECK(said_of({0, 1, 1}) == "");
  CHECK(said_of({0, 1, 4}) == "");
  const Verdict twice = judge(claim, {points, {{0, 1, 3}, {1, 2, 3}, {3, 0, 1}, {0, 3, 1}}}, 0);
  REQUIRE(twice.violations().size() == 2);
  CHECK(twice.violations()[0].witness.places == std::vector<std::size_t>{0, 2});
  CHECK(twice.violations()[1].witness.places == std::vector<std::size_t>{2, 3});
  // Nothing is a simplex of the empty set.
  CHECK(broken(claim, {PointSet({}), {{}}}) == Broken{{Rule::kWrongDimension, 1}});
  CHECK(broken(claim, {PointSet({}), {}}).empty());
}

TEST_CASE("faces of given sizes, each once") {
  using List = std::vector<Simplex>;
  CHECK(faces_of({{2, 0, 1}, {1, 2, 3}}, 2) == List{{0, 1}, {0, 2}, {1, 2}, {1, 3}, {2, 3}});
  CHECK(faces_of({{2, 0, 1}, {3}}, 3) == List{{0, 1, 2}});
  CHECK(faces_of({{2, 0}}, 1) == List{{0}, {2}});
}

TEST_CASE("a complex, whose vertices are the points, and whose union is their hull") {
  const Claim claim = Claim::kTriangulation;
  CHECK(broken(claim, {kSquare, {{0, 1, 2}, {0, 2, 3}}}).empty());
  CHECK(broken(claim, {kSquare, {{0, 1, 2}, {1, 2, 3}}}) == Broken{{Rule::kOverlap, 1}});
  CHECK(broken(claim, {kSquare, {{0, 1, 2}}}) ==
        Broken{{Rule::kUnusedPoint, 1}, {Rule::kHullNotConvex, 1}});
  const PointSet notched({{0, 0}, {4, 0}, {1, 1}, {0, 4}});
  const Verdict open = judge(claim, {notched, {{0, 1, 2}, {0, 2, 3}}}, 0);
  CHECK(broken(open) == Broken{{Rule::kHullNotConvex, 2}});
  CHECK(open.violations()[0].witness.face == Simplex{1, 2});
  CHECK(open.violations()[0].witness.vertices == Simplex{3});
  CHECK(open.violations()[0].witness.values[0].value *
            open.violations()[0].witness.values[1].value <
        0);
  // A vertex in an edge of another, and two that touch from outside.
  const PointSet hanging({{0, 0}, {2, 0}, {1, 1}, {1, 0}, {1, -1}});
  CHECK(broken(claim, {hanging, {{0, 1, 2}, {0, 3, 4}, {1, 3, 4}}}) == Broken{{Rule::kOverlap, 2}});
  // In one dimension less than the space around, and in one dimension.
  const PointSet line({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}});
  CHECK(broken(claim, {line, {{0, 1}, {1, 2}}}).empty());
  CHECK(broken(claim, {line, {{0, 2}}}) == Broken{{Rule::kUnusedPoint, 1}});
  CHECK(broken(claim, {line, {{0, 1}}}) ==
        Broken{{Rule::kUnusedPoint, 1}, {Rule::kHullNotConvex, 1}});
  CHECK(broken(claim, {PointSet({{5, 5}}), {{0}}}).empty());
}

TEST_CASE("empty balls, and what is on their spheres") {
  const Claim claim = Claim::kDelaunay;
  const auto kite = [](const Rational& height) {
    return ExactMesh{PointSet({{0, 0}, {1, 0}, {1, height}, {0, 1}}), {{0, 1, 3}, {1, 2, 3}}};
  };
  const Rational hair(1, 1'000'000'000);
  CHECK(broken(claim, kite(1 + hair)).empty());
  CHECK(broken(claim, kite(1 - hair)) == Broken{{Rule::kVertexInBall, 2}});
  const Verdict tie = judge(claim, kite(1), 0);
  CHECK(tie.holds());
  CHECK(tie.unique == false);
  CHECK(tie.canonical == false);
  const Verdict canonical = judge(claim, {kSquare, {{0, 1, 2}, {0, 2, 3}}}, 0);
  CHECK(canonical.unique == false);
  CHECK(canonical.canonical == true);
  CHECK(judge(claim, kite(2), 0).unique == true);
  CHECK(judge(Claim::kTriangulation, kite(2), 0).unique == std::nullopt);
  const Verdict in = judge(claim, kite(Rational(1, 2)), 0);
  const Witness& witness = in.violations().front().witness;
  CHECK(witness.simplices == std::vector<Simplex>{{0, 1, 3}});
  CHECK(witness.vertices == Simplex{2});
  CHECK(witness.ball->squared_radius == Rational(1, 2));
  CHECK(witness.values.back().value == Rational(1, 4));
  CHECK(in.tallies().at(Rule::kVertexInBall).worst_margin > Rational(1, 2));
  // The two stages are judged even if the hull is not convex; not if simplices overlap.
  CHECK(broken(claim, {PointSet({{0, 0}, {1, 0}, {2, 2}, {0, 1}, {-4, 9}}), {{0, 1, 3}, {1, 2, 3}}})
            .count(Rule::kHullNotConvex) == 1);
}

TEST_CASE("with weights a point need not be a vertex") {
  const auto weighted = [](const Rational& weight) {
    return PointSet({{0, 0}, {3, 0}, {0, 3}, {1, 1}}, {0, 0, 0, weight});
  };
  const Claim claim = Claim::kWeightedDelaunay;
  const std::vector<Simplex> without = {{0, 1, 2}};
  const std::vector<Simplex> with = {{0, 1, 3}, {1, 2, 3}, {0, 2, 3}};
  CHECK(broken(claim, {weighted(-5), without}).empty());
  CHECK(broken(claim, {weighted(0), without}) == Broken{{Rule::kPointBelowPlane, 1}});
  CHECK(broken(claim, {weighted(0), with}).empty());
  CHECK(broken(claim, {weighted(-5), with}) == Broken{{Rule::kPointBelowPlane, 3}});
  CHECK(broken(claim, {weighted(0), {}}) == Broken{{Rule::kUnusedPoint, 4}});
  // An orthoball without a real radius has no margin.
  const PointSet heavy({{0, 0}, {1, 0}, {0, 1}, {1, 1}}, {4, 4, 4, 9});
  const Verdict deep = judge(claim, {heavy, {{0, 1, 2}}}, 0);
  CHECK(broken(deep) == Broken{{Rule::kPointBelowPlane, 1}, {Rule::kHullNotConvex, 1}});
  CHECK(!deep.tallies().at(Rule::kPointBelowPlane).worst_margin);
}

TEST_CASE("a simplex of lower dimension has an empty ball or has none") {
  const auto against = [](const std::vector<Point>& points, const Simplex& simplex) {
    Verdict verdict(Claim::kConformingDelaunay, 0);
    judge_some_ball_is_empty(PointSet(points), {simplex}, verdict);
    return verdict.holds() ? Simplex{} : verdict.violations().front().witness.vertices;
  };
  // An edge with a point on each side of it, near or far.
  CHECK(against({{0, 0}, {2, 0}, {1, 2}, {1, -2}}, {0, 1}).empty());
  CHECK(against({{0, 0}, {2, 0}, {1, 1}, {1, -1}}, {0, 1}).empty());
  const Rational near(9, 10);
  CHECK(against({{0, 0}, {2, 0}, {1, near}, {1, -near}, {7, 7}}, {0, 1}) == Simplex{2, 3});
  CHECK(against({{0, 0}, {2, 0}, {1, near}, {5, 9}}, {0, 1}).empty());
  CHECK(against({{0, 0, 0}, {2, 0, 0}, {1, near, 0}, {1, -near, 0}, {1, 0, 9}}, {0, 1}) ==
        Simplex{2, 3});
  CHECK(against({{0, 0, 0}, {2, 0, 0}, {1, near, 0}, {1, 0, 9}}, {0, 1}).empty());
  CHECK(against({{0, 0, 0}, {2, 0, 0}, {1, 2, 0}, {1, 1, near}, {1, 1, -near}}, {0, 1, 2}) ==
        Simplex{3, 4});
}

}  // namespace
}  // namespace circumspect::definition
