// Are segments and lone vertices of a domain in the mesh?
#pragma once

#include "oracle/judge/domain/meshed_domain.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

// domain.vertex-in-edge: an edge of the mesh whose ends are on one segment, but not next to each
// other. domain.segment-missing: a link that is not an edge of the mesh, or one inside a polyhedron
// that is not an edge of a simplex there. True if nothing is wrong.
bool judge_segments(const MeshedDomain& in, Verdict& verdict);

// domain.vertex-missing: a vertex of the domain inside a polyhedron that no simplex has for a
// vertex.
bool judge_inner_vertices(const MeshedDomain& in, Verdict& verdict);

}  // namespace circumspect::check
