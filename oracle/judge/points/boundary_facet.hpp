// A facet that only one simplex has: a piece of the boundary of what the mesh covers.
#pragma once

#include <vector>

#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/witness.hpp"
#include "reference/kernel/complex/simplex.hpp"

namespace circumspect::check {

struct BoundaryFacet {
  Simplex facet;        // ascending
  Vertex apex;          // the vertex of its simplex off the facet, so on the inner side
  std::size_t simplex;  // the simplex that has it
};

// All of them, in order of their vertices.
std::vector<BoundaryFacet> boundary_facets(const ExactMesh& mesh,
                                           const std::vector<FacetUse>& uses);

// On which side of the facet is q? 1: on the inner side, strictly; 0: in its hyperplane; −1:
// strictly beyond. `points` is the mesh's configuration or one with further points.
int side_of(const Configuration& points, const BoundaryFacet& facet, Vertex q);

// The witness that q lies strictly beyond a facet: the two determinants of opposite signs.
Witness beyond(const ExactMesh& mesh, const BoundaryFacet& facet, Vertex q);

}  // namespace circumspect::check
