// Each simplex by itself, and the set of vertices: what must be true before simplices can be held
// against each other.
#pragma once

#include <vector>

#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

// triangulation.unknown-vertex, simplex.wrong-dimension, simplex.repeated-vertex,
// simplex.degenerate, then complex.duplicate-simplex and, if `oriented`, simplex.orientation. True
// if the simplices can be worked with: nothing but their order of vertices is wrong with them.
bool judge_simplices(const ExactMesh& mesh, bool oriented, Verdict& verdict);

// The points that are a vertex of no simplex, ascending.
std::vector<Vertex> unused_points(const ExactMesh& mesh);

// triangulation.unused-point: the vertices must be all the points.
void judge_vertex_set(const ExactMesh& mesh, Verdict& verdict);

}  // namespace circumspect::check
