// Are the neighbours that a program lists (TetGen's and Triangle's .neigh) the true ones?
#pragma once

#include <vector>

#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/verdict.hpp"
#include "reference/kernel/complex/simplex.hpp"

namespace circumspect::check {

// complex.wrong-neighbor: entry i of a simplex must be the simplex across the facet opposite its
// vertex i, or none on the boundary. Requires: the mesh lists neighbours; simplices are sound and
// facets lie in one or two of them. `uses` are those of the mesh.
void judge_neighbors(const ExactMesh& mesh, const std::vector<FacetUse>& uses, Verdict& verdict);

// The same of one facet, of which somebody else has found that the simplex across, `across` if there is one,
// is not the one that is listed. `listed`, `expected`: the indices, as the program counts.
void add_wrong_neighbor(const ExactMesh& mesh, const FacetUse& use, const Simplex* across,
                        Vertex listed, Vertex expected, Verdict& verdict);

}  // namespace circumspect::check
