// Proof that the cells which a lattice repeats are a Delaunay triangulation, or that they are not.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "oracle/certificate/scaled_points.hpp"
#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/periodic.hpp"
#include "oracle/model/periodic_facets.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::certificate {

struct PeriodicDocument {
  // The cell across a facet, the place of its vertex opposite, and how far that cell is moved.
  struct Link {
    std::size_t cell = 0;
    std::size_t place = 0;
    Simplex offset = {};
  };
  // Where a point is a corner.
  struct Home {
    std::size_t cell = 0;
    std::size_t place = 0;
  };

  ScaledPoints points;  // with the copies, for which the file lists the lattice
  std::size_t listed = 0;
  std::vector<std::vector<Integer>> lattice = {};  // in the scale of the points
  std::vector<std::vector<Integer>> dual = {};     // the dual basis, times `factor`
  Integer factor = 1;
  Integer first_reached = 0;  // moves by other multiples are too far to matter
  Integer last_reached = 0;
  std::vector<PeriodicCell> cells = {};
  // If the claim holds:
  std::vector<Home> homes = {};               // one a listed point
  std::vector<std::vector<Link>> links = {};  // one a facet of each cell
  HomogeneousPoint sample = {};               // in the interior of the first cell
  // If it does not:
  std::string rule = {};  // which the evidence shows to be broken; empty if the claim holds
  std::vector<Integer> because = {};
};

// Near-linear in the mesh. Error: why there is neither a certificate nor a refutation, for people.
// Requires: the verdict is about the mesh, which was unfolded (oracle/judge/periodic/unfolded.hpp).
tl::expected<PeriodicDocument, std::string> periodic_document_of(const ExactMesh& mesh,
                                                                 const Copies& copies,
                                                                 const Verdict& verdict);

// As proofs/CERTIFICATE.md lays it out. The mesh says by which index its user knows a point.
void write(std::ostream& out, const ExactMesh& mesh, const PeriodicDocument& document);

}  // namespace circumspect::certificate
