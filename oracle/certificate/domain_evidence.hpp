// What shows that a mesh breaks a claim about a domain, in the mesh and the domain's vertices and
// segments alone.
#pragma once

#include <optional>
#include <vector>

#include "oracle/certificate/evidence.hpp"
#include "oracle/certificate/scaled_points.hpp"
#include "oracle/model/domain.hpp"
#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::certificate {

// Evidence of the first broken rule that has some; nothing if none has. `all` are the simplices of
// the mesh, then what dangles; `vertices`: which of the points each vertex of the domain is.
// Requires: the verdict does not hold.
std::optional<Evidence> domain_evidence(const ExactMesh& mesh, const ExactMesh& all,
                                        const Domain& domain, const Verdict& verdict,
                                        const ScaledPoints& points,
                                        const std::vector<Vertex>& vertices);

}  // namespace circumspect::certificate
