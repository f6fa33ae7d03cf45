#include "oracle/certificate/domain_certificate.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "kernel/complex/simplex.hpp"
#include "oracle/certificate/domain_part.hpp"
#include "oracle/judge/domain/plc_triangulation.hpp"
#include "oracle/judge/domain/polygon_tiling.hpp"
#include "oracle/judge/domain/vertex_search.hpp"

namespace circumspect::certificate {
namespace {

using check::MeshedDomain;
using check::VertexPlaces;
using check::WallPiece;

constexpr std::string_view kNoCertificate = "there is no certificate of this mesh: ";

// The mesh, and what fills its hull besides.
std::optional<ExactMesh> filled(const ExactMesh& mesh, const HullFillers::Filler& fill) {
  const auto pockets = fill(mesh.points, mesh.simplices, dangling_faces(mesh));
  if (!pockets) return std::nullopt;
  ExactMesh whole{mesh.points, mesh.simplices, mesh.labels, mesh.first_index};
  whole.simplices.insert(whole.simplices.end(), pockets->begin(), pockets->end());
  return whole;
}

Point without(const Point& point, std::size_t axis) {
  Point rest = point;
  rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(axis));
  return rest;
}

// The plane of three of the points.
void set_plane(const ScaledPoints& points, const Simplex& triangle, PolygonCertificate& polygon) {
  const auto difference = [&](std::size_t i, std::size_t axis) {
    return Integer(points.coordinate(triangle[i], axis) - points.coordinate(triangle[0], axis));
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t next = (axis + 1) % 3;
    const std::size_t last = (axis + 2) % 3;
    polygon.normal[axis] =
        difference(1, next) * difference(2, last) - difference(1, last) * difference(2, next);
  }
  // The least such integers: so the plane is the same, whichever triangle says it.
  Integer common = gcd(gcd(polygon.normal[0], polygon.normal[1]), polygon.normal[2]);
  polygon.axis = 0;
  while (polygon.normal[polygon.axis] == 0) ++polygon.axis;
  if (polygon.normal[polygon.axis] < 0) common = -common;
  for (Integer& x : polygon.normal) x /= common;
  polygon.offset = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    polygon.offset += polygon.normal[axis] * points.coordinate(triangle[0], axis);
  }
}

// The polygon's segments, those that its lines list, as chains of edges of its mesh. `seen`: the
// same vertices in the plane.
template <class Seen>
void add_rim(const PolygonPlace& in, const Polygon& given, const std::set<Simplex>& listed,
             const Seen& seen, PolygonCertificate& polygon, PartInput& part) {
  for (const Simplex& segment : given.segments) {
    if (!listed.contains(segment)) continue;
    const auto found =
        std::lower_bound(in.complex.segments.begin(), in.complex.segments.end(), segment);
    polygon.rim.push_back(static_cast<std::size_t>(found - in.complex.segments.begin()));
    const std::vector<Vertex> chain = seen(in.chain(polygon.rim.back()));
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      part.walls[sorted({chain[i], chain[i + 1]})] = {part.chains.size(), 0};
    }
    part.chains.push_back(chain);
  }
}

void add_hole_seeds(const ScaledPoints& scale, const std::vector<Point>& seeds,
                    PolygonCertificate& polygon, PartInput& part) {
  for (const Point& seed : seeds) {
    const HomogeneousPoint in_space = scaled(scale, seed);
    HomogeneousPoint flat = in_space;
    flat.numerators.erase(flat.numerators.begin() + static_cast<std::ptrdiff_t>(polygon.axis));
    if (!simplex_around(part, flat)) continue;
    polygon.seeds.push_back(in_space);
    part.seeds.push_back(std::move(flat));
  }
}

}  // namespace

