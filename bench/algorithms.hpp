// The constructions that the benchmarks compare.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "reference/kernel/complex/point_set.hpp"
#include "reference/kernel/complex/triangulation.hpp"

namespace circumspect::bench {

struct Algorithm {
  std::string name;
  std::function<Triangulation(const PointSet&)> construct;
  // The numbers of points to try, and the seconds that the last may take (0: any).
  std::vector<std::size_t> sizes;
  int seconds_allowed = 0;
};

// One line an algorithm.
const std::vector<Algorithm>& algorithms();

}  // namespace circumspect::bench
