// How far are two convex sets from each other?
#pragma once

#include <vector>

#include "kernel/exact/point.hpp"

namespace circumspect::definition {

// The squared distance between the convex hulls of some points. Of two nearest points each lies in
// a simplex of d + 1 of the points or fewer; for the smallest such simplices they are the only
// nearest points of the affine hulls. So all pairs of simplices are tried that have such a pair.
// Requires: there are points in both.
Rational squared_distance_between(const std::vector<Point>& a, const std::vector<Point>& b);

}  // namespace circumspect::definition
