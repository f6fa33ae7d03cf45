// Cells that a mesh certainly lacks. On random domains, `held_to_definition_test.hpp` holds this to
// the definition.
#include "oracle/judge/within/without_image.hpp"

#include <doctest/doctest.h>

#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "oracle/judge/within/moved_meshes_test.hpp"

namespace circumspect::check {
namespace {

// A square in three strips of two triangles each, whose inner vertices are a bit off it. The
// square's side 0 1 has two vertices more, 4 and 5, and its side 2 3 has 6 and 7.
struct Strips {
  std::vector<Point> points = {{0, 0, 0},       {9, 0, 0},       {9, 9, 0},       {0, 9, 0},
                               {3, bits(1), 0}, {6, 0, bits(1)}, {6, 9, bits(1)}, {3, 9, 0}};
  std::vector<Simplex> triangles = {{0, 4, 7}, {0, 3, 7}, {4, 5, 6},
                                    {4, 6, 7}, {1, 2, 5}, {2, 5, 6}};

  bool lacks(LinearCell cell) const {
    PiecewiseLinearInput input;
    input.points = {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}};
    input.polygons = {{{{0, 1, 2, 3}}, {}}};
    const PiecewiseLinearComplex complex = assemble(input);
    ExactMesh exact{PointSet(points), {}};
    exact.faces = triangles;
    const Mesh mesh = in_rows(exact);
    return WithoutImage(mesh, complex, bits(2) * bits(2)).certainly(cell);
  }
  void leave_out(std::size_t triangle) {
    triangles.erase(triangles.begin() + static_cast<std::ptrdiff_t>(triangle));
  }
};

constexpr LinearCell kSide = {1, 0}, kSquare = {2, 0};

}  // namespace

TEST_CASE("nothing is certainly missing that is there, a bit off") {
  const Strips strips;
  for (const std::size_t v : {0U, 1U, 2U, 3U}) CHECK(!strips.lacks({0, v}));
  for (const std::size_t s : {0U, 1U, 2U, 3U}) CHECK(!strips.lacks({1, s}));
  CHECK(!strips.lacks(kSquare));
}

TEST_CASE("a corner, a side and a square are missing that would have to be moved too far") {
  Strips strips;
  strips.points[5][2] = bits(3);
  CHECK(strips.lacks(kSide));
  CHECK(strips.lacks(kSquare));
  strips.points[5][2] = 0;
  CHECK(!strips.lacks(kSquare));
  strips.points[0][0] = bits(1);
  CHECK(!strips.lacks({0, 0}));
  strips.points[0][0] = bits(3);
  CHECK(strips.lacks({0, 0}));
}

TEST_CASE("without one of its triangles a square is missing, and a side without an edge") {
  for (std::size_t t = 0; t < 6; ++t) {
    Strips strips;
    strips.leave_out(t);
    CAPTURE(t);
    CHECK(strips.lacks(kSquare));
    CHECK(strips.lacks({1, 1}) == (t == 1));  // the only one at that side
  }
  Strips strips;
  strips.triangles = {{0, 4, 7}, {0, 3, 7}, {4, 6, 7}, {1, 2, 5}, {2, 5, 6}};
  CHECK(strips.lacks(kSide));
}

}  // namespace circumspect::check
