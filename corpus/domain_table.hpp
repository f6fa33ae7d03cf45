// The rows of domains/expected.tsv, and the meshes and domains they are about, for the tests in
// this folder.
#pragma once

#include <algorithm>
#include <array>
#include <map>

#include "corpus/expected_table.hpp"
#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "kernel/piecewise_linear/regions.hpp"
#include "kernel/piecewise_linear/validity.hpp"
#include "oracle/formats/domain_file.hpp"
#include "oracle/formats/plane.hpp"
#include "oracle/formats/read_domain.hpp"
#include "oracle/judge/domain/judge_exactly.hpp"
#include "oracle/judge/within/judge_within.hpp"

namespace circumspect::corpus {

// One line: a mesh and a domain, both below corpus/domains/, options for the domain, a claim with
// options, and the rules that are broken, none if the claim holds.
struct DomainRow {
  std::string mesh;
  std::string domain;
  std::optional<DomainKind> kind = {};
  Claim claim = Claim::kCdt;
  check::Options options = {.max_violations = 1};
  std::optional<Rational> within = {};  // a distance
  std::set<std::string> broken = {};
  std::string text = {};  // the line, for messages
};

inline const std::string kDomainFolder = CIRCUMSPECT_CORPUS_DIR "/domains/";

inline Claim claim_about_a_domain(const std::string& word) {
  for (const ClaimEntry& one : claims()) {
    if (one.is_about_a_domain && one.name == word) return one.claim;
  }
  throw std::runtime_error("expected a claim about a domain, found " + word);
}

inline DomainRow domain_row_of(const std::string& line) {
  const std::vector<std::string> cells = split(line, '\t');
  const std::vector<std::string> domain = split(cells.at(1), ' ');
  const std::vector<std::string> claim = split(cells.at(2), ' ');
  DomainRow row{.mesh = cells.at(0), .domain = domain.at(0), .text = line};
  for (const std::string& word : domain) {
    if (word == "hull") row.kind = DomainKind::kHull;
    if (word == "enclosed") row.kind = DomainKind::kEnclosed;
  }
  row.claim = claim_about_a_domain(claim.at(0));
  if (claim.back() == "definition") row.options.by = check::By::kDefinition;
  if (claim.size() == 3 && claim[1] == "--within") {
    row.within = *read_number(claim[2], NumberReading::kDecimal);
  }
  if (cells.at(3) != "holds") {
    const std::vector<std::string> rules = split(cells.at(3), ',');
    row.broken = {rules.begin(), rules.end()};
  }
  return row;
}

inline std::vector<DomainRow> domain_rows() {
  std::ifstream file(kDomainFolder + "expected.tsv");
  std::vector<DomainRow> rows;
  for (std::string line; std::getline(file, line);) rows.push_back(domain_row_of(line));
  return rows;
}

// What the command makes of a file. Without a kind, a domain is enclosed if it encloses anything,
// and its convex hull if it has no walls. Throws if the file holds no valid complex, or one whose
// kind has to be said.
inline Domain domain_of(const std::string& path, std::optional<DomainKind> kind = {}) {
  auto file = formats::read_domain(path, NumberReading::kDouble);
  if (!file) throw std::runtime_error(file.error().to_string());
  file = formats::as_it_stands(std::move(*file));
  auto complex = validated(file->input);
  if (!complex) {
    throw std::runtime_error(path + ": " + std::string(identifier(complex.error().front().kind)));
  }
  const bool encloses = Regions(*complex).size() > 1;
  if (!kind && !encloses && !walls(*complex).empty()) {
    throw std::runtime_error(path + ": expected a kind for walls that enclose nothing");
  }
  complex->kind = kind.value_or(encloses ? DomainKind::kEnclosed : DomainKind::kHull);
  return {std::move(*complex), file->labels, file->first_index};
}

inline Mesh read_mesh_with_faces(const std::string& path) {
  auto file = formats::read_mesh({.mesh = path, .with_faces = true});
  if (!file) throw std::runtime_error(file.error().to_string());
  return std::move(file->mesh);
}

inline ExactMesh mesh_with_faces(const std::string& path) {
  return exact(read_mesh_with_faces(path));
}

inline Verdict judge(const DomainRow& row) {
  const ExactMesh mesh = mesh_with_faces(kDomainFolder + row.mesh);
  const Domain domain = domain_of(kDomainFolder + row.domain, row.kind);
  if (!row.within) return check::judge_exactly(row.claim, mesh, &domain, row.options);
  const Rational squared = *row.within * *row.within;
  auto verdict = check::judge_within(row.claim, mesh, domain, squared, row.options);
  if (!verdict) throw std::runtime_error(verdict.error().reason);
  return std::move(*verdict);
}

}  // namespace circumspect::corpus
