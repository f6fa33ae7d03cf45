// The flip algorithm: where it ends, where it is stuck, and how long it can take. Book: Section
// 4.4.
#include "reference/delaunay/flip_algorithm.hpp"

#include <doctest/doctest.h>

#include "reference/delaunay/flip.hpp"
#include "reference/delaunay/lifted_hull.hpp"

namespace circumspect::delaunay {
namespace {

TEST_CASE("flip algorithm: one edge flip in the plane, none where it is Delaunay already") {
  const PointSet points({{0, 0}, {3, 0}, {4, 4}, {0, 3}});
  const Triangulation wrong(2, {{0, 1, 2}, {0, 2, 3}});
  const FlippedTriangulation result = flip_algorithm(points, wrong);
  CHECK(result.triangulation == by_definition(points));
  CHECK(result.run.flips == 1);
  CHECK(!result.run.is_stuck());
  CHECK(flip_algorithm(points, result.triangulation).run.flips == 0);
}

TEST_CASE("flip algorithm: no point, one point, an edge") {
  CHECK(flip_algorithm(PointSet({}), Triangulation(-1, {})).triangulation == Triangulation(-1, {}));
  CHECK(flip_algorithm(PointSet({{1, 2}}), Triangulation(0, {{0}})).triangulation ==
        Triangulation(0, {{0}}));
  CHECK(flip_algorithm(PointSet({{1, 2}, {3, 4}}), Triangulation(1, {{0, 1}})).triangulation ==
        Triangulation(1, {{0, 1}}));
}

TEST_CASE("flip algorithm: perturbed tests choose between the diagonals of a square") {
  const PointSet square({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  const Triangulation pulled(2, {{0, 1, 2}, {0, 2, 3}});
  const Triangulation other(2, {{0, 1, 3}, {1, 2, 3}});
  CHECK(flip_algorithm(square, other).triangulation == pulled);
  // To unperturbed tests both are Delaunay.
  CHECK(flip_algorithm(square, other, FlipTest::kUnperturbed).triangulation == other);
  CHECK(flip_algorithm(square, pulled, FlipTest::kUnperturbed).triangulation == pulled);
}

TEST_CASE("flip algorithm: a vertex too light is flipped out, on a line, in the plane, in space") {
  const PointSet line({{0}, {4}, {1}}, {0, 0, -9});
  CHECK(flip_algorithm(line, Triangulation(1, {{0, 2}, {1, 2}})).triangulation ==
        Triangulation(1, {{0, 1}}));
  const PointSet plane({{0, 0}, {6, 0}, {0, 6}, {1, 2}}, {0, 0, 0, -99});
  CHECK(flip_algorithm(plane, Triangulation(2, {{0, 1, 3}, {0, 2, 3}, {1, 2, 3}})).triangulation ==
        Triangulation(2, {{0, 1, 2}}));
  const PointSet space({{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {0, 0, 8}, {1, 2, 3}}, {0, 0, 0, 0, -99});
  const Triangulation four(3, {{0, 1, 2, 4}, {0, 1, 3, 4}, {0, 2, 3, 4}, {1, 2, 3, 4}});
  CHECK(flip_algorithm(space, four).triangulation == Triangulation(3, {{0, 1, 2, 3}}));
}

TEST_CASE("flip algorithm: stuck in the plane with weights, every 3-1 flip blocked") {
  // Two nested triangles, 023 and a smaller one, 145, twisted inside it. Its vertices are so light
  // that all should go, but each has four edges or five, and no flip would reduce their number.
  const PointSet points({{0, 5}, {1, 3}, {0, 0}, {5, 1}, {2, 2}, {1, 2}}, {0, -12, 0, 0, -13, -12});
  const Triangulation start(
      2, {{0, 1, 2}, {0, 1, 4}, {0, 3, 4}, {1, 2, 5}, {1, 4, 5}, {2, 3, 5}, {3, 4, 5}});
  CHECK(by_definition(points) == Triangulation(2, {{0, 2, 3}}));
  for (const FlipTest test : {FlipTest::kPerturbed, FlipTest::kUnperturbed}) {
    const FlippedTriangulation result = flip_algorithm(points, start, test);
    CHECK(result.triangulation == start);
    CHECK(result.run.flips == 0);
    REQUIRE(result.run.blocked.size() == 6);
    CHECK(result.run.blocked[0].facet == Simplex{0, 1});
    CHECK(result.run.blocked[0].missing == std::vector<Simplex>{{1, 2, 4}});
    CHECK(result.run.blocked[5].facet == Simplex{4, 5});
    CHECK(result.run.blocked[5].missing == std::vector<Simplex>{{1, 3, 4}});
  }
}

TEST_CASE(
    "flip algorithm: facets found blocked before a flip elsewhere are still blocked after it") {
  // The same beside a quadrilateral, 0421, whose edge 14 is looked at last.
  const PointSet points({{-4, 1}, {-4, 5}, {0, 5}, {1, 3}, {0, 0}, {5, 1}, {2, 2}, {1, 2}},
                        {0, 0, 0, -12, 0, 0, -13, -12});
  const Triangulation start(2, {{2, 3, 4},
                                {2, 3, 6},
                                {2, 5, 6},
                                {3, 4, 7},
                                {3, 6, 7},
                                {4, 5, 7},
                                {5, 6, 7},
                                {0, 1, 4},
                                {1, 2, 4}});
  const FlippedTriangulation result = flip_algorithm(points, start);
  CHECK(result.run.flips == 1);
  CHECK(result.triangulation.has({0, 2, 4}));
  REQUIRE(result.run.blocked.size() == 6);
  CHECK(result.run.blocked[0].facet == Simplex{2, 3});
}

TEST_CASE("flip algorithm: the bound of Section 4.4") {
  CHECK(most_flips(0, 3) == 0);
  CHECK(most_flips(10, 1) == 2 * 10);
  CHECK(most_flips(10, 2) == 2 * (10 + 45));
  CHECK(most_flips(10, 3) == 2 * (10 + 45));
  CHECK(most_flips(10, 4) == 2 * (10 + 45 + 120));
  CHECK(most_flips(2, 4) == 2 * (2 + 1));
}

}  // namespace
}  // namespace circumspect::delaunay
