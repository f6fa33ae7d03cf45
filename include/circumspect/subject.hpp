// The program under test, which turns points into simplices, as a function. Every harness, adapter
// and planted fault speaks these three types, which need only the standard library.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace circumspect {

// Points as a program takes them: IEEE doubles, `dimension` of them a point, one point after the
// other; all finite. Weights: none, or one a point, in squared units of length, so that a weighted
// point is a ball with centre p and squared radius w (Book: Section 5.2).
struct PointArray {
  std::size_t dimension = 3;
  std::vector<double> coordinates = {};
  std::vector<double> weights = {};

  std::size_t size() const { return dimension == 0 ? 0 : coordinates.size() / dimension; }
  const double* point(std::size_t i) const { return coordinates.data() + i * dimension; }
};

// One row a simplex: indices of points from 0, in any order. Rows of k+1 indices where the points
// span only a flat of dimension k.
using SimplexArray = std::vector<std::vector<std::int64_t>>;

// The program. It may throw: an exception is reported as a crash, with its text.
using Triangulator = std::function<SimplexArray(const PointArray&)>;

}  // namespace circumspect
