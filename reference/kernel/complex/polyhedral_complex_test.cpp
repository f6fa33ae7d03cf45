// Cells and their face lattice.
#include "reference/kernel/complex/polyhedral_complex.hpp"

#include <doctest/doctest.h>

namespace circumspect {
namespace {

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
