// What is known of the simplices is taken at its word, and nothing else is: each list decides what
// it is about. That verdicts are the same with right lists: `verdict_by_lemma`, in every test of
// this folder.
#include <doctest/doctest.h>

#include "inputs/named_complexes.hpp"
#include "oracle/judge/domain/domain_cases_test.hpp"
#include "oracle/judge/domain/facets_of_interest.hpp"

namespace circumspect::check {
namespace {

// Two flat tetrahedra on both sides of the triangle 0 1 2, each with the apex of the other in its
// ball.
// The triangle is a wall of the domain or not.
Domain bipyramid(bool with_wall) {
  PiecewiseLinearInput input;
  input.points = {{4, 0, 0}, {-2, 4, 0}, {-2, -4, 0}, {0, 0, 1}, {0, 0, -1}};
  for (Vertex i = 0; i < 3; ++i) {
    for (const Vertex apex : {3, 4}) input.polygons.push_back({{{i, (i + 1) % 3, apex}}, {}});
  }
  if (with_wall) input.polygons.push_back({{{0, 1, 2}}, {}});
  return domain_of(input);
}
const ExactMesh& two_tetrahedra() {
  static const ExactMesh mesh{bipyramid(false).complex.points, {{0, 1, 2, 3}, {0, 1, 2, 4}}};
  return mesh;
}
constexpr fast::FacetId kBetween(0, 3);  // opposite the vertex 3 of the first

fast::SimplexFacts with(std::vector<fast::FacetId> not_local, std::vector<fast::FacetId> ties,
                        std::vector<fast::FacetId> not_canonical) {
  return {{{0, 0}, {0, 1}, {0, 2}, {1, 0}, {1, 1}, {1, 2}},
          std::move(not_local),
          std::move(ties),
          std::move(not_canonical)};
}

Verdict judged(Claim claim, bool with_wall, const fast::SimplexFacts& known) {
  return judge_domain(claim, two_tetrahedra(), bipyramid(with_wall), {}, &known);
}

TEST_CASE("facets of two simplices: what is known of them counts off the walls") {
  const std::optional<fast::SimplexFacts> right =
      exact_facts(Claim::kCdt, two_tetrahedra(), bipyramid(false));
  REQUIRE(right);
  CHECK(right->boundary == with({}, {}, {}).boundary);
  CHECK(right->not_local == std::vector{kBetween});
  CHECK(vertices_of(two_tetrahedra(), kBetween) == Simplex{0, 1, 2});

  for (const bool wall : {false, true}) {
    CHECK(judged(Claim::kCdt, wall, *right).holds() == wall);
    CHECK(!judged(Claim::kConformingDelaunay, wall, *right).holds());
    const Verdict none = judged(Claim::kCdt, wall, with({}, {}, {}));
    CHECK(none.holds());
    CHECK(none.unique == true);
    CHECK(none.canonical == true);
    const Verdict tie = judged(Claim::kCdt, wall, with({}, {kBetween}, {}));
    CHECK(tie.unique == (wall ? std::optional(true) : std::nullopt));
    CHECK(tie.canonical == true);
    const Verdict other = judged(Claim::kCdt, wall, with({}, {kBetween}, {kBetween}));
    CHECK(other.canonical == wall);
  }
  // Balls at the boundary are looked at whatever is known of facets.
  CHECK(judged(Claim::kConformingDelaunay, false, with({}, {}, {}))
            .tallies()
            .contains(Rule::kVertexInBall));
}

TEST_CASE("a facet that is not locally Delaunay is found where it has a vertex off the walls") {
  const Domain cube = domain_of(generators::box(0, 2));
  const ExactMesh even = grid({0, 1, 2}, {0, 1, 2}, {0, 1, 2}, every_cell);
  std::vector<Point> points = even.points.points();
  const Point aside = {Rational(5) / 4, Rational(5) / 4, Rational(9) / 8};
  std::replace(points.begin(), points.end(), Point{1, 1, 1}, aside);
  const ExactMesh mesh{PointSet(points), even.simplices};
  CHECK(verdict_by_lemma(Claim::kSteinerTriangulation, mesh, cube).holds());
  CHECK(broken(Claim::kSteinerCdt, mesh, cube) == std::set{Rule::kConstrainedFacetNotLocal});
  CHECK(broken(Claim::kConformingDelaunay, mesh, cube).contains(Rule::kFacetNotLocal));
}

TEST_CASE("a tie in the plane can be flipped") {
  const Domain square = domain_of(cuboid({0, 0}, {2, 2}));
  const ExactMesh mesh{square.complex.points, {{0, 1, 2}, {0, 2, 3}}};
  const std::optional<fast::SimplexFacts> known = exact_facts(Claim::kCdt, mesh, square);
  REQUIRE(known);
  CHECK(known->ties == std::vector<fast::FacetId>{{0, 1}});
  CHECK(judge_domain(Claim::kCdt, mesh, square, {}, &*known).unique == false);
}

TEST_CASE("a facet of one simplex off the walls is found by the list") {
  const Domain cube = domain_of(generators::box(0, 2));
  const ExactMesh mesh = eight_cubes_with_a_gap();
  fast::SimplexFacts known = *exact_facts(Claim::kSteinerTriangulation, mesh, cube);
  const auto uncovered = [&] {
    const Verdict verdict = judge_domain(Claim::kSteinerTriangulation, mesh, cube, {}, &known);
    return verdict.tallies().at(Rule::kUncovered).count;
  };
  CHECK(uncovered() == 4);
  std::erase_if(known.boundary, [&](fast::FacetId facet) {
    const Simplex vertices = vertices_of(mesh, facet);
    return std::any_of(vertices.begin(), vertices.end(), [&](Vertex v) {
      return mesh.points[v] == Point{1, 1, 1};
    });
  });
  CHECK(uncovered() == 1);
}

TEST_CASE("whether simplices fill a convex hull is asked if it is not known") {
  PiecewiseLinearInput input;
  input.points = generators::box(0, 2).points;
  input.kind = DomainKind::kHull;
  const Domain hull = domain_of(input);
  ExactMesh mesh{hull.complex.points, kCubeInFive};
  CHECK(exact_facts(Claim::kCdt, mesh, hull)->fills_hull);
  CHECK(verdict_by_lemma(Claim::kCdt, mesh, hull).holds());
  mesh.simplices.pop_back();
  fast::SimplexFacts known = *exact_facts(Claim::kCdt, mesh, hull);
  CHECK(!known.fills_hull);
  CHECK(!judge_domain(Claim::kPlcTriangulation, mesh, hull, {}, &known).holds());
  known.fills_hull = true;
  CHECK(!judge_domain(Claim::kPlcTriangulation, mesh, hull, {}, &known)
             .tallies()
             .contains(Rule::kHullNotConvex));
}

TEST_CASE("listed faces are judged, wherever they are") {
  const Domain cube = domain_of(generators::box(0, 2));
  ExactMesh mesh = grid({0, 1, 2}, {0, 1, 2}, {0, 1, 2}, every_cell);
  for (std::size_t place = 0; place < 4; ++place) {
    mesh.faces.push_back(facet_opposite(mesh.simplices.front(), place));
  }
  CHECK(verdict_by_lemma(Claim::kSteinerCdt, mesh, cube).holds());
  mesh.faces.push_back({0, 1, static_cast<Vertex>(mesh.points.size())});
  CHECK(verdict_by_lemma(Claim::kSteinerCdt, mesh, cube).tallies().contains(Rule::kUnknownVertex));
}

}  // namespace
}  // namespace circumspect::check
