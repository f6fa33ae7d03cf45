// Judges whether triangles are intrinsically Delaunay: docs/theory/questions.md.
#pragma once

#include <string>

#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

// Why the mesh cannot be a surface of triangles, one line that says what to do; empty if it can.
std::string fault_of_surface(const Mesh& mesh);

// The answer is the same by definition and by lemma, but for the time that it takes. Triangles that
// are flat or are listed twice are named and set apart, edges of more than two are counted.
Verdict judge_surface(const ExactMesh& mesh, bool by_definition, std::size_t max_violations);

}  // namespace circumspect::check
