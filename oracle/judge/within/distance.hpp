// Exact squared distances between points, segments and triangles.
#pragma once

#include <vector>

#include "reference/kernel/exact/point.hpp"

namespace circumspect::check {

// Of a point and a simplex of one to three corners, in the plane or in space.
// Requires: the corners are affinely independent.
Rational squared_distance_to(const std::vector<Point>& simplex, const Point& point);

// Of two simplices of one to three corners each. Requires: as above, and that they have no point in
// common; in the plane they are points or segments.
Rational squared_distance_between(const std::vector<Point>& a, const std::vector<Point>& b);

}  // namespace circumspect::check
