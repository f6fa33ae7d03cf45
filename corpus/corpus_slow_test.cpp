// Every mesh of the corpus by definition, by certificates, and by the engine's facts of simplices.
#include <doctest/doctest.h>

#include "corpus/domain_table.hpp"
#include "corpus/expected_table.hpp"
#include "oracle/certificate/accepted_test.hpp"
#include "oracle/judge/domain/domain_cases_test.hpp"
#include "oracle/judge/domain/judge_exactly.hpp"
#include "oracle/judge/judge.hpp"
#include "oracle/judge/known_mesh.hpp"
#include "oracle/report/text.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect::corpus {

// Judges the meshes of the corpus from the definitions, those with many simplices left out: the
// time grows with the square of their number. `make test`, which tries a quarter of all inputs,
// leaves out more.

std::size_t too_many_by_definition() { return properties::one_input_in() > 1 ? 20 : 100; }
// Of a domain, definitions look at visibility, too.
std::size_t too_many_in_domain() { return properties::one_input_in() > 1 ? 10 : 30; }

TEST_CASE("by definition, each mesh holds or fails as expected.tsv says") {
  std::size_t judged = 0;
  for (Row row : expected_rows()) {
    INFO(row.text);
    const Mesh mesh = read_mesh_of(row);
    if (mesh.simplices.size() > too_many_by_definition()) continue;
    row.options.by = check::By::kDefinition;
    const Verdict verdict = check::judge(row.claim, mesh, nullptr, row.options).value();
    CHECK(verdict.holds() == row.broken.empty());
    // Of a mesh alone both ways name the same.
    if (is_of_a_mesh_alone(row)) CHECK(broken_rules(verdict) == row.broken);
    ++judged;
  }
  CHECK(judged > 220);
}

TEST_CASE("by definition, each small mesh of a domain holds or fails as its table says") {
  std::size_t judged = 0;
  for (DomainRow row : domain_rows()) {
    INFO(row.text);
    if (mesh_with_faces(kDomainFolder + row.mesh).simplices.size() > too_many_in_domain()) continue;
    row.options.by = check::By::kDefinition;
    CHECK(judge(row).holds() == row.broken.empty());
    ++judged;
  }
  CHECK(judged > 150);
}

// What proves each verdict of expected.tsv, held against proofs/CERTIFICATE.md.

namespace {

// The acceptor of the tests computes with rationals, and slowly.
std::size_t too_many_to_accept() { return properties::one_input_in() > 1 ? 500 : 3000; }

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
    if (is_of_a_mesh_alone(row)) continue;
    INFO(row.text);
    const ExactMesh mesh = mesh_of(row);
    if (!has_certificate(mesh) || mesh.simplices.size() > too_many_to_accept()) continue;
    const Verdict verdict = check::judge_exactly(row.claim, mesh, nullptr, row.options);
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

// The meshes of domains/, judged with what the fast judge knows of their simplices and without: the
// same word for word.

TEST_CASE("what is known of the simplices changes no word about a mesh of a domain") {
  std::size_t known = 0, wrong = 0, place = 0;
  for (const DomainRow& row : domain_rows()) {
    INFO(row.text);
    const bool both = place++ % properties::one_input_in() == 0;
    const Mesh mesh = read_mesh_with_faces(kDomainFolder + row.mesh);
    const ExactMesh exact_mesh = exact(mesh);
    const Domain domain = domain_of(kDomainFolder + row.domain, row.kind);
    check::Options options = row.options;
    options.threads = 2;
    options.max_violations = 0;
    for (const bool oriented : {false, true}) {
      if (oriented && !both) continue;
      options.oriented = oriented;
      const Verdict slow = check::judge_exactly(row.claim, exact_mesh, &domain, options);
      const Verdict quick = check::judge(row.claim, mesh, &domain, options).value();
      CHECK(check::text_of(quick) == check::text_of(slow));
      CHECK(report::verdict_line(quick, mesh, row.mesh, &domain) ==
            report::verdict_line(slow, mesh, row.mesh, &domain));
      CHECK(report::explanation(quick, mesh, &domain) == report::explanation(slow, mesh, &domain));
    }
    if (!check::facts_of_simplices(row.claim, mesh, domain.complex.kind, row.options)) continue;
    ++known;
    wrong += row.broken.empty() ? 0 : 1;
  }
  CHECK(known > 100);
  CHECK(wrong > 20);
}

}  // namespace circumspect::corpus
