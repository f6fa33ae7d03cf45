// The vertices and ridges of the Voronoi diagram within a box, from the corners of its cells.
#pragma once

#include <vector>

#include "oracle/judge/definition/voronoi_structure.hpp"

namespace circumspect::check {

// The answer of definition::exact_structure. A corner of cells within the box is a vertex if the
// sites of these cells span the plane, or space. These sites are then the corners of a polytope:
// its edges are the ridges at the vertex, its facets the edges (in the plane: the ridges) at it. A
// ridge leaves the box if one of its edges does, which then has only one vertex in the box: a
// polygon whose edges do not is inside. Requires: the corners of each site's cell, all different.
definition::VoronoiStructure structure_by_corners(const PointSet& sites,
                                                  const std::vector<std::vector<Point>>& cells);

}  // namespace circumspect::check
