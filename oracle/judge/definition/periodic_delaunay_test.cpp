#include "oracle/judge/definition/periodic_delaunay.hpp"

#include <doctest/doctest.h>

namespace circumspect::definition {

TEST_CASE("multiples of short vectors are visited one by one, and none is kept") {
  const Rational tiny(Integer(1), Integer(1) << 200U);
  std::vector<Simplex> visited;
  for_each_shift({{tiny, 0}, {0, 1}}, {{0, 0}, {1, 0}}, [&](const Simplex& multiples) {
    visited.push_back(multiples);
    return visited.size() < 3;
  });
  CHECK(visited == std::vector<Simplex>{{0, 0}, {1, 0}, {2, 0}});
}

TEST_CASE("multiples are those whose sum is in the box, its boundary included") {
  std::vector<Simplex> visited;
  for_each_shift({{2, 1}, {0, 3}}, {{-2, -1}, {2, 2}}, [&](const Simplex& multiples) {
    visited.push_back(multiples);
    return true;
  });
  CHECK(visited == std::vector<Simplex>{{-1, 0}, {-1, 1}, {0, 0}, {1, 0}});
}

}  // namespace circumspect::definition
