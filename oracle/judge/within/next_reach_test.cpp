// Where the search for the least reach must not go too far: docs/theory/within.md, A′.
#include <doctest/doctest.h>

#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "oracle/judge/within/moved_meshes_test.hpp"
#include "oracle/judge/within/reach_by_definition.hpp"
#include "oracle/judge/within/reach_search.hpp"

namespace circumspect::check {
namespace {

// A square of 8 × 8, and triangles on its corners 0 to 3 and more points.
struct Square {
  std::vector<Point> points = {{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}};
  std::vector<Simplex> triangles = {};

  // The least reach in bits; −1 if there is none.
  long reach() const {
    PiecewiseLinearInput input;
    input.points.assign(points.begin(), points.begin() + 4);
    input.polygons = {{{{0, 1, 2, 3}}, {}}};
    const PiecewiseLinearComplex complex = assemble(input);
    ExactMesh mesh{PointSet(points), {}};
    mesh.faces = triangles;
    const std::vector<bool> used(points.size(), true);
    const Cells cells(complex);
    const Regions regions(complex);
    Work work;
    const ReachAnswer quick = least_reach(mesh, used, cells, regions, kSquaredLimit, 1, work);
    const ReachAnswer slow = least_reach_by_definition(mesh, used, cells, regions, kSquaredLimit);
    const bool found = quick.kind == ReachAnswer::Kind::kFound;
    CHECK(found == (slow.kind == ReachAnswer::Kind::kFound));
    if (!found) return -1;
    CHECK(quick.squared_reach == slow.squared_reach);
    long number = 0;
    while (bits(number) * bits(number) < quick.squared_reach) ++number;
    CHECK(bits(number) * bits(number) == quick.squared_reach);
    return number;
  }
};

}  // namespace

TEST_CASE("next reach: a triangle that another one may stand for is in no hurry") {
  // Four triangles around vertex 5, and before them in order one at vertex 4, which is near the
  // square and in no image.
  Square square;
  square.points.push_back({4, 2, bits(5)});
  square.points.push_back({4, 4, bits(2)});
  square.triangles = {{0, 1, 5}, {1, 2, 5}, {2, 3, 5}, {0, 3, 5}};
  CHECK(square.reach() == 2);
  square.triangles.push_back({0, 1, 4});
  CHECK(square.reach() == 2);
  // Without the right one the other is no help.
  square.triangles.erase(square.triangles.begin());
  CHECK(square.reach() == -1);
}

TEST_CASE(
    "next reach: a path that goes through one vertex more may be the one that has triangles") {
  // Vertex 4 is in the square, 5 bits from its side 0 1. That is an edge of a triangle that leads
  // away, and no other.
  Square square;
  square.points.push_back({4, bits(5), 0});
  square.points.push_back({4, -3, -9});
  square.triangles = {{0, 3, 4}, {1, 2, 4}, {2, 3, 4}, {0, 1, 5}};
  CHECK(square.reach() == 5);
  // With that triangle, the side needs no other vertex.
  square.triangles.push_back({0, 1, 4});
  CHECK(square.reach() == 0);
}

TEST_CASE("next reach: of a path, too, one of several edges that lead ahead is in no hurry") {
  // Vertices 5 and 4 are near the side 0 1, one after the other. There is an edge from 0 to each of
  // them.
  Square square;
  square.points.push_back({5, bits(7), 0});
  square.points.push_back({3, bits(2), 0});
  square.triangles = {{0, 3, 5}, {3, 4, 5}, {2, 3, 4}, {1, 2, 4}};
  CHECK(square.reach() == 7);
  square.triangles.push_back({0, 4, 5});
  CHECK(square.reach() == 7);
}

TEST_CASE("next reach: a vertex that must not be in the polygon may come to be in a side of it") {
  // Vertex 4 is in the square, and in no triangle of it but those at the side that it is 3 bits
  // from.
  Square square;
  square.points.push_back({4, bits(3), 0});
  square.points.push_back({4, -5, 0});
  square.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 4, 5}, {1, 4, 5}};
  CHECK(square.reach() == -1);
  square.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 4, 5}, {1, 4, 5}, {0, 4, 3}, {4, 1, 2}, {4, 2, 3}};
  CHECK(square.reach() == 3);
}

}  // namespace circumspect::check
