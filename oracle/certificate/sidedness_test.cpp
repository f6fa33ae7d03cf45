#include "oracle/certificate/sidedness.hpp"

#include <doctest/doctest.h>

namespace circumspect::certificate {
namespace {

TEST_CASE("orientations in the plane, with a rational point in each place") {
  const auto points = *scaled_to_integers(PointSet({{0, 0}, {4, 0}, {0, 4}, {7, 1}}));
  Sidedness sidedness(points);
  const Simplex triangle = {0, 1, 2};
  CHECK(sidedness.orientation(triangle) == 1);
  CHECK(sidedness.orientation(Simplex{1, 0, 2}) == -1);
  CHECK(sidedness.orientation(Simplex{0, 1, 1}) == 0);
  const HomogeneousPoint inside{{3, 2}, 2};
  const HomogeneousPoint on_edge{{5, 3}, 2};
  const HomogeneousPoint beyond{{9, 1}, 2};
  for (std::size_t place = 0; place < 3; ++place) {
    CHECK(sidedness.orientation_with(triangle, place, inside) == 1);
    CHECK(sidedness.orientation_with(triangle, place, on_edge) == (place == 0 ? 0 : 1));
    CHECK(sidedness.orientation_with(triangle, place, beyond) == (place == 0 ? -1 : 1));
  }
  for (const std::size_t first : {0u, 1u, 2u}) {
    CHECK(!sidedness.separating_place(triangle, 1, inside, first));
    CHECK(!sidedness.separating_place(triangle, 1, on_edge, first));
    CHECK(sidedness.separating_place(triangle, 1, beyond, first) == 0);
    CHECK(sidedness.separating_place(Simplex{0, 2, 1}, -1, beyond, first) == 0);
  }
}

TEST_CASE("orientations in space, with a rational point in each place") {
  const auto points = *scaled_to_integers(PointSet({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}));
  Sidedness sidedness(points);
  const Simplex simplex = {0, 1, 2, 3};
  CHECK(sidedness.orientation(simplex) == 1);
  CHECK(sidedness.orientation(Simplex{0, 1, 3, 2}) == -1);
  const HomogeneousPoint inside{{1, 1, 1}, 4};
  const HomogeneousPoint beyond{{-1, 1, 1}, 3};
  for (std::size_t place = 0; place < 4; ++place) {
    CHECK(sidedness.orientation_with(simplex, place, inside) == 1);
    CHECK(sidedness.orientation_with(simplex, place, beyond) == (place == 0 ? -1 : 1));
  }
  CHECK(!sidedness.separating_place(simplex, 1, inside));
  CHECK(sidedness.separating_place(simplex, 1, beyond) == 0);
}

}  // namespace
}  // namespace circumspect::certificate
