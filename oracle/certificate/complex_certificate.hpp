// Proof that the simplices of a mesh alone form a complex: what parts each two of them that are
// near one another.
#pragma once

#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "oracle/certificate/certificate.hpp"
#include "oracle/certificate/scaled_points.hpp"
#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::certificate {

// The hyperplane <normal, p> = offset parts a simplex from another: it is nowhere negative on one,
// nowhere positive on the other, and zero only where they have vertices in common.
struct Parting {
  std::size_t other;  // the number of a simplex
  std::vector<Integer> normal;
  Integer offset;
};

struct ComplexCertificate {
  ScaledPoints points;
  std::vector<Vertex> order = {};  // all vertices, in lexicographic order of their coordinates
  std::vector<Incidence> incidences = {};  // one a point; of one that is unused none
  // One a simplex: points that make d+1 affinely independent ones of its vertices, and partings
  // that the hyperplanes of facets do not show. Of two simplices the first has them.
  std::vector<std::vector<std::vector<Integer>>> pads = {};
  std::vector<std::vector<Parting>> partings = {};
  std::vector<std::size_t> sequence =
      {};  // all simplices, such as are near one another side by side
};

// Near-linear in the mesh. Requires: the claim complex holds of the mesh, but that points may be
// unused, and these have two or three coordinates.
ComplexCertificate complex_certificate_of(const ExactMesh& mesh, ScaledPoints points);

// As proofs/CERTIFICATE.md lays it out. The mesh says by which index its user knows a point.
void write(std::ostream& out, const ExactMesh& mesh, const ComplexCertificate& certificate);

// Proof that two points of a mesh, whose points are not a set, are one.
struct EqualPoints {
  ScaledPoints points;
  Vertex first;
  Vertex second;
  std::vector<std::size_t> basis = {};  // points that span the plane or space
};

// Requires: the verdict, which is about the mesh, names equal points. Error: why there is none, for
// people.
tl::expected<EqualPoints, std::string> equal_points_of(const Mesh& mesh, const Verdict& verdict);

void write(std::ostream& out, const Mesh& mesh, const EqualPoints& equal);

}  // namespace circumspect::certificate
