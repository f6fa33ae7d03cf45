#include "command/build/constrained_constructions.hpp"

#include <cassert>
#include <set>

#include <fmt/format.h>

#include "command/input/domain_input.hpp"
#include "kernel/complex/point_set.hpp"
#include "reference/constrained/cdt_by_polygon_insertion.hpp"
#include "reference/constrained/conforming_delaunay.hpp"
#include "reference/constrained/planar_cdt.hpp"
#include "reference/constrained/plc_triangulation.hpp"
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
      return fmt::format("tetrahedra overlap at {}", simplex);
    case WhyNoCdt::kNotLocallyDelaunay:
      return fmt::format("facet {} is not locally Delaunay: vertex {} is in the ball", simplex,
                         witness);
    case WhyNoCdt::kSegmentMissing:
      return fmt::format("segment {} is not an edge", witness);
  }
  return "";
}

DomainMesh mesh_of(const Domain& domain, PlcTriangulation triangulation) {
  return {domain.complex.points, std::move(triangulation)};
}

// By insertion, or nothing: where insertion fails there may be a CDT all the same.
std::optional<DomainMesh> by_polygon_insertion(const Domain& domain,
                                               constrained::PolygonInsertion by,
                                               const Progress& progress) {
  auto cdt = constrained::cdt_by_polygon_insertion(domain.complex, {by, {}, progress});
  if (!cdt) return std::nullopt;
  return mesh_of(domain, std::move(*cdt));
}

tl::expected<DomainMesh, NoMesh> cdt(const Domain& domain, const DomainConstruction& construction,
                                     const std::string& name, Output& output) {
  const std::optional<std::string>& asked_for = construction.algorithm;
  if (asked_for && *asked_for != "gift-wrapping") {
    output.begin("inserting the polygons of " + name);
    auto mesh = by_polygon_insertion(domain,
                                     *asked_for == "polygon-flips"
                                         ? constrained::PolygonInsertion::kFlips
                                         : constrained::PolygonInsertion::kCavities,
                                     output.progress());
    if (mesh) return *std::move(mesh);
  }
  CdtDecision decision = decide_cdt(domain.complex, construction.search, !asked_for, name, output);
  if (decision.answer == CdtAnswer::kCanonical) {
    if (!asked_for || *asked_for == "gift-wrapping") {
      return mesh_of(domain, *std::move(decision.cdt));
    }
    return tl::unexpected(NoMesh{
        false, fmt::format("{} cannot insert every polygon; gift-wrapping finds the canonical one",
                           *asked_for)});
  }
  const std::string why = in_words(*decision.not_canonical, domain);
  switch (decision.answer) {
    case CdtAnswer::kCanonical:
      break;
    case CdtAnswer::kAnother: {
      if (asked_for) {
        return tl::unexpected(NoMesh{
            false,
            fmt::format(
                "there is a CDT, but no canonical one, and {} makes only that; build cdt without "
                "--algorithm makes another; {}",
                *asked_for, why)});
      }
      DomainMesh mesh = mesh_of(domain, *std::move(decision.cdt));
      mesh.not_canonical = why;
      return mesh;
    }
    case CdtAnswer::kNone:
      return tl::unexpected(NoMesh{true, fmt::format("none (proved); {}", why)});
    case CdtAnswer::kUnknown:
      break;
  }
  return tl::unexpected(NoMesh{
      false,
      fmt::format(
          "there is no canonical CDT, and the search for another was given up, {}; "
          "--search-vertices and --search-conflicts set its limits, and build steiner-cdt adds "
          "vertices until there is a canonical one; {}",
          decision.limit, why)});
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

NoMesh not_with(std::size_t steiner_points) {
  return {false, fmt::format("{} Steiner points do not suffice; --steiner-points allows more",
                             steiner_points)};
}

tl::expected<DomainMesh, NoMesh> steiner(const Domain& domain, const std::string& algorithm,
                                         std::size_t most, const Progress& progress) {
  using constrained::CdtAlgorithm;
  const CdtAlgorithm by = algorithm == "polygon-flips"      ? CdtAlgorithm::kPolygonFlips
                          : algorithm == "polygon-cavities" ? CdtAlgorithm::kPolygonCavities
                                                            : CdtAlgorithm::kGiftWrapping;
  auto built = constrained::steiner_cdt(domain.complex, by, most, progress);
  if (!built) return tl::unexpected(not_with(most));
  DomainMesh mesh{std::move(built->complex.points), std::move(built->triangulation)};
  for (const auto& point : built->steiner_points) {
    mesh.steiner_points.push_back(on_segment(domain, point));
  }
  return mesh;
}

tl::expected<DomainMesh, NoMesh> conforming(const Domain& domain, std::size_t most) {
  auto built = constrained::conforming_delaunay(domain.complex, most);
  if (!built) return tl::unexpected(not_with(most));
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
                                           const Domain& domain, const std::string& name,
                                           Output& output) {
  const std::string& what = construction.what;
  const std::size_t dimension = domain.complex.ambient_dimension();
  if (what != "cdt" || dimension == 2) output.begin("meshing " + name);
  if (what == "conforming-delaunay") return conforming(domain, construction.most_steiner_points);
  if (what == "planar-cdt" && dimension == 3) return mesh_of(domain, of_polygons(domain.complex));
  if (what == "cdt" && dimension == 3) return cdt(domain, construction, name, output);
  if (dimension == 2) return planar(domain, construction.algorithm.value_or("gift-wrapping"));
  if (construction.algorithm == "gift-wrapping") {
    output.begin("gift-wrapping " + name, seconds_of_gift_wrapping(domain.complex.points.size()));
  }
  return steiner(domain, construction.algorithm.value_or("polygon-flips"),
                 construction.most_steiner_points, output.progress());
}

}  // namespace circumspect::cli
