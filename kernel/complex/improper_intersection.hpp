// Do two simplices meet in a common face or not at all? Book: Definition 2.1 by way of Section 1.5
// (simplicial complexes).
#pragma once

#include <optional>
#include <vector>

#include "kernel/complex/point_set.hpp"

namespace circumspect {

// A point that lies in both simplices but not in the face spanned by their common corners; nothing
// iff they intersect properly. Found by a linear program: among all ways to write one point as a
// convex combination of either simplex, one that leaves the common face as far as it can.
// Requires: the corners of each are affinely independent.
std::optional<Point> improper_intersection(const std::vector<Point>& a,
                                           const std::vector<Point>& b);
std::optional<Point> improper_intersection(const PointSet& points, const Simplex& a,
                                           const Simplex& b);

// Do the relative interiors of the convex hulls of some points have a point in common? Then both
// are convex combinations of all their points, with positive coefficients.
bool relative_interiors_meet(const std::vector<Point>& a, const std::vector<Point>& b);

}  // namespace circumspect
