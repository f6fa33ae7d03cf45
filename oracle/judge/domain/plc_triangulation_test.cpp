// Triangulations of domains in space: each rule broken alone, by the smallest mesh at hand.
#include <doctest/doctest.h>

#include "inputs/named_complexes.hpp"
#include "kernel/complex/improper_intersection.hpp"
#include "kernel/complex/point_set.hpp"
#include "oracle/judge/domain/domain_cases_test.hpp"
#include "oracle/judge/domain/judge_exactly.hpp"

namespace circumspect::check {
namespace {

using generators::both;
using generators::box;

Domain cube() { return domain_of(box(0, 2)); }
ExactMesh cube_mesh(const std::vector<Simplex>& simplices) {
  return {PointSet(box(0, 2).points), simplices};
}

// A prism of two cubes on each other, with the square between them.
PiecewiseLinearInput two_storeys() {
  PiecewiseLinearInput input;
  for (const int z : {0, 1, 2}) {
    for (const int y : {0, 1}) {
      for (const int x : {0, 1}) input.points.push_back({x, y, z});
    }
  }
  for (const Vertex z : {0, 4, 8}) input.polygons.push_back({{{z, z + 1, z + 3, z + 2}}, {}});
  for (const auto& [a, b] :
       std::vector<std::pair<Vertex, Vertex>>{{0, 1}, {0, 2}, {1, 3}, {2, 3}}) {
    input.polygons.push_back({{{a, b, b + 4, b + 8, a + 8, a + 4}}, {}});
  }
  return input;
}

std::vector<Simplex> raised(std::vector<Simplex> simplices) {
  for (Simplex& simplex : simplices) {
    for (Vertex& v : simplex) v += 4;
  }
  return simplices;
}

// A cube with a square standing out from its edge 1 3.
PiecewiseLinearInput cube_with_flag() {
  PiecewiseLinearInput input = box(0, 2);
  input.points.push_back({4, 0, 0});
  input.points.push_back({4, 2, 0});
  input.polygons.push_back({{{1, 8, 9, 3}}, {}});
  return input;
}
ExactMesh flag_mesh(const std::vector<Simplex>& faces) {
  ExactMesh mesh{PointSet(cube_with_flag().points), kCubeInFive};
  mesh.faces = faces;
  return mesh;
}

TEST_CASE("a cube in five and in six tetrahedra, however numbered") {
  check_holds(Claim::kPlcTriangulation, cube_mesh(kCubeInFive), cube());
  check_holds(Claim::kPlcTriangulation, cube_mesh(kCubeInSix), cube());
  std::vector<Point> points = box(0, 2).points;
  std::reverse(points.begin(), points.end());
  std::vector<Simplex> simplices = kCubeInFive;
  for (Simplex& simplex : simplices) {
    for (Vertex& v : simplex) v = 7 - v;
  }
  check_holds(Claim::kPlcTriangulation, {PointSet(points), simplices}, cube());
}

TEST_CASE("Steiner points are counted by the cell that they lie in, and forbidden by two claims") {
  const ExactMesh mesh = grid({0, 1, 2}, {0, 1, 2}, {0, 1, 2}, every_cell);
  check_holds(Claim::kSteinerTriangulation, mesh, cube());
  const Verdict verdict = judge_domain(Claim::kSteinerTriangulation, mesh, cube());
  REQUIRE(verdict.steiner_points.has_value());
  CHECK(verdict.steiner_points->on_segments == 12);
  CHECK(verdict.steiner_points->in_polygons == 6);
  CHECK(verdict.steiner_points->in_polyhedra == 1);
  CHECK(rules(mesh, cube(), Claim::kPlcTriangulation) == std::set{Rule::kSteinerForbidden});
  CHECK(rules(mesh, cube(), Claim::kCdt) == std::set{Rule::kSteinerForbidden});
  CHECK(judge_domain(Claim::kCdt, mesh, cube()).tallies().at(Rule::kSteinerForbidden).count == 19);
}

TEST_CASE("a hole is left empty, and nothing else is") {
  const auto around = [](std::size_t i, std::size_t j, std::size_t k) {
    return i != 1 || j != 1 || k != 1;
  };
  const ExactMesh hollow = grid({0, 1, 3, 4}, {0, 1, 3, 4}, {0, 1, 3, 4}, around);
  const ExactMesh full = grid({0, 1, 3, 4}, {0, 1, 3, 4}, {0, 1, 3, 4}, every_cell);
  PiecewiseLinearInput input = both(box(0, 4), box(1, 3));
  CHECK(broken(Claim::kSteinerTriangulation, full, domain_of(input)).empty());
  CHECK(broken(Claim::kSteinerTriangulation, hollow, domain_of(input)) ==
        std::set{Rule::kUncovered});
  input.hole_seeds = {{2, 2, 2}};
  CHECK(broken(Claim::kSteinerTriangulation, hollow, domain_of(input)).empty());
  CHECK(broken(Claim::kSteinerTriangulation, full, domain_of(input)) == std::set{Rule::kOutside});
  // A cavity that the domain does not have: its boundary is off the walls.
  CHECK(broken(Claim::kSteinerTriangulation, hollow, domain_of(box(0, 4))) ==
        std::set{Rule::kUncovered});
  const Verdict verdict = judge_domain(Claim::kSteinerTriangulation, hollow, domain_of(box(0, 4)));
  CHECK(verdict.tallies().at(Rule::kUncovered).count == 12);
}

TEST_CASE("domain.vertex-missing: no point, or one that no simplex around it has") {
  ExactMesh fewer{PointSet({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}}), {{0, 1, 2, 3}}};
  CHECK(rules(fewer, cube()) == std::set{Rule::kDomainVertexMissing});
  PiecewiseLinearInput with_centre = box(0, 2);
  with_centre.points.push_back({1, 1, 1});
  const ExactMesh passing_over{PointSet(with_centre.points), kCubeInFive};
  CHECK(rules(passing_over, domain_of(with_centre)) == std::set{Rule::kDomainVertexMissing});
  PiecewiseLinearInput in_face = box(0, 2);
  in_face.points.push_back({1, Rational(1, 2), 0});
  const ExactMesh over_face{PointSet(in_face.points), kCubeInFive};
  CHECK(rules(over_face, domain_of(in_face)) == std::set{Rule::kDomainVertexMissing});
  const Verdict verdict = judge_domain(Claim::kPlcTriangulation, over_face, domain_of(in_face));
  REQUIRE(!verdict.holds());
  CHECK(verdict.violations()[0].witness.polygon == std::size_t{0});
}

TEST_CASE(
    "the first vertex of a domain or a mesh may be missing, or a Steiner point, as any other") {
  PiecewiseLinearInput square;
  square.points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  square.segments = {{0, 1}, {1, 2}, {2, 3}, {0, 3}};
  CHECK(rules({PointSet({{4, 0}, {4, 4}, {0, 4}}), {{0, 1, 2}}}, domain_of(square)) ==
        std::set{Rule::kDomainVertexMissing});
  PiecewiseLinearInput with_inner;
  with_inner.points = {{2, 1}, {0, 0}, {4, 0}, {4, 4}, {0, 4}};
  with_inner.segments = {{1, 2}, {2, 3}, {3, 4}, {1, 4}};
  CHECK(rules({PointSet(with_inner.points), {{1, 2, 3}, {1, 3, 4}}}, domain_of(with_inner)) ==
        std::set{Rule::kDomainVertexMissing});
  const ExactMesh halved{PointSet({{2, 0}, {0, 0}, {4, 0}, {4, 4}, {0, 4}}),
                         {{0, 2, 3}, {0, 3, 4}, {0, 1, 4}}};
  check_holds(Claim::kSteinerTriangulation, halved, domain_of(square));
  // The middle of a segment and of a square of the surface come first.
  const ExactMesh fine = grid({0, 1, 2}, {0, 1, 2}, {0, 1, 2}, every_cell);
  for (const Vertex first : {1, 4, 13}) {
    const auto renumbered = [&](Vertex v) { return (v + 27 - first) % 27; };
    std::vector<Point> points(27);
    for (Vertex v = 0; v < 27; ++v)
      points[static_cast<std::size_t>(renumbered(v))] = fine.points[v];
    std::vector<Simplex> simplices = fine.simplices;
    for (Simplex& simplex : simplices) {
      for (Vertex& v : simplex) v = renumbered(v);
    }
    CHECK(broken(Claim::kSteinerTriangulation, {PointSet(points), simplices}, cube()).empty());
  }
  // Beyond the hull of a domain that is its hull.
  PiecewiseLinearInput hull;
  hull.points = square.points;
  hull.kind = DomainKind::kHull;
  CHECK(
      rules({PointSet({{5, 2}, {0, 0}, {4, 0}, {4, 4}, {0, 4}}), {{0, 2, 3}, {1, 2, 3}, {1, 3, 4}}},
            domain_of(hull)) == std::set{Rule::kOutside});
}

TEST_CASE("domain.segment-missing: half of a segment, and the vertex that is nearest to it") {
  PiecewiseLinearInput input;
  input.points = {{0, 0}, {4, 0}, {3, 1}, {3, -1}};
  input.segments = {{0, 1}};
  input.kind = DomainKind::kHull;
  const ExactMesh half{PointSet({{0, 0}, {4, 0}, {3, 1}, {3, -1}, {2, 0}}),
                       {{0, 2, 4}, {0, 3, 4}, {2, 3, 4}, {1, 2, 3}}};
  CHECK(rules(half, domain_of(input)) == std::set{Rule::kSegmentMissing});
  // Two vertices are near the ends, another one, which is nearer, near the middle.
  input.points = {{0, 0}, {100000, 0}, {51234, 1}, {51234, -2}, {0, 3}, {100000, 3}};
  const ExactMesh mesh{PointSet(input.points),
                       {{0, 2, 3}, {1, 2, 3}, {1, 2, 5}, {2, 4, 5}, {0, 2, 4}}};
  const Verdict verdict = judge_domain(Claim::kPlcTriangulation, mesh, domain_of(input));
  REQUIRE(verdict.violations().size() == 1);
  CHECK(verdict.violations()[0].rule == Rule::kSegmentMissing);
  REQUIRE(verdict.violations()[0].witness.nearest.has_value());
  CHECK(verdict.violations()[0].witness.nearest->vertex == 2);
  CHECK(verdict.violations()[0].witness.nearest->squared_distance == 1);
}

TEST_CASE("a vertex of the domain outside everything is a vertex of the mesh without simplices") {
  PiecewiseLinearInput input = box(0, 2);
  input.points.push_back({5, 5, 5});
  check_holds(Claim::kPlcTriangulation, {PointSet(input.points), kCubeInFive}, domain_of(input));
  CHECK(rules({PointSet(input.points), kCubeInFive}, cube()) == std::set{Rule::kUnusedPoint});
}

TEST_CASE(
    "domain.segment-missing: a diagonal that the tetrahedra cross, or that is merely listed") {
  PiecewiseLinearInput input = box(0, 2);
  input.segments = {{0, 7}};
  check_holds(Claim::kPlcTriangulation, cube_mesh(kCubeInSix), domain_of(input));
  ExactMesh five = cube_mesh(kCubeInFive);
  CHECK(rules(five, domain_of(input)) == std::set{Rule::kSegmentMissing});
  const Verdict verdict = judge_domain(Claim::kPlcTriangulation, five, domain_of(input));
  CHECK(verdict.violations()[0].witness.face == Simplex{0, 7});
  five.faces = {{0, 7}};
  CHECK(rules(five, domain_of(input)) == std::set{Rule::kSegmentMissing});
}

TEST_CASE("a dangling polygon is tiled by listed triangles") {
  const Domain domain = domain_of(cube_with_flag());
  check_holds(Claim::kPlcTriangulation, flag_mesh({{1, 8, 9}, {3, 1, 9}}), domain);
  check_holds(Claim::kCdt, flag_mesh({{1, 8, 3}, {3, 8, 9}, {0, 1, 3}, {0, 1}}), domain);
  CHECK(rules(flag_mesh({}), domain) == std::set{Rule::kSegmentMissing});
  CHECK(rules(flag_mesh({{1, 8}, {8, 9}, {3, 9}, {1, 8, 9}}), domain) ==
        std::set{Rule::kPolygonNotTiled});
  CHECK(rules(flag_mesh({{1, 8, 9}, {3, 1, 9}, {1, 8, 3}, {8, 9, 3}}), domain) ==
        std::set{Rule::kOverlap});
  // Each edge inside the square is that of two triangles, but one of them is folded over.
  std::vector<Point> points = cube_with_flag().points;
  points.push_back({Rational(7, 2), 1, 0});
  ExactMesh folded{PointSet(points), kCubeInFive};
  folded.faces = {{1, 8, 9}, {1, 9, 10}, {3, 9, 10}, {1, 3, 10}};
  CHECK(broken(Claim::kSteinerTriangulation, folded, domain) == std::set{Rule::kOverlap});
}

TEST_CASE("domain.polygon-not-tiled: each side of the square between two cubes has its own cut") {
  const Domain domain = domain_of(two_storeys());
  std::vector<Simplex> matched = kCubeInSix;
  for (const Simplex& simplex : raised(kCubeInSix)) matched.push_back(simplex);
  check_holds(Claim::kCdt, {PointSet(two_storeys().points), matched}, domain);
  std::vector<Simplex> merely_tiled = kCubeInSix;
  for (Simplex simplex : raised(kCubeInSix)) {
    for (Vertex& v : simplex) v ^= 1;  // reflected
    merely_tiled.push_back(simplex);
  }
  CHECK(rules({PointSet(two_storeys().points), merely_tiled}, domain) == std::set{Rule::kOverlap});
  // One tetrahedron through the square.
  PiecewiseLinearInput pyramids;
  pyramids.points = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 3}, {1, 1, -3}};
  for (const Vertex apex : {3, 4}) {
    for (const auto& [a, b] : std::vector<std::pair<Vertex, Vertex>>{{0, 1}, {1, 2}, {0, 2}}) {
      pyramids.polygons.push_back({{{a, b, apex}}, {}});
    }
  }
  pyramids.polygons.push_back({{{0, 1, 2}}, {}});
  const PointSet points(pyramids.points);
  check_holds(Claim::kPlcTriangulation, {points, {{0, 1, 2, 3}, {0, 1, 2, 4}}},
              domain_of(pyramids));
  CHECK(rules({points, {{0, 1, 3, 4}, {1, 2, 3, 4}, {0, 2, 3, 4}}}, domain_of(pyramids)) ==
        std::set{Rule::kPolygonNotTiled});
  // Listing the triangle does not help.
  ExactMesh listed{points, {{0, 1, 3, 4}, {1, 2, 3, 4}, {0, 2, 3, 4}}};
  listed.faces = {{0, 1, 2}};
  CHECK(rules(listed, domain_of(pyramids)) == std::set{Rule::kUncovered});
}

