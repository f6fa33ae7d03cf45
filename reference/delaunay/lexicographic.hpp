// The lexicographic triangulation: a triangulation of any point set, without the Delaunay property.
// Book: Section 2.1, Section 4.1 ("the lexicographic triangulation … generalizes to higher
// dimensions with no change").
#pragma once

#include "kernel/complex/point_set.hpp"
#include "kernel/complex/triangulation.hpp"

namespace circumspect::delaunay {

// Takes the points in lexicographic order. Each lies outside the convex hull of those before it,
// and is joined to every hull facet that it sees, or, if it leaves their affine hull, to all of
// their simplices. Weights play no part. Any number of points, any dimension.
Triangulation lexicographic(const PointSet& points);

}  // namespace circumspect::delaunay
