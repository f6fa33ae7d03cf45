// A program to be put to the test: the Delaunay triangulation of points in the plane, as it is
// often written, with floating-point predicates.
#pragma once

#include <array>
#include <vector>

namespace example {

using Point = std::array<double, 2>;
using Triangle = std::array<int, 3>;  // counterclockwise

// Requires: distinct points, not all on one line.
std::vector<Triangle> triangulate(const std::vector<Point>& points);

}  // namespace example
