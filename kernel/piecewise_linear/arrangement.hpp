// The arrangement of segments that may meet in any way, in the plane, or in space with polygons
// among them: what a program that promises to resolve untidy input has to mesh.
#pragma once

#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"

namespace circumspect {

// Equal vertices become one, the first of them; each point in which two segments cross, or a
// segment goes through a polygon, is a vertex, after all others; and each segment, edges of
// polygons included, is cut at every vertex that lies inside it. A part that two segments share
// occurs once, and a segment with equal ends becomes a vertex. So segments of the result meet only
// in common vertices, and their union is that of the input's segments, as Definition 4.3 of the
// book requires. Polygons are not changed: if two of them cross or overlap, they still do, and
// `validated` says so, and likewise for a hole seed that lies on a wall. In the plane the lines of
// polygons are cut like segments, and their edges are segments only if they are listed as such.
// Requires: segments are pairs of points. Quadratic time.
PiecewiseLinearInput arranged(const PiecewiseLinearInput& input);

}  // namespace circumspect
