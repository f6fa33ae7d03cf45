// Deleting a vertex from a Delaunay triangulation. Book: Section 5.6 ("retriangulating the cavity
// evacuated when a vertex is deleted … is gift-wrapping").
#pragma once

#include <vector>

#include "kernel/complex/point_set.hpp"
#include "kernel/complex/triangulation.hpp"

namespace circumspect::delaunay {

// The canonical triangulation of a set without one of its points, from the canonical triangulation
// of that set, some of `points`. Vertices keep their numbers. The star of v is evacuated and
// gift-wrapped from the facets of its link inwards; the only candidates are the vertices of the
// link and the submerged points that lie in the star, some of which may surface. If v is on the
// hull, part of the star stays empty; if all other points lie on one hyperplane, the triangulation
// drops a dimension.
//
// `submerged` names the points of the set that are not vertices, only possible with weights.
// Requires: v is a vertex; the triangulation is the canonical one of its vertices and `submerged`.
Triangulation delete_vertex(const PointSet& points, const Triangulation& triangulation, Vertex v,
                            const std::vector<Vertex>& submerged = {});

}  // namespace circumspect::delaunay
