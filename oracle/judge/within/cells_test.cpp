// How the cells of a domain lie to each other, by the questions that the search asks; and which
// triangles are marked for a polygon.
#include "oracle/judge/within/cells.hpp"

#include <algorithm>

#include <doctest/doctest.h>

namespace circumspect::check {
namespace {

// A square with a slit and a vertex in it, a triangle that stands on one of its sides, a segment
// that leaves a corner, and what touches neither.
PiecewiseLinearComplex all_kinds() {
  PiecewiseLinearInput input;
  input.points = {{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0},  {2, 2, 0},  {5, 5, 0}, {4, 0, 4},
                  {9, 9, 9}, {1, 1, 5}, {1, 2, 5}, {20, 0, 0}, {20, 1, 0}, {20, 0, 1}};
  input.polygons = {{{{0, 1, 2, 3}}, {}}, {{{0, 1, 6}}, {}}, {{{10, 11, 12}}, {}}};
  input.segments = {{0, 4}, {2, 7}, {8, 9}};
  return assemble(input);
}

bool has(const std::vector<Cell>& cells, Cell cell) {
  return std::count(cells.begin(), cells.end(), cell) == 1;
}

TEST_CASE("cells: a face of a cell is in its closure and its vertices have both in their stars") {
  const PiecewiseLinearComplex complex = all_kinds();
  const Cells cells(complex);
  const auto meet_in_vertex = [&](Cell a, Cell b) {
    const std::vector<Vertex> of_a = cells.vertices(a), of_b = cells.vertices(b);
    return std::any_of(of_a.begin(), of_a.end(), [&](Vertex v) { return contains(of_b, v); });
  };
  for (const Cell cell : cells.all()) {
    const std::vector<Cell> closure = cells.closure(cell);
    std::vector<Cell> asked = {cell};
    CHECK(cells.holds_of_faces(cell, [&](Cell face) {
      asked.push_back(face);
      return true;
    }));
    CHECK(asked == closure);
    for (const Cell other : cells.all()) {
      const bool is_face = circumspect::is_face(complex, other, cell);
      CHECK(has(closure, other) == is_face);
      CHECK(cells.is_in_closure(other, cell) == is_face);
      CHECK(cells.meet(cell, other) == meet_in_vertex(cell, other));
      // One face of which it does not hold is enough, whichever it is.
      const auto holds = [&](Cell face) { return face != other; };
      CHECK(cells.holds_of_faces(cell, holds) == (other == cell || !is_face));
      if (other.dimension == 0 && cell.dimension > 0) {
        CHECK(has(cells.star(other.place), cell) == is_face);
      }
    }
  }
}

TEST_CASE("markers: a triangle is marked for a polygon that has the same marker, unless it is 0") {
  const PiecewiseLinearComplex complex = all_kinds();
  for (const Vertex of_triangle : {0, 1, 2, -1}) {
    const Cells cells(complex, {{{{0, 1, 2}, of_triangle}}, {0, 1}});
    CHECK(!cells.is_marked({0, 1, 2}, 0));
    CHECK(cells.is_marked({0, 1, 2}, 1) == (of_triangle == 1));
    CHECK(!cells.is_marked({0, 1, 2}, 2));  // no marker was listed for it
    CHECK(!cells.is_marked({0, 1, 3}, 1));
  }
}

}  // namespace
}  // namespace circumspect::check
