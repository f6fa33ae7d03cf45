// Are the neighbours that a program lists (TetGen's and Triangle's .neigh) the true ones?
#pragma once

#include <vector>

#include "kernel/complex/simplex.hpp"
#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

// complex.wrong-neighbor: entry i of a simplex must be the simplex across the facet opposite its
// vertex i, or none on the boundary. Requires: the mesh lists neighbours; simplices are sound and
// facets lie in one or two of them. `uses` are those of the mesh.
void judge_neighbors(const ExactMesh& mesh, const std::vector<FacetUse>& uses, Verdict& verdict);

// The same for one facet, given that the simplex across it, `across` if there is one, is not the
// listed one. `listed`, `expected`: the indices as the program counts them.
void add_wrong_neighbor(const ExactMesh& mesh, const FacetUse& use, const Simplex* across,
                        Vertex listed, Vertex expected, Verdict& verdict);

}  // namespace circumspect::check
