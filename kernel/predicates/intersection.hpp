// What two vertices, segments or triangles have in common. CGAL's kernel does the work, over exact
// rationals. Book: Definition 4.3 speaks of the intersections of linear cells.
#pragma once

#include <vector>

#include "kernel/exact/point.hpp"

namespace circumspect {

// The vertices of the intersection of the convex hulls of `a` and of `b`: nothing if they are
// disjoint, one point, the two ends of a segment, or the corners of a convex polygon in order.
// Requires: either has one to three affinely independent points, in the plane or in space.
std::vector<Point> intersection(const std::vector<Point>& a, const std::vector<Point>& b);

}  // namespace circumspect
