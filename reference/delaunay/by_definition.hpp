// The Delaunay triangulation from its definition. Book: Definition 4.1.
#pragma once

#include "reference/kernel/complex/point_set.hpp"
#include "reference/kernel/complex/triangulation.hpp"

namespace circumspect::delaunay {

// The canonical Delaunay triangulation (weighted: the canonical weighted one): all (k+1)-subsets
// that are no flat simplex and whose (perturbed) open circumball holds no point of the set. Under
// the canonical perturbation every set is generic, so these simplices are a triangulation
// (Theorem 4.4). Any number of points, any dimension; takes n^(k+2) predicates.
Triangulation by_definition(const PointSet& points);

}  // namespace circumspect::delaunay
