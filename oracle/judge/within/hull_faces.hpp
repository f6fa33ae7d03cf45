// The faces of a convex hull, by the points on them.
#pragma once

#include <vector>

#include "kernel/complex/point_set.hpp"

namespace circumspect::check {

// The largest sets of points on one plane (in the plane: line) that has all others on one side,
// each ascending, in lexicographic order, as facets_by_definition finds them by looking at all
// planes; here by going around the hull.
// Requires: the points span space (the plane).
std::vector<std::vector<Vertex>> hull_faces(const PointSet& points);

}  // namespace circumspect::check
