// Fills what is between a mesh in space and its convex hull with cones.
#pragma once

#include <optional>

#include "oracle/certificate/domain_certificate.hpp"
#include "oracle/model/exact_mesh.hpp"

namespace circumspect::cli {

// Each pocket gets a further point, and a tetrahedron over each triangle of its boundary. Nothing
// if a pocket has no point that sees all of its boundary, or none is found. Requires: the mesh is a
// complex of tetrahedra.
std::optional<certificate::FilledMesh> filled_by_cones(const ExactMesh& mesh);

}  // namespace circumspect::cli
