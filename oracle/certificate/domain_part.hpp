// The part of a domain certificate that a domain and a polygon, seen as a domain of its plane, have
// in common.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "oracle/certificate/domain_certificate.hpp"

namespace circumspect::certificate {

// The triangles and edges that are faces of no simplex, nor of each other.
std::vector<Simplex> dangling_faces(const ExactMesh& mesh);

struct PartInput {
  const Certificate& mesh;  // of the whole hull
  std::size_t kept;         // so many simplices, the first ones, are kept
  DomainKind kind;
  std::vector<bool> is_corner = {};                                   // by the vertices
  std::vector<std::vector<std::pair<Integer, Vertex>>> weights = {};  // likewise, or empty
  std::vector<std::vector<Vertex>> chains = {};                       // of the segments
  std::map<Simplex, std::pair<std::size_t, std::size_t>> walls = {};  // facets, ascending
  std::vector<HomogeneousPoint> seeds = {};  // of the holes, each in a simplex that is not kept
};

// Error: why there is none, for people.
tl::expected<DomainPart, std::string> domain_part(const PartInput& input);

// The point v as a combination, with weights that are not negative, of the vertices of a simplex
// that contains it; empty if none does.
std::vector<std::pair<Integer, Vertex>> combination(const ScaledPoints& points,
                                                    const std::vector<Simplex>& simplices,
                                                    Vertex v);

// The simplex that has the seed strictly inside, if there is one that is not kept; else one that
// has it.
// None: it is in a kept one or beyond all of them, and makes no hole.
std::optional<std::uint32_t> simplex_around(const PartInput& input, const HomogeneousPoint& seed);

// Where the polygons of a complex lie.
struct PolygonPlace {
  const PiecewiseLinearComplex& complex;
  const PointSet& points;
  const ScaledPoints& scaled_points;  // the same
  // Is a point a vertex of the domain, and which points follow on each other on a segment?
  std::function<bool(Vertex)> is_corner;
  std::function<std::vector<Vertex>(std::size_t)> chain;
};

// The polygon number `cell`, which these triangles of the points tile; `listed` are its own
// segments. Where in a mesh the triangles are is left open. Error: why there is none, for people.
tl::expected<PolygonCertificate, std::string> polygon_certificate(const PolygonPlace& in,
                                                                  std::size_t cell,
                                                                  const std::set<Simplex>& listed,
                                                                  const std::vector<Simplex>& tiles,
                                                                  const HullFillers& fillers);

// All polygons of a complex, by its own triangles and with its own points.
tl::expected<std::vector<PolygonCertificate>, std::string> polygon_certificates(
    const PiecewiseLinearComplex& complex, const ScaledPoints& scaled_points,
    const ListedSegments& listed, const HullFillers& fillers);

}  // namespace circumspect::certificate
