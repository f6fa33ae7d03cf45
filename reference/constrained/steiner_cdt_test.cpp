// Conforming Delaunay triangulations, and Steiner CDTs.
#include "reference/constrained/steiner_cdt.hpp"

#include <doctest/doctest.h>

#include "inputs/named_complexes.hpp"
#include "reference/constrained/cdt_by_polygon_insertion.hpp"
#include "reference/constrained/conforming_delaunay.hpp"
#include "reference/constrained/edge_protection.hpp"
#include "reference/constrained/gift_wrapping_cdt.hpp"
#include "reference/constrained/planar_cdt.hpp"
#include "reference/constrained/vertex_in_cdt.hpp"
#include "reference/delaunay/lifted_hull.hpp"

namespace circumspect::constrained {

namespace {

// ---- Conforming Delaunay triangulations, and limits reached ----

// Checks the guarantees of the answer.
ConformingDelaunay conforming(const PiecewiseLinearComplex& complex) {
  const auto answer = conforming_delaunay(complex, 500);
  REQUIRE(answer.has_value());
  const PointSet& points = answer->complex.points;
  CHECK(points.size() ==
        complex.points.size() + answer->on_segments.size() + answer->in_polygons.size());
  CHECK(is_edge_protected_under_perturbation(answer->complex));
  const StarIndex canonical = canonical_delaunay(points);
  for (const Simplex& simplex : answer->triangulation.simplices) CHECK(canonical.has(simplex));
  for (const Polygon& polygon : answer->complex.polygons) {
    for (const Simplex& facet : subfacets(points, polygon, polygon.vertices)) {
      CHECK_FALSE(canonical.star(facet).empty());
    }
  }
  for (const PointInPolygon& point : answer->in_polygons) {
    CHECK(is_in_polygon(complex.points, complex.polygons[point.polygon], points[point.vertex]));
  }
  return *answer;
}

TEST_CASE("conforming Delaunay: what is Delaunay stays as it is") {
  const ConformingDelaunay answer = conforming(assemble(generators::box(0, 1)));
  CHECK(answer.on_segments.empty());
  CHECK(answer.in_polygons.empty());
  CHECK(answer.triangulation.simplices.size() == 6);
}

TEST_CASE("conforming Delaunay: the named complexes") {
  CHECK(conforming(assemble(generators::encircled_segment())).on_segments.size() == 1);
  CHECK(conforming(assemble(generators::schonhardt())).on_segments.size() == 3);
  CHECK(conforming(assemble(generators::cube_with_three_segments())).in_polygons.empty());
  const ConformingDelaunay notched = conforming(assemble(generators::chazelle(1)));
  CHECK(!notched.in_polygons.empty());
}

// Two vertices very near the middle of a polygon, on either side of it: an edge between them
// pierces the polygon until it has a vertex there.
TEST_CASE("conforming Delaunay: a polygon with vertices close by on both sides") {
  PiecewiseLinearInput input = generators::box(0, 4);
  const auto first = static_cast<Vertex>(input.points.size());
  for (const auto& [x, y] : {std::pair{1, 1}, {3, 1}, {3, 3}, {1, 3}}) {
    input.points.push_back({x, y, 2});
  }
  input.points.push_back({2, 2, Rational(9, 4)});
  input.points.push_back({2, 2, Rational(7, 4)});
  input.polygons.push_back({{{first, first + 1, first + 2, first + 3}}, {}});
  const ConformingDelaunay answer = conforming(assemble(input));
  CHECK(!answer.in_polygons.empty());
}

TEST_CASE("conforming Delaunay: exact circumcentres are rounded, but not far") {
  const auto box = assemble(generators::box(0, 1));
  const Ball ball{{Rational(1, 3), Rational(2, 7), 0}, Rational(1, 100)};
  const Point near = near_circumcentre(box.points, box.polygons.front(), ball);
  CHECK(near[2] == 0);
  CHECK(16 * squared_distance(near, ball.centre) <= ball.squared_radius);
  CHECK(near[0].get_den() <= 64);
}

TEST_CASE("conforming Delaunay: in the plane, a constrained diagonal that is not Delaunay") {
  PiecewiseLinearInput input;
  input.points = {{0, 0}, {4, -1}, {8, 0}, {4, 1}};
  input.segments = {{0, 1}, {1, 2}, {2, 3}, {0, 3}, {0, 2}};
  const ConformingDelaunay answer = conforming(assemble(input));
  CHECK(answer.on_segments.size() == 1);
  CHECK(answer.triangulation.simplices.size() == 4);
}

TEST_CASE(
    "conforming Delaunay: both diagonals of a square are Delaunay, but only one is canonical") {
  PiecewiseLinearInput input;
  input.points = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  input.segments = {{0, 1}, {1, 2}, {2, 3}, {0, 3}, {0, 2}};
  CHECK(conforming(assemble(input)).on_segments.empty());
  input.segments.back() = {1, 3};
  CHECK(conforming(assemble(input)).on_segments.size() == 1);
}

TEST_CASE("conforming Delaunay: a limit that is reached is not an answer") {
  const auto answer = conforming_delaunay(assemble(generators::chazelle(1)), 10);
  REQUIRE_FALSE(answer.has_value());
  CHECK(answer.error().on_segments + answer.error().in_polygons > 10);
}

// ---- Steiner CDTs of complexes that have no triangulation ----

// All algorithms give the same answer; returns the number of its Steiner points.
std::size_t steiner_points_of_cdt(const PiecewiseLinearComplex& complex) {
  const SteinerCdt by_flips = steiner_cdt(complex);
  for (const CdtAlgorithm other : {CdtAlgorithm::kGiftWrapping, CdtAlgorithm::kPolygonCavities}) {
    const SteinerCdt answer = steiner_cdt(complex, other);
    CHECK(answer.triangulation == by_flips.triangulation);
    CHECK(answer.steiner_points == by_flips.steiner_points);
  }
  CHECK(by_flips.triangulation.dangling.empty());
  return by_flips.steiner_points.size();
}

TEST_CASE("steiner CDT: a box needs nothing") {
  const SteinerCdt answer = steiner_cdt(assemble(generators::box(0, 1)));
  CHECK(answer.steiner_points.empty());
  CHECK(answer.triangulation.simplices.size() == 6);
}

TEST_CASE("steiner CDT: the book's complexes without a triangulation, or without a CDT") {
  CHECK(steiner_points_of_cdt(assemble(generators::schonhardt())) == 3);
  CHECK(steiner_points_of_cdt(assemble(generators::cube_with_three_segments())) == 3);
  CHECK(steiner_points_of_cdt(assemble(generators::chazelle(2))) == 34);
  // "The PLC in Figure 4.15 has a Steiner CDT with one Steiner point on its central segment."
  const auto encircled = assemble(generators::encircled_segment());
  CHECK(steiner_points_of_cdt(encircled) == 1);
  const PointOnSegment point = steiner_cdt(encircled).steiner_points.front();
  CHECK(encircled.segments[point.segment] == Simplex{3, 4});
}

TEST_CASE("steiner CDT: in the plane there is no need for Steiner points") {
  PiecewiseLinearInput input;
  input.points = {{0, 0}, {9, 0}, {9, 1}, {0, 1}, {4, Rational(1, 2)}, {8, Rational(1, 9)}};
  input.segments = {{0, 1}, {1, 2}, {2, 3}, {0, 3}, {0, 2}};
  const SteinerCdt answer = steiner_cdt(assemble(input));
  CHECK(answer.steiner_points.empty());
  CHECK(answer.triangulation.simplices.size() == 6);
}

}  // namespace

// ---- Planar CDTs ----
// Planar CDTs whose answer is known, by both algorithms.

namespace {

PlcTriangulation both_ways(const PiecewiseLinearInput& input) {
  const PiecewiseLinearComplex complex = assemble(input);
  const PlcTriangulation answer = planar_cdt(complex, PlanarAlgorithm::kGiftWrapping);
  CHECK(answer == planar_cdt(complex, PlanarAlgorithm::kSegmentInsertion));
  return answer;
}

std::vector<Simplex> both_ways(const PiecewiseLinearComplex& complex, const Polygon& polygon) {
  const auto answer = planar_cdt(complex.points, polygon, PlanarAlgorithm::kGiftWrapping);
  CHECK(answer == planar_cdt(complex.points, polygon, PlanarAlgorithm::kSegmentInsertion));
  return answer;
}

TEST_CASE("planar CDT: a convex hull without segments has its Delaunay triangulation") {
  PiecewiseLinearInput input;
  for (int x = 0; x < 4; ++x) {
    for (int y = 0; y < 3; ++y) input.points.push_back({x, y});
  }
  input.kind = DomainKind::kHull;
  const PlcTriangulation answer = both_ways(input);
  CHECK(answer.simplices == delaunay::by_definition(PointSet(input.points)).simplices());
  CHECK(answer.dangling.empty());
}

TEST_CASE("planar CDT: a segment that is not Delaunay") {
  PiecewiseLinearInput input;
  input.points = {{0, 0}, {9, 0}, {4, 1}, {4, -1}};
  input.segments = {{0, 1}};
  input.kind = DomainKind::kHull;
  CHECK(both_ways(input) == PlcTriangulation{{{0, 1, 2}, {0, 1, 3}}, {}});
  input.segments.clear();
  CHECK(both_ways(input) == PlcTriangulation{{{0, 2, 3}, {1, 2, 3}}, {}});
}

TEST_CASE("planar CDT: of the enclosed kind only what segments enclose has triangles") {
  PiecewiseLinearInput input;
  // A square with a square hole, a segment that leads out of the outline, a separate one, and a
  // vertex outside.
  input.points = {{0, 0}, {6, 0}, {6, 6}, {0, 6}, {2, 2},  {4, 2},
                  {4, 4}, {2, 4}, {9, 9}, {8, 0}, {9, 20}, {20, 9}};
  for (Vertex i = 0; i < 4; ++i) {
    input.segments.push_back({i, (i + 1) % 4});
    input.segments.push_back({4 + i, 4 + (i + 1) % 4});
  }
  input.segments.push_back({2, 8});
  input.segments.push_back({10, 11});
  input.hole_seeds = {{3, 3}};
  const PlcTriangulation answer = both_ways(input);
  CHECK(answer.simplices.size() == 8);
  CHECK(answer.dangling == std::vector<Simplex>{{2, 8}, {9}, {10, 11}});
  input.hole_seeds.clear();
  CHECK(both_ways(input).simplices.size() == 10);
}

TEST_CASE("planar CDT: vertices that are hidden do not count") {
  // A wall 4 5 between the edge 0 1 and the vertex 6, which would be in every ball otherwise.
  PiecewiseLinearInput input;
  input.points = {{0, 0}, {10, 0}, {10, 9}, {0, 9}, {-1, 3}, {11, 3}, {5, 4}};
  input.segments = {{4, 5}};
  input.kind = DomainKind::kHull;
  const PlcTriangulation answer = both_ways(input);
  CHECK(answer.simplices ==
        std::vector<Simplex>{{0, 1, 4}, {1, 4, 5}, {2, 3, 6}, {2, 5, 6}, {3, 4, 6}, {4, 5, 6}});
}

TEST_CASE("planar CDT: cavities that are passed twice by one edge, and by one vertex") {
  // The segment 0 1 passes the tips of two segments that hang down, and of one that stands up.
  PiecewiseLinearInput input;
  input.points = {{0, 0}, {30, 0}, {7, 8}, {8, 1}, {17, 9}, {16, 1}, {12, -9}, {12, -1}, {25, -3}};
  input.segments = {{2, 3}, {4, 5}, {6, 7}, {0, 1}};
  input.kind = DomainKind::kHull;
  CHECK(both_ways(input).dangling.empty());
  CHECK(both_ways(input).simplices.size() == 10);
}

TEST_CASE("planar CDT: points on one line, and none") {
  PiecewiseLinearInput input;
  CHECK(both_ways(input) == PlcTriangulation{});
  input.points = {{0, 0}, {2, 2}, {1, 1}};
  CHECK(planar_domain(PointSet(input.points), {0, 1}, {0, 1, 2}, {}, {}, DomainKind::kHull)
            .segments == std::vector<Simplex>{{0, 2}, {1, 2}});
  input.segments = {{0, 2}};
  CHECK(both_ways(input) == PlcTriangulation{{}, {{0, 2}, {1}}});
  input.kind = DomainKind::kHull;
  CHECK(both_ways(input) == PlcTriangulation{{}, {{0, 2}, {1}}});
}

TEST_CASE("planar CDT: a polygon in space with a hole, a slit and a vertex inside") {
  PiecewiseLinearInput input;
  // In the plane z = x + 2y.
  const auto add = [&input](int x, int y) { input.points.push_back({x, y, x + 2 * y}); };
  for (const int at : {0, 10}) {
    add(at, 0);
    add(at, 10);
  }
  for (const int at : {2, 4}) {
    add(at, 2);
    add(at, 4);
  }
  add(6, 1), add(6, 9), add(8, 5);
  input.polygons = {{{{0, 2, 3, 1}, {4, 6, 7, 5}, {8, 9}, {10}}, {{3, 3, 9}}}};
  const PiecewiseLinearComplex complex = assemble(input);
  const std::vector<Simplex> answer = both_ways(complex, complex.polygons.front());
  // Euler's relation: n vertices, b edges on the boundary, a hole: 2n − b triangles.
  CHECK(answer.size() == 2 * 11 - 8);
  for (const Simplex& segment : std::vector<Simplex>{{8, 9}, {4, 5}, {0, 2}}) {
    CHECK(std::any_of(answer.begin(), answer.end(), [&](const Simplex& triangle) {
      return contains(triangle, segment[0]) && contains(triangle, segment[1]);
    }));
  }
}

}  // namespace

// ---- Vertices that are inserted ----
// Inserting a vertex into a CDT, and why it cannot be done. Book: Section 5.7.

namespace {

struct Start {
  EvolvingCdt cdt;
  PointSet larger;  // the same points and the one to be inserted
  Vertex v;
};

Start start(const std::vector<Point>& points, const std::vector<std::vector<Vertex>>& polygons,
            const std::vector<std::vector<Vertex>>& segments, const Point& point) {
  PiecewiseLinearInput input{points, segments, {}, {}, DomainKind::kHull};
  for (const auto& line : polygons) input.polygons.push_back({{line}, {}});
  std::vector<Point> more = points;
  more.push_back(point);
  return {hull_cdt_by_polygon_insertion(assemble(input)).value(), PointSet(more),
          static_cast<Vertex>(points.size())};
}

// Inserts the vertex, and deletes it again, which must restore; or why it cannot be.
std::optional<NoChange> answer_to_insertion(Start& s) {
  const EvolvingCdt before = s.cdt;
  const auto wrong = insert_vertex(s.larger, s.cdt, s.v);
  if (wrong) {
    CHECK(s.cdt == before);
    return wrong;
  }
  EvolvingCdt back = s.cdt;
  CHECK(!delete_vertex(s.larger, back, s.v));
  CHECK(back == before);
  return std::nullopt;
}

const std::vector<Point> kPierced = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 1}, {1, 1, -1}};

