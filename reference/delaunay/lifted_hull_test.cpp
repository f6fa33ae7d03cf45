// The Delaunay triangulation from its definition, on sets whose triangulation is known, and the
// Delaunay subdivision as a lower hull. Book: Definition 4.1, Figures 4.1 and 4.2.
#include "reference/delaunay/lifted_hull.hpp"

#include <doctest/doctest.h>

namespace circumspect::delaunay {
namespace {

std::vector<Simplex> simplices(const std::vector<Point>& points,
                               const std::vector<Rational>& weights = {}) {
  return by_definition(PointSet(points, weights)).simplices();
}

TEST_CASE("by definition: of no point, one point, two points") {
  CHECK(by_definition(PointSet({})) == Triangulation(-1, {}));
  CHECK(by_definition(PointSet({{5, 5}})) == Triangulation(0, {{0}}));
  CHECK(by_definition(PointSet({{5, 5}, {0, 1}})) == Triangulation(1, {{0, 1}}));
}

TEST_CASE("by definition: points on a line are joined to their neighbours") {
  CHECK(simplices({{3}, {0}, {1}, {-2}}) == std::vector<Simplex>{{0, 2}, {1, 2}, {1, 3}});
  CHECK(simplices({{3, 6, 1}, {0, 0, 1}, {1, 2, 1}}) == std::vector<Simplex>{{0, 2}, {1, 2}});
}

TEST_CASE("by definition: the shorter diagonal of a kite, and never the flat triangle") {
  CHECK(simplices({{-2, 0}, {2, 0}, {0, 1}, {0, -1}}) ==
        std::vector<Simplex>{{0, 2, 3}, {1, 2, 3}});
  CHECK(simplices({{0, 0}, {1, 0}, {2, 0}, {1, 5}}) == std::vector<Simplex>{{0, 1, 3}, {1, 2, 3}});
}

TEST_CASE("by definition: a square is cut at its lexicographically smallest corner") {
  CHECK(simplices({{1, 1}, {0, 1}, {1, 0}, {0, 0}}) == std::vector<Simplex>{{0, 1, 3}, {0, 2, 3}});
  // Where the square lies in space changes nothing but the coordinates that decide.
  CHECK(simplices({{1, 7, 1}, {0, 7, 1}, {1, 7, 0}, {0, 7, 0}}) ==
        std::vector<Simplex>{{0, 1, 3}, {0, 2, 3}});
}

// Five points in space have two triangulations, of two and of three tetrahedra. Book: Figure 4.1.
TEST_CASE("by definition: two tetrahedra or three, as the apexes are far apart or near") {
  const std::vector<Point> flat = {{2, 0, 0}, {-1, 2, 0}, {-1, -2, 0}, {0, 0, 1}, {0, 0, -1}};
  CHECK(simplices(flat) == std::vector<Simplex>{{0, 1, 3, 4}, {0, 2, 3, 4}, {1, 2, 3, 4}});
  std::vector<Point> tall = flat;
  tall[3] = {0, 0, 5};
  tall[4] = {0, 0, -5};
  CHECK(simplices(tall) == std::vector<Simplex>{{0, 1, 2, 3}, {0, 1, 2, 4}});
}

TEST_CASE("by definition: weights move the diagonal, and submerge a point") {
  const std::vector<Point> kite = {{-2, 0}, {2, 0}, {0, 1}, {0, -1}};
  CHECK(simplices(kite, {4, 4, 0, 0}) == std::vector<Simplex>{{0, 1, 2}, {0, 1, 3}});
  CHECK(simplices({{0}, {1}, {2}}, {0, 0, 0}) == std::vector<Simplex>{{0, 1}, {1, 2}});
  CHECK(simplices({{0}, {1}, {2}}, {0, -2, 0}) == std::vector<Simplex>{{0, 2}});
  // On the lower hull without being extreme: the perturbation of point 0 lowers the edge below it.
  CHECK(simplices({{0}, {1}, {2}}, {0, -1, 0}) == std::vector<Simplex>{{0, 2}});
}

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
