// FlipInsertPolygon, and the times of its events. Book: Section 5.8.
#include "reference/constrained/flip_insert_polygon.hpp"

#include <doctest/doctest.h>

#include "inputs/named_complexes.hpp"
#include "reference/constrained/cavity.hpp"
#include "reference/constrained/cdt_by_polygon_insertion.hpp"
#include "reference/constrained/evolving_cdt.hpp"
#include "reference/constrained/gift_wrapping_cdt.hpp"

namespace circumspect::constrained {
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

}  // namespace
}  // namespace circumspect::constrained