tl::expected<PolygonCertificate, std::string> polygon_certificate(const PolygonPlace& in,
                                                                  std::size_t cell,
                                                                  const std::set<Simplex>& listed,
                                                                  const std::vector<Simplex>& tiles,
                                                                  const HullFillers& fillers) {
  const Polygon& given = in.complex.polygons[cell];
  PolygonCertificate polygon{.mesh = {PointSet({}), {}}};
  set_plane(in.scaled_points, tiles.front(), polygon);
  std::map<Vertex, Vertex> below;
  for (const Simplex& tile : tiles) {
    for (const Vertex v : tile) below.emplace(v, 0);
  }
  std::vector<Point> points;
  ScaledPoints flat_points{2, in.scaled_points.scale_numerator, in.scaled_points.scale_denominator};
  for (auto& [v, number] : below) {
    number = static_cast<Vertex>(points.size());
    polygon.above.push_back(v);
    points.push_back(without(in.points[v], polygon.axis));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (axis != polygon.axis)
        flat_points.coordinates.push_back(in.scaled_points.coordinate(v, axis));
    }
  }
  const auto seen = [&](Simplex vertices) {
    for (Vertex& v : vertices) v = below.at(v);
    return vertices;
  };
  ExactMesh kept{PointSet(points), {}};
  for (const Simplex& tile : tiles) kept.simplices.push_back(seen(tile));
  auto whole = filled(kept, fillers.fill);
  if (!whole) {
    return tl::unexpected(
        fmt::format("{}the hull of polygon {} cannot be filled", kNoCertificate, cell + 1));
  }
  polygon.mesh = std::move(*whole);
  polygon.plane = certificate_of(polygon.mesh, Claim::kTriangulation, std::move(flat_points));
  PartInput part{.mesh = polygon.plane, .kept = tiles.size(), .kind = DomainKind::kEnclosed};
  for (const Vertex v : polygon.above) {
    part.is_corner.push_back(in.is_corner(v));
  }
  add_rim(in, given, listed, seen, polygon, part);
  add_hole_seeds(in.scaled_points, given.hole_seeds, polygon, part);
  auto found = domain_part(part);
  if (!found)
    return tl::unexpected(fmt::format("{}polygon {}: {}", kNoCertificate, cell + 1, found.error()));
  if (found->dangles)
    return tl::unexpected(
        fmt::format("{}something dangles in polygon {}", kNoCertificate, cell + 1));
  polygon.part = std::move(*found);
  return polygon;
}

tl::expected<std::vector<PolygonCertificate>, std::string> polygon_certificates(
    const PiecewiseLinearComplex& complex, const ScaledPoints& scaled_points,
    const ListedSegments& listed, const HullFillers& fillers) {
  const PolygonPlace place{complex, complex.points, scaled_points, [](Vertex) { return true; },
                           [&](std::size_t segment) { return complex.segments[segment]; }};
  std::vector<PolygonCertificate> made;
  for (std::size_t cell = 0; cell < complex.polygons.size(); ++cell) {
    auto polygon =
        polygon_certificate(place, cell, listed[cell], complex.polygons[cell].triangles, fillers);
    if (!polygon) return tl::unexpected(polygon.error());
    made.push_back(std::move(*polygon));
  }
  return made;
}

namespace {

// Where in the mesh the facets are, first in what is kept.
std::map<Simplex, std::pair<std::uint32_t, std::size_t>> places_of_facets(
    const ExactMesh& mesh, const Certificate& certificate) {
  std::map<Simplex, std::pair<std::uint32_t, std::size_t>> places;
  const std::size_t size = certificate.points.dimension + 1;
  for (std::size_t s = 0; s < mesh.simplices.size(); ++s) {
    const auto& vertices = certificate.simplices[s].vertices;
    for (std::size_t place = 0; place < size; ++place) {
      Simplex facet(vertices.begin(), vertices.begin() + static_cast<std::ptrdiff_t>(size));
      facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(place));
      places.emplace(sorted(facet), std::pair(static_cast<std::uint32_t>(s), place));
    }
  }
  return places;
}

