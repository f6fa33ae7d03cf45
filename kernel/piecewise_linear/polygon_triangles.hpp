// Cutting a polygon into triangles, in any way that keeps its segments. Nothing here is Delaunay:
// the triangles only say exactly which points belong to the polygon. Book: Section 4.5.1, Figure
// 4.11 ("Each polygon … may have holes, slits, and vertices in its relative interior").
#pragma once

#include <vector>

#include "kernel/complex/point_set.hpp"
#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"

namespace circumspect {

// Triangles that fill the convex hull of the vertices and have all of them as corners and all
// segments as edges; each ascending, in lexicographic order. None if all vertices lie on one line.
// Any such triangulation would do; this one is quick. (K. Hertel and K. Mehlhorn, "Fast
// triangulation of the plane with respect to simple polygons", Information and Control 64, 1985.)
// Requires: the plane projects injectively on the two axes; segments have their ends among the
// vertices, and meet one another and the vertices in their ends only.
std::vector<Simplex> triangulate_by_sweep(const PointSet& points,
                                          const std::vector<std::size_t>& axes,
                                          const std::vector<Vertex>& vertices,
                                          const std::vector<Simplex>& segments);

// Some triangles with these vertices whose union is the polygon, and which have its segments for
// edges; ascending. The convex hull of the vertices is cut into triangles that have the segments as
// edges; those that are joined, across edges that are not segments, to the outside or to a triangle
// with a hole seed do not belong to the polygon. Segments with the outside on both sides (dangling
// from the outline) leave no triangle, and that is right. `slits` are more segments that may or may
// not lie in the polygon: they become edges as well, but do not separate the polygon from what does
// not belong to it. Requires: `vertices` ascending, in one plane with coordinates `axes`; segments
// and slits meet one another and `vertices` only in their ends, and have ends among the vertices.
std::vector<Simplex> polygon_triangles(const PointSet& points, const std::vector<std::size_t>& axes,
                                       const std::vector<Vertex>& vertices,
                                       const std::vector<Simplex>& segments,
                                       const std::vector<Point>& hole_seeds,
                                       const std::vector<Simplex>& slits = {});

}  // namespace circumspect
