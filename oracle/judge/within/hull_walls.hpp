// A domain that is a convex hull, with the hull's own boundary as walls. Only cells can have
// images. docs/theory/within.md, "Convex hulls".
#pragma once

#include <vector>

#include "kernel/complex/point_set.hpp"
#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"

namespace circumspect::check {

// The same points, segments and polygons in the same order, then more: the edges of the convex
// hull, cut at the points on them, are segments; in space the parts of its faces between segments
// that no polygon covers are polygons, each connected. What these walls enclose is the hull, so the
// kind is kEnclosed, without holes. `faces`: as hull_faces returns them; none where the points span
// no space (in the plane: no plane), for then nothing is filled.
// Requires: a valid complex of the kind kHull, with a point.
PiecewiseLinearComplex with_hull_walls(const PiecewiseLinearComplex& complex,
                                       const std::vector<std::vector<Vertex>>& faces);

}  // namespace circumspect::check
