// The claim that is meant where nobody names one.
#pragma once

#include "oracle/model/claim.hpp"
#include "oracle/model/domain.hpp"
#include "oracle/model/mesh.hpp"

namespace circumspect::check {

// Delaunay, where there is no domain. With a domain a CDT, or a Steiner CDT if the mesh has other
// points than the domain; if points may have been moved (`--within`), another number of points.
// Requires: no equal points, where there is a domain.
Claim default_claim(const Mesh& mesh, const Domain* domain, bool are_moved = false);

}  // namespace circumspect::check
