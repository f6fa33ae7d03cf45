// The Delaunay subdivision as the lower convex hull of the lifted points, and the canonical
// triangulation of it. Book: Section 4.2.
#pragma once

#include "reference/kernel/complex/polyhedral_complex.hpp"
#include "reference/kernel/complex/triangulation.hpp"

namespace circumspect::delaunay {

// The Delaunay subdivision (weighted: the regular subdivision of the heights |p|² − w), each face
// with all the points whose lifted companions lie on it. No perturbation takes part. Any number of
// points, any dimension.
//
// By definition: through every k+1 lifted points, is there a non-vertical hyperplane with no lifted
// point below?
PolyhedralComplex delaunay_subdivision_by_definition(const PointSet& points);

// By gift-wrapping the whole convex hull of the lifted points in R^{d+1}, of which the
// downward-facing facets are kept. Time O(n f) for a hull with f facets.
PolyhedralComplex delaunay_subdivision(const PointSet& points);

// The canonical Delaunay triangulation, as the least-vertex triangulation of the subdivision.
Triangulation lifted_hull_by_definition(const PointSet& points);
Triangulation lifted_hull(const PointSet& points);

}  // namespace circumspect::delaunay
