#include "oracle/certificate/document.hpp"

#include <fmt/format.h>

#include "oracle/judge/points/check.hpp"

namespace circumspect::certificate {
namespace {

// What certificates do not cover; empty if they cover this.
std::string limit(const ExactMesh& mesh, Claim claim) {
  if (is_about_a_domain(claim)) {
    return fmt::format(
        "expected triangulation, delaunay or weighted-delaunay for a certificate, found {}",
        name(claim));
  }
  const std::size_t dimension = mesh.points.ambient_dimension();
  if (mesh.points.empty()) return "expected points for a certificate, found none";
  if (dimension != 2 && dimension != 3) {
    return fmt::format("expected points of dimension 2 or 3 for a certificate, found dimension {}",
                       dimension);
  }
  if (mesh.points.dimension() != static_cast<int>(dimension)) {
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

tl::expected<Document, std::string> document_of(const ExactMesh& mesh, const Verdict& verdict) {
  const std::string beyond = limit(mesh, verdict.claim());
  if (!beyond.empty()) return tl::unexpected(beyond);
  auto points = scaled_to_integers(mesh.points);
  if (!points) return tl::unexpected(points.error());
  if (verdict.holds()) {
    Certificate certificate = certificate_of(mesh, verdict.claim(), std::move(*points));
    certificate.standing = verdict.unique.value_or(false)      ? "unique"
                           : verdict.canonical.value_or(false) ? "canonical"
                                                               : "";
    return certificate;
  }
  auto refutation = refutation_of(mesh, verdict, *points);
  if (!refutation) {
    // The witness that is needed may be one that the verdict had no room for.
    const Verdict with_all = check::judge_points(verdict.claim(), mesh, {.max_violations = 0});
    refutation = refutation_of(mesh, with_all, *points);
  }
  if (refutation) return RefutationWithPoints{std::move(*refutation), std::move(*points)};
  return tl::unexpected(fmt::format(
      "expected a fault of the claim for a refutation, found only {}, which {} does not include",
      identifier(verdict.tallies().begin()->first), name(verdict.claim())));
}

void write(std::ostream& out, const ExactMesh& mesh, const Document& document) {
  if (const auto* certificate = std::get_if<Certificate>(&document)) {
    write(out, mesh, *certificate);
  } else {
    const auto& refuted = std::get<RefutationWithPoints>(document);
    write(out, mesh, refuted.points, refuted.refutation);
  }
}

}  // namespace circumspect::certificate