// The other vertices as combinations of those of the domain, where its hull is the domain.
void weigh(const MeshedDomain& in, const HullFillers& fillers, const Certificate& mesh,
           PartInput& part) {
  std::vector<Simplex> simplices = fillers.triangulate(in.complex.points);
  for (Simplex& simplex : simplices) {
    for (Vertex& v : simplex) v = in.in_mesh(v);
  }
  part.weights.resize(in.mesh.points.size());
  for (Vertex v = 0; in.mesh.points.names(v); ++v) {
    const auto place = VertexPlaces::place(v);
    if (!part.is_corner[place]) part.weights[place] = combination(mesh.points, simplices, v);
  }
}

// The pieces of each polygon, in space.
std::vector<std::vector<Simplex>> tiles_of(const PiecewiseLinearComplex& complex,
                                           const std::vector<WallPiece>& pieces) {
  std::vector<std::vector<Simplex>> tiles(complex.polygons.size());
  if (complex.ambient_dimension() == 2) return tiles;
  for (const WallPiece& piece : pieces) tiles[piece.cell].push_back(piece.facet);
  return tiles;
}

// By the facets, the cell that each is a piece of, and in space which of its pieces.
decltype(PartInput::walls) walls_of(std::size_t dimension, const std::vector<WallPiece>& pieces) {
  decltype(PartInput::walls) walls;
  std::map<std::size_t, std::size_t> counts;
  for (const WallPiece& piece : pieces) {
    walls[piece.facet] = {piece.cell, dimension == 2 ? 0 : counts[piece.cell]++};
  }
  return walls;
}

bool is_of_domain(const MeshedDomain& in, Vertex v) {
  return in.places.in_domain[VertexPlaces::place(v)] != check::kNoVertex;
}

// The certificates of the polygons. What is wrong with them; empty if nothing is.
std::string add_polygons(const MeshedDomain& in, const ListedSegments& listed,
                         const std::vector<std::vector<Simplex>>& tiles, const HullFillers& fillers,
                         DomainCertificate& made) {
  const auto places = places_of_facets(made.whole, made.mesh);
  const PolygonPlace place_of_polygons{
      in.complex, in.mesh.points, made.mesh.points, [&](Vertex v) { return is_of_domain(in, v); },
      [&](std::size_t segment) { return in.chains.chain(segment); }};
  for (std::size_t cell = 0; cell < tiles.size(); ++cell) {
    auto polygon = polygon_certificate(place_of_polygons, cell, listed[cell], tiles[cell], fillers);
    if (!polygon) return polygon.error();
    for (const Simplex& tile : tiles[cell]) {
      const auto place = places.find(tile);
      if (place == places.end())
        return std::string(kNoCertificate) + "a triangle that dangles is in no mesh of the hull";
      made.dangles = made.dangles || place->second.first >= in.mesh.simplices.size();
      polygon->tiles.push_back(place->second);
    }
    made.polygons.push_back(std::move(*polygon));
  }
  return "";
}

// In a CDT such a triangle is shown to be constrained Delaunay by a whole mesh that is Delaunay.
bool has_dangling_triangle(const ExactMesh& mesh) {
  const std::vector<Simplex> faces = dangling_faces(mesh);
  return mesh.points.ambient_dimension() == 3 &&
         std::any_of(faces.begin(), faces.end(),
                     [](const Simplex& face) { return face.size() == 3; });
}

