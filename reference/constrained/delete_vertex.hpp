// Deleting a vertex from a CDT by gift-wrapping. Book: Section 5.6.
#pragma once

#include "reference/constrained/evolving_cdt.hpp"

namespace circumspect::constrained {

// Makes the CDT of P ∪ {v} that of P, or says why it cannot be done, and then nothing has changed.
// No segment may end at v, unless there are two which v parts: they become one. The polygons that v
// lies in, and the facets of the hull, are retriangulated within their planes first; the star of v
// is then wrapped from these and from the facets of its link.
// Requires: the CDT is the canonical one of its vertices, segments and polygons, and fills a convex
// hull: facets that one tetrahedron has are read as the hull's, which is asserted of those at v.
std::optional<NoChange> delete_vertex(const PointSet& points, EvolvingCdt& cdt, Vertex v);

}  // namespace circumspect::constrained
