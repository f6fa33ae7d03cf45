// CDTs by polygon insertion. Book: Sections 5.6 and 5.8.
#include <algorithm>

#include <doctest/doctest.h>

#include "inputs/named_complexes.hpp"
#include "reference/constrained/cavity.hpp"
#include "reference/constrained/cdt_by_polygon_insertion.hpp"
#include "reference/constrained/gift_wrapping_cdt.hpp"
#include "reference/constrained/plc_triangulation.hpp"

namespace circumspect::constrained {
namespace {

// ---- Which tetrahedra a polygon crosses ----

const PointSet kPiercedTriangle({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 1}, {1, 1, -1}});
const Polygon kTriangle{{0, 1, 2}, {{0, 1}, {0, 2}, {1, 2}}, {}, {0, 1}, {{0, 1, 2}}};

TEST_CASE("distances along the axis that the polygon leaves out") {
  const PolygonInSpace polygon(kPiercedTriangle, kTriangle);
  CHECK(polygon.distance(0) == 0);
  CHECK(abs(polygon.distance(3)) == 1);
  CHECK(polygon.distance(4) == -polygon.distance(3));
  CHECK(polygon.parts({0, 3, 4}));
  CHECK(!polygon.parts({0, 1, 3}));
  CHECK(polygon.is_coplanar({0, 1, 2}));
}

TEST_CASE("the tetrahedra around an edge that pierces the polygon") {
  const PolygonInSpace polygon(kPiercedTriangle, kTriangle);
  const std::vector<Simplex> around = {{0, 1, 3, 4}, {0, 2, 3, 4}, {1, 2, 3, 4}};
  CHECK(crossed_tetrahedra(StarIndex(around), polygon) ==
        std::set<Simplex>(around.begin(), around.end()));
  CHECK(facets_included_in(StarIndex(around), polygon).empty());

  const StarIndex parted({{0, 1, 2, 3}, {0, 1, 2, 4}});
  CHECK(crossed_tetrahedra(parted, polygon).empty());
  CHECK(facets_included_in(parted, polygon) == std::set<Simplex>{{0, 1, 2}});
}

TEST_CASE("only what the polygon covers counts, not its plane") {
  // Two such places side by side; the polygon covers the first.
  std::vector<Point> points = kPiercedTriangle.points();
  points.push_back({4, 4, 0});
  points.push_back({3, 3, 1});
  points.push_back({3, 3, -1});
  const PointSet set(points);
  const StarIndex tetrahedra(
      {{0, 1, 3, 4}, {0, 2, 3, 4}, {1, 2, 3, 4}, {1, 5, 6, 7}, {2, 5, 6, 7}, {1, 2, 6, 7}});
  const PolygonInSpace polygon(set, kTriangle);
  CHECK(crossed_tetrahedra(tetrahedra, polygon) ==
        std::set<Simplex>{{0, 1, 3, 4}, {0, 2, 3, 4}, {1, 2, 3, 4}});
}

}  // namespace

// ---- FlipInsertPolygon, and the times of its events ----

// ---- Times of events ----

namespace {

// Three tetrahedra around the edge 3 4, which pierces the triangle 0 1 2.
struct Pierced {
  PointSet points{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 1}, {1, 1, -1}}};
  Polygon triangle{{0, 1, 2}, {{0, 1}, {0, 2}, {1, 2}}, {}, {0, 1}, {{0, 1, 2}}};
  PolygonInSpace polygon{points, triangle};
};

TEST_CASE("when two tetrahedra become cohyperplanar, to the last infinitesimal") {
  const Pierced p;
  // (p3 + p4) / 2 = p0 / 2 + p1 / 4 + p2 / 4; the means of |v|² are 3 and 8, the vertex on the
  // right is at distance 1, so 3 + κ/2 = 8.
  const auto time = event_time(p.polygon, {0, 1, 3, 4}, 2);
  REQUIRE(time.has_value());
  CHECK(time->standard == 10);
  // The lexicographic order is 0, 2, 4, 3, 1.
  const std::vector<std::pair<std::size_t, Rational>> infinitesimal = {
      {0, -1}, {1, Rational(-1, 2)}, {2, 1}, {3, 1}, {4, Rational(-1, 2)}};
  CHECK(time->infinitesimal == infinitesimal);
  // The other two facets at the edge belong to the same flip.
  CHECK(event_time(p.polygon, {0, 2, 3, 4}, 1) == time);
  CHECK(event_time(p.polygon, {1, 2, 3, 4}, 0) == time);
}