TEST_CASE("a wall keeps its far side as it is") {
  Start s = start(kPierced, {{0, 1, 2}}, {}, {1, 1, Rational(1, 2)});
  CHECK(!answer_to_insertion(s));
  CHECK(s.cdt.tetrahedra.star({5}).size() == 4);
  CHECK(s.cdt.tetrahedra.has({0, 1, 2, 4}));
}

TEST_CASE("in a polygon, in the hull and in a segment") {
  Start s = start(kPierced, {{0, 1, 2}}, {}, {1, 1, 0});
  CHECK(!answer_to_insertion(s));
  CHECK(s.cdt.walls == std::set<Simplex>{{0, 1, 5}, {0, 2, 5}, {1, 2, 5}});
  CHECK(s.cdt.tetrahedra.size() == 6);

  s = start(kPierced, {{0, 1, 2}, {0, 1, 3}}, {}, {1, 0, 0});
  CHECK(!answer_to_insertion(s));
  CHECK(s.cdt.segments.contains({0, 5}));
  CHECK(s.cdt.segments.contains({1, 5}));
  CHECK(!s.cdt.segments.contains({0, 1}));
  CHECK(s.cdt.walls == std::set<Simplex>{{0, 2, 5}, {0, 3, 5}, {1, 2, 5}, {1, 3, 5}});

  // In the middle of the facet 0 1 3 of the hull.
  s = start(kPierced, {{0, 1, 2}}, {}, {Rational(5, 3), Rational(1, 3), Rational(1, 3)});
  CHECK(!answer_to_insertion(s));
  CHECK(s.cdt.tetrahedra.size() == 4);
}

