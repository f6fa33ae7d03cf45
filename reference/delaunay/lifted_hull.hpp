// The Delaunay triangulation by its definition and by lifting. Book: Section 4.2.
#pragma once

#include <functional>

#include "kernel/complex/point_set.hpp"
#include "kernel/complex/polyhedral_complex.hpp"
#include "kernel/complex/polytope.hpp"
#include "kernel/complex/triangulation.hpp"

namespace circumspect::delaunay {

// The Delaunay triangulation from its definition. Book: Definition 4.1.

// The canonical Delaunay triangulation (weighted: the canonical weighted one): all (k+1)-subsets
// that are not flat and whose (perturbed) open circumball holds no point of the set. Under the
// canonical perturbation every set is generic, so these simplices are a triangulation (Theorem
// 4.4). Any number of points, any dimension; takes n^(k+2) predicates.
Triangulation by_definition(const PointSet& points);

// The least-vertex triangulation of a polyhedral complex. Book: Section 4.2, Figure 4.4.

// Triangulates the faces in order of increasing dimension, each by joining its lexicographically
// minimum vertex to the simplices on its subdivided boundary that do not contain that vertex. So
// faces that two cells share are triangulated alike. A face of a weighted subdivision may also hold
// points that are not extreme. They remain unused: the lexicographic minimum of a set is a vertex
// of its convex hull. The canonical perturbation, which pulls the first point down most, agrees.
Triangulation least_vertex_triangulation(const PointSet& points, const PolyhedralComplex& complex);

// The Delaunay subdivision as the lower convex hull of the lifted points, and the canonical
// triangulation of it. Book: Section 4.2.

// The Delaunay subdivision (weighted: the regular subdivision of the heights |p|² − w), each face
// with all the points whose lifted companions lie on it. No perturbation takes part. Any number of
// points, any dimension.
//
// By definition: for every k+1 lifted points, do they span a non-vertical hyperplane with no lifted
// point below?
PolyhedralComplex delaunay_subdivision_by_definition(const PointSet& points);

// By gift-wrapping the whole convex hull of the lifted points in R^{d+1} and keeping the facets
// that face downwards. Time O(n f) for a hull with f facets. The watch is called for each facet,
// with whether it faces downwards.
using HullWatch = std::function<void(const Face&, bool)>;
PolyhedralComplex delaunay_subdivision(const PointSet& points, const HullWatch& watch = {});

// The canonical Delaunay triangulation, as the least-vertex triangulation of the subdivision.
Triangulation lifted_hull_by_definition(const PointSet& points);
Triangulation lifted_hull(const PointSet& points, const HullWatch& watch = {});

}  // namespace circumspect::delaunay
