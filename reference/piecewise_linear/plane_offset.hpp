// How far a point is off a plane of space.
#pragma once

#include <vector>

#include "reference/exact/point.hpp"

namespace circumspect {

// With n = (b − a) × (c − a) and i the first axis on which |n_i| is greatest, n·(q − a) / n_i: the
// distance of q from the plane through a, b, c along axis i, positive in the direction of the axis.
// Requires: three points of space that are not on one line.
Rational offset_from_plane(const std::vector<Point>& plane, const Point& q);

}  // namespace circumspect
