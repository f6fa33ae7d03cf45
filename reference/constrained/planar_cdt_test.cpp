// Planar CDTs. Book: Sections 3.10 and 3.11.
#include "reference/constrained/planar_cdt.hpp"

#include <doctest/doctest.h>

#include "reference/constrained/gift_wrapping_cdt.hpp"
#include "reference/delaunay/lifted_hull.hpp"

namespace circumspect::constrained {

// Planar CDTs whose answer is known, by both algorithms.

namespace {

PlcTriangulation both_ways(const PiecewiseLinearInput& input) {
  const PiecewiseLinearComplex complex = assemble(input);
  const PlcTriangulation answer = planar_cdt(complex, PlanarAlgorithm::kGiftWrapping);
  CHECK(answer == planar_cdt(complex, PlanarAlgorithm::kSegmentInsertion));
  return answer;
}

std::vector<Simplex> both_ways(const PiecewiseLinearComplex& complex, const Polygon& polygon) {
  const auto answer = planar_cdt(complex.points, polygon, PlanarAlgorithm::kGiftWrapping);
  CHECK(answer == planar_cdt(complex.points, polygon, PlanarAlgorithm::kSegmentInsertion));
  return answer;
}

TEST_CASE("planar CDT: a convex hull without segments has its Delaunay triangulation") {
  PiecewiseLinearInput input;
  for (int x = 0; x < 4; ++x) {
    for (int y = 0; y < 3; ++y) input.points.push_back({x, y});
  }
  input.kind = DomainKind::kHull;
  const PlcTriangulation answer = both_ways(input);
  CHECK(answer.simplices == delaunay::by_definition(PointSet(input.points)).simplices());
  CHECK(answer.dangling.empty());
}

TEST_CASE("planar CDT: a segment that is not Delaunay") {
  PiecewiseLinearInput input;
  input.points = {{0, 0}, {9, 0}, {4, 1}, {4, -1}};
  input.segments = {{0, 1}};
  input.kind = DomainKind::kHull;
  CHECK(both_ways(input) == PlcTriangulation{{{0, 1, 2}, {0, 1, 3}}, {}});
  input.segments.clear();
  CHECK(both_ways(input) == PlcTriangulation{{{0, 2, 3}, {1, 2, 3}}, {}});
}

TEST_CASE("planar CDT: of the enclosed kind only what segments enclose has triangles") {
  PiecewiseLinearInput input;
  // A square with a square hole, a segment that leads out of the outline, a separate one, and a
  // vertex outside.
  input.points = {{0, 0}, {6, 0}, {6, 6}, {0, 6}, {2, 2},  {4, 2},
                  {4, 4}, {2, 4}, {9, 9}, {8, 0}, {9, 20}, {20, 9}};
  for (Vertex i = 0; i < 4; ++i) {
    input.segments.push_back({i, (i + 1) % 4});
    input.segments.push_back({4 + i, 4 + (i + 1) % 4});
  }
  input.segments.push_back({2, 8});
  input.segments.push_back({10, 11});
  input.hole_seeds = {{3, 3}};
  const PlcTriangulation answer = both_ways(input);
  CHECK(answer.simplices.size() == 8);
  CHECK(answer.dangling == std::vector<Simplex>{{2, 8}, {9}, {10, 11}});
  input.hole_seeds.clear();
  CHECK(both_ways(input).simplices.size() == 10);
}

TEST_CASE("planar CDT: vertices that are hidden do not count") {
  // A wall 4 5 between the edge 0 1 and the vertex 6, which would be in every ball otherwise.
  PiecewiseLinearInput input;
  input.points = {{0, 0}, {10, 0}, {10, 9}, {0, 9}, {-1, 3}, {11, 3}, {5, 4}};
  input.segments = {{4, 5}};
  input.kind = DomainKind::kHull;
  const PlcTriangulation answer = both_ways(input);
  CHECK(answer.simplices ==
        std::vector<Simplex>{{0, 1, 4}, {1, 4, 5}, {2, 3, 6}, {2, 5, 6}, {3, 4, 6}, {4, 5, 6}});
}

TEST_CASE("planar CDT: cavities that are passed twice by one edge, and by one vertex") {
  // The segment 0 1 passes the tips of two segments that hang down, and of one that stands up.
  PiecewiseLinearInput input;
  input.points = {{0, 0}, {30, 0}, {7, 8}, {8, 1}, {17, 9}, {16, 1}, {12, -9}, {12, -1}, {25, -3}};
  input.segments = {{2, 3}, {4, 5}, {6, 7}, {0, 1}};
  input.kind = DomainKind::kHull;
  CHECK(both_ways(input).dangling.empty());
  CHECK(both_ways(input).simplices.size() == 10);
}

TEST_CASE("planar CDT: points on one line, and none") {
  PiecewiseLinearInput input;
  CHECK(both_ways(input) == PlcTriangulation{});
  input.points = {{0, 0}, {2, 2}, {1, 1}};
  CHECK(planar_domain(PointSet(input.points), {0, 1}, {0, 1, 2}, {}, {}, DomainKind::kHull)
            .segments == std::vector<Simplex>{{0, 2}, {1, 2}});
  input.segments = {{0, 2}};
  CHECK(both_ways(input) == PlcTriangulation{{}, {{0, 2}, {1}}});
  input.kind = DomainKind::kHull;
  CHECK(both_ways(input) == PlcTriangulation{{}, {{0, 2}, {1}}});
}

TEST_CASE("planar CDT: a polygon in space with a hole, a slit and a vertex inside") {
  PiecewiseLinearInput input;
  // In the plane z = x + 2y.
  const auto add = [&input](int x, int y) { input.points.push_back({x, y, x + 2 * y}); };
  for (const int at : {0, 10}) {
    add(at, 0);
    add(at, 10);
  }
  for (const int at : {2, 4}) {
    add(at, 2);
    add(at, 4);
  }
  add(6, 1), add(6, 9), add(8, 5);
  input.polygons = {{{{0, 2, 3, 1}, {4, 6, 7, 5}, {8, 9}, {10}}, {{3, 3, 9}}}};
  const PiecewiseLinearComplex complex = assemble(input);
  const std::vector<Simplex> answer = both_ways(complex, complex.polygons.front());
  // Euler's relation: n vertices, b edges on the boundary, a hole: 2n − b triangles.
  CHECK(answer.size() == 2 * 11 - 8);
  for (const Simplex& segment : std::vector<Simplex>{{8, 9}, {4, 5}, {0, 2}}) {
    CHECK(std::any_of(answer.begin(), answer.end(), [&](const Simplex& triangle) {
      return contains(triangle, segment[0]) && contains(triangle, segment[1]);
    }));
  }
}

}  // namespace
}  // namespace circumspect::constrained
