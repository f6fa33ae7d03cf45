// Gift-wrapping and its seeds, on sets whose answer is known. Book: Section 5.6.
#include "reference/delaunay/gift_wrapping.hpp"

#include <stdexcept>

#include <doctest/doctest.h>

#include "reference/delaunay/gift_wrapping_cells.hpp"
#include "reference/delaunay/lifted_hull.hpp"

namespace circumspect::delaunay {
namespace {

TEST_CASE("gift-wrapping: the apex is in front, and nearest in the pencil of circles") {
  const PointSet points({{0, 0}, {4, 0}, {2, 9}, {2, 1}, {2, 5}, {2, -1}, {6, 0}});
  const std::vector<std::size_t> axes = {0, 1};
  const OrientedFacet edge = OrientedFacet::of({0, 1});
  CHECK(apex_of_facet(points, axes, edge, {2, 3, 4, 5, 6}) == 3);
  CHECK(apex_of_facet(points, axes, edge, {2, 4, 5, 6}) == 4);
  CHECK(apex_of_facet(points, axes, edge.reverse(), {2, 3, 4, 5, 6}) == 5);
  CHECK_FALSE(apex_of_facet(points, axes, edge, {0, 1, 5, 6}).has_value());
}

// Figure 3.14: cocircular points on which gift-wrapping without perturbation goes wrong.
TEST_CASE("gift-wrapping: eight cospherical points of a cube, and six of an octahedron") {
  std::vector<Point> corners;
  for (int i = 0; i < 8; ++i) corners.push_back({i & 1, (i >> 1) & 1, i >> 2});
  const PointSet cube(corners);
  CHECK(gift_wrapping(cube) == by_definition(cube));
  CHECK(gift_wrapping_by_cells(cube) == by_definition(cube));
  CHECK(gift_wrapping_cells(cube).cells() == std::vector<Face>{{0, 1, 2, 3, 4, 5, 6, 7}});
  const PointSet octahedron({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}});
  CHECK(gift_wrapping(octahedron).simplices().size() == 4);
  CHECK(gift_wrapping(octahedron) == by_definition(octahedron));
}

TEST_CASE("gift-wrapping: no point, one, points on a line, submerged points") {
  for (const auto algorithm :
       {+[](const PointSet& points) { return gift_wrapping(points); }, gift_wrapping_by_cells}) {
    CHECK(algorithm(PointSet({})) == Triangulation(-1, {}));
    CHECK(algorithm(PointSet({{1, 2}})) == Triangulation(0, {{0}}));
    CHECK(algorithm(PointSet({{3, 3}, {1, 1}, {2, 2}})) == Triangulation(1, {{0, 2}, {1, 2}}));
    CHECK(algorithm(PointSet({{3}, {1}, {2}}, {0, 0, -5})) == Triangulation(1, {{0, 1}}));
  }
}

TEST_CASE("gift-wrapping: the nearest-neighbour seed (Section 5.6)") {
  const PointSet points({{0, 0, 0}, {9, 1, 0}, {2, 0, 1}, {1, 3, 0}, {1, 1, 7}, {-8, 2, 2}});
  CHECK(nearest_neighbour_seed(points) == Simplex{0, 2, 3});
  CHECK(gift_wrapping(points, {0, 2, 3}) == by_definition(points));
  CHECK(nearest_neighbour_seed(PointSet({{5}, {9}, {1}})) == Simplex{0});
}

TEST_CASE("gift-wrapping: facets that no triangulation has together are found out") {
  const PointSet points({{-9, 0}, {0, -1}, {8, 0}, {0, 1}});
  UnfinishedFacets crossing;
  crossing.add(OrientedFacet::of({1, 3}));
  crossing.add(OrientedFacet::of({0, 2}));
  crossing.add(OrientedFacet::of({2, 0}));
  CHECK_THROWS_AS(gift_wrap(points, {0, 1}, crossing, all_vertices(points)), std::logic_error);
}

}  // namespace
}  // namespace circumspect::delaunay
