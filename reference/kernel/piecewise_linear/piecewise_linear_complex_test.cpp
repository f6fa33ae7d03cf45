// Polygons out of lines, and the triangles that say what belongs to them.
#include <doctest/doctest.h>

#include "inputs/named_complexes.hpp"

namespace circumspect {
namespace {

TEST_CASE("assemble: a box has 12 segments and 12 walls") {
  const auto complex = assemble(generators::box(0, 1));
  CHECK(complex.segments.size() == 12);
  CHECK(walls(complex).size() == 12);
  CHECK(complex.polygons[0].vertices == std::vector<Vertex>{0, 1, 2, 3});
}

TEST_CASE("assemble: a square with a square hole, a slit and an isolated vertex") {
  PiecewiseLinearInput input;
  input.points = {{0, 0, 5}, {9, 0, 5}, {9, 9, 5}, {0, 9, 5}, {3, 3, 5}, {6, 3, 5},
                  {6, 6, 5}, {3, 6, 5}, {1, 1, 5}, {2, 1, 5}, {1, 8, 5}, {4, 5, 5}};
  input.segments = {{8, 9}};
  input.polygons = {{{{0, 1, 2, 3}, {4, 5, 6, 7}, {10}}, {{4, 4, 5}}}};
  const auto complex = assemble(input);
  const Polygon& polygon = complex.polygons.front();
  // The slit is adopted, the vertex in the hole is not.
  CHECK(polygon.vertices == std::vector<Vertex>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10});
  CHECK(polygon.segments.size() == 9);
  Rational area = 0;
  for (const Simplex& t : polygon.triangles) {
    const Point u = complex.points[t[1]] - complex.points[t[0]];
    const Point v = complex.points[t[2]] - complex.points[t[0]];
    area += abs(u[0] * v[1] - u[1] * v[0]) / 2;
  }
  CHECK(area == 72);
}

TEST_CASE("assemble: an L-shaped polygon without its notch") {
  PiecewiseLinearInput input;
  input.points = {{0, 0, 0}, {2, 0, 2}, {2, 1, 2}, {1, 1, 1}, {1, 2, 1}, {0, 2, 0}};
  input.polygons = {{{{0, 1, 2, 3, 4, 5}}, {}}};
  CHECK(assemble(input).polygons.front().triangles.size() == 4);
}

}  // namespace
}  // namespace circumspect
