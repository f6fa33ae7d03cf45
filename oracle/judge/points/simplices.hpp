// Each simplex by itself, and the set of vertices: conditions that must hold before simplices can
// be compared with each other.
#pragma once

#include <optional>
#include <vector>

#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

// triangulation.unknown-vertex, simplex.wrong-dimension, simplex.repeated-vertex,
// simplex.degenerate, then complex.duplicate-simplex and, if `oriented`, simplex.orientation. True
// if the simplices are usable: nothing is wrong with them except the order of their vertices.
// `of_most`: the orientation of most simplices, if the mesh is a part of the one that is judged.
// Requires: the part contains the first simplex of the whole that has this orientation.
bool judge_simplices(const ExactMesh& mesh, bool oriented, Verdict& verdict,
                     std::optional<int> of_most = std::nullopt);

// The points that are not vertices of any simplex, ascending.
std::vector<Vertex> unused_points(const ExactMesh& mesh);

// triangulation.unused-point: the vertices must be all the points.
void judge_vertex_set(const ExactMesh& mesh, Verdict& verdict);

}  // namespace circumspect::check
