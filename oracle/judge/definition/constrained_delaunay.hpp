// Is a triangulation of a complex constrained Delaunay? Book: Definitions 4.6 and 4.7.
#pragma once

#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::definition {

// "Every tetrahedron is constrained Delaunay, and every dangling triangle": no vertex that is
// visible from a point in its relative interior is in its open circumball
// (cdt.visible-vertex-in-ball, cdt.dangling-not-delaunay). That it respects the complex is known of
// a simplex of a triangulation. Of a dangling triangle nothing beside its plane is visible, for |P|
// is not beside it; and all its circumballs cut that plane in its circumdisk. So its one circumdisk
// decides.
// Requires: the mesh is a triangulation of the complex, which has the same vertices.
void judge_constrained_delaunay(const ExactMesh& mesh, const PiecewiseLinearComplex& complex,
                                Verdict& verdict);

}  // namespace circumspect::definition
