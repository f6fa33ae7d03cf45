// Proof that facets are the boundary of a convex hull: the cones over them, a triangulation.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "oracle/certificate/certificate.hpp"
#include "oracle/model/exact_mesh.hpp"

namespace circumspect::certificate {

struct HullCertificate {
  // Each facet makes a simplex with the summit, the last point, which is nobody's. If some points
  // are not vertices, it is a weighted Delaunay triangulation: the summit is lowered, and all other
  // points have one height.
  Certificate cones;
  std::vector<Vertex> around;  // d+1 of the points, positively oriented: the summit is inside
};

// Near-linear in the mesh. Requires: the claim convex-hull holds of the mesh, whose points span the
// plane or space. Error: why there is none, for people.
tl::expected<HullCertificate, std::string> hull_certificate_of(const ExactMesh& mesh);

// As proofs/CERTIFICATE.md lays it out. The mesh says by which index its user knows a point.
void write(std::ostream& out, const ExactMesh& mesh, const HullCertificate& certificate);

}  // namespace circumspect::certificate
