// Which facets of a mesh there is something to say of, where much is known of its simplices.
#pragma once

#include <vector>

#include "kernel/complex/simplex.hpp"
#include "oracle/judge/domain/vertex_places.hpp"
#include "oracle/judge/fast/simplex_facts.hpp"
#include "oracle/model/exact_mesh.hpp"

namespace circumspect::check {

// The vertices of a facet, ascending.
Simplex vertices_of(const ExactMesh& mesh, fast::FacetId facet);

// Some of facet_uses(mesh.simplices), in their order; of a facet all uses or none. Left out are
// only facets of two simplices that are not known to be not locally Delaunay, are not listed beside
// the simplices, and are in no wall: in space, no polygon has all of their vertices; in the plane,
// one of these is in no segment.
// Requires: Steiner points are located.
std::vector<FacetUse> uses_of_interest(const ExactMesh& mesh, const PiecewiseLinearComplex& complex,
                                       const VertexPlaces& places, const fast::SimplexFacts& known);

}  // namespace circumspect::check
