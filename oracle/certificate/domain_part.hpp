// The part of a domain certificate that is the same for a domain and for a polygon seen as one.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "oracle/certificate/domain_certificate.hpp"
#include "oracle/judge/domain/meshed_domain.hpp"

namespace circumspect::certificate {

struct PartInput {
  const Certificate& mesh;  // of the whole hull
  std::size_t kept;         // so many simplices, the first ones, are kept
  DomainKind kind;
  std::vector<bool> is_corner = {};                                   // by the vertices
  std::vector<std::vector<std::pair<Integer, Vertex>>> weights = {};  // likewise, or empty
  std::vector<std::vector<Vertex>> chains = {};                       // of the segments
  std::map<Simplex, std::pair<std::size_t, std::size_t>> walls = {};  // facets, ascending
  std::vector<HomogeneousPoint> seeds = {};                           // of the holes
};

// Error: why there is none, for people.
tl::expected<DomainPart, std::string> domain_part(const PartInput& input);

// The point v as a combination, with weights that are not negative, of the vertices of a simplex that
// contains it; empty if none does.
std::vector<std::pair<Integer, Vertex>> combination(const ScaledPoints& points,
                                                    const std::vector<Simplex>& simplices,
                                                    Vertex v);

// The hole seeds that make holes.
std::vector<Point> seeds_of_holes(const check::MeshedDomain& in);

}  // namespace circumspect::certificate
