// The Delaunay subdivision as a lower hull, on sets whose answer is known.
#include "reference/delaunay/lifted_hull.hpp"

#include <doctest/doctest.h>

#include "reference/delaunay/by_definition.hpp"

namespace circumspect::delaunay {
namespace {

using Faces = std::vector<Face>;

TEST_CASE("lifted hull: a grid of squares is its own subdivision") {
  std::vector<Point> grid;
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 3; ++y) grid.push_back({x, y});
  }
  const PointSet points(grid);
  for (const PolyhedralComplex& subdivision :
       {delaunay_subdivision(points), delaunay_subdivision_by_definition(points)}) {
    CHECK(subdivision.cells() == Faces{{0, 1, 3, 4}, {1, 2, 4, 5}, {3, 4, 6, 7}, {4, 5, 7, 8}});
    CHECK(subdivision.faces(1).size() == 12);
    CHECK(subdivision.faces(0).size() == 9);
  }
  CHECK(lifted_hull(points) == by_definition(points));
}

TEST_CASE("lifted hull: all points on one sphere are one cell") {
  const PointSet points({{3, 4}, {-3, 4}, {5, 0}, {0, -5}, {-4, -3}});
  CHECK(delaunay_subdivision(points).cells() == Faces{{0, 1, 2, 3, 4}});
  CHECK(delaunay_subdivision_by_definition(points).cells() == Faces{{0, 1, 2, 3, 4}});
  CHECK(lifted_hull(points).simplices().size() == 3);
}

TEST_CASE("lifted hull: a cell may face up or stand upright, and is none then") {
  // Three points on the x-axis: the facets of conv S+ over the axis are vertical.
  const PointSet points({{0, 0}, {1, 0}, {2, 0}, {1, 5}, {1, -5}});
  CHECK(delaunay_subdivision(points).cells() == Faces{{0, 1, 3}, {0, 1, 4}, {1, 2, 3}, {1, 2, 4}});
}

TEST_CASE("lifted hull: no point, one, two, and points of a plane in space") {
  CHECK(delaunay_subdivision(PointSet({})).dimension() == -1);
  CHECK(lifted_hull(PointSet({})) == Triangulation(-1, {}));
  CHECK(lifted_hull(PointSet({{1, 2, 3}})) == Triangulation(0, {{0}}));
  CHECK(lifted_hull(PointSet({{1, 2, 3}, {4, 4, 4}})) == Triangulation(1, {{0, 1}}));
  const PointSet square({{0, 0, 0}, {1, 1, 0}, {1, 1, 1}, {0, 0, 1}});  // on x = y
  CHECK(delaunay_subdivision(square).dimension() == 2);
  CHECK(delaunay_subdivision(square).cells() == Faces{{0, 1, 2, 3}});
}

TEST_CASE("lifted hull: weights submerge points, or leave them on a face without being extreme") {
  const std::vector<Point> line = {{0}, {1}, {2}};
  const auto with_middle_weight = [&](const Rational& weight) {
    return PointSet(line, {0, weight, 0});
  };
  CHECK(delaunay_subdivision(with_middle_weight(-2)).cells() == Faces{{0, 2}});  // above the hull
  CHECK(delaunay_subdivision(with_middle_weight(-1)).cells() == Faces{{0, 1, 2}});  // on it
  CHECK(delaunay_subdivision(with_middle_weight(0)).cells() == Faces{{0, 1}, {1, 2}});
  CHECK(delaunay_subdivision(with_middle_weight(-1)).faces(0) == Faces{{0}, {2}});
  // Pulling the first point down leaves the middle one above.
  CHECK(lifted_hull(with_middle_weight(-1)) == Triangulation(1, {{0, 2}}));
  CHECK(lifted_hull(with_middle_weight(-1)) == by_definition(with_middle_weight(-1)));
}

}  // namespace
}  // namespace circumspect::delaunay
