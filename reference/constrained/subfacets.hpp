// The triangles of which a polygon is to be the union. Book: Section 4.5.3 ("every polygon is a union
// of Delaunay (preferably strongly Delaunay) triangles").
#pragma once

#include <vector>

#include "reference/kernel/complex/circumball.hpp"
#include "reference/kernel/piecewise_linear/piecewise_linear_complex.hpp"

namespace circumspect::constrained {

// The triangles of the canonical Delaunay triangulation of some points of the polygon that are in it.
// If the segments of the polygon are unions of edges, so is the polygon of these; and a triangulation
// of more points under the canonical perturbation, of which the polygon is a union of triangles, has
// these and no other triangles in it.
// Requires: `vertices` are the polygon's, and others that have been added in it.
std::vector<Simplex> subfacets(const PointSet& points, const Polygon& polygon,
                               const std::vector<Vertex>& vertices);

// Does the polygon contain this point of its plane?
bool is_in_polygon(const PointSet& points, const Polygon& polygon, const Point& point);

// A point in the plane of the polygon, a quarter of the circumradius or less from the circumcentre of
// the triangle. Its coordinates on the polygon's axes are dyadic and as short as that allows: exact
// circumcentres of triangles of circumcentres would soon have thousands of digits.
Point near_circumcentre(const PointSet& points, const Polygon& polygon, const Ball& circumball);

// Do two segments in the plane of the polygon have a point in common?
bool do_meet(const std::vector<std::size_t>& axes, const Point& a, const Point& b, const Point& c,
             const Point& d);

}  // namespace circumspect::constrained
