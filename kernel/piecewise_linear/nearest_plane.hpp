// How far points of space are from being in one plane.
#pragma once

#include <cstddef>
#include <vector>

#include "kernel/exact/point.hpp"

namespace circumspect {

// The plane from which the farthest of some points is as near as it can be. It is halfway between two parallel planes
// that enclose the points and are as near to each other as such planes can be: half the width of the points. Each of
// the two touches a facet of the convex hull and the other a vertex, or both touch an edge, so the normal is rational.
struct NearestPlane {
  Point normal;
  Rational squared_distance;  // of the farthest points
  std::vector<std::size_t>
      farthest;  // places of points that are so far from it, on both sides; ascending
};

// Looks at few points, and takes in those that the planes about these leave out, until none is left out: what is the
// width of some points and encloses all is the width of all. Of points that are as round as a ball this takes too many;
// after kMostPlacesOfWidth, planes about all points are returned that need not be the nearest to each other.
// Requires: points of space, not all in one plane.
inline constexpr std::size_t kMostPlacesOfWidth = 16;
NearestPlane nearest_plane(const std::vector<Point>& points);

}  // namespace circumspect
