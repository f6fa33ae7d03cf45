// The affine hull of some points of a set.
#include "reference/complex/flat.hpp"

#include <doctest/doctest.h>

namespace circumspect {
namespace {

const PointSet kPoints({{0, 0, 1}, {2, 0, 1}, {4, 0, 1}, {0, 3, 1}, {0, 0, 5}});

TEST_CASE("flat: a point, a line, a plane, space") {
  CHECK(flat_through(kPoints, {3}).dimension() == 0);
  CHECK(flat_through(kPoints, {3}).basis == Simplex{3});
  const Flat line = flat_through(kPoints, {2, 0, 1});
  CHECK(line.basis == Simplex{2, 0});
  CHECK(line.axes == std::vector<std::size_t>{0});
  const Flat plane = flat_through(kPoints, {0, 1, 2, 3});
  CHECK(plane.basis == Simplex{0, 1, 3});
  CHECK(plane.axes == std::vector<std::size_t>{0, 1});
  CHECK(flat_through(kPoints, all_vertices(kPoints)).basis == Simplex{0, 1, 3, 4});
}

TEST_CASE("flat: of a projection on some axes") {
  const Flat shadow = flat_through(kPoints, {1, 2}, {0, 1, 3, 4});
  CHECK(shadow.basis == Simplex{0, 3, 4});  // 0 and 1 have one shadow
  CHECK(shadow.axes == std::vector<std::size_t>{1, 2});
  CHECK(flat_through(kPoints, {2}, {0, 1, 2, 3}).dimension() == 0);
}

}  // namespace
}  // namespace circumspect