TEST_CASE("no event for a facet that will not have to go") {
  const Pierced p;
  CHECK(!event_time(p.polygon, {0, 1, 2, 3}, 4));
}

TEST_CASE("times are ordered by the first number in which they differ") {
  const EventTime early{1, {{0, 1}}}, late{2, {}};
  CHECK(early < late);
  const EventTime none{1, {}}, less{1, {{0, -1}}}, later{1, {{3, 1}}}, more{1, {{0, 1}, {3, -9}}};
  CHECK(less < none);
  CHECK(none < later);
  CHECK(later < more);
  CHECK(less < more);
  CHECK(more < early);
  CHECK(early == EventTime{1, {{0, 1}}});
}

// ---- FlipInsertPolygon ----

PiecewiseLinearComplex complex_of(const std::vector<Point>& points,
                                  const std::vector<PolygonLines>& polygons) {
  return assemble({points, {}, polygons, {}, DomainKind::kHull});
}

// Inserts the only polygon by flips; the cavities must lead to the same.
PolygonFlips inserted(const PiecewiseLinearComplex& complex, EvolvingCdt& cdt) {
  EvolvingCdt by_cavity = cdt;
  auto run = flip_insert_polygon(complex.points, cdt, complex.polygons.front());
  REQUIRE(run.has_value());
  CHECK(!insert_polygon_by_cavity(complex.points, by_cavity, complex.polygons.front()));
  CHECK(by_cavity == cdt);
  return *std::move(run);
}

TEST_CASE("an edge that pierces a triangle goes in one 3-2 flip; then nothing is left to do") {
  const auto complex =
      complex_of({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 1}, {1, 1, -1}}, {{{{0, 1, 2}}, {}}});
  EvolvingCdt cdt = evolving_delaunay(complex.points);
  CHECK(cdt.tetrahedra.size() == 3);
  const PolygonFlips run = inserted(complex, cdt);
  CHECK(run.vertices == 5);
  REQUIRE(run.flips.size() == 1);
  CHECK(run.flips[0].flip.name() == "3-2");
  CHECK(run.flips[0].time.standard == 10);
  CHECK(run.held_back == 0);
  CHECK(cdt.tetrahedra.simplices() == std::set<Simplex>{{0, 1, 2, 3}, {0, 1, 2, 4}});
  CHECK(cdt.walls == std::set<Simplex>{{0, 1, 2}});
  CHECK(inserted(complex, cdt).flips.empty());
}

// The corners of an 8 by 8 square, its middle hole of 2 by 2, and two points on each side of the
// square's ring.
PiecewiseLinearComplex ring() {
  std::vector<Point> points;
  for (const long r : {4, 1}) {
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
      points.push_back({Rational(r * x), Rational(r * y), 0});
    }
  }
  for (const long z : {1, -1}) {
    points.push_back({Rational(5, 2), Rational(z, 7), Rational(z, 2)});
    points.push_back({Rational(z, 9), Rational(5, 2), Rational(z, 2)});
    points.push_back({Rational(-5, 2), Rational(z, 8), Rational(z, 2)});
    points.push_back({Rational(z, 6), Rational(-5, 2), Rational(z, 2)});
    points.push_back({0, 0, Rational(5 * z)});
  }
  return complex_of(points, {{{{0, 1, 2, 3}, {4, 5, 6, 7}}, {{0, 0, 0}}}});
}

TEST_CASE("a polygon with a hole: nothing in the hole changes") {
  const PiecewiseLinearComplex complex = ring();
  EvolvingCdt cdt = evolving_delaunay(complex.points);
  for (const Simplex& segment : complex.segments) {
    CAPTURE(segment[0]);
    CAPTURE(segment[1]);
    REQUIRE(!cdt.tetrahedra.star(segment).empty());
  }
  const PolygonFlips run = inserted(complex, cdt);
  CHECK(run.flips.size() >= 4);
  CHECK(cdt.walls.size() == 8);
  for (std::size_t i = 1; i < run.flips.size(); ++i) {
    CHECK(run.flips[i - 1].time < run.flips[i].time);
  }
}

TEST_CASE("without one of its segments a polygon cannot be inserted, and nothing has changed") {
  // The edge 0 1 passes between 2, 3, 4 and 5, which are close together.
  const auto complex =
      complex_of({{-9, 0, 0}, {9, 0, 0}, {0, 1, 1}, {0, -1, 1}, {0, 1, -1}, {0, -1, -1}, {0, 9, 0}},
                 {{{{0, 1, 6}}, {}}});
  const EvolvingCdt before = evolving_delaunay(complex.points);
  EvolvingCdt cdt = before;
  const auto run = flip_insert_polygon(complex.points, cdt, complex.polygons.front());
  REQUIRE(!run.has_value());
  CHECK(run.error() == NoChange{WhyNoChange::kSegmentMissing, {0, 1}});
  CHECK(insert_polygon_by_cavity(complex.points, cdt, complex.polygons.front()) == run.error());
  CHECK(cdt == before);
}

