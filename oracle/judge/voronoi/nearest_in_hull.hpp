// The distance from a point to the convex hull of others.
#pragma once

#include <vector>

#include "kernel/exact/point.hpp"

namespace circumspect::check {

// The answer of definition::squared_distance_between, by Wolfe's algorithm: a simplex of some
// points whose nearest point to q is inside of it is changed, ever nearer, until no point is beyond
// the hyperplane through that nearest point (P. Wolfe, "Finding the nearest point in a polytope",
// Math.
// Programming 11, 1976). Requires: there is a point.
Rational squared_distance_to_hull(const Point& q, const std::vector<Point>& points);

}  // namespace circumspect::check
