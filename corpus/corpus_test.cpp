// Judges every mesh of the corpus from the lemmas, and holds expected.tsv and the files to each
// other.
#include <algorithm>
#include <filesystem>

#include <circumspect/check.hpp>
#include <doctest/doctest.h>

#include "corpus/domain_table.hpp"
#include "corpus/expected_table.hpp"
#include "corpus/voronoi_table.hpp"
#include "oracle/formats/mesh_files.hpp"
#include "oracle/judge/arrays/arrays_of_test.hpp"
#include "oracle/judge/domain/judge_exactly.hpp"
#include "oracle/judge/judge.hpp"
#include "oracle/report/json.hpp"
#include "oracle/report/text.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect::corpus {

namespace {

namespace fs = std::filesystem;

std::string rule_in_name(const Row& row) {
  const std::string file = fs::path(row.path).stem().string();
  return file.substr(0, file.find("--"));
}

bool is_below(const Row& row, const std::string& folder) { return row.path.starts_with(folder); }

// Every file with simplices in one of the folders of the corpus that has meshes.
std::set<std::string> mesh_files() {
  const fs::path root = CIRCUMSPECT_CORPUS_DIR;
  std::set<std::string> found;
  for (const char* folder : {"accept", "reject", "peers", "regressions"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const std::string extension = formats::extension(entry.path().string());
      if (std::set<std::string>{".ele", ".off", ".json", ".qhull-i", ".msh", ".ply"}.contains(
              extension)) {
        found.insert(fs::relative(entry.path(), root).generic_string());
      }
    }
  }
  return found;
}

}  // namespace

TEST_CASE("each mesh breaks exactly the rules that expected.tsv names, by lemma or as told") {
  for (const Row& row : expected_rows()) {
    INFO(row.text);
    const Verdict verdict =
        is_of_a_mesh_alone(row)
            ? check::judge(row.claim, read_mesh_of(row), nullptr, row.options).value()
            : check::judge_exactly(row.claim, mesh_of(row), nullptr, row.options);
    CHECK(broken_rules(verdict) == row.broken);
  }
}

TEST_CASE("each mesh of reject/ breaks the one rule that its name begins with") {
  for (const Row& row : expected_rows()) {
    if (!is_below(row, "reject/")) continue;
    INFO(row.text);
    CHECK(row.broken.size() <= 1);
  }
  std::set<std::string> named;
  for (const Row& row : expected_rows()) {
    if (is_below(row, "reject/") && row.broken.contains(rule_in_name(row))) named.insert(row.path);
  }
  for (const std::string& path : mesh_files()) {
    if (path.starts_with("reject/")) CHECK_MESSAGE(named.contains(path), path);
  }
}

TEST_CASE("there is a mesh in reject/ for every rule") {
  std::set<std::string> covered;
  for (const Row& row : expected_rows()) {
    if (is_below(row, "reject/")) covered.insert(row.broken.begin(), row.broken.end());
  }
  for (const DomainRow& row : domain_rows()) {
    if (row.mesh.starts_with("reject/")) covered.insert(row.broken.begin(), row.broken.end());
  }
  for (const VoronoiRow& row : voronoi_rows()) {
    covered.insert(row.broken.begin(), row.broken.end());
  }
  for (const RuleEntry& entry : rules()) {
    CHECK_MESSAGE(covered.contains(std::string(entry.identifier)), entry.identifier);
  }
}

TEST_CASE("each mesh of accept/ holds under some claim") {
  std::set<std::string> held;
  for (const Row& row : expected_rows()) {
    if (row.broken.empty()) held.insert(row.path);
  }
  for (const std::string& path : mesh_files()) {
    if (path.starts_with("accept/")) CHECK_MESSAGE(held.contains(path), path);
  }
}

TEST_CASE("expected.tsv and the meshes on disk are the same set") {
  std::set<std::string> listed;
  for (const Row& row : expected_rows()) listed.insert(row.path);
  CHECK(listed.size() > 300);
  const std::set<std::string> on_disk = mesh_files();
  for (const std::string& path : on_disk) CHECK_MESSAGE(listed.contains(path), path);
  for (const std::string& path : listed) CHECK_MESSAGE(on_disk.contains(path), path);
}

// The meshes of the corpus as arrays: whatever the checkers say of the files, `judge` says of the
// arrays.