TEST_CASE("domain.uncovered: a corner is missing; domain.outside: there is one too many") {
  std::vector<Simplex> four = kCubeInFive;
  four.pop_back();
  ExactMesh notched = cube_mesh(four);
  notched.faces = {{3, 5, 7}, {3, 6, 7}, {5, 6, 7}};
  CHECK(rules(notched, cube()) == std::set{Rule::kUncovered});
  ExactMesh nothing = cube_mesh({});
  nothing.faces = {{0, 1, 3}, {0, 3, 2}, {4, 5, 6}, {5, 6, 7}, {0, 1, 5}, {0, 5, 4},
                   {2, 3, 6}, {3, 6, 7}, {0, 2, 6}, {0, 6, 4}, {1, 3, 5}, {3, 5, 7}};
  CHECK(rules(nothing, cube()) == std::set{Rule::kUncovered});
  std::vector<Point> points = box(0, 2).points;
  points.push_back({3, 1, 1});
  std::vector<Simplex> six = kCubeInFive;
  six.push_back({3, 5, 7, 8});
  CHECK(rules({PointSet(points), six}, cube()) == std::set{Rule::kOutside});
}

TEST_CASE("complex.overlap: a vertex hangs in a triangle inside a cube") {
  // The middle tetrahedron of five is divided in its face 3 5 6, the one beyond is not.
  std::vector<Point> points = box(0, 2).points;
  points.push_back({Rational(4) / 3, Rational(4) / 3, Rational(4) / 3});
  const ExactMesh mesh{PointSet(points),
                       {{0, 3, 5, 8},
                        {0, 5, 6, 8},
                        {0, 3, 6, 8},
                        {0, 1, 3, 5},
                        {0, 2, 3, 6},
                        {0, 4, 5, 6},
                        {3, 5, 6, 7}}};
  CHECK(rules(mesh, cube()) == std::set{Rule::kOverlap});
  const Verdict verdict = judge_domain(Claim::kSteinerTriangulation, mesh, cube());
  REQUIRE(verdict.violations().size() == 1);
  CHECK(verdict.violations()[0].witness.face == Simplex{3, 5, 6});
  CHECK(verdict.violations()[0].witness.vertices == std::vector<Vertex>{8});
}

