// Do two simplices meet in a common face or not at all? Book: Definition 2.1 by way of Section 1.5
// (simplicial complexes).
#pragma once

#include <optional>

#include "reference/kernel/complex/point_set.hpp"

namespace circumspect {

// A point that lies in both simplices but not in the face spanned by their common vertices;
// nothing iff they intersect properly. Found by a linear program: among all ways to write one point
// as a convex combination of either simplex, one that leaves the common face as far as it can.
// Requires: each simplex affinely independent.
std::optional<Point> improper_intersection(const PointSet& points, const Simplex& a,
                                           const Simplex& b);

}  // namespace circumspect