TEST_CASE("a polygon that leaves no triangulation is not inserted (Exercise 5)") {
  PiecewiseLinearInput input = generators::prism_on_a_sphere(true);
  input.kind = DomainKind::kHull;
  const PiecewiseLinearComplex closed = assemble(input);
  const Polygon floor = closed.polygons.back();
  REQUIRE(floor.vertices == std::vector<Vertex>{0, 1, 2});
  PiecewiseLinearComplex open = closed;
  open.polygons.pop_back();
  // All on one sphere: a CDT, though not the canonical one, which there is not.
  const EvolvingCdt before = evolving_cdt(open, {{{0, 1, 3, 4},
                                                  {0, 1, 4, 6},
                                                  {0, 2, 3, 5},
                                                  {0, 2, 3, 6},
                                                  {0, 3, 4, 6},
                                                  {1, 2, 4, 5},
                                                  {1, 2, 5, 6},
                                                  {1, 4, 5, 6},
                                                  {2, 3, 5, 6},
                                                  {3, 4, 5, 6}},
                                                 {}});
  EvolvingCdt cdt = before;
  const auto run = flip_insert_polygon(closed.points, cdt, floor);
  REQUIRE(!run.has_value());
  CHECK(run.error().why == WhyNoChange::kFlipBlocked);
  CHECK(cdt == before);
  const auto wrong = insert_polygon_by_cavity(closed.points, cdt, floor);
  REQUIRE(wrong.has_value());
  CHECK(wrong->why == WhyNoChange::kFacetUnfinished);
  CHECK(cdt == before);
}

// ---- CDTs by polygon insertion, carved to the domain; and polygons deleted ----

using generators::both;
using generators::box;

PlcTriangulation made(const PiecewiseLinearInput& input) {
  const PiecewiseLinearComplex complex = assemble(input);
  PolygonInsertionOptions options;
  const auto by_flips = cdt_by_polygon_insertion(complex, options);
  REQUIRE(by_flips.has_value());
  options.by = PolygonInsertion::kCavities;
  CHECK(cdt_by_polygon_insertion(complex, options).value() == *by_flips);
  CHECK(gift_wrapping_cdt(complex).value() == *by_flips);
  return *by_flips;
}

TEST_CASE("a box, a box within a box, and the same as a cavity") {
  const std::size_t tetrahedra = made(box(0, 1)).simplices.size();
  CHECK(tetrahedra == 6);
  CHECK(made(box(0, 1)).dangling.empty());
  PiecewiseLinearInput nested = both(box(0, 12), box(4, 8));
  const PlcTriangulation whole = made(nested);
  nested.hole_seeds = {{5, 6, 7}};
  const PlcTriangulation hollow = made(nested);
  CHECK(hollow.simplices.size() == whole.simplices.size() - 6);
  CHECK(hollow.dangling.empty());
}

TEST_CASE("a domain that is not convex is carved from its hull") {
  // A prism over an L; the tetrahedra in the notch go.
  PiecewiseLinearInput input;
  for (const long z : {0, 4}) {
    for (const auto& [x, y] : {std::pair{0, 0}, {8, 0}, {8, 4}, {4, 4}, {4, 8}, std::pair{0, 8}}) {
      input.points.push_back({x, y, z});
    }
  }
  input.polygons = {{{{0, 1, 2, 3, 4, 5}}, {}}, {{{6, 7, 8, 9, 10, 11}}, {}}};
  for (Vertex v = 0; v < 6; ++v) {
    const Vertex w = (v + 1) % 6;
    input.polygons.push_back({{{v, w, w + 6, v + 6}}, {}});
  }
  const PlcTriangulation carved = made(input);
  CHECK(carved.dangling.empty());
  input.kind = DomainKind::kHull;
  const PlcTriangulation hull = made(input);
  CHECK(hull.simplices.size() > carved.simplices.size());
  CHECK(std::includes(hull.simplices.begin(), hull.simplices.end(), carved.simplices.begin(),
                      carved.simplices.end()));
}