TEST_CASE("domain.vertex-in-edge: two boxes along one edge, one of which splits it") {
  const PiecewiseLinearInput near = cuboid({0, 0, 0}, {2, 2, 2});
  PiecewiseLinearInput input = near;
  const Vertex shared[2] = {3, 7};
  const Point far_corners[6] = {{4, 2, 0}, {2, 4, 0}, {4, 4, 0}, {4, 2, 2}, {2, 4, 2}, {4, 4, 2}};
  input.points.insert(input.points.end(), std::begin(far_corners), std::end(far_corners));
  const std::vector<Vertex> at = {shared[0], 8, 9, 10, shared[1], 11, 12, 13};
  for (PolygonLines polygon : near.polygons) {
    for (Vertex& v : polygon.lines[0]) v = at[static_cast<std::size_t>(v)];
    input.polygons.push_back(polygon);
  }
  const Domain domain = domain_of(input);
  std::vector<Simplex> simplices = kCubeInSix;
  for (Simplex simplex : kCubeInSix) {
    for (Vertex& v : simplex) v = at[static_cast<std::size_t>(v)];
    simplices.push_back(simplex);
  }
  check_holds(Claim::kCdt, {PointSet(input.points), simplices}, domain);
  // The middle of the edge, a vertex of the first cube only: its two tetrahedra there are halved.
  std::vector<Point> points = input.points;
  points.push_back({2, 2, 1});
  const Vertex middle = 14;
  std::vector<Simplex> split;
  for (std::size_t s = 0; s < simplices.size(); ++s) {
    const Simplex& simplex = simplices[s];
    if (s < 6 && contains(simplex, shared[0]) && contains(simplex, shared[1])) {
      for (const Vertex end : shared) {
        Simplex half = simplex;
        for (Vertex& v : half) v = v == end ? middle : v;
        split.push_back(half);
      }
    } else {
      split.push_back(simplex);
    }
  }
  CHECK(rules({PointSet(points), split}, domain) == std::set{Rule::kVertexInEdge});
}

