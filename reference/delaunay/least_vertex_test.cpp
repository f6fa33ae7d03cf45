// The least-vertex triangulation of polyhedral complexes, of those too that are not Delaunay
// subdivisions. Book: Section 4.2.
#include <doctest/doctest.h>

#include "reference/delaunay/lifted_hull.hpp"

namespace circumspect::delaunay {
namespace {

TEST_CASE("least vertex: a square, by its lexicographically minimum vertex") {
  const PointSet points({{1, 1}, {1, 0}, {0, 1}, {0, 0}});
  const PolyhedralComplex square(points, 2, {{0, 1, 2, 3}}, facets_by_wrapping);
  CHECK(least_vertex_triangulation(points, square) == Triangulation(2, {{0, 1, 3}, {0, 2, 3}}));
}

TEST_CASE("least vertex: two cubes triangulate their common square alike (Figure 4.4)") {
  std::vector<Point> corners;
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 2; ++y) {
      for (int z = 0; z < 2; ++z) corners.push_back({x, y, z});
    }
  }
  const PointSet points(corners);
  const PolyhedralComplex cubes(points, 3, {{0, 1, 2, 3, 4, 5, 6, 7}, {4, 5, 6, 7, 8, 9, 10, 11}},
                                facets_by_wrapping);
  const Triangulation triangulation = least_vertex_triangulation(points, cubes);
  CHECK(triangulation.simplices().size() == 12);
  // The diagonal of the square adjoins its least vertex; both cubes have its two triangles.
  const auto apexes = apexes_by_facet(triangulation);
  CHECK(apexes.at({4, 5, 7}).size() == 2);
  CHECK(apexes.at({4, 6, 7}).size() == 2);
  CHECK(apexes.count({4, 5, 6}) == 0);
}

TEST_CASE("least vertex: a pentagon that no circle passes through") {
  const PointSet points({{5, 0}, {6, 3}, {1, 9}, {-4, 2}, {-3, -1}});
  const PolyhedralComplex pentagon(points, 2, {{0, 1, 2, 3, 4}}, facets_by_wrapping);
  CHECK(least_vertex_triangulation(points, pentagon) ==
        Triangulation(2, {{0, 1, 3}, {0, 3, 4}, {1, 2, 3}}));
}

TEST_CASE("least vertex: points that are not extreme remain unused") {
  // On a line, the points 1 and 2 lie between the ends 0 and 3.
  const PointSet line({{0}, {1}, {2}, {3}});
  const PolyhedralComplex segment(line, 1, {{0, 1, 2, 3}}, facets_by_wrapping);
  CHECK(least_vertex_triangulation(line, segment) == Triangulation(1, {{0, 3}}));
  // In a triangle, on an edge.
  const PointSet points({{0, 0}, {0, 4}, {3, 0}, {0, 2}});
  const PolyhedralComplex triangle(points, 2, {{0, 1, 2, 3}}, facets_by_wrapping);
  CHECK(least_vertex_triangulation(points, triangle) == Triangulation(2, {{0, 1, 2}}));
}

TEST_CASE("least vertex: the empty complex and a point") {
  const PointSet none(std::vector<Point>{});
  CHECK(least_vertex_triangulation(none, PolyhedralComplex(none, -1, {}, facets_by_wrapping)) ==
        Triangulation(-1, {}));
  const PointSet one(std::vector<Point>{{7}});
  CHECK(least_vertex_triangulation(one, PolyhedralComplex(one, 0, {{0}}, facets_by_wrapping)) ==
        Triangulation(0, {{0}}));
}

}  // namespace
}  // namespace circumspect::delaunay
