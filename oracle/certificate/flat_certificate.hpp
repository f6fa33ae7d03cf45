// Proof of claims about points of a plane in space: a certificate of their picture, as they are
// seen along an axis.
#pragma once

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

#include "kernel/exact/triple.hpp"
#include "oracle/certificate/certificate.hpp"
#include "oracle/certificate/scaled_points.hpp"
#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::certificate {

struct FlatCertificate {
  // Of the points in the plane. For the claim delaunay each has a weight, so that its height is the
  // square of its norm in space: the plane over a triangle is then that of a ball in space.
  Certificate seen;
  std::size_t axis;             // the coordinate that is not seen
  std::vector<Integer> unseen;  // one a point
  Triple<Integer> normal;       // of the plane <normal, p> = offset
  Integer offset;
};

// Near-linear in the mesh. Requires: the claim, triangulation or delaunay, holds of the mesh, whose
// points are in space and in one plane, but not on one line.
FlatCertificate flat_certificate_of(const ExactMesh& mesh, Claim claim, ScaledPoints points);

// As proofs/CERTIFICATE.md lays it out. The mesh says by which index its user knows a point.
void write(std::ostream& out, const ExactMesh& mesh, const FlatCertificate& certificate);

}  // namespace circumspect::certificate
