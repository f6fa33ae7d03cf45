// Joining polygons of one plane, as the users of CAD programs mean a face that was cut into
// triangles.
// Book: Section 4.5.1 (polygons with holes, slits and vertices in their interior).
#pragma once

#include <vector>

#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"

namespace circumspect {

// A complex with joined polygons, and what somebody would have handed in for it.
struct JoinedPolygons {
  PiecewiseLinearInput input;
  PiecewiseLinearComplex complex;
  std::vector<std::vector<std::size_t>>
      members;  // of each polygon: of which it was joined, ascending
  std::size_t removed_segments = 0;
};

// Two polygons belong together if they lie in one plane, exactly, and a segment lies in both; what
// belongs to the same polygon belongs together. A joined polygon covers what its members cover,
// with their holes and slits. A segment that two of them have and nothing else has, neither a
// polygon of another plane nor a list of segments (lines of two vertices among them), stops being
// one. All vertices stay vertices, also those that lie inside a joined polygon and in nothing
// else. So the polyhedra do not change: the walls, triangle by triangle, are the same. Polygons are
// in the order of their first members.
// Requires: the complex is what `validated` or `assemble` made of the input, in space.
JoinedPolygons coplanar_polygons_joined(const PiecewiseLinearInput& input,
                                        const PiecewiseLinearComplex& complex);

// Do two polygons belong together? Much faster than to join them.
bool share_segments_in_one_plane(const PiecewiseLinearComplex& complex);

// The segments that somebody lists as segments, not only as edges of outlines: ascending pairs,
// each once, in lexicographic order.
std::vector<Simplex> listed_segments(const PiecewiseLinearInput& input);

}  // namespace circumspect
