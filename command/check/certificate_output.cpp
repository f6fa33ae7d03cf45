#include "command/check/certificate_output.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "command/check/filled_by_cones.hpp"
#include "construct/delaunay.hpp"
#include "kernel/complex/by_facet.hpp"
#include "kernel/complex/simplex.hpp"
#include "kernel/piecewise_linear/regions.hpp"
#include "oracle/certificate/document.hpp"
#include "oracle/certificate/domain_certificate.hpp"
#include "oracle/certificate/periodic_certificate.hpp"
#include "oracle/judge/points/delaunay.hpp"
#include "reference/constrained/gift_wrapping_cdt.hpp"
#include "reference/constrained/planar_cdt.hpp"
#include "reference/constrained/steiner_cdt.hpp"
#include "reference/existence/existence.hpp"
#include "reference/existence/solver.hpp"

namespace circumspect::cli {
namespace {

// Those of `all` that are not among `some`; nothing if some of these are not among all.
std::optional<std::vector<Simplex>> others(std::vector<Simplex> all, std::vector<Simplex> some) {
  for (Simplex& simplex : all) std::sort(simplex.begin(), simplex.end());
  for (Simplex& simplex : some) std::sort(simplex.begin(), simplex.end());
  std::sort(all.begin(), all.end());
  std::sort(some.begin(), some.end());
  if (!std::includes(all.begin(), all.end(), some.begin(), some.end())) return std::nullopt;
  std::vector<Simplex> rest;
  std::set_difference(all.begin(), all.end(), some.begin(), some.end(), std::back_inserter(rest));
  return rest;
}

// In the plane the edges of the triangles, and what dangles, are the segments of a domain, and
// these are its triangles.
std::optional<std::vector<Simplex>> fill_in_plane(const PointSet& points,
                                                  const std::vector<Simplex>& triangles,
                                                  const std::vector<Simplex>& dangling) {
  std::set<Simplex> edges(dangling.begin(), dangling.end());
  for (const FacetUse& use : facet_uses(triangles)) edges.insert(use.facet);
  const PiecewiseLinearComplex complex{
      points, {edges.begin(), edges.end()}, {}, {}, DomainKind::kHull};
  return others(constrained::planar_cdt(complex).simplices, triangles);
}

// Another affine image of the points for every `number` but 0: a triangulation of it is one of
// them.
std::vector<Point> image(const PointSet& points, int number) {
  std::vector<Point> images = points.points();
  for (Point& point : images) {
    point[0] += point[1] * number / 7 + point[2] * (number % 3) / 5;
    point[1] = point[1] * (number + 9) / 9 + point[2] * (number % 4) / 11;
  }
  return images;
}

// In space the facets of the tetrahedra, and triangles that dangle, are the polygons of a domain,
// and these are its tetrahedra. A CDT of it does; where there is none, there may be one of an
// affine image, or some other triangulation, which is searched for if there are few points.
std::optional<std::vector<Simplex>> fill_in_space(const PointSet& points,
                                                  const std::vector<Simplex>& tetrahedra,
                                                  const std::vector<Simplex>& dangling) {
  PiecewiseLinearInput facets;
  facets.kind = DomainKind::kHull;
  for (const auto group : ByFacet(facet_uses(tetrahedra))) {
    facets.polygons.push_back({{group.front().facet}, {}});
  }
  for (const Simplex& face : dangling) {
    if (face.size() == 3) facets.polygons.push_back({{face}, {}});
    if (face.size() == 2) facets.segments.push_back(face);
  }
  constexpr int kImages = 12;
  for (int number = 0; number < kImages; ++number) {
    facets.points = image(points, number);
    const auto cdt = constrained::gift_wrapping_cdt(assemble(facets));
    if (!cdt) continue;
    auto rest = others(cdt->simplices, tetrahedra);
    if (rest) return rest;
  }
  facets.points = points.points();
  const PiecewiseLinearComplex complex = assemble(facets);
  const auto any = existence::any_triangulation(complex, Regions(complex), {.vertices = 24});
  const auto* exists = std::get_if<existence::Exists>(&any);
  if (exists == nullptr) return std::nullopt;
  return others(exists->tetrahedra, tetrahedra);
}

bool fills_its_hull(const PointSet& points, const std::vector<Simplex>& simplices, Claim claim) {
  return check::judge_points(claim, {points, simplices}).holds();
}

std::optional<std::vector<Simplex>> fill(const PointSet& points,
                                         const std::vector<Simplex>& simplices,
                                         const std::vector<Simplex>& dangling) {
  if (fills_its_hull(points, simplices, Claim::kTriangulation)) return std::vector<Simplex>{};
  return points.ambient_dimension() == 2 ? fill_in_plane(points, simplices, dangling)
                                         : fill_in_space(points, simplices, dangling);
}

std::vector<Simplex> delaunay_simplices(const PointSet& points) {
  return construct::any_canonical_delaunay(points).triangulation.simplices();
}

// The canonical triangulation, if it has the simplices; where points are cospherical, what fills
// the hull of constraints that are Delaunay is a Delaunay triangulation too.
std::optional<std::vector<Simplex>> fill_delaunay(const PointSet& points,
                                                  const std::vector<Simplex>& simplices,
                                                  const std::vector<Simplex>& dangling) {
  if (fills_its_hull(points, simplices, Claim::kDelaunay)) return std::vector<Simplex>{};
  auto rest = others(delaunay_simplices(points), simplices);
  if (rest) return rest;
  rest = fill(points, simplices, dangling);
  if (!rest) return std::nullopt;
  std::vector<Simplex> all = simplices;
  all.insert(all.end(), rest->begin(), rest->end());
  if (!fills_its_hull(points, all, Claim::kDelaunay)) return std::nullopt;
  return rest;
}

// Of joined polygons, which nobody listed, all segments.
certificate::ListedSegments listed_segments(const LoadedDomain& loaded) {
  const auto& lines = loaded.file.input.polygons;
  const auto& polygons = loaded.domain.complex.polygons;
  certificate::ListedSegments listed;
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    if (lines.size() == polygons.size()) {
      listed.push_back(edges_of(lines[i]));
    } else {
      listed.emplace_back(polygons[i].segments.begin(), polygons[i].segments.end());
    }
  }
  return listed;
}

// The corners of a box around the points that touches none of them.
std::vector<Point> box_around(const PointSet& points) {
  const std::size_t dimension = points.ambient_dimension();
  std::vector<Point> corners = {{}};
  for (std::size_t axis = 0; axis < dimension; ++axis) {
    Rational low = points[0][axis];
    Rational high = low;
    for (const Point& point : points.points()) {
      low = std::min(low, point[axis]);
      high = std::max(high, point[axis]);
    }
    const Rational margin = high - low + 1;
    std::vector<Point> longer;
    for (const Point& corner : corners) {
      for (const Rational& end : {Rational(low - margin), Rational(high + margin)}) {
        longer.push_back(corner);
        longer.back().push_back(end);
      }
    }
    corners = std::move(longer);
  }
  return corners;
}

// A Steiner CDT of the domain in a box, if it is not too large: of its simplices those in the
// domain, and the others.
std::optional<certificate::FilledMesh> meshed(const PiecewiseLinearComplex& complex) {
  constexpr std::size_t kMostPoints = 1000;
  if (complex.points.size() > kMostPoints) return std::nullopt;
  const bool is_enclosed = complex.kind == DomainKind::kEnclosed;
  PiecewiseLinearComplex boxed = complex;
  if (is_enclosed) {
    std::vector<Point> points = complex.points.points();
    for (Point& corner : box_around(complex.points)) points.push_back(std::move(corner));
    boxed.points = PointSet(std::move(points));
    boxed.kind = DomainKind::kHull;
    boxed.hole_seeds.clear();
  }
  const auto made =
      constrained::steiner_cdt(boxed, constrained::CdtAlgorithm::kPolygonFlips, kMostPoints);
  if (!made || !made->triangulation.dangling.empty()) return std::nullopt;
  const Regions regions(complex);
  certificate::FilledMesh filled{{made->complex.points, {}}, {}};
  for (const Simplex& simplex : made->triangulation.simplices) {
    const Point centre = barycentre(made->complex.points, simplex);
    const bool is_kept = !is_enclosed || regions.locate(centre) == Where::kInside;
    (is_kept ? filled.mesh.simplices : filled.rest).push_back(simplex);
  }
  return filled;
}

certificate::HullFillers fillers() {
  return {.fill = fill,
          .fill_delaunay = fill_delaunay,
          .triangulate = delaunay_simplices,
          .mesh = meshed};
}

// The solver, whose proofs get hints.
std::optional<certificate::Decision> decide(int variables,
                                            const std::vector<certificate::Clause>& clauses) {
  constexpr int kConflicts = 1'000'000;
  const existence::Formula formula{variables, clauses};
  auto answer = existence::solve(formula, kConflicts);
  if (auto* satisfied = std::get_if<existence::Satisfied>(&answer)) {
    return certificate::Decision{.model = std::move(satisfied->assignment)};
  }
  const auto* refuted = std::get_if<existence::Refuted>(&answer);
  if (refuted == nullptr) return std::nullopt;
  auto steps = existence::with_hints(formula, refuted->refutation);
  if (!steps) return std::nullopt;
  certificate::Decision decision;
  for (existence::HintedStep& step : *steps) {
    for (std::size_t& hint : step.hints) ++hint;
    decision.proof.push_back({std::move(step.clause), std::move(step.hints)});
  }
  return decision;
}

// True, or says why not.
template <typename Write>
bool is_written(const std::string& path, const Write& write, Output& output) {
  output.end_watch();  // what is found is written, whatever its time
  const std::string fault = write_file(path, write);
  if (fault.empty()) return true;
  output.error(ExitCode::kUsage, "certificate", path, fault);
  return false;
}

// `made`, of that mesh, or says why there is none.
template <typename Made, typename AnyMesh>
bool is_written(const std::string& path, const std::string& mesh_name, const AnyMesh& mesh,
                const tl::expected<Made, std::string>& made, Output& output) {
  if (!made) {
    output.error(ExitCode::kUsage, "mesh", mesh_name,
                 fmt::format("{}: {}", mesh_name, made.error()));
    return false;
  }
  return is_written(
      path, [&](std::ostream& out) { certificate::write(out, mesh, *made); }, output);
}

}  // namespace

