// What proves that a mesh is a triangulation, Delaunay or not: the mesh with everything that a proved
// checker needs to see it in linear time. proofs/CERTIFICATE.md says what it has to fulfil.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <ostream>
#include <vector>

#include "oracle/certificate/lines.hpp"
#include "oracle/certificate/scaled_points.hpp"
#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::certificate {

// What lies across a facet or a ridge, and the place of its vertex that the facet or ridge leaves out.
// A facet of the hull has a hull facet there, which leaves out no vertex.
struct Across {
  std::uint32_t cell = 0;
  std::int32_t place = kHull;

  static constexpr std::int32_t kHull = -1;
};

// Vertices are those of the mesh; in the plane the last entry of each array is not used.
struct CertifiedSimplex {
  std::array<Vertex, 4> vertices = {};  // positively oriented
  std::array<Across, 4> across = {};
  std::optional<std::size_t> separating = {};  // the facet beyond which the sample lies
};

// The vertices of a hull facet are in the order of its simplex.
struct HullFacet {
  std::uint32_t simplex = 0;
  std::uint32_t place = 0;
  std::array<Across, 3> across = {};
};

// Where a point is a vertex; or, if it is none, in which simplex it lies.
struct Incidence {
  std::uint32_t simplex = 0;
  std::optional<std::size_t> place = {};
};

struct Certificate {
  Claim claim = Claim::kDelaunay;
  ScaledPoints points;
  std::vector<Vertex> order = {};  // all vertices, in lexicographic order of their coordinates
  std::vector<Incidence> incidences = {};  // one a vertex
  std::vector<CertifiedSimplex> simplices = {};
  std::vector<HullFacet> hull = {};
  HomogeneousPoint sample = {};  // in the interior of the first simplex
  // Besides the claim: `unique` if it is the only such triangulation of the points, `canonical` if it is
  // the canonical one; or nothing.
  std::string_view standing = {};
};

// Linear in the mesh but for sorting, and for what it takes to find weighted points that are no
// vertices. Requires: the claim holds of the mesh; its points have dimension 2 or 3, and that is the
// dimension of their affine hull.
Certificate certificate_of(const ExactMesh& mesh, Claim claim, ScaledPoints points);

// From the scale to the sample point; proofs/CERTIFICATE.md lays it out. The mesh says by which index its
// user knows a point.
void write_mesh(Lines& lines, const ExactMesh& mesh, const Certificate& certificate);

// As proofs/CERTIFICATE.md lays it out. The mesh says by which index its user knows a point.
void write(std::ostream& out, const ExactMesh& mesh, const Certificate& certificate);

}  // namespace circumspect::certificate
