// What proves each verdict of expected.tsv, held against proofs/CERTIFICATE.md.
#include <doctest/doctest.h>

#include "corpus/expected_table.hpp"
#include "oracle/certificate/accepted_test.hpp"

namespace circumspect::corpus {
namespace {

// The acceptor of the tests computes with rationals, and slowly.
constexpr std::size_t kManySimplices = 3000;

bool has_certificate(const ExactMesh& mesh) {
  const std::size_t dimension = mesh.points.ambient_dimension();
  return (dimension == 2 || dimension == 3) &&
         mesh.points.dimension() == static_cast<int>(dimension);
}

// Rules that are broken by what options demand on top of the claim.
bool is_about_options(const std::set<std::string>& rules) {
  return rules == std::set<std::string>{"simplex.orientation"} ||
         rules == std::set<std::string>{"complex.wrong-neighbor"};
}

}  // namespace

TEST_CASE("each verdict in the plane and in space has a certificate or a refutation") {
  std::size_t certificates = 0;
  std::set<std::string> refuted;
  for (const Row& row : expected_rows()) {
    INFO(row.text);
    const ExactMesh mesh = mesh_of(row);
    if (!has_certificate(mesh) || mesh.simplices.size() > kManySimplices) continue;
    const Verdict verdict = check::judge_points(row.claim, mesh, row.options);
    if (is_about_options(row.broken)) {
      CHECK(!certificate::document_of(mesh, verdict));
      continue;
    }
    CHECK(certificate::fault_of(mesh, verdict) == "");
    certificates += verdict.holds() ? 1u : 0u;
    if (verdict.holds()) continue;
    const std::string rule = certificate::refuted_rule(mesh, verdict);
    CHECK(row.broken.contains(rule));
    refuted.insert(rule);
  }
  CHECK(certificates > 100);
  // All kinds of evidence that there are.
  for (const char* rule :
       {"simplex.wrong-dimension", "triangulation.unknown-vertex", "simplex.repeated-vertex",
        "simplex.degenerate", "complex.duplicate-simplex", "complex.facet-overused",
        "complex.overlap", "triangulation.covered-twice", "triangulation.unused-point",
        "triangulation.hull-not-convex", "triangulation.hull-not-closed",
        "delaunay.facet-not-local", "delaunay.vertex-in-ball", "weighted.point-below-plane",
        "weighted.vertex-submerged"}) {
    CHECK_MESSAGE(refuted.contains(rule), rule);
  }
}

}  // namespace circumspect::corpus
