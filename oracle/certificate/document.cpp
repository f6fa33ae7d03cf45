#include "oracle/certificate/document.hpp"

#include <algorithm>
#include <type_traits>

#include <fmt/format.h>

#include "oracle/certificate/certificate.hpp"
#include "oracle/certificate/evidence.hpp"
#include "oracle/judge/domain/judge_exactly.hpp"

namespace circumspect::certificate {

namespace {

// The kept violations of a rule, until one of them has evidence.
std::optional<Evidence> from_violations(const Verdict& verdict, Rule rule,
                                        const auto& evidence_of) {
  for (const Violation& violation : verdict.violations()) {
    if (violation.rule != rule) continue;
    if (auto evidence = evidence_of(violation.witness)) return evidence;
  }
  return std::nullopt;
}

// A weighted triangulation need not use all points, but has to cover them.
std::optional<Evidence> unused_point_evidence(const ExactMesh& mesh, const Verdict& verdict,
                                              const ScaledPoints& points) {
  if (verdict.claim() != Claim::kWeightedDelaunay) {
    return simplex_evidence(mesh, points, Rule::kUnusedPoint);
  }
  return from_violations(verdict, Rule::kUnusedPoint, [&](const Witness& witness) {
    return uncovered_point_evidence(mesh, points, witness.vertices.front());
  });
}

// Where the vertex is that hangs.
std::optional<Evidence> hanging_evidence(const ExactMesh& mesh, const ScaledPoints& points,
                                         Witness witness) {
  witness.point = mesh.points[witness.vertices.front()];
  return overlap_evidence(mesh, points, Rule::kHangingVertex, witness);
}

// Of points that do not span few rules are refuted, of hulls two, and of surfaces one; and of
// a mesh alone some can be shown of simplices of full dimension only.
bool may_be_shown(const ExactMesh& mesh, const Verdict& verdict, Rule rule) {
  if (verdict.claim() == Claim::kSurfaceDelaunay) return rule == Rule::kEdgeNotDelaunay;
  if (verdict.claim() == Claim::kConvexHull) {
    return rule == Rule::kFacetNotSupporting || rule == Rule::kHullUncovered;
  }
  if (mesh.points.dimension() < static_cast<int>(mesh.points.ambient_dimension())) {
    const bool is_line = mesh.points.dimension() == 1;
    return rule == Rule::kWrongDimension || rule == Rule::kUnusedPoint ||
           rule == Rule::kFacetNotLocal || rule == Rule::kVertexInBall ||
           (is_line && (rule == Rule::kHullNotClosed || rule == Rule::kHullNotConvex));
  }
  if (verdict.claim() != Claim::kComplex) return true;
  switch (rule) {
    case Rule::kUnknownVertex:
    case Rule::kRepeatedVertex:
    case Rule::kUnusedPoint:
      return true;
    case Rule::kDegenerateSimplex:
    case Rule::kDuplicateSimplex:
    case Rule::kOverlap:
    case Rule::kHangingVertex:
    case Rule::kFacesCross:
      return mesh.simplices.front().size() == mesh.points.ambient_dimension() + 1;
    default:
      return false;
  }
}

}  // namespace

std::optional<Evidence> evidence_for(const ExactMesh& mesh, const Verdict& verdict,
                                     const ScaledPoints& points, Rule rule) {
  switch (rule) {
    case Rule::kUnknownVertex:
    case Rule::kWrongDimension:
    case Rule::kRepeatedVertex:
    case Rule::kDegenerateSimplex:
    case Rule::kDuplicateSimplex:
    case Rule::kFacetOverused:
      return simplex_evidence(mesh, points, rule);
    case Rule::kUnusedPoint:
      return unused_point_evidence(mesh, verdict, points);
    case Rule::kHangingVertex:
      return from_violations(verdict, rule, [&](const Witness& witness) {
        return hanging_evidence(mesh, points, witness);
      });
    case Rule::kFacesCross:
    case Rule::kOverlap:
    case Rule::kCoveredTwice:
      return from_violations(verdict, rule, [&](const Witness& witness) {
        return overlap_evidence(mesh, points, rule, witness);
      });
    case Rule::kHullNotClosed:
    case Rule::kHullNotConvex:
      if (mesh.points.dimension() == 1) return line_end_evidence(mesh, points);
      return from_violations(verdict, rule, [&](const Witness& witness) {
        return hull_evidence(mesh, rule, witness);
      });
    case Rule::kFacetNotSupporting:
      return from_violations(
          verdict, rule, [&](const Witness& witness) { return two_sides_evidence(mesh, witness); });
    case Rule::kHullUncovered:
      return from_violations(verdict, rule, [&](const Witness& witness) {
        return uncovered_hull_evidence(mesh, points, witness);
      });
    case Rule::kEdgeNotDelaunay:
      return from_violations(verdict, rule,
                             [&](const Witness& witness) { return edge_evidence(mesh, witness); });
    case Rule::kFacetNotLocal:
    case Rule::kVertexInBall:
      if (mesh.points.dimension() < static_cast<int>(points.dimension)) {
        return from_violations(verdict, rule, [&](const Witness& witness) {
          return flat_ball_evidence(mesh, points, witness);
        });
      }
      [[fallthrough]];
    case Rule::kVertexSubmerged:
    case Rule::kPointBelowPlane:
      return from_violations(verdict, rule, [&](const Witness& witness) {
        return ball_evidence(mesh, rule, witness);
      });
    default:
      return std::nullopt;
  }
}

std::optional<Refutation> refutation_of(const ExactMesh& mesh, const Verdict& verdict,
                                        const ScaledPoints& points) {
  for (const auto& [rule, tally] : verdict.tallies()) {
    if (!may_be_shown(mesh, verdict, rule)) continue;
    auto evidence = evidence_for(mesh, verdict, points, rule);
    if (evidence) {
      const std::vector<std::size_t>& basis = mesh.points.configuration().hull().basis;
      return Refutation{verdict.claim(), evidence->rule, std::move(evidence->because), basis};
    }
  }
  return std::nullopt;
}

void write_mesh(Lines& lines, const ExactMesh& mesh, const ScaledPoints& points,
                const Refutation& refutation, std::string_view words) {
  write_first_line(lines, "circumspect-refutation 2", refutation.claim, points.dimension,
                   words.empty() ? identifier(refutation.rule) : words);
  write_scale(lines, points);
  write_points(lines, mesh, points, all_vertices(mesh.points),
               refutation.claim == Claim::kWeightedDelaunay);
  write_simplices(lines, mesh.simplices);
}

void write_simplices(Lines& lines, const std::vector<Simplex>& simplices) {
  begin_section(lines, "simplices", simplices.size());
  for (const Simplex& simplex : simplices) {
    lines << simplex.size();
    lines.gap();
    for (const Vertex v : simplex) lines << to_integer(v) + 1;
    lines.end_line();
  }
}

void write_basis(Lines& lines, const std::vector<std::size_t>& basis) {
  lines << "spans";
  for (const std::size_t v : basis) lines << v + 1;
  lines.end_line();
}

void write_because(Lines& lines, const std::vector<Integer>& because) {
  lines << "because";
  for (const Integer& token : because) lines << token;
  lines.end_line();
  lines << "end";
  lines.end_line();
}

void write(std::ostream& out, const ExactMesh& mesh, const ScaledPoints& points,
           const Refutation& refutation) {
  Lines lines(out);
  const bool spans = mesh.points.dimension() == static_cast<int>(points.dimension);
  const bool needs_basis =
      refutation.claim != Claim::kSurfaceDelaunay && refutation.claim != Claim::kConvexHull;
  const bool is_flat = !spans && needs_basis;
  const std::string words = fmt::format("{} flat", identifier(refutation.rule));
  write_mesh(lines, mesh, points, refutation, is_flat ? words : "");
  if (needs_basis) write_basis(lines, refutation.basis);
  if (is_flat) write_pads(lines, mesh, points);
  write_because(lines, refutation.because);
}

namespace {

// Does something prove the claim, or refute it, wherever the points are?
bool may_lie_anywhere(const Verdict& verdict) {
  const Claim claim = verdict.claim();
  return claim == Claim::kTriangulation || claim == Claim::kDelaunay ||
         claim == Claim::kSurfaceDelaunay || (claim == Claim::kComplex && verdict.holds());
}

// What certificates do not cover; empty if they cover this.
std::string limit(const ExactMesh& mesh, const Verdict& verdict) {
  const Claim claim = verdict.claim();
  // Of what a lattice repeats, periodic_certificate.hpp makes documents.
  if (is_about_a_domain(claim) || is_unproved(claim) || claim == Claim::kPeriodicDelaunay) {
    return fmt::format(
        "expected complex, convex-hull, surface-delaunay, triangulation, delaunay or "
        "weighted-delaunay for a certificate, found {}",
        name(claim));
  }
  const std::size_t dimension = mesh.points.ambient_dimension();
  if (mesh.points.empty()) return "expected points for a certificate, found none";
  if (dimension != 2 && dimension != 3) {
    return fmt::format("expected points of dimension 2 or 3 for a certificate, found dimension {}",
                       dimension);
  }
  if (mesh.points.dimension() != static_cast<int>(dimension) && !may_lie_anywhere(verdict)) {
    return fmt::format(
        "expected points that span the {} for a certificate, found that all of them lie {}",
        dimension == 2 ? "plane" : "space",
        mesh.points.dimension() == 0   ? "in one place"
        : mesh.points.dimension() == 1 ? "on one line"
                                       : "in one plane");
  }
  return "";
}

}  // namespace

bool is_unproved(Claim claim) { return claim == Claim::kVoronoi; }

tl::expected<Document, std::string> document_of(const ExactMesh& mesh, const Verdict& verdict) {
  const std::string beyond = limit(mesh, verdict);
  if (!beyond.empty()) return tl::unexpected(beyond);
  if (verdict.holds() && verdict.claim() == Claim::kConvexHull) return hull_certificate_of(mesh);
  auto points = scaled_to_integers(mesh.points);
  if (!points) return tl::unexpected(points.error());
  if (verdict.holds() && verdict.claim() == Claim::kComplex) {
    return complex_certificate_of(mesh, std::move(*points));
  }
  if (verdict.holds() && verdict.claim() == Claim::kSurfaceDelaunay) {
    return surface_certificate_of(mesh, std::move(*points));
  }
  if (verdict.holds() && mesh.points.dimension() < 2) {
    return line_certificate_of(mesh, verdict.claim(), std::move(*points));
  }
  if (verdict.holds() && mesh.points.dimension() < static_cast<int>(points->dimension)) {
    return flat_certificate_of(mesh, verdict.claim(), std::move(*points));
  }
  if (verdict.holds()) {
    Certificate certificate = certificate_of(mesh, verdict.claim(), std::move(*points));
    certificate.standing = standing_of(verdict);
    return certificate;
  }
  auto refutation = refutation_of(mesh, verdict, *points);
  if (!refutation) {
    // The witness that is needed may be one that the verdict had no room for.
    const Verdict with_all =
        check::judge_exactly(verdict.claim(), mesh, nullptr, {.max_violations = 0});
    refutation = refutation_of(mesh, with_all, *points);
  }
  if (refutation) return RefutationWithPoints{std::move(*refutation), std::move(*points)};
  const auto& tallies = verdict.tallies();
  const auto of_complex = std::find_if(tallies.begin(), tallies.end(), [](const auto& tally) {
    return tally.first != Rule::kOrientation;
  });
  if (verdict.claim() == Claim::kComplex && of_complex != tallies.end()) {
    return tl::unexpected(fmt::format(
        "there is no refutation of this mesh: of simplices of a lower dimension, or of another "
        "than the first, none shows {}",
        identifier(of_complex->first)));
  }
  if (verdict.claim() == Claim::kConvexHull) {
    return tl::unexpected(fmt::format(
        "there is no refutation of this mesh: none shows that facets are not those of a hull by {}",
        identifier(tallies.begin()->first)));
  }
  if (mesh.points.dimension() < static_cast<int>(mesh.points.ambient_dimension()) ||
      verdict.claim() == Claim::kSurfaceDelaunay) {
    return tl::unexpected(fmt::format(
        "there is no refutation of this mesh: of a surface, or of points that do not span, none "
        "shows {}",
        identifier(tallies.begin()->first)));
  }
  return tl::unexpected(fmt::format(
      "expected a fault of the claim for a refutation, found only {}, which {} does not include",
      identifier(tallies.begin()->first), name(verdict.claim())));
}

void write(std::ostream& out, const ExactMesh& mesh, const Document& document) {
  if (const auto* refuted = std::get_if<RefutationWithPoints>(&document)) {
    write(out, mesh, refuted->points, refuted->refutation);
    return;
  }
  std::visit(
      [&](const auto& certificate) {
        if constexpr (!std::is_same_v<decltype(certificate), const RefutationWithPoints&>) {
          write(out, mesh, certificate);
        }
      },
      document);
}

}  // namespace circumspect::certificate
