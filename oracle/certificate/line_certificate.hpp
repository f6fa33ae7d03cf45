// Proof of claims about points on a line, or about one point: which simplex joins which neighbours.
#pragma once

#include <cstddef>
#include <ostream>
#include <vector>

#include "oracle/certificate/certificate.hpp"
#include "oracle/certificate/scaled_points.hpp"
#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::certificate {

struct LineCertificate {
  Claim claim;
  ScaledPoints points;
  std::vector<Vertex> order;  // all vertices, along the line
  // For each two neighbours in this order the simplex that joins them.
  std::vector<std::size_t> joining = {};
};

// Near-linear in the mesh. Requires: the claim, triangulation or delaunay, holds of the mesh, whose
// points have two or three coordinates and lie on one line or in one place.
LineCertificate line_certificate_of(const ExactMesh& mesh, Claim claim, ScaledPoints points);

// As proofs/CERTIFICATE.md lays it out. The mesh says by which index its user knows a point.
void write(std::ostream& out, const ExactMesh& mesh, const LineCertificate& certificate);

// Points that make d+1 affinely independent ones of those that span the affine hull of a mesh:
// steps along the axes that the hull can do without. As proofs/CERTIFICATE.md lays them out.
void write_pads(Lines& lines, const ExactMesh& mesh, const ScaledPoints& points);

}  // namespace circumspect::certificate