bool write_certificate(const std::string& path, const std::string& mesh_name, const Mesh& mesh,
                       const Verdict& verdict, Output& output) {
  if (verdict.tallies().contains(Rule::kPointsEqual)) {
    return is_written(path, mesh_name, mesh, certificate::equal_points_of(mesh, verdict), output);
  }
  if (const auto certificate = certificate::certificate_of(mesh, verdict)) {
    return is_written(
        path, [&](std::ostream& out) { certificate::write(out, mesh, *certificate); }, output);
  }
  const ExactMesh exactly = exact(mesh);
  if (mesh.copies) {
    return is_written(path, mesh_name, exactly,
                      certificate::periodic_document_of(exactly, *mesh.copies, verdict), output);
  }
  return is_written(path, mesh_name, exactly, certificate::document_of(exactly, verdict), output);
}

std::string certificate_fault(const std::optional<Claim>& claim, const DomainOptions& said) {
  if (claim && certificate::is_unproved(*claim)) {
    return fmt::format(
        "expected a claim about which something is proved for a certificate, found {}",
        name(*claim));
  }
  if (said.resolves) {
    return "expected no --resolve for a certificate, found it: circumspect-verified compares the "
           "segments of the domain's file, as they are listed";
  }
  if (!said.merged_slope) return "";
  return "expected no --merge-coplanar for a certificate, found it: circumspect-verified compares "
         "the polygons of the domain's file, as they are listed";
}

