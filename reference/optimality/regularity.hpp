// Which triangulations are regular: the weighted Delaunay triangulations for some weights.
// Book: Section 4.2 by way of Definition 2.5 (weighted Delaunay triangulations, of which Section 4.3
// says that they are the optimal ones for some function).
#pragma once

#include <optional>
#include <vector>

#include "reference/kernel/complex/point_set.hpp"
#include "reference/kernel/complex/triangulation.hpp"

namespace circumspect::optimality {

// Heights, one a point, over which the triangulation is the whole lower hull: every interior facet
// is strictly convex, every point that is no vertex strictly above. Nothing if there are none: the
// triangulation is not regular. By a linear program in the heights.
// Requires: a triangulation of the points, or of some of them.
std::optional<std::vector<Rational>> heights_of_regular(const PointSet& points,
                                                        const Triangulation& triangulation);

}  // namespace circumspect::optimality