TEST_CASE("listed faces that belong to nothing") {
  ExactMesh mesh = cube_mesh(kCubeInFive);
  mesh.faces = {{0, 3, 7}};
  CHECK(rules(mesh, cube()) == std::set{Rule::kOverlap});
  mesh.faces = {{0, 7}};
  CHECK(rules(mesh, cube()) == std::set{Rule::kOverlap});
  mesh.faces = {{0, 3, 5}, {3, 7}};
  check_holds(Claim::kPlcTriangulation, mesh, cube());
  ExactMesh outside = flag_mesh({{1, 8, 9}, {3, 1, 9}, {7, 9}});
  CHECK(rules(outside, domain_of(cube_with_flag())) == std::set{Rule::kOutside});
  mesh.faces = {{0, 9}};
  CHECK(broken(Claim::kPlcTriangulation, mesh, cube()) == std::set{Rule::kUnknownVertex});
  mesh.faces = {{0, 0}};
  CHECK(broken(Claim::kPlcTriangulation, mesh, cube()) == std::set{Rule::kRepeatedVertex});
  mesh.faces = {{0, 1, 2, 3}};
  CHECK(broken(Claim::kPlcTriangulation, mesh, cube()) == std::set{Rule::kWrongDimension});
}

TEST_CASE("a stray listed face: what it meets is named, with a point of both") {
  ExactMesh mesh = cube_mesh(kCubeInFive);
  for (const Simplex& stray : {Simplex{0, 3, 7}, Simplex{0, 7}}) {
    mesh.faces = {stray};
    const Verdict verdict = judge_domain(Claim::kPlcTriangulation, mesh, cube());
    REQUIRE(verdict.violations().size() == 1);
    const Witness& witness = verdict.violations()[0].witness;
    REQUIRE(witness.simplices.size() == 2);
    CHECK(witness.simplices[0] == stray);
    CHECK(witness.simplices[1] == Simplex{0, 3, 5, 6});
    CHECK(witness.point == improper_intersection(mesh.points, stray, {0, 3, 5, 6}));
  }
  // In the plane of a square that dangles alone there is nothing but its triangles to meet.
  ExactMesh flag = flag_mesh({{1, 8, 9}, {3, 1, 9}, {1, 3, 8}});
  const Verdict verdict = judge_domain(Claim::kPlcTriangulation, flag, domain_of(cube_with_flag()));
  REQUIRE(verdict.violations().size() == 1);
  const Witness& witness = verdict.violations()[0].witness;
  CHECK(verdict.violations()[0].rule == Rule::kOverlap);
  REQUIRE(witness.simplices.size() == 2);
  CHECK(witness.point ==
        improper_intersection(flag.points, witness.simplices[0], witness.simplices[1]));
}

