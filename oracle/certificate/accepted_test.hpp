// Writes what proves a verdict and holds it against its conditions, for tests.
#pragma once

#include "oracle/certificate/certificate_acceptor_test.hpp"
#include "oracle/certificate/document.hpp"
#include "oracle/certificate/refutation_acceptor_test.hpp"

namespace circumspect::certificate {

inline std::string text_of(const ExactMesh& mesh, const Document& document) {
  std::ostringstream out;
  write(out, mesh, document);
  return out.str();
}

// Are these the points of the user's mesh, scaled back?
inline bool are_points_of(const ExactMesh& mesh, const LabelledPoints& points) {
  if (points.size() != mesh.points.size()) return false;
  for (Vertex v = 0; mesh.points.names(v); ++v) {
    const auto found = points.find(std::to_string(mesh.label(v)));
    if (found == points.end()) return false;
    Point expected = mesh.points[v];
    if (found->second.size() > expected.size()) expected.push_back(mesh.points.weight(v));
    if (found->second != expected) return false;
  }
  return true;
}

// What is wrong with the document, whatever it is; empty if it proves its claim about this mesh.
inline std::string fault_of(const ExactMesh& mesh, const Verdict& verdict,
                            const std::string& text) {
  const auto fault = [&](const auto& acceptor) -> std::string {
    if (acceptor.header().claim != name(verdict.claim())) return "another claim";
    if (acceptor.header().dimension != mesh.points.ambient_dimension()) return "another dimension";
    if (!are_points_of(mesh, acceptor.labelled_points())) return "other points";
    return acceptor.simplex_count() == mesh.simplices.size() ? "" : "other simplices";
  };
  if (verdict.holds()) {
    const CertificateAcceptor acceptor(text);
    const std::string condition = acceptor.verdict();
    const bool unique = verdict.unique.value_or(false);
    const std::string standing = unique                              ? "unique"
                                 : verdict.canonical.value_or(false) ? "canonical"
                                                                     : "";
    if (acceptor.header().standing != standing) return "another standing";
    return condition == "accepted" ? fault(acceptor) : condition;
  }
  RefutationAcceptor acceptor(text);
  return acceptor.accepts() ? fault(acceptor) : "no evidence of " + acceptor.header().rule;
}

// What is wrong with what is written about the mesh.
inline std::string fault_of(const ExactMesh& mesh, const Verdict& verdict) {
  const auto document = document_of(mesh, verdict);
  if (!document) return document.error();
  return fault_of(mesh, verdict, text_of(mesh, *document));
}

// The rule that a refutation is about; empty if it is none or there is none.
inline std::string refuted_rule(const ExactMesh& mesh, const Verdict& verdict) {
  const auto document = document_of(mesh, verdict);
  if (!document || !std::holds_alternative<RefutationWithPoints>(*document)) return "";
  return std::string(identifier(std::get<RefutationWithPoints>(*document).refutation.rule));
}

}  // namespace circumspect::certificate
