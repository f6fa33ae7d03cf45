// Deleting a polygon from a CDT by gift-wrapping. Book: Section 5.6.
#pragma once

#include "reference/constrained/evolving_cdt.hpp"
#include "reference/piecewise_linear/piecewise_linear_complex.hpp"

namespace circumspect::constrained {

// Makes the CDT of P that of P \ {f}, or says why it cannot be done, and then nothing has changed.
// The segments of f stay.
//
// The facets in f that are not locally Delaunay must go, with the tetrahedra at them. Nobody says
// beforehand which other tetrahedra must: the cavity grows over a facet that is found not to be
// locally Delaunay after the wrapping, and over all its facets where the wrapping fails. In the end
// it holds all tetrahedra that are not constrained Delaunay any more, if P \ {f} has a CDT.
// Requires: f is a polygon of P; the CDT fills a convex hull, which is asserted of the facets in f.
std::optional<NoChange> delete_polygon(const PointSet& points, EvolvingCdt& cdt,
                                       const Polygon& polygon);

}  // namespace circumspect::constrained
