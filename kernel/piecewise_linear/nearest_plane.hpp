// How far points in space are from being coplanar.
#pragma once

#include <cstddef>
#include <vector>

#include "kernel/exact/point.hpp"

namespace circumspect {

// The plane that minimises the largest distance of some points from it. It is halfway between the
// two closest parallel planes that enclose the points, so that distance is half the width of the
// points. One of the two planes touches a facet of the convex hull and the other a vertex, or both
// touch an edge, so the normal is rational.
struct NearestPlane {
  Point normal;
  Rational squared_distance;  // of the farthest points
  std::vector<std::size_t>
      farthest;  // places of the points at that distance, on both sides; ascending
};

// Begins with few points and adds those outside the planes around these, until none is outside: if
// planes at the width of some points enclose all points, that is the width of all. For points on
// something like a ball, this takes too many; after kMostPlacesOfWidth, it returns planes around
// all points that need not be the closest. Requires: points in space, not coplanar.
inline constexpr std::size_t kMostPlacesOfWidth = 16;
NearestPlane nearest_plane(const std::vector<Point>& points);

}  // namespace circumspect