TEST_CASE("what dangles is counted: triangles and edges that are faces of nothing larger") {
  const auto dangling = [](const ExactMesh& mesh, const Domain& domain, By by) {
    const Verdict verdict = judge_exactly(Claim::kPlcTriangulation, mesh, &domain, {.by = by});
    CHECK(verdict.holds());
    return verdict.dangling;
  };
  for (const By by : {By::kLemma, By::kDefinition}) {
    ExactMesh mesh = cube_mesh(kCubeInFive);
    mesh.faces = {{0, 3, 5}, {0, 1, 3}, {3, 7}};
    CHECK(dangling(mesh, cube(), by) == 0);
    // Listed twice is listed once; the edge 8 9 belongs to a triangle.
    const ExactMesh flag = flag_mesh({{1, 8, 9}, {3, 1, 9}, {9, 1, 8}, {8, 9}});
    CHECK(dangling(flag, domain_of(cube_with_flag()), by) == 2);
    PiecewiseLinearInput antenna = box(0, 2);
    antenna.points.push_back({4, 0, 0});
    antenna.segments = {{1, 8}};
    ExactMesh with_edge{PointSet(antenna.points), kCubeInFive};
    with_edge.faces = {{8, 1}, {1, 3}, {1, 8}};
    CHECK(dangling(with_edge, domain_of(antenna), by) == 1);
  }
}

