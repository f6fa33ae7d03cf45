// Programs that people use, as functions: Debian's CGAL, TetGen and Qhull. They are put to the test
// here and are a second opinion nowhere: nothing that ships is linked to them (their licences, the
// GPL, the AGPL and Qhull's own, stay with the tests). Gmsh's library needs half a gigabyte of
// other libraries, so campaigns run Gmsh as a program (hunt/pages/).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <circumspect/subject.hpp>

namespace circumspect::adapters {

// CGAL, with the kernel that its manual recommends (exact predicates, inexact constructions),
// points inserted in their order. Of equal points the first one is named. They are right on every
// input that has been tried; sets of a lower dimension get rows of fewer indices.
SimplexArray cgal_delaunay_2(const PointArray& points);
SimplexArray cgal_delaunay_3(const PointArray& points);
// Regular_triangulation_3: weights are squared radii, as ours. Without weights: all 0.
SimplexArray cgal_regular_3(const PointArray& points);

// The triangles of the convex hull, with all segments as edges (or as chains of edges, where a
// point lies on one). If the points lie in a line: the edges that segments cover. Requires:
// dimension 2; segments name points and do not cross.
using Segments = std::vector<std::array<std::int64_t, 2>>;
SimplexArray cgal_constrained_2(const PointArray& points, const Segments& segments);

// What CGAL makes of a mesh that somebody else made, in space, when its assertions are off.
enum class Opinion {
  kValid,            // is_valid() returns true
  kInvalid,          // it returns false
  kNoDataStructure,  // the mesh cannot be put into CGAL's structure: its facets do not match
};
Opinion cgal_is_valid_3(const PointArray& points, const SimplexArray& simplices);

// TetGen's library. Throws std::runtime_error with its error code. Limits that its documents name:
// points within 1e-8 of the size of the set of each other may be merged (switch -T). Limits that
// they do not name (hunt/pages/): fewer than four points, coordinates beyond 1e100, and coplanar
// points end the process, with a signal or an endless loop. Requires: none of these; dimension 3.
SimplexArray tetgen_delaunay(const PointArray& points);

// Qhull's reentrant library with the options "d Qt Qbb Qc": the lower hull of the lifted points.
// Throws std::runtime_error with its error code. Its documents name its limits: facets that are
// nearly in one hyperplane are merged, with option Qt their triangulation may overlap, and sets of
// a lower dimension are an error. Requires: dimension is 2 or more.
SimplexArray qhull_delaunay(const PointArray& points);

}  // namespace circumspect::adapters
