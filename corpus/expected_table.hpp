// The rows of expected.tsv, and the meshes they are about, for the tests in this folder.
#pragma once

#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "oracle/formats/mesh_files.hpp"
#include "oracle/model/options.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::corpus {

// One line: the path of a mesh below corpus/, a claim with further options, and the rules that the
// mesh breaks under them, none if it holds.
struct Row {
  std::string path;
  Claim claim = Claim::kDelaunay;
  check::Options options = {.max_violations = 1};
  bool with_neighbors = false;
  std::set<std::string> broken = {};
  std::string text = {};  // the line, for messages
};

inline std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

inline Row row_of(const std::string& line) {
  const std::vector<std::string> cells = split(line, '\t');
  Row row{.path = cells.at(0), .text = line};
  const std::vector<std::string> words = split(cells.at(1), ' ');
  for (const ClaimEntry& one : claims()) {
    if (one.name == words.at(0)) row.claim = one.claim;
  }
  for (const std::string& word : words) {
    if (word == "--oriented") row.options.oriented = true;
    if (word.starts_with("--oriented")) {
      row.options.complex.oriented = word.ends_with("=positive")   ? Orientations::kPositive
                                     : word.ends_with("=negative") ? Orientations::kNegative
                                                                   : Orientations::kSame;
    }
    if (word == "--manifold") row.options.complex.manifold = true;
    if (word == "--connected") row.options.complex.connected = true;
    if (word == "--closed") row.options.complex.closed = true;
    if (word == "--faces") row.options.complex.faces = true;
    if (word == "hanging-vertex") row.options.complex.allow_hanging = true;
    if (word == "--allow-unused") row.options.complex.allow_unused = true;
    if (const auto required = read_requirement(word)) {
      row.options.quality.requirements.push_back(*required);
    }
    if (word == "--all-boundary-points") row.options.hull.all_boundary_points = true;
    if (word == "--only-extreme") row.options.hull.only_extreme = true;
    if (word == "--neighbors") row.with_neighbors = true;
    if (word == "definition") row.options.by = check::By::kDefinition;
  }
  if (cells.at(2) != "holds") {
    const std::vector<std::string> rules = split(cells.at(2), ',');
    row.broken = {rules.begin(), rules.end()};
  }
  return row;
}

inline std::vector<Row> expected_rows() {
  std::ifstream file(CIRCUMSPECT_CORPUS_DIR "/expected.tsv");
  std::vector<Row> rows;
  for (std::string line; std::getline(file, line);) rows.push_back(row_of(line));
  return rows;
}

// Throws if it cannot be read: the corpus holds no malformed mesh.
inline Mesh read_mesh_of(const Row& row) {
  formats::MeshRequest request;
  request.mesh = CIRCUMSPECT_CORPUS_DIR "/" + row.path;
  request.with_neighbors = row.with_neighbors;
  request.with_faces = row.options.complex.faces;
  if (row.claim == Claim::kWeightedDelaunay) request.weights = formats::Weights::kDemanded;
  auto file = formats::read_mesh(request);
  if (!file) throw std::runtime_error(file.error().to_string());
  if (row.with_neighbors && !file->mesh.neighbors) throw std::runtime_error("no .neigh file");
  return std::move(file->mesh);
}

// Is it of a mesh by itself, which need not be one of full dimension? Its points may be equal,
// which they may not in an exact mesh.
inline bool is_of_a_mesh_alone(const Row& row) { return is_about_a_list(row.claim); }

inline ExactMesh mesh_of(const Row& row) { return exact(read_mesh_of(row)); }

inline std::set<std::string> broken_rules(const Verdict& verdict) {
  std::set<std::string> rules;
  for (const auto& [rule, tally] : verdict.tallies()) rules.emplace(identifier(rule));
  return rules;
}

}  // namespace circumspect::corpus
