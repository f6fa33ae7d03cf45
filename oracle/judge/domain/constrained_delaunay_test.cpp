// Constrained and conforming Delaunay meshes of domains, in space and in the plane.
#include <doctest/doctest.h>

#include "inputs/named_complexes.hpp"
#include "oracle/judge/domain/domain_cases_test.hpp"
#include "oracle/judge/domain/empty_circumball.hpp"
#include "oracle/judge/domain/judge_exactly.hpp"
#include "oracle/judge/domain/vertex_index.hpp"

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

TEST_CASE("cdt.dangling-not-delaunay: beside tetrahedra") {
  PiecewiseLinearInput input = generators::box(0, 2);
  input.points.push_back({3, 0, 0});
  input.points.push_back({6, 2, 0});
  input.polygons.push_back({{{1, 8, 9, 3}}, {}});
  ExactMesh mesh{PointSet(input.points), kCubeInFive};
  mesh.faces = {{1, 8, 9}, {1, 3, 9}};
  for (const By by : {By::kLemma, By::kDefinition}) {
    CHECK(broken(Claim::kCdt, mesh, domain_of(input), by) == std::set{Rule::kDanglingNotDelaunay});
  }
  mesh.faces = {{1, 3, 8}, {3, 8, 9}};
  check_holds(Claim::kCdt, mesh, domain_of(input));
}

