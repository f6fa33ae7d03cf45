// The triangles and edges that a file lists beside its simplices: are they faces of these?
#pragma once

#include "oracle/model/mesh.hpp"
#include "oracle/model/options.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

// Adds complex.stray-face for each listed face that no simplex has, and counts how many are listed.
// Equal points are one vertex. Requires: the verdict of the claim `complex` on this mesh.
void judge_listed_faces(const Mesh& mesh, By by, Verdict& verdict);

// Would all listed faces be faces of simplices if their indices were greater by `shift`?
bool are_faces_if_shifted(const Mesh& mesh, Vertex shift);

}  // namespace circumspect::check
