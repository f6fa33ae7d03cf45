// The arrangement of segments of the plane that meet as they like: what a program that promises to resolve
// untidy input has to mesh.
#pragma once

#include "reference/kernel/piecewise_linear/piecewise_linear_complex.hpp"

namespace circumspect {

// Equal vertices become one, the first of them; each point in which two segments cross is a vertex, after all others;
// and each segment is cut at every vertex that lies inside it. What two segments share is there once, and a segment of
// equal ends is its vertex alone. So no two of the segments of the result meet but in common vertices, and their union is
// that of the input's: what Definition 4.3 of the book asks of them. Whether a hole seed lies on one of them is left to
// `validated`.
// Requires: points of the plane; segments are pairs of them; no polygons. Quadratic time.
PiecewiseLinearInput arranged(const PiecewiseLinearInput& input);

}  // namespace circumspect
