// The arrangement of segments that meet as they like, of the plane or of space with polygons between them: what a program
// that promises to resolve untidy input has to mesh.
#pragma once

#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"

namespace circumspect {

// Equal vertices become one, the first of them; each point in which two segments cross, or a segment goes through a
// polygon, is a vertex, after all others; and each segment, edges of polygons included, is cut at every vertex that lies
// inside it. What two segments share is there once, and a segment of equal ends is its vertex alone. So no two of the
// segments of the result meet but in common vertices, and their union is that of the input's: what Definition 4.3 of the
// book asks of them. Polygons keep their place: where two of them cross, or overlap, they still do, and `validated` says so, as
// of a hole seed that lies on a wall.
// Requires: segments are pairs of points; in the plane no polygons. Quadratic time.
PiecewiseLinearInput arranged(const PiecewiseLinearInput& input);

}  // namespace circumspect