tl::expected<DomainCertificate, std::string> certificate_in(
    const MeshedDomain& in, const Domain& domain, const ListedSegments& listed, Claim claim,
    const std::vector<WallPiece>& pieces, const HullFillers& fillers) {
  const std::size_t dimension = in.complex.ambient_dimension();
  auto points = scaled_to_integers(in.mesh.points);
  if (!points) return tl::unexpected(points.error());
  const bool has_triangle =
      (claim == Claim::kCdt || claim == Claim::kSteinerCdt) && has_dangling_triangle(in.mesh);
  const bool is_delaunay = has_triangle || claim == Claim::kConformingDelaunay;
  auto whole = filled(in.mesh, is_delaunay ? fillers.fill_delaunay : fillers.fill);
  if (!whole) {
    return tl::unexpected(
        std::string(kNoCertificate) +
        (has_triangle
             ? "a triangle dangles, and is in no Delaunay triangulation of the hull with the mesh"
             : "what is between it and its convex hull cannot be filled without more vertices"));
  }
  DomainCertificate made{.claim = claim, .kind = domain.complex.kind, .whole = std::move(*whole)};
  made.mesh = certificate_of(made.whole, is_delaunay ? Claim::kDelaunay : Claim::kTriangulation,
                             std::move(*points));
  PartInput part{.mesh = made.mesh, .kept = in.mesh.simplices.size(), .kind = made.kind};
  for (Vertex v = 0; in.mesh.points.names(v); ++v) {
    part.is_corner.push_back(is_of_domain(in, v));
  }
  for (std::size_t s = 0; s < in.chains.size(); ++s) part.chains.push_back(in.chains.chain(s));
  if (made.kind == DomainKind::kHull) {
    weigh(in, fillers, made.mesh, part);
  } else {
    for (const Point& seed : in.complex.hole_seeds) {
      HomogeneousPoint point = scaled(made.mesh.points, seed);
      if (simplex_around(part, point)) part.seeds.push_back(std::move(point));
    }
  }
  const std::vector<std::vector<Simplex>> tiles = tiles_of(in.complex, pieces);
  if (made.kind == DomainKind::kEnclosed || claim == Claim::kCdt || claim == Claim::kSteinerCdt) {
    part.walls = walls_of(dimension, pieces);
  }
  auto found = domain_part(part);
  if (!found) return tl::unexpected(std::string(kNoCertificate) + found.error());
  made.part = std::move(*found);
  made.dangles = made.part.dangles;
  if (dimension == 3) {
    const std::string fault = add_polygons(in, listed, tiles, fillers, made);
    if (!fault.empty()) return tl::unexpected(fault);
  }
  if (!made.dangles) made.complex = complex_part(made);
  return made;
}

}  // namespace

tl::expected<DomainCertificate, std::string> domain_certificate_of(const ExactMesh& mesh,
                                                                   const Domain& domain,
                                                                   const ListedSegments& listed,
                                                                   Claim claim,
                                                                   const HullFillers& fillers) {
  const PiecewiseLinearComplex& complex = domain.complex;
  const std::size_t dimension = complex.ambient_dimension();
  if ((dimension != 2 && dimension != 3) ||
      mesh.points.dimension() != static_cast<int>(dimension)) {
    return tl::unexpected(std::string(kNoCertificate) +
                          "the domain does not span the plane or space");
  }
  VertexPlaces places = check::match_vertices(mesh, complex);
  check::locate_steiner_points(mesh, complex, places);
  const check::SegmentChains chains(mesh, complex, places);
  const Regions regions(complex);
  const std::vector<FacetUse> uses = facet_uses(mesh.simplices);
  check::VertexSearch search(mesh, places.used);
  const MeshedDomain in{mesh, complex, regions, uses, nullptr, places, chains, search};
  Verdict verdict(claim, 1);
  const auto pieces = check::wall_pieces(in, verdict);
  if (!pieces) return tl::unexpected(std::string(kNoCertificate) + "its walls are not tiled");
  return certificate_in(in, domain, listed, claim, *pieces, fillers);
}

tl::expected<DomainCertificate, std::string> domain_certificate_of(const FilledMesh& filled_mesh,
                                                                   const Domain& domain,
                                                                   const ListedSegments& listed,
                                                                   Claim claim,
                                                                   const HullFillers& fillers) {
  HullFillers known = fillers;
  const std::size_t dimension = domain.complex.ambient_dimension();
  known.fill = [&](const PointSet& points, const std::vector<Simplex>& simplices,
                   const std::vector<Simplex>& faces) {
    return points.ambient_dimension() == dimension ? filled_mesh.rest
                                                   : fillers.fill(points, simplices, faces);
  };
  auto made = domain_certificate_of(filled_mesh.mesh, domain, listed, claim, known);
  if (made) made->helpers = filled_mesh.helpers;
  return made;
}

}  // namespace circumspect::certificate
