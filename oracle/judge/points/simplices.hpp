// Each simplex by itself, and the set of vertices: conditions that must hold before simplices can be compared with
// each other.
#pragma once

#include <optional>
#include <vector>

#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

// triangulation.unknown-vertex, simplex.wrong-dimension, simplex.repeated-vertex,
// simplex.degenerate, then complex.duplicate-simplex and, if `oriented`, simplex.orientation. True
// if the simplices can be worked with: nothing but their order of vertices is wrong with them.
// `of_most`: the orientation of most, if the mesh is a part of the one that is judged. Requires: of the whole, the
// first that has it is in the part.
bool judge_simplices(const ExactMesh& mesh, bool oriented, Verdict& verdict,
                     std::optional<int> of_most = std::nullopt);

// The points that are a vertex of no simplex, ascending.
std::vector<Vertex> unused_points(const ExactMesh& mesh);

// triangulation.unused-point: the vertices must be all the points.
void judge_vertex_set(const ExactMesh& mesh, Verdict& verdict);

}  // namespace circumspect::check
