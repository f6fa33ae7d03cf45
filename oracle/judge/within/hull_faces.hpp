// The faces of a convex hull, by the points on them.
#pragma once

#include <vector>

#include "reference/kernel/complex/point_set.hpp"

namespace circumspect::check {

// The largest sets of points on one plane (in the plane: line) that has all others on one side, each ascending, in
// lexicographic order: by going around the hull, and by looking at all planes.
// Requires: the points span space (the plane).
std::vector<std::vector<Vertex>> hull_faces(const PointSet& points);
std::vector<std::vector<Vertex>> hull_faces_by_definition(const PointSet& points);

}  // namespace circumspect::check
