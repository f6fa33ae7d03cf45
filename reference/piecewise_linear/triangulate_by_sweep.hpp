// A triangulation of points of one plane that has given segments for edges, by a plane sweep.
#pragma once

#include <vector>

#include "reference/complex/point_set.hpp"

namespace circumspect {

// Triangles that fill the convex hull of the vertices, have all of them for corners and all segments
// for edges; each ascending, in lexicographic order. None if all vertices lie on one line. Any such
// triangulation would do; this one is quick. (K. Hertel and K. Mehlhorn, "Fast triangulation of the
// plane with respect to simple polygons", Information and Control 64, 1985.)
// Requires: the plane projects injectively on the two axes; segments have their ends among the
// vertices, and meet one another and the vertices in their ends only.
std::vector<Simplex> triangulate_by_sweep(const PointSet& points,
                                          const std::vector<std::size_t>& axes,
                                          const std::vector<Vertex>& vertices,
                                          const std::vector<Simplex>& segments);

}  // namespace circumspect
