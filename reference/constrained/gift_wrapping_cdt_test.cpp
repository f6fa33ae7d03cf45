// CDTs of complexes in space whose answer is known, and of complexes that have none. Book: Section
// 5.6.
#include "reference/constrained/gift_wrapping_cdt.hpp"

#include <algorithm>

#include <doctest/doctest.h>

#include "inputs/named_complexes.hpp"
#include "kernel/predicates/orientation.hpp"
#include "reference/constrained/evolving_cdt.hpp"
#include "reference/constrained/plc_triangulation.hpp"
#include "reference/delaunay/lifted_hull.hpp"

namespace circumspect::constrained {
namespace {

using generators::both;
using generators::box;

tl::expected<PlcTriangulation, NoCdt> cdt_of(const PiecewiseLinearInput& input) {
  return gift_wrapping_cdt(assemble(input));
}

std::vector<Simplex> delaunay_of(const PiecewiseLinearInput& input) {
  return delaunay::by_definition(PointSet(input.points)).simplices();
}

Rational volume(const PiecewiseLinearInput& input, const std::vector<Simplex>& tetrahedra) {
  const PointSet points(input.points);
  Rational sum = 0;
  for (const Simplex& tetrahedron : tetrahedra) {
    const Rational part = orientation_determinant(points.configuration(),
                                                  std::vector<std::size_t>{0, 1, 2}, tetrahedron);
    sum += sign(part) * part / 6;
  }
  return sum;
}

// The same with other coordinates for the vertices.
template <typename Map>
PiecewiseLinearInput moved(PiecewiseLinearInput input, const Map& map) {
  for (Point& point : input.points) point = map(point);
  return input;
}

TEST_CASE("gift-wrapping a CDT: convex complexes have the Delaunay triangulation") {
  const PiecewiseLinearInput cube = box(0, 1);
  const auto answer = cdt_of(cube);
  REQUIRE(answer.has_value());
  CHECK(answer->simplices == delaunay_of(cube));
  CHECK(answer->dangling.empty());

  PiecewiseLinearInput with_vertices = box(0, 4);
  with_vertices.points.insert(with_vertices.points.end(),
                              {{1, 1, 1}, {2, 2, 2}, {2, 2, 4}, {4, 2, 0}, {3, 1, 2}});
  // The vertex in the edge 1 3 of the cube needs to be one of both squares.
  with_vertices.polygons[0].lines[0] = {0, 1, 11, 3, 2};
  with_vertices.polygons[5].lines[0] = {1, 11, 3, 7, 5};
  const auto more = cdt_of(with_vertices);
  REQUIRE(more.has_value());
  CHECK(more->simplices == delaunay_of(with_vertices));
}

TEST_CASE("gift-wrapping a CDT: the hull kind, with polygons, segments, or nothing inside") {
  PiecewiseLinearInput input;
  input.kind = DomainKind::kHull;
  for (int i = 0; i < 27; i += 2) input.points.push_back({i % 3, i / 3 % 3, i / 9});
  const auto bare = cdt_of(input);
  REQUIRE(bare.has_value());
  CHECK(bare->simplices == delaunay_of(input));

  PiecewiseLinearInput floating = both(box(0, 9), box(4, 5));
  floating.polygons.erase(floating.polygons.begin(), floating.polygons.begin() + 6);
  floating.kind = DomainKind::kHull;
  floating.segments = {{7, 15}, {0, 8}};
  const auto answer = cdt_of(floating);
  REQUIRE(answer.has_value());
  CHECK(answer->simplices == delaunay_of(floating));
  CHECK(answer->dangling.empty());
  floating.segments = {{0, 15}};  // Vertex 8 is in between.
  floating.points[8] = {3, 4, 5};
  floating.polygons.clear();
  const auto none = cdt_of(floating);
  REQUIRE_FALSE(none.has_value());
  CHECK(none.error().why == WhyNoCdt::kSegmentCrosses);
  CHECK(none.error().witness == Simplex{0, 15});
}

TEST_CASE("gift-wrapping a CDT: Schonhardt's polyhedron has none, with vertices on edges it has") {
  PiecewiseLinearInput input = generators::schonhardt();
  const auto none = cdt_of(input);
  REQUIRE_FALSE(none.has_value());
  // Vertex 5 is the first that is visible from the facet 0 1 2, but not from all of it.
  CHECK(none.error() == NoCdt{WhyNoCdt::kPolygonCrosses, {0, 1, 2, 5}, {0, 2, 3}});
  // A vertex in the middle gives it a triangulation, but no CDT: seen from there, the two facets at
  // a reflex edge fall back too steeply.
  PiecewiseLinearInput centred = input;
  centred.points.push_back({0, 0, 5});
  const auto not_constrained_delaunay = cdt_of(centred);
  REQUIRE_FALSE(not_constrained_delaunay.has_value());
  CHECK(not_constrained_delaunay.error() == NoCdt{WhyNoCdt::kNotLocallyDelaunay, {0, 4, 6}, {3}});
  // Vertices in the middle of the reflex edges protect them.
  for (Vertex i = 0; i < 3; ++i) {
    const Vertex next = (i + 1) % 3, middle = 6 + i;
    input.points.push_back(barycentre({input.points[static_cast<std::size_t>(i)],
                                       input.points[static_cast<std::size_t>(next + 3)]}));
    auto side = input.polygons.begin() + 2 + 2 * i;
    side[0].lines = {{i, next, next + 3, middle}};
    side[1].lines = {{i, middle, next + 3, i + 3}};
  }
  const auto answer = cdt_of(input);
  REQUIRE(answer.has_value());
  CHECK(answer->simplices.size() == 11);
  CHECK(answer->dangling.empty());
}

TEST_CASE("gift-wrapping a CDT: segments that are not there (Figures 4.12 and 4.15)") {
  const auto encircled = cdt_of(generators::encircled_segment());
  REQUIRE_FALSE(encircled.has_value());
  CHECK(encircled.error() == NoCdt{WhyNoCdt::kSegmentCrosses, {0, 1, 2, 3}, {3, 4}});
  PiecewiseLinearInput without = generators::encircled_segment();
  without.segments.clear();
  CHECK(cdt_of(without).value().simplices == std::vector<Simplex>{{0, 1, 2, 3}, {0, 1, 2, 4}});
  CHECK_FALSE(cdt_of(generators::cube_with_three_segments()).has_value());
  // The diagonal of a face that the canonical triangulation does not have; the other it has.
  PiecewiseLinearInput cube = box(0, 1);
  cube.segments = {{1, 2}};
  CHECK(cdt_of(cube).error().why == WhyNoCdt::kSimplicesOverlap);
  cube.polygons.clear();
  cube.kind = DomainKind::kHull;
  CHECK(cdt_of(cube).error() == NoCdt{WhyNoCdt::kSegmentMissing, {}, {1, 2}});
  cube.segments = {{0, 3}};
  CHECK(cdt_of(cube).value().simplices == delaunay_of(cube));
}

TEST_CASE("gift-wrapping a CDT: a box in a box, full or hollow") {
  PiecewiseLinearInput nested = both(box(0, 9), box(3, 6));
  const auto full = cdt_of(nested);
  REQUIRE(full.has_value());
  CHECK(volume(nested, full->simplices) == 729);
  nested.hole_seeds = {{4, 4, 4}};
  const auto hollow = cdt_of(nested);
  REQUIRE(hollow.has_value());
  CHECK(volume(nested, hollow->simplices) == 729 - 27);
  CHECK(hollow->dangling.empty());
  CHECK(std::includes(full->simplices.begin(), full->simplices.end(), hollow->simplices.begin(),
                      hollow->simplices.end()));
  nested.hole_seeds = {{1, 1, 1}};
  CHECK(cdt_of(nested).value().simplices.size() == 6);  // The inner cube by itself.
}

TEST_CASE("gift-wrapping a CDT: an internal square that hides vertices from one another") {
  // Without the square an edge would join the two vertices that it separates.
  PiecewiseLinearInput input = box(0, 20);
  input.points.insert(
      input.points.end(),
      {{8, 8, 10}, {12, 8, 10}, {12, 12, 10}, {8, 12, 10}, {10, 10, 9}, {10, 10, 11}, {10, 11, 7}});
  const auto before = cdt_of(input);
  REQUIRE(before.has_value());
  CHECK(before->simplices == delaunay_of(input));
  CHECK(edges_of(before->simplices).contains({12, 13}));
  input.polygons.push_back({{{8, 9, 10, 11}}, {}});
  const auto after = cdt_of(input);
  REQUIRE(after.has_value());
  CHECK_FALSE(edges_of(after->simplices).contains({12, 13}));
  CHECK(volume(input, after->simplices) == 8000);
  CHECK(after->dangling.empty());
}

// The prism over a planar polygon, from height 0 to 1.
PiecewiseLinearInput prism(const std::vector<std::pair<int, int>>& outline) {
  PiecewiseLinearInput input;
  const auto size = static_cast<Vertex>(outline.size());
  std::vector<Vertex> below, above;
  for (const int height : {0, 1}) {
    for (const auto& [x, y] : outline) input.points.push_back({x, y, height});
  }
  for (Vertex i = 0; i < size; ++i) {
    below.push_back(i);
    above.push_back(i + size);
    const Vertex next = (i + 1) % size;
    input.polygons.push_back({{{i, next, next + size, i + size}}, {}});
  }
  input.polygons.push_back({{below}, {}});
  input.polygons.push_back({{above}, {}});
  return input;
}

TEST_CASE("gift-wrapping a CDT: prisms that are not convex") {
  const PiecewiseLinearInput l_shaped = prism({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
  const auto l = cdt_of(l_shaped);
  REQUIRE(l.has_value());
  CHECK(volume(l_shaped, l->simplices) == 3);
  const PiecewiseLinearInput comb = prism({{0, 0},
                                           {10, 0},
                                           {10, 5},
                                           {9, 5},
                                           {9, 1},
                                           {6, 1},
                                           {6, 5},
                                           {5, 5},
                                           {5, 1},
                                           {1, 1},
                                           {1, 5},
                                           {0, 5}});
  const auto c = cdt_of(comb);
  REQUIRE(c.has_value());
  CHECK(volume(comb, c->simplices) == 22);
}

TEST_CASE("gift-wrapping a CDT: boxes that share a polygon, polygons side by side in one plane") {
  PiecewiseLinearInput pair = box(0, 2);
  for (int corner = 0; corner < 4; ++corner) {
    pair.points.push_back({(corner & 1) * 2, (corner >> 1) * 2, 5});
  }
  for (const std::vector<Vertex>& square : {std::vector<Vertex>{8, 9, 11, 10},
                                            {4, 5, 9, 8},
                                            {6, 7, 11, 10},
                                            {4, 6, 10, 8},
                                            {5, 7, 11, 9}}) {
    pair.polygons.push_back({{square}, {}});
  }
  const auto answer = cdt_of(pair);
  REQUIRE(answer.has_value());
  CHECK(volume(pair, answer->simplices) == 20);
  CHECK(answer->simplices.size() == 12);
  pair.hole_seeds = {{1, 1, 1}};
  CHECK(volume(pair, cdt_of(pair).value().simplices) == 12);
}

TEST_CASE("gift-wrapping a CDT: dangling triangles, edges and vertices; slits") {
  PiecewiseLinearInput input = box(0, 2);
  input.points.insert(
      input.points.end(),
      {{5, 5, 5}, {5, 7, 5}, {5, 5, 8}, {9, 9, 9}, {1, 1, 0}, {Rational(1, 2), 1, 0}});
  input.polygons.push_back({{{8, 9, 10}}, {}});
  input.segments = {{7, 8}, {12, 13}};
  const auto answer = cdt_of(input);
  REQUIRE(answer.has_value());
  CHECK(answer->dangling == std::vector<Simplex>{{7, 8}, {8, 9, 10}, {11}});
  CHECK(edges_of(answer->simplices).contains({12, 13}));
  CHECK(volume(input, answer->simplices) == 8);
}

TEST_CASE("gift-wrapping a CDT: nothing enclosed; points of one plane") {
  CHECK(cdt_of({}).value() == PlcTriangulation{});
  PiecewiseLinearInput square;
  square.points = {{0, 0, 0}, {2, 0, 2}, {2, 2, 4}, {0, 2, 2}, {1, 0, 1}, {1, 1, 2}};
  square.polygons = {{{{0, 4, 1, 2, 5}}, {}}};
  CHECK(cdt_of(square).value() == PlcTriangulation{{}, {{0, 4, 5}, {1, 2, 5}, {1, 4, 5}, {3}}});
  square.kind = DomainKind::kHull;  // The hull has no volume: nothing more is enclosed.
  CHECK(cdt_of(square).value() == PlcTriangulation{{}, {{0, 4, 5}, {1, 2, 5}, {1, 4, 5}, {3}}});
}

}  // namespace
}  // namespace circumspect::constrained
