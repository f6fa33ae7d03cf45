// Conforming Delaunay triangulations, and limits reached. Book: Section 4.5.3.
#include "reference/constrained/conforming_delaunay.hpp"

#include <doctest/doctest.h>

#include "inputs/named_complexes.hpp"
#include "kernel/complex/circumball.hpp"
#include "reference/constrained/edge_protection.hpp"
#include "reference/constrained/gift_wrapping_cdt.hpp"

namespace circumspect::constrained {
namespace {

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

}  // namespace
}  // namespace circumspect::constrained