TEST_CASE(
    "domain.vertex-in-edge: halves that are listed, and no edges of simplices, are not missing "
    "too") {
  std::vector<Point> points = box(0, 2).points;
  points.push_back({1, 0, 0});
  PiecewiseLinearInput border = box(0, 2);
  border.polygons.clear();
  border.segments = {{0, 1}};
  border.kind = DomainKind::kHull;
  ExactMesh mesh{PointSet(points), kCubeInFive};
  mesh.faces = {{0, 8}, {1, 8}};
  CHECK(rules(mesh, domain_of(border)) == std::set{Rule::kVertexInEdge});
  PiecewiseLinearInput inner = border;
  inner.segments = {{0, 7}};
  points.back() = {1, 1, 1};
  ExactMesh diagonal{PointSet(points), kCubeInSix};
  diagonal.faces = {{0, 8}, {7, 8}};
  CHECK(rules(diagonal, domain_of(inner)) == std::set{Rule::kVertexInEdge});
}

TEST_CASE("the kind hull: what is convex is covered, whatever the polygons are") {
  PiecewiseLinearInput input = box(0, 2);
  input.polygons = {input.polygons[0]};
  input.segments = {{0, 7}};
  input.kind = DomainKind::kHull;
  const Domain domain = domain_of(input);
  check_holds(Claim::kPlcTriangulation, cube_mesh(kCubeInSix), domain);
  CHECK(rules(cube_mesh(kCubeInFive), domain) == std::set{Rule::kSegmentMissing});
  std::vector<Simplex> five = kCubeInSix;
  five.erase(five.begin() + 4);
  CHECK(rules(cube_mesh(five), domain) == std::set{Rule::kHullNotConvex});
  ExactMesh nothing = cube_mesh({});
  nothing.faces = {{0, 7}, {0, 1, 3}, {0, 2, 3}};
  CHECK(broken(Claim::kPlcTriangulation, nothing, domain).contains(Rule::kDomainVertexMissing));
  // A Steiner point may lie on the hull, not beyond it.
  std::vector<Point> points = input.points;
  points.push_back({3, 1, 1});
  std::vector<Simplex> with_tip = kCubeInSix;
  with_tip.push_back({1, 3, 7, 8});
  with_tip.push_back({1, 5, 7, 8});
  CHECK(rules({PointSet(points), with_tip}, domain) == std::set{Rule::kOutside});
  const ExactMesh fine = grid({0, 1, 2}, {0, 1, 2}, {0, 1, 2}, every_cell);
  CHECK(broken(Claim::kSteinerTriangulation, fine, domain).empty());
}

TEST_CASE("a domain that is flat has triangles only, and one without points has nothing") {
  PiecewiseLinearInput square;
  square.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  square.polygons = {{{{0, 1, 2, 3}}, {}}};
  ExactMesh mesh{PointSet(square.points), {}};
  mesh.faces = {{0, 1, 2}, {0, 2, 3}};
  check_holds(Claim::kCdt, mesh, domain_of(square));
  mesh.faces.pop_back();
  CHECK(!holds(Claim::kPlcTriangulation, mesh, domain_of(square), By::kLemma));
  mesh.simplices = {{0, 1, 2, 3}};
  CHECK(rules(mesh, domain_of(square)) == std::set{Rule::kWrongDimension});
  const Domain empty{assemble({})};
  check_holds(Claim::kCdt, {PointSet({}), {}}, empty);
  CHECK(broken(Claim::kCdt, cube_mesh(kCubeInFive), empty) == std::set{Rule::kOutside});
}

}  // namespace
}  // namespace circumspect::check
