// Proof that the triangles of a surface are intrinsically Delaunay: their edges, in order.
#pragma once

#include <cstdint>
#include <ostream>
#include <vector>

#include "oracle/certificate/scaled_points.hpp"
#include "oracle/model/exact_mesh.hpp"

namespace circumspect::certificate {

struct SurfaceCertificate {
  // The edge opposite a vertex of a triangle.
  struct Edge {
    std::uint32_t triangle;
    std::uint32_t place;
  };

  ScaledPoints points;
  std::vector<Vertex> order = {};  // all vertices, in lexicographic order of their coordinates
  // Of all triangles, by their ends and the vertex opposite as `order` numbers these: so the same
  // edges stand side by side.
  std::vector<Edge> edges = {};
};

// Near-linear in the mesh. Requires: the claim surface-delaunay holds of the mesh, and its points
// have two or three coordinates.
SurfaceCertificate surface_certificate_of(const ExactMesh& mesh, ScaledPoints points);

// As proofs/CERTIFICATE.md lays it out. The mesh says by which index its user knows a point.
void write(std::ostream& out, const ExactMesh& mesh, const SurfaceCertificate& certificate);

}  // namespace circumspect::certificate
