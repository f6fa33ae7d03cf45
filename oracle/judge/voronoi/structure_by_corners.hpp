// The vertices and ridges of the Voronoi diagram within a box, from the corners of its cells.
#pragma once

#include "oracle/judge/definition/voronoi_structure.hpp"
#include "oracle/judge/voronoi/sites_around.hpp"

namespace circumspect::check {

// The answer of definition::exact_structure. A corner of cells within the box is a vertex if the
// sites of these cells span the plane, or space. These sites are then the corners of a polytope:
// its edges are the ridges at the vertex, its facets the edges (in the plane: the ridges) at it. A
// ridge leaves the box if one of its edges does, which then has only one vertex in the box: a
// polygon whose edges do not is inside.
definition::VoronoiStructure structure_by_corners(const PointSet& sites, const SitesAround& around);

}  // namespace circumspect::check