namespace {

// What is between a mesh in space and its hull; all simplices, that are to be Delaunay, cannot have
// points that are nobody's.
bool may_have_pockets(const Domain& domain, Claim claim) {
  return domain.complex.ambient_dimension() == 3 && domain.complex.kind == DomainKind::kEnclosed &&
         claim != Claim::kConformingDelaunay;
}

// A mesh in a plane of space, all of it dangling, with a point beside the plane, and beyond all of
// the mesh along an axis: no point of the mesh is there.
std::optional<certificate::FilledMesh> beside_its_plane(const ExactMesh& mesh) {
  if (mesh.points.ambient_dimension() != 3 || mesh.points.dimension() != 2) return std::nullopt;
  std::vector<Vertex> labels;
  for (Vertex v = 0; mesh.points.names(v); ++v) labels.push_back(mesh.label(v));
  labels.push_back(0);  // the point is nobody's
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<Point> points = mesh.points.points();
    Point beyond = points.front();
    for (const Point& point : points) beyond[axis] = std::max(beyond[axis], point[axis]);
    beyond[axis] += 1;
    points.push_back(std::move(beyond));
    certificate::FilledMesh filled{mesh, {}, 1};
    filled.mesh.points = PointSet(std::move(points));
    filled.mesh.labels = labels;
    if (filled.mesh.points.dimension() != 3) continue;
    auto rest = fill(filled.mesh.points, {}, mesh.faces);
    if (!rest) return std::nullopt;
    filled.rest = std::move(*rest);
    return filled;
  }
  return std::nullopt;
}

