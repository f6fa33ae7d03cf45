// The Delaunay triangulation from its definition, on sets whose triangulation is known.
// Book: Definition 4.1, Figures 4.1 and 4.2.
#include "reference/delaunay/by_definition.hpp"

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

}  // namespace
}  // namespace circumspect::delaunay
