// Inserting a polygon into a CDT by gift-wrapping. Book: Section 5.8 ("the obvious algorithm").
#pragma once

#include "reference/constrained/evolving_cdt.hpp"
#include "reference/piecewise_linear/piecewise_linear_complex.hpp"

namespace circumspect::constrained {

// "Delete the tetrahedra whose interiors intersect f. All the simplices not deleted are still
// constrained Delaunay. Then retriangulate the polyhedral cavities on either side of f." Makes the
// CDT of P that of P ∪ {f}, or says why it cannot be done, and then nothing has changed.
// Requires: the CDT is that of a PLC P in which all vertices of the points that are in f are
// vertices, and P ∪ {f} is a valid PLC; it fills a convex hull, so that f does not leave it, which
// is asserted.
std::optional<NoChange> insert_polygon_by_cavity(const PointSet& points, EvolvingCdt& cdt,
                                                 const Polygon& polygon);

}  // namespace circumspect::constrained
