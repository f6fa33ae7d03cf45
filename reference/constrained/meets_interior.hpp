// Does a facet reach into a simplex? Book: Section 4.5.2 (where it does, and lies in a polygon, the
// simplex does not respect the PLC), Section 5.8 ("the tetrahedra whose interiors intersect f").
#pragma once

#include <span>

#include "reference/complex/point_set.hpp"

namespace circumspect::constrained {

// Does the interior of the k-simplex contain a point of the (closed) (k−1)-simplex `facet`, k = 2 or
// 3, on these axes? (It may be a simplex of lower dimension, too.) Clips the facet by the halfspaces
// of the simplex; a mean of the corners of what is left lies in the interior if any point of the
// facet does.
// Requires: neither is degenerate on the axes.
bool meets_interior(const PointSet& points, std::span<const std::size_t> axes,
                    const Simplex& simplex, const Simplex& facet);

}  // namespace circumspect::constrained
