#include "oracle/cli/constrained_constructions.hpp"

#include <cassert>
#include <set>

#include <fmt/format.h>

#include "oracle/cli/labels.hpp"
#include "reference/complex/flat.hpp"
#include "reference/constrained/carve.hpp"
#include "reference/constrained/cdt_by_polygon_insertion.hpp"
#include "reference/constrained/conforming_delaunay.hpp"
#include "reference/constrained/gift_wrapping_cdt.hpp"
#include "reference/constrained/planar_cdt.hpp"
#include "reference/constrained/steiner_cdt.hpp"

namespace circumspect::cli {
namespace {

using constrained::PlcTriangulation;

std::string in_words(const constrained::NoCdt& no_cdt, const Domain& domain) {
  using constrained::WhyNoCdt;
  const std::string simplex = labels(domain, no_cdt.simplex);
  const std::string witness = labels(domain, no_cdt.witness);
  switch (no_cdt.why) {
    case WhyNoCdt::kFacetUnfinished:
      return fmt::format("no vertex in front of facet {} makes a tetrahedron with it", simplex);
    case WhyNoCdt::kPolygonCrosses:
      return fmt::format("triangle {} of a polygon runs through the tetrahedron {}", witness,
                         simplex);
    case WhyNoCdt::kSegmentCrosses:
      return fmt::format("segment {} runs through the tetrahedron {}", witness, simplex);
    case WhyNoCdt::kSimplicesOverlap:
      return fmt::format("tetrahedra are in each other's way at {}", simplex);
    case WhyNoCdt::kNotLocallyDelaunay:
      return fmt::format("facet {} is not locally Delaunay: vertex {} is in the ball", simplex,
                         witness);
    case WhyNoCdt::kSegmentMissing:
      return fmt::format("segment {} is no edge", witness);
  }
  return "";
}

DomainMesh mesh_of(const Domain& domain, PlcTriangulation triangulation) {
  return {domain.complex.points, std::move(triangulation)};
}

tl::expected<DomainMesh, NoMesh> by_gift_wrapping(const Domain& domain) {
  auto cdt = constrained::gift_wrapping_cdt(domain.complex);
  if (cdt) return mesh_of(domain, std::move(*cdt));
  return tl::unexpected(NoMesh{true, in_words(cdt.error(), domain)});
}

// Where insertion fails there may be a CDT all the same: gift-wrapping knows.
tl::expected<DomainMesh, NoMesh> by_polygon_insertion(const Domain& domain,
                                                      constrained::PolygonInsertion by) {
  auto cdt = constrained::cdt_by_polygon_insertion(domain.complex, {by, {}});
  if (cdt) return mesh_of(domain, std::move(*cdt));
  const auto wrapped = by_gift_wrapping(domain);
  if (!wrapped) return wrapped;
  const std::string what = cdt.error().polygon
                               ? "polygon " + domain.polygon_name(*cdt.error().polygon)
                               : "segment " + labels(domain, cdt.error().cause.witness);
  return tl::unexpected(
      NoMesh{false, what + " could not be inserted; --algorithm gift-wrapping finds the CDT"});
}

tl::expected<DomainMesh, NoMesh> planar(const Domain& domain, const std::string& algorithm) {
  using constrained::PlanarAlgorithm;
  const bool by_wrapping = algorithm == "gift-wrapping";
  return mesh_of(domain, constrained::planar_cdt(domain.complex,
                                                 by_wrapping ? PlanarAlgorithm::kGiftWrapping
                                                             : PlanarAlgorithm::kSegmentInsertion));
}

// The CDTs of all polygons of a domain in space; segments and vertices in none of them dangle.
PlcTriangulation of_polygons(const PiecewiseLinearComplex& complex) {
  std::set<Simplex> faces(complex.segments.begin(), complex.segments.end());
  for (const Vertex v : all_vertices(complex.points)) faces.insert({v});
  return constrained::with_dangling(constrained::triangulated_polygons(complex), faces);
}

std::string on_segment(const Domain& domain, const constrained::PointOnSegment& point) {
  return "on segment " + labels(domain, domain.complex.segments[point.segment]);
}

DomainMesh steiner(const Domain& domain, const std::string& algorithm) {
  using constrained::CdtAlgorithm;
  const CdtAlgorithm by = algorithm == "polygon-flips"      ? CdtAlgorithm::kPolygonFlips
                          : algorithm == "polygon-cavities" ? CdtAlgorithm::kPolygonCavities
                                                            : CdtAlgorithm::kGiftWrapping;
  constrained::SteinerCdt built = constrained::steiner_cdt(domain.complex, by);
  DomainMesh mesh{std::move(built.complex.points), std::move(built.triangulation)};
  for (const auto& point : built.steiner_points) {
    mesh.steiner_points.push_back(on_segment(domain, point));
  }
  return mesh;
}

tl::expected<DomainMesh, NoMesh> conforming(const Domain& domain, std::size_t most) {
  auto built = constrained::conforming_delaunay(domain.complex, most);
  if (!built) {
    return tl::unexpected(NoMesh{false, fmt::format("{} Steiner points do not suffice; "
                                                    "--steiner-points allows more",
                                                    most)});
  }
  const std::size_t first = domain.complex.points.size();
  DomainMesh mesh{std::move(built->complex.points), std::move(built->triangulation)};
  mesh.steiner_points.resize(mesh.points.size() - first);
  const auto place = [first](Vertex v) { return static_cast<std::size_t>(v) - first; };
  for (const auto& point : built->on_segments) {
    mesh.steiner_points[place(point.vertex)] = on_segment(domain, point);
  }
  for (const auto& point : built->in_polygons) {
    mesh.steiner_points[place(point.vertex)] = "in polygon " + domain.polygon_name(point.polygon);
  }
  return mesh;
}

}  // namespace

std::vector<std::string> algorithms_for(const std::string& what, std::size_t dimension) {
  if (what == "conforming-delaunay") return {};
  if (dimension == 2) return {"gift-wrapping", "segment-insertion"};
  if (what == "planar-cdt") return {"gift-wrapping"};
  return {"gift-wrapping", "polygon-flips", "polygon-cavities"};
}

tl::expected<DomainMesh, NoMesh> construct(const DomainConstruction& construction,
                                           const Domain& domain) {
  const auto& [what, algorithm, most_steiner_points] = construction;
  if (what == "conforming-delaunay") return conforming(domain, most_steiner_points);
  if (domain.complex.ambient_dimension() == 2) return planar(domain, algorithm);
  if (what == "steiner-cdt") return steiner(domain, algorithm);
  if (what == "planar-cdt") {
    return mesh_of(domain, of_polygons(domain.complex));
  }
  if (algorithm == "polygon-flips") {
    return by_polygon_insertion(domain, constrained::PolygonInsertion::kFlips);
  }
  if (algorithm == "polygon-cavities") {
    return by_polygon_insertion(domain, constrained::PolygonInsertion::kCavities);
  }
  return by_gift_wrapping(domain);
}

}  // namespace circumspect::cli
