// What is to be triangulated in a plane: a polygon, a PLC in the plane, or a convex hull.
// Book: Section 4.5.4, Proposition 4.11 (the faces of a polygon are a two-dimensional PLC).
#pragma once

#include <vector>

#include "reference/piecewise_linear/piecewise_linear_complex.hpp"

namespace circumspect::constrained {

// The edges of the convex hull of some vertices of one plane, which projects injectively on the two
// axes, cut at every vertex that lies on them; each ascending, in lexicographic order. If all the
// vertices lie on one line, these are the edges between successive ones.
std::vector<Simplex> hull_edges(const PointSet& points, const std::vector<std::size_t>& axes,
                                std::vector<Vertex> vertices);

// A polygon with these vertices, and with these segments and (of the hull kind) the edges of the hull
// for segments. It is the union of the bounded components of the complement of its segments, without
// those that hold a hole seed (the hull kind has no holes); so it need not be connected, and it is
// empty if nothing is enclosed.
// Requires: as for `polygon_triangles`.
Polygon planar_domain(const PointSet& points, const std::vector<std::size_t>& axes,
                      const std::vector<Vertex>& vertices, std::vector<Simplex> segments,
                      const std::vector<Point>& hole_seeds, DomainKind kind);

}  // namespace circumspect::constrained
