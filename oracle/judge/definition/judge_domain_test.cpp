// The claims about domains by definition, visibility and Definition 4.3, by small cases.
#include <map>

#include <doctest/doctest.h>

#include "oracle/judge/definition/judge.hpp"
#include "oracle/judge/definition/linear_cells.hpp"
#include "oracle/judge/definition/visibility.hpp"

namespace circumspect::definition {
namespace {

using Broken = std::map<Rule, std::size_t>;

Broken broken_in_domain(Claim claim, const ExactMesh& mesh, const PiecewiseLinearInput& input) {
  Broken rules;
  const Verdict verdict = judge(claim, mesh, assemble(input), 0);
  for (const auto& [rule, tally] : verdict.tallies()) rules[rule] = tally.count;
  return rules;
}

const PiecewiseLinearInput kSquareOutline{
    {{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {{0, 1}, {1, 2}, {2, 3}, {0, 3}}, {}, {}};

TEST_CASE("a square, triangulated or not") {
  const auto broken = [](const ExactMesh& mesh, Claim claim = Claim::kSteinerTriangulation) {
    return broken_in_domain(claim, mesh, kSquareOutline);
  };
  const PointSet corners(kSquareOutline.points);
  const std::vector<Simplex> two = {{0, 1, 2}, {0, 2, 3}};
  CHECK(broken({corners, two}, Claim::kCdt).empty());
  CHECK(broken({corners, two}, Claim::kConformingDelaunay).empty());
  CHECK(broken({corners, {{0, 1, 2}}}) == Broken{{Rule::kSegmentMissing, 2}});
  CHECK(broken({corners, {{0, 1, 2}}, {}, 0, {}, {{2, 3}, {0, 3}}}) ==
        Broken{{Rule::kUncovered, 1}});
  CHECK(broken({PointSet({{0, 0}, {2, 0}, {2, 2}}), {{0, 1, 2}}}) ==
        Broken{{Rule::kDomainVertexMissing, 1}});
  CHECK(broken({corners, {{0, 1, 2}, {1, 2, 3}}}) == Broken{{Rule::kOverlap, 1}});
  // With a Steiner point in the middle of an edge, and one beyond it.
  PointSet more({{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0}});
  const std::vector<Simplex> three = {{0, 4, 3}, {4, 1, 2}, {4, 2, 3}};
  CHECK(broken({more, three}).empty());
  CHECK(broken({more, three}, Claim::kPlcTriangulation) == Broken{{Rule::kSteinerForbidden, 1}});
  CHECK(broken({more, two}) == Broken{{Rule::kUnusedPoint, 1}});
  const PointSet beyond({{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, -1}});
  const auto outside = broken({beyond, {{0, 1, 2}, {0, 2, 3}, {0, 1, 4}}});
  CHECK(outside == Broken{{Rule::kOutside, 1}});
  // A listed edge that is in nothing.
  CHECK(broken({corners, two, {}, 0, {}, {{0, 2}}}).empty());
  CHECK(broken({beyond, two, {}, 0, {}, {{0, 4}}}) == Broken{{Rule::kOutside, 1}});
}

TEST_CASE("the nearest vertex shows that one was rounded") {
  const PointSet rounded({{0, 0}, {2, 0}, {2, Rational(21, 10)}, {0, 2}});
  const Verdict verdict =
      judge(Claim::kCdt, {rounded, {{0, 1, 2}, {0, 2, 3}}}, assemble(kSquareOutline), 0);
  const Witness& witness = verdict.violations().front().witness;
  REQUIRE(witness.nearest.has_value());
  CHECK(witness.nearest->vertex == 2);
  CHECK(witness.nearest->squared_distance == Rational(1, 100));
}

TEST_CASE("holes, hulls and points of one line") {
  PiecewiseLinearInput ring = kSquareOutline;
  for (const Point& p : std::vector<Point>{{Rational(1, 2), 1}, {1, Rational(1, 2)}, {1, 1}}) {
    ring.points.push_back(p);
  }
  for (const Simplex& edge : std::vector<Simplex>{{4, 5}, {5, 6}, {4, 6}})
    ring.segments.push_back(edge);
  const std::vector<Simplex> around = {{0, 1, 5}, {0, 4, 5}, {0, 3, 4}, {1, 2, 5},
                                       {2, 5, 6}, {2, 4, 6}, {2, 3, 4}};
  std::vector<Simplex> all = around;
  all.push_back({4, 5, 6});
  const PointSet points(ring.points);
  const Claim claim = Claim::kPlcTriangulation;
  CHECK(broken_in_domain(claim, {points, all}, ring).empty());
  CHECK(broken_in_domain(claim, {points, around}, ring) == Broken{{Rule::kUncovered, 1}});
  ring.hole_seeds = {{Rational(9, 10), Rational(9, 10)}};
  CHECK(broken_in_domain(claim, {points, around}, ring).empty());
  CHECK(broken_in_domain(claim, {points, all}, ring) == Broken{{Rule::kOutside, 1}});
  PiecewiseLinearInput hull{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {{0, 2}}, {}, {}, DomainKind::kHull};
  const PointSet corners(hull.points);
  CHECK(broken_in_domain(claim, {corners, {{0, 1, 2}, {0, 2, 3}}}, hull).empty());
  CHECK(broken_in_domain(claim, {corners, {{0, 1, 3}, {1, 2, 3}}}, hull) ==
        Broken{{Rule::kSegmentMissing, 1}});
  CHECK(broken_in_domain(claim, {corners, {{0, 1, 2}}}, hull) == Broken{{Rule::kUncovered, 1}});
  const ExactMesh empty{corners, {}, {}, 0, {}, {{0, 2}}};
  CHECK(broken_in_domain(claim, empty, hull) == Broken{{Rule::kUncovered, 1}});
  // A convex hull that is a segment: nothing fills it, and an edge may be in it.
  PiecewiseLinearInput line{{{0, 0}, {1, 1}, {2, 2}}, {{0, 1}}, {}, {}, DomainKind::kHull};
  const PointSet on_line(line.points);
  CHECK(broken_in_domain(claim, {on_line, {}, {}, 0, {}, {{0, 1}}}, line).empty());
  CHECK(broken_in_domain(claim, {on_line, {}}, line) == Broken{{Rule::kSegmentMissing, 1}});
  CHECK(broken_in_domain(claim, {on_line, {{0, 1, 2}}}, line) ==
        Broken{{Rule::kWrongDimension, 1}});
  // An edge that leads to a segment at a right angle has nothing in common with it, but no length
  // along it either.
  const PiecewiseLinearInput foot{{{0, 0}, {2, 0}, {0, 1}}, {{0, 1}}, {}, {}};
  const PointSet at_foot(foot.points);
  CHECK(broken_in_domain(claim, {at_foot, {}, {}, 0, {}, {{0, 1}}}, foot).empty());
  CHECK(broken_in_domain(claim, {at_foot, {}, {}, 0, {}, {{0, 1}, {0, 2}}}, foot) ==
        Broken{{Rule::kOutside, 1}});
}

TEST_CASE("an empty domain has nothing in it") {
  const PointSet points({{0, 0}, {1, 0}, {0, 1}, {5, 5}});
  CHECK(broken_in_domain(Claim::kCdt, {points, {{0, 1, 2}}, {}, 0, {}, {{0, 1}}}, {}) ==
        Broken{{Rule::kOutside, 2}, {Rule::kUnusedPoint, 1}});
}

TEST_CASE("what a wall hides may be in a ball") {
  // The vertex 3 is deep in the ball of 0 1 2, beyond the edge 1 2.
  PiecewiseLinearInput quad{{{0, 0}, {2, 0}, {0, 2}, {Rational(5, 4), Rational(5, 4)}},
                            {{0, 1}, {1, 3}, {2, 3}, {0, 2}},
                            {},
                            {}};
  const ExactMesh mesh{PointSet(quad.points), {{0, 1, 2}, {1, 2, 3}}};
  CHECK(broken_in_domain(Claim::kPlcTriangulation, mesh, quad).empty());
  CHECK(broken_in_domain(Claim::kCdt, mesh, quad) == Broken{{Rule::kVisibleVertexInBall, 2}});
  CHECK(broken_in_domain(Claim::kConformingDelaunay, mesh, quad) ==
        Broken{{Rule::kVertexInBall, 2}});
  quad.segments.push_back({1, 2});
  CHECK(broken_in_domain(Claim::kCdt, mesh, quad).empty());
  CHECK(broken_in_domain(Claim::kConformingDelaunay, mesh, quad) ==
        Broken{{Rule::kVertexInBall, 2}});
}

// A rhombus that lies aslant in space by itself, cut along its long diagonal or along its short
// one.
TEST_CASE("a dangling polygon has a triangulation of its own") {
  PiecewiseLinearInput rhombus{
      {{0, 0, 0}, {3, 1, 1}, {6, 0, 2}, {3, -1, 1}}, {}, {{{{0, 1, 2, 3}}, {}}}, {}};
  const PointSet points(rhombus.points);
  const auto with = [&](const std::vector<Simplex>& faces, Claim claim) {
    return broken_in_domain(claim, {points, {}, {}, 0, {}, faces}, rhombus);
  };
  const std::vector<Simplex> shortly = {{0, 1, 3}, {1, 2, 3}}, lengthwise = {{0, 1, 2}, {0, 2, 3}};
  CHECK(with(shortly, Claim::kCdt).empty());
  CHECK(with(lengthwise, Claim::kPlcTriangulation).empty());
  CHECK(with(lengthwise, Claim::kCdt) == Broken{{Rule::kDanglingNotDelaunay, 2}});
  CHECK(with({{0, 1, 3}}, Claim::kCdt) ==
        Broken{{Rule::kPolygonNotTiled, 1}, {Rule::kSegmentMissing, 2}});
  CHECK(with(shortly, Claim::kConformingDelaunay).empty());
  // A slit along the diagonal hides the two parts from each other. What is off the plane is not
  // seen.
  rhombus.segments = {{0, 2}};
  CHECK(with(lengthwise, Claim::kCdt).empty());
  PiecewiseLinearInput with_vertex = rhombus;
  with_vertex.segments.clear();
  with_vertex.points.push_back({3, 0, Rational(1, 2)});
  CHECK(broken_in_domain(Claim::kCdt, {PointSet(with_vertex.points), {}, {}, 0, {}, shortly},
                         with_vertex)
            .empty());
  rhombus.segments.clear();
  // In space a long edge has a small ball; the triangles along it have none that is empty.
  CHECK(with(lengthwise, Claim::kConformingDelaunay) == Broken{{Rule::kNoEmptyBall, 2}});
  // Under a pyramid the same triangles are faces of tetrahedra, and do not dangle.
  PiecewiseLinearInput pyramid = rhombus;
  pyramid.points.push_back({3, 0, 4});
  for (Vertex v = 0; v < 4; ++v) pyramid.polygons.push_back({{{v, (v + 1) % 4, 4}}, {}});
  CHECK(broken_in_domain(Claim::kCdt, {PointSet(pyramid.points), {{0, 1, 2, 4}, {0, 2, 3, 4}}},
                         pyramid) == Broken{{Rule::kVisibleVertexInBall, 2}});
}

TEST_CASE("a cube: its tetrahedra are inside, and cover it") {
  PiecewiseLinearInput cube;
  for (int i = 0; i < 8; ++i) cube.points.push_back({i % 2, i / 2 % 2, i / 4});
  for (const auto& side : std::vector<std::vector<Vertex>>{
           {0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}}) {
    cube.polygons.push_back({{side}, {}});
  }
  const std::vector<Simplex> five = {
      {0, 3, 5, 6}, {0, 1, 3, 5}, {0, 2, 3, 6}, {0, 4, 5, 6}, {3, 5, 6, 7}};
  const PointSet points(cube.points);
  for (const Claim claim : {Claim::kPlcTriangulation, Claim::kCdt, Claim::kConformingDelaunay}) {
    CHECK(broken_in_domain(claim, {points, five}, cube).empty());
  }
  const std::vector<Simplex> no_middle(five.begin() + 1, five.end());
  CHECK(broken_in_domain(Claim::kCdt, {points, no_middle}, cube) == Broken{{Rule::kUncovered, 1}});
  const std::vector<Simplex> no_corner(five.begin(), five.end() - 1);
  CHECK(broken_in_domain(Claim::kCdt, {points, no_corner}, cube) ==
        Broken{{Rule::kSegmentMissing, 3}, {Rule::kPolygonNotTiled, 3}});
  cube.kind = DomainKind::kHull;
  CHECK(broken_in_domain(Claim::kCdt, {points, five}, cube).empty());
  CHECK(broken_in_domain(Claim::kCdt, {points, no_middle}, cube) == Broken{{Rule::kUncovered, 4}});
}

// A triangle, a vertex above it, and walls with gaps between them.
TEST_CASE("visible is what is seen through gaps in a row") {
  const auto sees = [](const std::vector<std::vector<Rational>>& ends) {
    std::vector<Point> points = {{0, 0}, {4, 0}, {2, -3}, {2, 9}};
    std::vector<Simplex> segments;
    for (const auto& wall : ends) {  // its height, and where it begins and ends
      const auto first = static_cast<Vertex>(points.size());
      points.push_back({wall[1], wall[0]});
      points.push_back({wall[2], wall[0]});
      segments.push_back({first, first + 1});
    }
    const bool visible = is_visible({PointSet(points), segments, {}, {}}, 3, {0, 1, 2});
    return visible;
  };
  const Rational hair(1, 1'000'000);
  CHECK(sees({}));
  CHECK(!sees({{1, -9, 9}}));
  CHECK(sees({{1, -9, 2}, {1, 2 + hair, 9}}));
  CHECK(sees({{1, -9, 1}, {1, 1 + hair, 9}}));
  CHECK(!sees({{1, -9, 0}, {1, hair / 9, 9}}));  // seen through the gap is nothing of the triangle
  CHECK(!sees({{1, -9, 1}, {1, 1 + hair, 9}, {2, -9, 2}, {2, 2 + hair, 9}}));
  CHECK(sees({{1, -9, 1}, {1, 1 + hair, 9}, {2, -9, 1}, {2, 2, 9}}));
  CHECK(sees({{-4, -9, 9}}));  // behind
  CHECK(sees({{10, -9, 9}}));
}

TEST_CASE("visible in space, past triangles, and in a plane that they cross") {
  std::vector<Point> points = {{0, 0, 0},  {4, 0, 0},   {0, 4, 0},   {1, 1, -4},  {1, 1, 9},
                               {3, -9, 0}, {-9, -9, 4}, {99, -9, 4}, {-9, 99, 4}, {-9, 3, 4}};
  const auto complex = [&](const std::vector<Simplex>& triangles) {
    PiecewiseLinearComplex with{PointSet(points), {}, {}, {}};
    for (const Simplex& t : triangles) with.polygons.push_back({{}, {}, {}, {}, {t}});
    return with;
  };
  CHECK(is_visible(complex({}), 4, {0, 1, 2, 3}));
  CHECK(!is_visible(complex({{6, 7, 8}}), 4, {0, 1, 2, 3}));
  CHECK(is_visible(complex({{7, 8, 9}}), 4, {0, 1, 2, 3}));
  CHECK(is_visible(complex({{6, 7, 9}}), 4, {0, 1, 2, 3}));
  CHECK(!is_visible(complex({{6, 7, 9}, {7, 8, 9}}), 4, {0, 1, 2, 3}));
  // In the plane z = 0 the triangle 0 1 2 and the vertex 5, with an upright wall between.
  points[6] = {-9, -3, -1};
  points[7] = {99, -3, -1};
  points[8] = {3, -3, 9};
  CHECK(is_visible(complex({}), 5, {0, 1, 2}));
  CHECK(!is_visible(complex({{6, 7, 8}}), 5, {0, 1, 2}));
  PiecewiseLinearComplex segments = complex({});
  points[6] = {-9, -3, 0};
  points[7] = {99, -3, 0};
  segments.points = PointSet(points);
  segments.segments = {{6, 7}};
  CHECK(!is_visible(segments, 5, {0, 1, 2}));
  points[7] = {99, -3, 1};  // meets the plane in an end
  segments.points = PointSet(points);
  CHECK(is_visible(segments, 5, {0, 1, 2}));
}

TEST_CASE("Definition 4.3, cell against cell") {
  const std::vector<Point> points = {{0, 0, 1}, {4, 0, 1}, {4, 4, 1}, {0, 4, 1}, {1, 2, 1},
                                     {3, 2, 1}, {2, 2, 0}, {2, 2, 2}, {9, 9, 9}};
  const std::vector<Simplex> outline = {{0, 1}, {0, 3}, {1, 2}, {2, 3}};
  const Polygon square{{}, {}, {}, {0, 1}, {{0, 1, 3}, {1, 2, 3}}};
  const auto is_complex = [&](std::vector<Simplex> more, std::vector<Polygon> polygons) {
    more.insert(more.end(), outline.begin(), outline.end());
    return is_piecewise_linear_complex({PointSet(points), more, std::move(polygons), {}});
  };
  CHECK(is_complex({}, {square}));
  CHECK(is_complex({{4, 5}}, {square}));           // a slit
  CHECK(is_complex({{7, 8}}, {square}));           // elsewhere
  CHECK(!is_complex({{6, 7}}, {square}));          // pierces it
  CHECK(is_complex({{4, 7}}, {square}));           // touches it in its own end
  CHECK(!is_complex({{0, 2}, {1, 3}}, {square}));  // diagonals that cross
  CHECK(!is_piecewise_linear_complex({PointSet(points), {{0, 1}, {1, 2}, {2, 3}}, {square}, {}}));
  const std::vector<Simplex> upright = {{4, 6}, {5, 6}, {5, 7}, {4, 7}};
  const Polygon through{{}, {}, {}, {0, 2}, {{4, 5, 6}, {4, 5, 7}}};
  CHECK(!is_complex(upright, {square, through}));
  std::vector<Simplex> with_seam = upright;
  with_seam.push_back({4, 5});
  CHECK(is_complex(with_seam, {square, through}));
  // Two of one plane, one inside the other; and one that is not flat.
  CHECK(!is_complex({{0, 4}, {3, 4}}, {square, {{}, {}, {}, {0, 1}, {{0, 3, 4}}}}));
  CHECK(!is_complex({{0, 7}, {3, 7}}, {{{}, {}, {}, {0, 1}, {{0, 1, 3}, {0, 3, 7}}}}));
  CHECK(!is_complex({}, {Polygon{}}));
  // In the plane: a vertex in a segment.
  const PointSet row({{0, 0}, {1, 0}, {2, 0}});
  CHECK(is_piecewise_linear_complex({row, {{0, 1}, {1, 2}}, {}, {}}));
  CHECK(!is_piecewise_linear_complex({row, {{0, 2}}, {}, {}}));
}

}  // namespace
}  // namespace circumspect::definition