TEST_CASE("arrays are judged as files are, and by the fast judge wherever they hold") {
  constexpr std::size_t kOneRowIn = properties::kOneInputIn > 1 ? 4 : 1;
  std::size_t rows = 0, fast = 0, rejected = 0;
  for (const Row& row : expected_rows()) {
    if (rows++ % kOneRowIn != 0 || is_of_a_mesh_alone(row)) continue;
    const ExactMesh mesh = mesh_of(row);
    const auto arrays = arrays::arrays_of(mesh);
    if (!arrays) continue;
    INFO(row.text);
    const MeshJudgement judgement = judge(std::string(name(row.claim)), arrays->view());
    CHECK(arrays::difference_from_slow(row.claim, mesh, judgement) == "");
    const bool is_handled = arrays->dimension == 2 || arrays->dimension == 3;
    if (is_handled && judgement.holds) CHECK(judgement.counts.fast);
    fast += judgement.counts.fast ? 1 : 0;
    rejected += judgement.holds ? 0 : 1;
  }
  CHECK(fast > 100 / kOneRowIn);
  CHECK(rejected > 100 / kOneRowIn);
}

// The one judge and the exact checkers alone give the same verdict, word for word, on every mesh of
// the corpus that has its points beside it. The fast engine decides it wherever the claim holds or
// only facets are not locally Delaunay.

namespace {

// The files with simplices of a folder and those below, in order.
std::vector<std::string> meshes_below(const std::string& folder) {
  std::vector<std::string> paths;
  for (const auto& entry : fs::recursive_directory_iterator(CIRCUMSPECT_CORPUS_DIR + folder)) {
    if (entry.path().extension() == ".ele") paths.push_back(entry.path().string());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

// Is all that is wrong that some facets are not locally Delaunay?
bool is_about_facets(const Verdict& verdict) {
  return std::all_of(verdict.tallies().begin(), verdict.tallies().end(), [](const auto& tally) {
    return tally.first == Rule::kFacetNotLocal || tally.first == Rule::kVertexSubmerged;
  });
}

std::string text_of(const Verdict& verdict, const Mesh& mesh) {
  return report::verdict_line(verdict, mesh, "m") + report::explanation(verdict, mesh) +
         report::verdict(verdict, mesh, "m", check::By::kLemma).dump();
}

// Judges a mesh in both ways; true if the fast engine decided.
bool compare(formats::MeshRequest request, Claim claim, const check::Options& options) {
  if (claim == Claim::kWeightedDelaunay) request.weights = formats::Weights::kDemanded;
  const auto file = formats::read_mesh(request, 2);
  if (!file) return false;
  const Mesh& mesh = file->mesh;
  const auto verdict = check::judge(claim, mesh, nullptr, options);
  if (!verdict) return false;
  const Verdict slow = check::judge_exactly(claim, exact(mesh), nullptr, options);
  CHECK(text_of(*verdict, mesh) == text_of(slow, mesh));
  if (verdict->course.fast) return true;
  const bool are_doubles = std::holds_alternative<Rows<double>>(mesh.coordinates) &&
                           std::holds_alternative<Rows<double>>(mesh.weights);
  const auto ambient = static_cast<int>(mesh.dimension());
  const bool in_scope = are_doubles && ambient == slow.dimension && (ambient == 2 || ambient == 3);
  const bool has_unused_points = claim == Claim::kWeightedDelaunay;
  CHECK(!(in_scope && is_about_facets(slow) && (slow.holds() || !has_unused_points)));
  return false;
}

constexpr std::size_t kOneMeshIn = properties::kOneInputIn > 1 ? 4 : 1;

}  // namespace

TEST_CASE(
    "the verdict of the judge is that of the exact checkers, and is found fast where it holds") {
  std::size_t verdicts = 0;
  std::size_t meshes = 0;
  for (const std::string folder : {"/accept", "/reject", "/peers", "/regressions", "/findings"}) {
    for (const std::string& path : meshes_below(folder)) {
      if (meshes++ % kOneMeshIn != 0) continue;
      CAPTURE(path);
      for (const Claim claim :
           {Claim::kTriangulation, Claim::kDelaunay, Claim::kWeightedDelaunay}) {
        verdicts += compare({.mesh = path}, claim, {}) ? 1 : 0;
        verdicts += compare({.mesh = path}, claim, {.oriented = true}) ? 1 : 0;
      }
      const formats::MeshRequest request{.mesh = path, .with_neighbors = true};
      verdicts += compare(request, Claim::kDelaunay, {}) ? 1 : 0;
    }
  }
  CHECK(verdicts > 100 / kOneMeshIn);
}

}  // namespace circumspect::corpus