// Hole points that options gave the domain, as circumspect-verified is told of them.
void note_further_holes(const LoadedDomain& loaded, Output& output) {
  const std::vector<Point>& seeds = loaded.domain.complex.hole_seeds;
  std::string words;
  for (std::size_t i = loaded.listed_holes; i < seeds.size(); ++i) {
    std::vector<std::string> numbers;
    for (const Rational& x : seeds[i]) numbers.push_back(x.get_str());
    words += fmt::format(" --hole {}", fmt::join(numbers, ","));
  }
  if (words.empty() || loaded.domain.complex.kind == DomainKind::kHull) return;
  output.note(fmt::format(
      "{}: the certificate has hole points that the file does not list; with your own files, also "
      "tell circumspect-verified of them:{}",
      loaded.name, words));
}

}  // namespace

bool write_domain_certificate(const std::string& path, const std::string& mesh_name,
                              const ExactMesh& mesh, const LoadedDomain& loaded,
                              const Verdict& verdict, Output& output) {
  if (loaded.is_hull_with_holes) {
    output.error(ExitCode::kUsage, "domain", loaded.name,
                 fmt::format("{}: expected no hole seeds in the domain of a certificate that is a "
                             "hull, found {}: nothing is proved of a hull with holes",
                             loaded.name, loaded.domain.complex.hole_seeds.size()));
    return false;
  }
  note_further_holes(loaded, output);
  if (!verdict.holds()) {
    const auto refutation = certificate::domain_refutation_of(
        mesh, loaded.domain, listed_segments(loaded), verdict, fillers());
    if (!refutation) {
      output.error(ExitCode::kUsage, "mesh", mesh_name,
                   fmt::format("{}: {}", mesh_name, refutation.error()));
      return false;
    }
    return is_written(
        path, [&](std::ostream& out) { certificate::write(out, mesh, *refutation); }, output);
  }
  auto document = certificate::domain_certificate_of(mesh, loaded.domain, listed_segments(loaded),
                                                     verdict.claim(), fillers());
  auto filled = document ? std::nullopt : beside_its_plane(mesh);
  if (!document && (filled || may_have_pockets(loaded.domain, verdict.claim()))) {
    if (!filled) filled = filled_by_cones(mesh);
    auto with_helpers =
        filled ? certificate::domain_certificate_of(*filled, loaded.domain, listed_segments(loaded),
                                                    verdict.claim(), fillers())
               : document;
    if (with_helpers) document = std::move(with_helpers);
  }
  if (!document) {
    output.error(ExitCode::kUsage, "mesh", mesh_name,
                 fmt::format("{}: {}", mesh_name, document.error()));
    return false;
  }
  return is_written(
      path, [&](std::ostream& out) { certificate::write(out, *document); }, output);
}

std::vector<std::string> impossibility_files(const std::string& prefix) {
  return {prefix + "-cdt.proof", prefix + "-triangulation.proof"};
}

std::string write_impossibility(const std::string& prefix, Claim claim, const LoadedDomain& loaded,
                                Output& output) {
  constexpr std::size_t kMostVertices = 48;  // candidates grow with their fourth power
  if (loaded.domain.complex.points.size() > kMostVertices) {
    output.note(
        fmt::format("no proof for circumspect-verified: more than {} vertices", kMostVertices));
    return "";
  }
  const auto proof = certificate::impossibility_of(loaded.domain, claim, listed_segments(loaded),
                                                   fillers(), decide);
  if (!proof) {
    output.note("no proof for circumspect-verified: " + proof.error());
    return "";
  }
  const std::size_t which = claim == Claim::kCdt ? 0 : 1;
  return write_file(impossibility_files(prefix)[which],
                    [&](std::ostream& out) { certificate::write(out, *proof); });
}

}  // namespace circumspect::cli
