// Inserting a vertex into a CDT, and deleting one. Book: Section 5.7 (Section 3.9 for the plane),
// Section 5.6.
#pragma once

#include "reference/constrained/evolving_cdt.hpp"

namespace circumspect::constrained {

// Turns the CDT of P into that of P ∪ {v}, or says why this is impossible and changes nothing.
//
// The depth-first search of the Bowyer–Watson algorithm, which does not pass through walls, finds
// the tetrahedra whose (perturbed) open circumballs hold v, starting from all that contain v: on
// both sides of a wall, if v lies in one. The cavity must be star-shaped, and no segment or polygon
// may run through its interior. A polygon that contains v does not count: its facets in the cavity
// give way to triangles with the vertex v, and a segment that contains v is split. Requires: the
// CDT is the canonical one of vertices among the points, and fills their convex hull: facets that
// one tetrahedron has are read as the hull's, which is asserted of those at the cavity.
std::optional<NoChange> insert_vertex(const PointSet& points, EvolvingCdt& cdt, Vertex v);

// Turns the CDT of P ∪ {v} into that of P, or says why this is impossible and changes nothing. No
// segment may end at v, except two that v separates: they become one. The polygons that v lies in,
// and the facets of the hull, are retriangulated within their planes first; the star of v is then
// wrapped from these and from the facets of its link. Requires: the CDT is the canonical one of its
// vertices, segments and polygons, and fills a convex hull: facets that one tetrahedron has are
// read as the hull's, which is asserted of those at v.
std::optional<NoChange> delete_vertex(const PointSet& points, EvolvingCdt& cdt, Vertex v);

}  // namespace circumspect::constrained
