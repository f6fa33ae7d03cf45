#include "oracle/certificate/refutation.hpp"

#include <algorithm>

#include "oracle/certificate/evidence.hpp"
#include "oracle/certificate/lines.hpp"

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
    case Rule::kOverlap:
    case Rule::kCoveredTwice:
      return from_violations(verdict, rule, [&](const Witness& witness) {
        return overlap_evidence(mesh, points, rule, witness);
      });
    case Rule::kHullNotClosed:
    case Rule::kHullNotConvex:
      return from_violations(verdict, rule, [&](const Witness& witness) {
        return hull_evidence(mesh, rule, witness);
      });
    case Rule::kFacetNotLocal:
    case Rule::kVertexInBall:
    case Rule::kVertexSubmerged:
    case Rule::kPointBelowPlane:
      return from_violations(verdict, rule, [&](const Witness& witness) {
        return ball_evidence(mesh, rule, witness);
      });
    default:
      return std::nullopt;
  }
}

}  // namespace

std::optional<Refutation> refutation_of(const ExactMesh& mesh, const Verdict& verdict,
                                        const ScaledPoints& points) {
  for (const auto& [rule, tally] : verdict.tallies()) {
    auto evidence = evidence_for(mesh, verdict, points, rule);
    if (evidence) {
      const std::vector<std::size_t>& basis = mesh.points.configuration().hull().basis;
      return Refutation{verdict.claim(), evidence->rule, std::move(evidence->because), basis};
    }
  }
  return std::nullopt;
}

void write(std::ostream& out, const ExactMesh& mesh, const ScaledPoints& points,
           const Refutation& refutation) {
  Lines lines(out);
  write_first_line(lines, "circumspect-refutation 2", refutation.claim, points.dimension,
                   identifier(refutation.rule));
  write_scale(lines, points);
  lines << "points" << points.size();
  lines.end_line();
  for (Vertex v = 0; mesh.points.names(v); ++v) {
    write_point(lines, points, v, refutation.claim == Claim::kWeightedDelaunay);
    lines.gap() << mesh.label(v);
    lines.end_line();
  }
  lines << "simplices" << mesh.simplices.size();
  lines.end_line();
  for (const Simplex& simplex : mesh.simplices) {
    lines << simplex.size();
    lines.gap();
    for (const Vertex v : simplex) lines << Integer(v) + 1;
    lines.end_line();
  }
  lines << "spans";
  for (const std::size_t v : refutation.basis) lines << v + 1;
  lines.end_line();
  lines << "because";
  for (const Integer& token : refutation.because) lines << token;
  lines.end_line();
  lines << "end";
  lines.end_line();
}

}  // namespace circumspect::certificate
