#include "oracle/judge/fast/lattice.hpp"

#include <vector>

#include <doctest/doctest.h>

namespace circumspect::fast {
namespace {

double unit_of_all(const std::vector<double>& coordinates,
                   const std::vector<double>& weights = {}) {
  return lattice_of_all(coordinates, weights).unit;
}

TEST_CASE("the coarsest lattice of all points, unless it is too fine") {
  CHECK(unit_of_all({0, 4, -12, 8}) == 4);
  CHECK(unit_of_all({0, 4, -12, 8}, {16, 32}) == 4);
  CHECK(unit_of_all({0, 4, -12, 8}, {16, 8}) == 2);  // its square divides them
  CHECK(unit_of_all({0, 4, -12, 8}, {16, 2}) == 1);
  CHECK(unit_of_all({1, 0x1p-39}) == 0x1p-39);
  CHECK(unit_of_all({1, 0x1p-40}) == 0);
  CHECK(unit_of_all({0.1, 0.2}) == 0);
  CHECK(unit_of_all({0x1p-199}) == 0x1p-199);
  CHECK(unit_of_all({0x1p-200}) == 0);
  CHECK(unit_of_all({0x1p200}) == 0x1p190);  // finer is right as well
  CHECK(unit_of_all({0x1p-1074, 1e300}) == 0);
}

}  // namespace
}  // namespace circumspect::fast
