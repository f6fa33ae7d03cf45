// Is a point set generic? Book: Definition 4.2, Theorem 4.4.
#pragma once

#include <optional>

#include "kernel/complex/point_set.hpp"
#include "kernel/complex/triangulation.hpp"

namespace circumspect::delaunay {

// k+2 points on the boundary of a single ball, the first such in lexicographic order of their
// indices; nothing iff the set is generic (Definition 4.2). Looks at all (k+2)-subsets.
std::optional<Simplex> cospherical_points(const PointSet& points);

// k+2 points on the boundary of a single *empty* ball; nothing iff the set has only one Delaunay
// triangulation, which is weaker than being generic. Linear in the triangulation.
// Requires: `triangulation` is a Delaunay triangulation of the points.
std::optional<Simplex> cospherical_points_of_an_empty_ball(const PointSet& points,
                                                           const Triangulation& triangulation);

}  // namespace circumspect::delaunay