TEST_CASE("outside the hull, and there already") {
  Start s = start(kPierced, {}, {}, {9, 9, 9});
  CHECK(answer_to_insertion(s) == NoChange{WhyNoChange::kOutsideHull, {5}});
  s.v = 3;
  CHECK(answer_to_insertion(s) == NoChange{WhyNoChange::kVertexAlreadyThere, {3}});
}

TEST_CASE("a segment runs through the cavity") {
  // The segment 3 4 in the tetrahedra around it; the vertex is in all their balls.
  std::vector<Point> points = {{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}, {0, 0, 8}, {0, 0, -8}};
  Start s = start(points, {}, {{3, 4}}, {0, Rational(1, 4), 0});
  CHECK(answer_to_insertion(s) == NoChange{WhyNoChange::kSegmentInCavity, {3, 4}});
}

TEST_CASE("a third sign: a cavity that is star-shaped and empty does not suffice") {
  // The new vertex lies beyond a segment at which two polygons meet.
  const std::vector<Point> points = {{1, 5, 3}, {0, 1, 3}, {0, 1, 4}, {2, 1, 3}, {1, 2, 2}};
  const Point point = {Rational(3, 4), 2, Rational(7, 2)};
  Start s = start(points, {{1, 2, 4}, {2, 3, 4}}, {}, point);
  CHECK(answer_to_insertion(s) == NoChange{WhyNoChange::kNotLocallyDelaunay, {2, 4, 5}});
  // There is no CDT, by gift-wrapping.
  PiecewiseLinearInput larger{
      s.larger.points(), {}, {{{{1, 2, 4}}, {}}, {{{2, 3, 4}}, {}}}, {}, DomainKind::kHull};
  CHECK(!gift_wrapping_cdt(assemble(larger)).has_value());
}

TEST_CASE("vertices that cannot be deleted") {
  Start s = start(kPierced, {{0, 1, 2}}, {}, {1, 1, Rational(1, 2)});
  CHECK(!insert_vertex(s.larger, s.cdt, 5));
  const EvolvingCdt before = s.cdt;
  CHECK(delete_vertex(s.larger, s.cdt, 0)->why == WhyNoChange::kVertexNeeded);
  CHECK(delete_vertex(s.larger, s.cdt, 4)->why == WhyNoChange::kExtremeVertex);
  CHECK(s.cdt == before);
  CHECK(!delete_vertex(s.larger, s.cdt, 5));
  CHECK(delete_vertex(s.larger, s.cdt, 5)->why == WhyNoChange::kVertexNeeded);
}

}  // namespace

}  // namespace circumspect::constrained
