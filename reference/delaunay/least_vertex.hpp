// The least-vertex triangulation of a polyhedral complex. Book: Section 4.2, Figure 4.4.
#pragma once

#include "reference/kernel/complex/polyhedral_complex.hpp"
#include "reference/kernel/complex/triangulation.hpp"

namespace circumspect::delaunay {

// Triangulates the faces in order of increasing dimension, each by joining its lexicographically
// minimum vertex to the simplices on its subdivided boundary that do not contain that vertex. Faces
// that two cells share are thereby triangulated alike. A face of a weighted subdivision may also hold
// points that are not extreme. They remain unused: the lexicographic minimum of a set is a vertex of
// its convex hull. The canonical perturbation, which pulls the first point down most, agrees.
Triangulation least_vertex_triangulation(const PointSet& points, const PolyhedralComplex& complex);

}  // namespace circumspect::delaunay
