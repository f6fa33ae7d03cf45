// Facets of polytopes, and complexes of polytopes.
#include "kernel/complex/polytope.hpp"

#include <algorithm>

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "kernel/complex/polyhedral_complex.hpp"
#include "properties/arguments/point_sets.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect {
namespace {

using Faces = std::vector<Face>;

// Corner i of the unit cube has the binary digits of i for coordinates.
PointSet cube(std::size_t dimension) {
  std::vector<Point> corners;
  for (std::size_t i = 0; i < (std::size_t{1} << dimension); ++i) {
    Point corner;
    for (std::size_t axis = 0; axis < dimension; ++axis)
      corner.push_back(Rational((i >> axis) & 1));
    corners.push_back(corner);
  }
  return PointSet(corners);
}

TEST_CASE("polytope: a point has no facets, a segment its ends, a cube its squares") {
  for (const auto facets : {facets_by_definition, facets_by_wrapping}) {
    const PointSet points = cube(3);
    CHECK(facets(points, {5}).empty());
    CHECK(facets(points, {2, 5}) == Faces{{2}, {5}});
    CHECK(facets(points, {0, 1, 2, 3}) == Faces{{0, 1}, {0, 2}, {1, 3}, {2, 3}});
    CHECK(
        facets(points, all_vertices(points)) ==
        Faces{{0, 1, 2, 3}, {0, 1, 4, 5}, {0, 2, 4, 6}, {1, 3, 5, 7}, {2, 3, 6, 7}, {4, 5, 6, 7}});
  }
}

TEST_CASE("polytope: a hypercube has eight cubes, also where it is not wrapped from a corner") {
  const PointSet points = cube(4);
  const Faces facets = facets_by_wrapping(points, all_vertices(points));
  CHECK(facets.size() == 8);
  CHECK(std::all_of(facets.begin(), facets.end(), [](const Face& f) { return f.size() == 8; }));
  CHECK(facets == facets_by_definition(points, all_vertices(points)));
}

TEST_CASE("polytope: points that are not extreme are on their facets, or on none") {
  // A square with the middle of an edge and of the whole; the ends of a line with a middle.
  const PointSet points({{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0}, {1, 1}});
  for (const auto facets : {facets_by_definition, facets_by_wrapping}) {
    CHECK(facets(points, all_vertices(points)) == Faces{{0, 1, 4}, {0, 3}, {1, 2}, {2, 3}});
    CHECK(facets(points, {0, 1, 4}) == Faces{{0}, {1}});
  }
}

TEST_CASE("polytope: some facet, where a projection hides others behind each other") {
  const PointSet points = cube(3);
  const Face facet = some_facet(points, {0, 1, 2}, all_vertices(points));
  CHECK(facet.size() == 4);
  const Faces facets = facets_by_definition(points, all_vertices(points));
  CHECK(std::count(facets.begin(), facets.end(), facet) == 1);
  CHECK(some_facet(points, {1}, all_vertices(points)) == Face{0, 1, 4, 5});
}

TEST_CASE("polytope: by definition and by wrapping agree") {
  for (const std::size_t d : {1u, 2u, 3u, 4u}) {
    CAPTURE(d);
    CHECK(properties::holds("facets", [d] {
      const PointSet points((*generators::any_unweighted_case(d, d == 4 ? 9 : 11)).points);
      RC_PRE(!points.empty());
      const Face all = all_vertices(points);
      const Faces facets = facets_by_wrapping(points, all);
      RC_ASSERT(facets == facets_by_definition(points, all));
      RC_PRE(points.dimension() >= 1);
      const Face one = some_facet(points, flat_through(points, all).axes, all);
      RC_ASSERT(std::count(facets.begin(), facets.end(), one) == 1);
    }));
  }
}

// Book: Figure 4.4, two cubes that share a square.
PointSet two_cubes() {
  std::vector<Point> points;
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 2; ++y) {
      for (int z = 0; z < 2; ++z) points.push_back({x, y, z});
    }
  }
  return PointSet(points);
}

TEST_CASE("polyhedral complex: two cubes that share a square (Figure 4.4)") {
  const PointSet points = two_cubes();
  const std::vector<Face> cells = {{4, 5, 6, 7, 8, 9, 10, 11}, {3, 2, 1, 0, 7, 6, 5, 4}};
  const PolyhedralComplex complex(points, 3, cells, facets_by_wrapping);
  CHECK(complex.dimension() == 3);
  CHECK(complex.faces(0).size() == 12);
  CHECK(complex.faces(1).size() == 20);
  CHECK(complex.faces(2).size() == 11);
  CHECK(complex.cells() == std::vector<Face>{{0, 1, 2, 3, 4, 5, 6, 7}, {4, 5, 6, 7, 8, 9, 10, 11}});
  CHECK(complex.facets_of(complex.cells()[0]).size() == 6);
  CHECK(complex.facets_of({4, 5, 6, 7}) == std::vector<Face>{{4, 5}, {4, 6}, {5, 7}, {6, 7}});
  CHECK_FALSE(complex.is_simplicial());
  CHECK(complex == PolyhedralComplex(points, 3, cells, facets_by_definition));
  CHECK_FALSE(complex == PolyhedralComplex(points, 3, {cells[0]}, facets_by_wrapping));
}

TEST_CASE("polyhedral complex: vertices of a face leave out what is not extreme") {
  const PointSet points({{0, 0}, {2, 0}, {0, 2}, {1, 0}, {Rational(1, 2), Rational(1, 2)}});
  const PolyhedralComplex complex(points, 2, {{0, 1, 2, 3, 4}}, facets_by_wrapping);
  CHECK(complex.vertices_of({0, 1, 2, 3, 4}) == Simplex{0, 1, 2});
  CHECK(complex.vertices_of({0, 1, 3}) == Simplex{0, 1});
  CHECK(complex.faces(1) == std::vector<Face>{{0, 1, 3}, {0, 2}, {1, 2}});
  CHECK_FALSE(complex.is_simplicial());
}

TEST_CASE("polyhedral complex: empty, and a point") {
  const PolyhedralComplex empty(PointSet({}), -1, {}, facets_by_wrapping);
  CHECK(empty.dimension() == -1);
  CHECK(empty.cells().empty());
  CHECK(empty.is_simplicial());
  const PolyhedralComplex point(PointSet({{3, 4}}), 0, {{0}}, facets_by_wrapping);
  CHECK(point.cells() == std::vector<Face>{{0}});
  CHECK(point.facets_of({0}).empty());
}

}  // namespace
}  // namespace circumspect