TEST_CASE("an orientation that is not that of others does not hide what is not Delaunay") {
  const PiecewiseLinearInput input = generators::encircled_segment();
  const ExactMesh mesh{PointSet(input.points), {{0, 1, 3, 4}, {1, 2, 3, 4}, {0, 2, 3, 4}}};
  const Verdict verdict = judge_domain(Claim::kCdt, mesh, domain_of(input), {.oriented = true});
  CHECK(verdict.tallies().contains(Rule::kOrientation));
  CHECK(verdict.tallies().contains(Rule::kConstrainedFacetNotLocal));
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
  for (const auto& [in_space, turned] :
       std::vector<std::pair<bool, int>>{{false, 0}, {false, 1}, {true, 0}, {true, 1}, {true, 2}}) {
    PiecewiseLinearInput input = crowded_segment(in_space);
    for (Point& point : input.points) std::rotate(point.begin(), point.end() - turned, point.end());
    ExactMesh mesh{PointSet(input.points), {}};
    mesh.faces = {{0, 1}};
    for (const By by : {By::kLemma, By::kDefinition}) {
      const Domain domain = domain_of(input);
      CHECK(broken(Claim::kCdt, mesh, domain, by).empty());
      const Verdict verdict = judge_exactly(Claim::kConformingDelaunay, mesh, &domain, {.by = by});
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

TEST_CASE(
    "conforming Delaunay: all vertices of a closed ball are looked at, and no others of its box") {
  const std::vector<Point> places = {{0, 0, 0},
                                     {Rational(1, 3), Rational(-1, 7), Rational(2, 11)},
                                     {0x1p52, -0x1p51, 0x1p50},
                                     {Rational(1, 3) + 0x1p40, 7, Rational(5, 9) - 0x1p45}};
  for (const Point& centre : places) {
    std::vector<Point> on_sphere, beyond;
    for (int x = -3; x <= 3; ++x) {
      for (int y = -3; y <= 3; ++y) {
        for (int z = -3; z <= 3; ++z) {
          const int square = x * x + y * y + z * z;
          if (square == 9) on_sphere.push_back(centre + Point{x, y, z});
          if (square > 12 && square <= 17) beyond.push_back(centre + Point{x, y, z});
        }
      }
    }
    std::vector<Point> all = on_sphere;
    all.insert(all.end(), beyond.begin(), beyond.end());
    const VertexIndex index((PointSet(all)));
    const std::vector<Vertex> near = index.near({centre, 9});
    REQUIRE(near.size() == on_sphere.size());
    CHECK(static_cast<std::size_t>(near.back()) + 1 == on_sphere.size());
  }
  // A radius whose square is not a double: what is beyond is so by less than a double can say.
  const Rational radius(1, 3);
  const VertexIndex two(PointSet({{radius, 0, 0}, {0, -radius, 0}}));
  CHECK(two.near({{0, 0, 0}, radius * radius}).size() == 2);
  // Around a double, points between two doubles, exactly on the sphere.
  const Point centre = {0x1p40, -0x1p39, 0x1p38};
  for (int k = 1; k <= 100; ++k) {
    const Rational part(k, 49);
    const std::vector<Point> around = {centre + Point{2 * part, 3 * part, 6 * part},
                                       centre + Point{-6 * part, 2 * part, -3 * part},
                                       centre + Point{3 * part, -6 * part, 2 * part}};
    CHECK(VertexIndex(PointSet(around)).near({centre, 49 * part * part}).size() == 3);
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

// Domains in the plane: segments are the walls.

PiecewiseLinearInput square(int low, int high) { return cuboid({low, low}, {high, high}); }

TEST_CASE("a square, with Steiner points and without") {
  const Domain domain = domain_of(square(0, 2));
  check_holds(Claim::kCdt, {PointSet(square(0, 2).points), {{0, 1, 2}, {0, 2, 3}}}, domain);
  const ExactMesh fine = grid({0, 1, 2}, {0, 1, 2}, {0}, every_cell);
  check_holds(Claim::kSteinerCdt, fine, domain);
  check_holds(Claim::kConformingDelaunay, fine, domain);
  CHECK(rules(fine, domain, Claim::kCdt) == std::set{Rule::kSteinerForbidden});
  const Verdict verdict = judge_domain(Claim::kSteinerCdt, fine, domain);
  CHECK(verdict.steiner_points->on_segments == 4);
  CHECK(verdict.steiner_points->in_polygons == 0);
  CHECK(verdict.steiner_points->in_polyhedra == 1);
  CHECK(verdict.unique == false);
  // Which they are, up to the limit on witnesses.
  REQUIRE(verdict.extra_vertices.has_value());
  CHECK(verdict.extra_vertices->count == 5);
  CHECK(verdict.extra_vertices->first.size() == 5);
  const Verdict limited = judge_domain(Claim::kCdt, fine, domain, {.max_violations = 2});
  CHECK(limited.extra_vertices->count == 5);
  CHECK(limited.extra_vertices->first ==
        std::vector<Vertex>(verdict.extra_vertices->first.begin(),
                            verdict.extra_vertices->first.begin() + 2));
}

TEST_CASE("a hole is left empty, and nothing else is") {
  const auto around = [](std::size_t i, std::size_t j, std::size_t) { return i != 1 || j != 1; };
  const ExactMesh hollow = grid({0, 1, 3, 4}, {0, 1, 3, 4}, {0}, around);
  const ExactMesh full = grid({0, 1, 3, 4}, {0, 1, 3, 4}, {0}, every_cell);
  PiecewiseLinearInput input = generators::both(square(0, 4), square(1, 3));
  check_holds(Claim::kSteinerCdt, full, domain_of(input));
  CHECK(rules(hollow, domain_of(input)) == std::set{Rule::kUncovered});
  input.hole_seeds = {{2, 2}};
  check_holds(Claim::kSteinerCdt, hollow, domain_of(input));
  CHECK(rules(full, domain_of(input)) == std::set{Rule::kOutside});
}

TEST_CASE("domain.vertex-in-edge: the two sides of an inner segment split it differently") {
  PiecewiseLinearInput input;
  input.points = {{0, 0}, {2, 0}, {4, 0}, {4, 2}, {2, 2}, {0, 2}};
  input.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {0, 5}, {1, 4}};
  std::vector<Point> points = input.points;
  points.push_back({2, 1});
  const ExactMesh junction{PointSet(points),
                           {{0, 1, 6}, {0, 6, 5}, {5, 6, 4}, {1, 2, 4}, {2, 3, 4}}};
  CHECK(rules(junction, domain_of(input)) == std::set{Rule::kVertexInEdge});
  const ExactMesh split{PointSet(points),
                        {{0, 1, 6}, {0, 6, 5}, {5, 6, 4}, {1, 2, 6}, {2, 4, 6}, {2, 3, 4}}};
  check_holds(Claim::kSteinerTriangulation, split, domain_of(input));
}

TEST_CASE("domain.segment-missing, domain.vertex-missing") {
  PiecewiseLinearInput input = square(0, 2);
  input.segments.push_back({1, 3});
  const ExactMesh other{PointSet(input.points), {{0, 1, 2}, {0, 2, 3}}};
  CHECK(rules(other, domain_of(input)) == std::set{Rule::kSegmentMissing});
  PiecewiseLinearInput with_centre = square(0, 4);
  with_centre.points.push_back({2, 1});
  const ExactMesh over{PointSet(with_centre.points), {{0, 1, 2}, {0, 2, 3}}};
  CHECK(rules(over, domain_of(with_centre)) == std::set{Rule::kDomainVertexMissing});
}

TEST_CASE("dangling edges and lone vertices") {
  PiecewiseLinearInput input = square(0, 2);
  input.points.insert(input.points.end(), {{5, 0}, {7, 7}});
  input.segments.push_back({1, 4});
  ExactMesh mesh{PointSet(input.points), {{0, 1, 2}, {0, 2, 3}}};
  CHECK(rules(mesh, domain_of(input)) == std::set{Rule::kSegmentMissing});
  mesh.faces = {{4, 1}, {0, 2}};
  check_holds(Claim::kCdt, mesh, domain_of(input));
  mesh.faces.push_back({4, 5});
  CHECK(rules(mesh, domain_of(input)) == std::set{Rule::kOutside});
}

TEST_CASE("domain.uncovered where the boundary is listed but not filled") {
  ExactMesh mesh{PointSet(square(0, 2).points), {{0, 1, 2}}};
  mesh.faces = {{2, 3}, {0, 3}};
  CHECK(rules(mesh, domain_of(square(0, 2))) == std::set{Rule::kUncovered});
}

TEST_CASE("complex.overlap: a vertex hangs in an edge of the triangle beyond") {
  // Below the diagonal one triangle, above it the diagonal is divided.
  std::vector<Point> points = square(0, 4).points;
  points.push_back({2, 2});
  const Domain domain = domain_of(square(0, 4));
  const ExactMesh hanging{PointSet(points), {{0, 1, 2}, {0, 4, 3}, {2, 3, 4}}};
  CHECK(rules(hanging, domain) == std::set{Rule::kOverlap});
  CHECK(broken(Claim::kSteinerTriangulation, hanging, domain, By::kDefinition) ==
        std::set{Rule::kOverlap});
  const Verdict verdict = judge_domain(Claim::kSteinerTriangulation, hanging, domain);
  REQUIRE(verdict.violations().size() == 1);
  const Witness& witness = verdict.violations()[0].witness;
  CHECK(witness.face == Simplex{0, 2});
  CHECK(witness.vertices == std::vector<Vertex>{4});
  CHECK(witness.simplices == std::vector<Simplex>{{0, 1, 2}, {0, 4, 3}});
  CHECK(witness.point == Point{2, 2});
  // What is not filled is told as well: half of the edge, the other half missing beyond it.
  ExactMesh open{PointSet(points), {{0, 1, 2}, {0, 4, 3}}};
  open.faces = {{2, 3}};
  CHECK(rules(open, domain) == std::set{Rule::kOverlap, Rule::kUncovered});
  const Verdict bare = judge_domain(Claim::kSteinerTriangulation, open, domain);
  CHECK(bare.tallies().at(Rule::kOverlap).count == 1);
  CHECK(bare.tallies().at(Rule::kUncovered).count == 3);  // 2 3, 3 4 and half of 0 2
  // A triangle on the same side of the edge fills nothing beyond it.
  points.push_back({3, 1});
  ExactMesh folded{PointSet(points), {{0, 1, 2}, {0, 4, 5}}};
  folded.faces = {{2, 3}, {0, 3}};
  const Verdict same_side = judge_domain(Claim::kSteinerTriangulation, folded, domain);
  CHECK(same_side.tallies().at(Rule::kOverlap).count == 1);
  CHECK(same_side.tallies().at(Rule::kUncovered).count == 6);  // 2 3, 0 3, 0 2, 0 4, 4 5, 0 5
}

TEST_CASE("the vertex nearest to what is missing, exactly") {
  const Rational tiny = Rational(1) / 1024;
  std::vector<Point> points = square(0, 2).points;
  points[2] = {2, 2 + tiny};
  const ExactMesh off{PointSet(points), {{0, 1, 2}, {0, 2, 3}}};
  const auto first = [](const ExactMesh& mesh, const Domain& domain, By by) {
    return judge_exactly(Claim::kSteinerTriangulation, mesh, &domain, {.by = by})
        .violations()
        .at(0);
  };
  for (const By by : {By::kLemma, By::kDefinition}) {
    const Violation violation = first(off, domain_of(square(0, 2)), by);
    CHECK(violation.rule == Rule::kDomainVertexMissing);
    REQUIRE(violation.witness.nearest.has_value());
    CHECK(violation.witness.nearest->vertex == 2);
    CHECK(violation.witness.nearest->squared_distance == tiny * tiny);
  }
  // A vertex that was to halve the diagonal and was rounded off it.
  PiecewiseLinearInput input = square(0, 2);
  input.segments.push_back({0, 2});
  std::vector<Point> rounded = square(0, 2).points;
  rounded.push_back({1 + tiny, 1});
  const ExactMesh fan{PointSet(rounded), {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {0, 3, 4}}};
  for (const By by : {By::kLemma, By::kDefinition}) {
    const Violation violation = first(fan, domain_of(input), by);
    CHECK(violation.rule == Rule::kSegmentMissing);
    REQUIRE(violation.witness.nearest.has_value());
    CHECK(violation.witness.nearest->vertex == 4);
    CHECK(violation.witness.nearest->squared_distance == tiny * tiny / 2);
  }
}

TEST_CASE("a fan that winds twice around a point is not a triangulation of its outline") {
  // The doubly wound ring of docs/theory/points.md; its hull is the domain.
  const std::vector<Point> points = {{0, 0},        {14280, 6877}, {-7858, 9854}, {-4612, -5783},
                                     {3739, -1801}, {1181, 5176},  {-10000, 0},   {3269, -14323}};
  std::vector<Simplex> fan;
  for (Vertex i = 2; i < 9; ++i) fan.push_back({0, 1 + i % 7, 1 + (i + 1) % 7});
  PiecewiseLinearInput input;
  input.points = points;
  input.kind = DomainKind::kHull;
  CHECK(rules({PointSet(points), fan}, domain_of(input)) == std::set{Rule::kCoveredTwice});
}

TEST_CASE("cdt.facet-not-local in the plane, and an edge that is exempt") {
  PiecewiseLinearInput kite;
  kite.points = {{0, 0}, {3, 1}, {6, 0}, {3, -1}};
  kite.segments = {{0, 1}, {1, 2}, {2, 3}, {0, 3}};
  const ExactMesh lengthwise{PointSet(kite.points), {{0, 1, 2}, {0, 2, 3}}};
  CHECK(broken(Claim::kCdt, lengthwise, domain_of(kite)) ==
        std::set{Rule::kConstrainedFacetNotLocal});
  CHECK(broken(Claim::kCdt, lengthwise, domain_of(kite), By::kDefinition) ==
        std::set{Rule::kVisibleVertexInBall});
  kite.segments.push_back({0, 2});
  check_holds(Claim::kCdt, lengthwise, domain_of(kite));
  CHECK(broken(Claim::kConformingDelaunay, lengthwise, domain_of(kite))
            .contains(Rule::kFacetNotLocal));
  const Verdict verdict = judge_domain(Claim::kCdt, lengthwise, domain_of(kite));
  CHECK(verdict.unique == true);
  CHECK(verdict.canonical == true);
}

}  // namespace

}  // namespace circumspect::check