TEST_CASE("what dangles, inside and outside") {
  PiecewiseLinearInput input = box(0, 4);
  input.points.insert(input.points.end(), {{1, 1, 2},
                                           {3, 1, 2},
                                           {2, 3, 2},
                                           {9, 0, 0},
                                           {9, 1, 0},
                                           {9, 0, 1},
                                           {-2, 0, 0},
                                           {-2, 0, 1},
                                           {-3, 3, 3}});
  input.polygons.push_back({{{8, 9, 10}}, {}});
  input.polygons.push_back({{{11, 12, 13}}, {}});
  input.segments.push_back({14, 15});
  const PlcTriangulation cdt = made(input);
  CHECK(cdt.dangling == std::vector<Simplex>{{11, 12, 13}, {14, 15}, {16}});
}

TEST_CASE("polygons that enclose nothing, and polygons in one plane with all the rest") {
  PiecewiseLinearInput open = box(0, 1);
  open.polygons.pop_back();
  CHECK(made(open).simplices.empty());
  CHECK(made(open).dangling.size() == 10);

  PiecewiseLinearInput flat{
      {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {5, 5, 0}}, {}, {}, {}, {}};
  flat.polygons = {{{{0, 1, 2, 3}}, {}}};
  CHECK(made(flat).simplices.empty());
  CHECK(made(flat).dangling.size() == 3);
}

TEST_CASE("a segment that is no Delaunay edge is named (Figure 4.10)") {
  const auto failed = cdt_by_polygon_insertion(assemble(generators::schonhardt()));
  REQUIRE(!failed.has_value());
  CHECK(failed.error().cause.why == WhyNoChange::kSegmentMissing);
  CHECK(!failed.error().polygon.has_value());
}

TEST_CASE("without its polygon the CDT is Delaunay again") {
  PiecewiseLinearInput input{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 1}, {1, 1, -1}},
                             {},
                             {{{{0, 1, 2}}, {}}},
                             {},
                             DomainKind::kHull};
  const PiecewiseLinearComplex complex = assemble(input);
  EvolvingCdt cdt = hull_cdt_by_polygon_insertion(complex).value();
  CHECK(cdt == evolving_cdt(complex, carve(complex, cdt)));
  CHECK(cdt.tetrahedra.size() == 2);
  CHECK(!delete_polygon(complex.points, cdt, complex.polygons.front()));
  CHECK(cdt.walls.empty());
  CHECK(cdt.tetrahedra.simplices() == evolving_delaunay(complex.points).tetrahedra.simplices());
}

// The obstacle to deleting the polygon from the CDT, which is found by gift-wrapping.
WhyNoChange why_not_deleted(const std::vector<Point>& points,
                            const std::vector<std::vector<Vertex>>& segments,
                            const std::vector<std::vector<Vertex>>& polygons, std::size_t place) {
  PiecewiseLinearInput input{points, segments, {}, {}, DomainKind::kHull};
  for (const auto& line : polygons) input.polygons.push_back({{line}, {}});
  const PiecewiseLinearComplex complex = assemble(input);
  EvolvingCdt cdt = evolving_cdt(complex, gift_wrapping_cdt(complex).value());
  const EvolvingCdt before = cdt;
  const auto wrong = delete_polygon(complex.points, cdt, complex.polygons[place]);
  REQUIRE(wrong.has_value());
  CHECK(cdt == before);
  PiecewiseLinearComplex others = complex;
  others.polygons.erase(others.polygons.begin() + static_cast<std::ptrdiff_t>(place));
  CHECK(!gift_wrapping_cdt(others).has_value());
  return wrong->why;
}

TEST_CASE("a polygon without which there is no CDT is not deleted") {
  CHECK(why_not_deleted({{1, 0, 5}, {5, 0, -1}, {0, -5, -1}, {-1, -5, 0}, {0, 1, 5}},
                        {{0, 4}, {0, 1}, {0, 3}}, {{2, 0, 4}, {2, 4, 1}},
                        0) == WhyNoChange::kFacetUnfinished);
  CHECK(why_not_deleted({{0, 4, -4}, {-4, 4, 0}, {4, 4, 0}, {4, -4, 0}, {4, 0, -4}}, {},
                        {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}},
                        2) == WhyNoChange::kSimplicesOverlap);
  CHECK(
      why_not_deleted(
          {{3, -16, -20}, {-3, 18, -16}, {17, 20, 15}, {10, 19, -5}, {-17, 16, -20}, {-10, -15, 6}},
          {{1, 2}, {3, 4}, {1, 4}}, {{4, 0, 2}, {2, 5, 0}}, 0) == WhyNoChange::kSegmentLost);
}

}  // namespace

}  // namespace circumspect::constrained
