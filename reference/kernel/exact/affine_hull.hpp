// The affine hull of a set of points, and coordinates in it.
// Book: Section 4.1 ("if the affine hull of S is k-dimensional …").
#pragma once

#include <cstddef>
#include <vector>

#include "reference/kernel/exact/point.hpp"

namespace circumspect {

// The affine hull of some points. `basis` holds the indices of k+1 affinely independent points, the
// first such in the order given. `axes` holds k coordinate axes, ascending, such that dropping all
// other coordinates is injective on the hull: a coordinate system of it.
struct AffineHull {
  int dimension = -1;  // k; -1 for no point at all
  std::vector<std::size_t> basis;
  std::vector<std::size_t> axes;
};

// Requires: all points of one dimension.
AffineHull affine_hull(const std::vector<Point>& points);

}  // namespace circumspect
