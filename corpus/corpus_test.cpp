// Judges every mesh of the corpus from the lemmas, and holds expected.tsv and the files to each other.
#include <filesystem>

#include <circumspect/check.hpp>
#include <doctest/doctest.h>

#include "corpus/domain_table.hpp"
#include "corpus/expected_table.hpp"
#include "oracle/judge/arrays/arrays_of_test.hpp"
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
    CHECK(broken_rules(check::judge_points(row.claim, mesh_of(row), row.options)) == row.broken);
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

// ---- Arrays ----
// The meshes of the corpus as arrays: whatever the checkers say of the files, `judge` says of the arrays.

TEST_CASE("arrays are judged as files are, and by the fast judge wherever they hold") {
  constexpr std::size_t kOneRowIn = properties::kOneInputIn > 1 ? 4 : 1;
  std::size_t rows = 0, fast = 0, rejected = 0;
  for (const Row& row : expected_rows()) {
    if (rows++ % kOneRowIn != 0) continue;
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

}  // namespace circumspect::corpus
