// Inserting a segment into a planar CDT. Book: Section 3.10.
#pragma once

#include "reference/complex/point_set.hpp"
#include "reference/complex/star_index.hpp"

namespace circumspect::constrained {

// The canonical Delaunay triangulation of some vertices of one plane. No triangle if they lie on one
// line.
StarIndex planar_delaunay(const PointSet& points, const std::vector<std::size_t>& axes,
                          const std::vector<Vertex>& vertices);

// Makes the canonical CDT of some segments that of these and of one more: deletes the triangles that
// the segment crosses, and retriangulates the cavities on its left and right.
// Requires: the triangles fill a convex hull; both ends are vertices; no vertex is inside the segment,
// and no other segment crosses it.
void insert_segment(const PointSet& points, const std::vector<std::size_t>& axes,
                    StarIndex& triangles, const Simplex& segment);

}  // namespace circumspect::constrained
