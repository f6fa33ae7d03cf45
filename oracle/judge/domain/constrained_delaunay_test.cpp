// Constrained Delaunay and conforming Delaunay in space.
#include <doctest/doctest.h>

#include "inputs/named_complexes.hpp"
#include "oracle/judge/domain/domain_cases_test.hpp"

namespace circumspect::check {
namespace {

std::set<Rule> by_definition(Claim claim, const ExactMesh& mesh, const Domain& domain) {
  return broken(claim, mesh, domain, By::kDefinition);
}

// A segment with vertices around it, near enough to be in all of its circumballs.
PiecewiseLinearInput crowded_segment(bool in_space) {
  PiecewiseLinearInput input;
  if (in_space) {
    input.points = {{0, 0, 0}, {10, 0, 0}, {5, 1, 0}, {5, -1, 1}, {5, -1, -1}};
  } else {
    input.points = {{0, 0}, {10, 0}, {5, 1}, {5, -1}};
  }
  input.segments = {{0, 1}};
  return input;
}

TEST_CASE("cdt.facet-not-local: three tetrahedra around a segment (Figure 4.15)") {
  const PiecewiseLinearInput input = generators::encircled_segment();
  const ExactMesh mesh{PointSet(input.points), {{0, 1, 3, 4}, {1, 2, 3, 4}, {0, 2, 3, 4}}};
  const Domain domain = domain_of(input);
  CHECK(broken(Claim::kPlcTriangulation, mesh, domain).empty());
  CHECK(broken(Claim::kCdt, mesh, domain) == std::set{Rule::kConstrainedFacetNotLocal});
  CHECK(by_definition(Claim::kCdt, mesh, domain) == std::set{Rule::kVisibleVertexInBall});
  const Verdict verdict = judge_domain(Claim::kCdt, mesh, domain);
  CHECK(verdict.tallies().begin()->second.count == 3);
  REQUIRE(verdict.violations()[0].witness.ball.has_value());
}

TEST_CASE("cdt.dangling-not-delaunay: the wrong diagonal of a kite in space") {
  PiecewiseLinearInput kite;
  kite.points = {{0, 0, 1}, {3, 1, 1}, {6, 0, 1}, {3, -1, 1}, {3, 0, 9}};
  kite.polygons = {{{{0, 1, 2, 3}}, {}}};
  ExactMesh mesh{PointSet(kite.points), {}};
  mesh.faces = {{0, 1, 2}, {0, 2, 3}};
  const Domain domain = domain_of(kite);
  CHECK(broken(Claim::kPlcTriangulation, mesh, domain).empty());
  CHECK(broken(Claim::kCdt, mesh, domain) == std::set{Rule::kDanglingNotDelaunay});
  CHECK(by_definition(Claim::kCdt, mesh, domain) == std::set{Rule::kDanglingNotDelaunay});
  // A slit along the diagonal hides either vertex from the other side.
  PiecewiseLinearInput slit = kite;
  slit.segments = {{0, 2}};
  CHECK(broken(Claim::kCdt, mesh, domain_of(slit)).empty());
  CHECK(by_definition(Claim::kCdt, mesh, domain_of(slit)).empty());
  mesh.faces = {{0, 1, 3}, {1, 2, 3}};
  CHECK(broken(Claim::kCdt, mesh, domain).empty());
  CHECK(by_definition(Claim::kCdt, mesh, domain).empty());
  CHECK(judge_domain(Claim::kCdt, mesh, domain).unique == true);
  CHECK(broken(Claim::kConformingDelaunay, mesh, domain).empty());
}

TEST_CASE("of a cube's triangulations all are constrained Delaunay, few canonical") {
  const PiecewiseLinearInput input = generators::box(0, 2);
  std::size_t canonical = 0;
  for (const auto& simplices : {kCubeInFive, kCubeInSix}) {
    const Verdict verdict =
        judge_domain(Claim::kCdt, {PointSet(input.points), simplices}, domain_of(input));
    CHECK(verdict.holds());
    CHECK(!verdict.unique.has_value());
    REQUIRE(verdict.canonical.has_value());
    canonical += *verdict.canonical ? 1 : 0;
  }
  CHECK(canonical <= 1);
}

TEST_CASE("a polygon hides a vertex: a CDT that is not Delaunay, in both words for it") {
  // Two tetrahedra apart; a vertex of the second lies in the ball of the first.
  PiecewiseLinearInput input;
  input.points = {{0, 0, 0}, {4, 0, 0}, {2, 3, 0}, {2, 1, 10},
                  {5, 1, 5}, {7, 1, 5}, {6, 2, 5}, {6, 1, 7}};
  for (const Vertex base : {0, 4}) {
    for (Vertex skip = 0; skip < 4; ++skip) {
      std::vector<Vertex> line;
      for (Vertex v = 0; v < 4; ++v) {
        if (v != skip) line.push_back(base + v);
      }
      input.polygons.push_back({{line}, {}});
    }
  }
  const ExactMesh mesh{PointSet(input.points), {{0, 1, 2, 3}, {4, 5, 6, 7}}};
  const Domain domain = domain_of(input);
  for (const By by : {By::kLemma, By::kDefinition}) {
    CHECK(broken(Claim::kCdt, mesh, domain, by).empty());
    CHECK(broken(Claim::kConformingDelaunay, mesh, domain, by) == std::set{Rule::kVertexInBall});
  }
}

TEST_CASE("delaunay.no-empty-ball: a dangling edge, a dangling triangle") {
  for (const bool in_space : {false, true}) {
    const PiecewiseLinearInput input = crowded_segment(in_space);
    ExactMesh mesh{PointSet(input.points), {}};
    mesh.faces = {{0, 1}};
    for (const By by : {By::kLemma, By::kDefinition}) {
      CHECK(broken(Claim::kCdt, mesh, domain_of(input), by).empty());
      const Verdict verdict =
          judge_domain(Claim::kConformingDelaunay, mesh, domain_of(input), {.by = by});
      REQUIRE(verdict.violations().size() == 1);
      CHECK(verdict.violations()[0].rule == Rule::kNoEmptyBall);
      CHECK(verdict.violations()[0].witness.vertices.size() == (in_space ? 3u : 2u));
    }
    // Without one of them there is room for a ball.
    PiecewiseLinearInput fewer = input;
    fewer.points.pop_back();
    ExactMesh rest{PointSet(fewer.points), {}};
    rest.faces = {{0, 1}};
    CHECK(broken(Claim::kConformingDelaunay, rest, domain_of(fewer)).empty());
    CHECK(by_definition(Claim::kConformingDelaunay, rest, domain_of(fewer)).empty());
  }
  PiecewiseLinearInput triangle;
  triangle.points = {{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {3, 3, 1}, {3, 3, -1}};
  triangle.polygons = {{{{0, 1, 2}}, {}}};
  ExactMesh mesh{PointSet(triangle.points), {}};
  mesh.faces = {{0, 1, 2}};
  for (const By by : {By::kLemma, By::kDefinition}) {
    CHECK(broken(Claim::kConformingDelaunay, mesh, domain_of(triangle), by) ==
          std::set{Rule::kNoEmptyBall});
  }
}

TEST_CASE("conforming Delaunay: a grid is, and polygons are not exempt") {
  const ExactMesh mesh = grid({0, 1, 3}, {0, 2, 3}, {0, 3}, every_cell);
  const Domain domain = domain_of(generators::box(0, 3));
  CHECK(broken(Claim::kConformingDelaunay, mesh, domain).empty());
  CHECK(by_definition(Claim::kConformingDelaunay, mesh, domain).empty());
  PiecewiseLinearInput bipyramid;
  bipyramid.points = {{4, 0, 0}, {-2, 4, 0}, {-2, -4, 0}, {0, 0, 1}, {0, 0, -1}};
  for (Vertex i = 0; i < 3; ++i) {
    for (const Vertex apex : {3, 4}) bipyramid.polygons.push_back({{{i, (i + 1) % 3, apex}}, {}});
  }
  bipyramid.polygons.push_back({{{0, 1, 2}}, {}});
  const ExactMesh flat{PointSet(bipyramid.points), {{0, 1, 2, 3}, {0, 1, 2, 4}}};
  CHECK(broken(Claim::kCdt, flat, domain_of(bipyramid)).empty());
  CHECK(by_definition(Claim::kCdt, flat, domain_of(bipyramid)).empty());
  CHECK(broken(Claim::kConformingDelaunay, flat, domain_of(bipyramid))
            .contains(Rule::kFacetNotLocal));
  CHECK(by_definition(Claim::kConformingDelaunay, flat, domain_of(bipyramid)) ==
        std::set{Rule::kVertexInBall});
}

}  // namespace
}  // namespace circumspect::check
