// Is a mesh a triangulation of a piecewise linear complex P, or a Steiner triangulation?
// Book: Definitions 4.4 and 4.5:
// "a simplicial complex T such that P and T have the same vertices [T contains every vertex in P
// and possibly more], every linear cell in P is a union of simplices in T, and |T| = |P|".
#pragma once

#include <optional>

#include "oracle/model/domain.hpp"
#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::definition {

// T is the list of simplices with the faces that are listed beside, and lone vertices of P. The
// stages: each simplex by itself; the vertices; a simplicial complex; the cells of P; |T| = |P|.
//
// "Is a union of": the simplices in a cell of P, of its dimension, do not overlap, because T is a
// complex. So they fill the cell iff their lengths (areas, volumes) add up to its own. Measures in
// one line, plane or space are compared by their projections on axes of it, all exact.
//
// If T is one but for vertices that P has not, returns P with the vertices of the mesh, numbered as
// there, its segments and polygons cut into what they are a union of (a polygon has its triangles
// alone). `may_have_more`: may T have such vertices?
// Requires: P is valid (linear_cells.hpp), in the plane or in space; the mesh has no weights, and
// no points or points of the same dimension.
std::optional<PiecewiseLinearComplex> judge_plc_triangulation(const ExactMesh& mesh,
                                                              const PiecewiseLinearComplex& complex,
                                                              bool may_have_more, Verdict& verdict);

}  // namespace circumspect::definition
