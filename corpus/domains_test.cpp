// Judges every mesh of domains/ from the lemmas, holds the validity check to invalid.tsv, and holds
// both tables and the files to each other.
#include <filesystem>

#include <doctest/doctest.h>

#include "corpus/domain_table.hpp"

namespace circumspect::corpus {
namespace {

namespace fs = std::filesystem;

// Up to "--", or all of it.
std::string cause_in_name(const std::string& path) {
  const std::string file = fs::path(path).stem().string();
  return file.substr(0, file.find("--"));
}

std::set<std::string> files_in(std::initializer_list<const char*> folders,
                               const std::set<std::string>& extensions) {
  std::set<std::string> found;
  for (const char* folder : folders) {
    for (const auto& entry : fs::directory_iterator(kDomainFolder + folder)) {
      if (!extensions.contains(formats::extension(entry.path().string()))) continue;
      found.insert(fs::relative(entry.path(), kDomainFolder).generic_string());
    }
  }
  return found;
}

// invalid.tsv: an input, and the breaches that it has; "valid" has none.
std::map<std::string, std::set<std::string>> expected_breaches() {
  std::map<std::string, std::set<std::string>> expected;
  std::ifstream table(kDomainFolder + "invalid.tsv");
  for (std::string line; std::getline(table, line);) {
    const std::vector<std::string> cells = split(line, '\t');
    const std::vector<std::string> breaches = split(cells.at(1), ',');
    expected[cells.at(0)] = {breaches.begin(), breaches.end()};
  }
  return expected;
}

std::set<std::string> breaches_of(const std::string& path) {
  const auto file = formats::read_domain(path, NumberReading::kDouble);
  if (!file) return {file.error().to_string()};
  const auto complex = validated(formats::as_it_stands(*file).input);
  if (complex) return {"valid"};
  std::set<std::string> breaches;
  for (const Breach& breach : complex.error()) breaches.emplace(identifier(breach.kind));
  return breaches;
}

}  // namespace

TEST_CASE("each mesh of a domain breaks exactly the rules that its table names") {
  for (const DomainRow& row : domain_rows()) {
    INFO(row.text);
    CHECK(broken_rules(judge(row)) == row.broken);
  }
}

TEST_CASE("each wrong mesh of a domain breaks, under some claim, the one rule of its name") {
  std::set<std::string> named;
  for (const DomainRow& row : domain_rows()) {
    if (row.broken == std::set<std::string>{cause_in_name(row.mesh)}) named.insert(row.mesh);
  }
  for (const std::string& path : files_in({"reject"}, {".ele"})) {
    CHECK_MESSAGE(named.contains(path), path);
  }
}

TEST_CASE("each right mesh of a domain holds under some claim") {
  std::set<std::string> held;
  for (const DomainRow& row : domain_rows()) {
    if (row.broken.empty()) held.insert(row.mesh);
  }
  for (const std::string& path : files_in({"accept"}, {".ele"})) {
    CHECK_MESSAGE(held.contains(path), path);
  }
}

TEST_CASE("the table of domains and the meshes on disk are the same set") {
  std::set<std::string> listed;
  for (const DomainRow& row : domain_rows()) listed.insert(row.mesh);
  CHECK(listed.size() > 100);
  CHECK(listed == files_in({"accept", "reject", "tetgen", "gmsh"}, {".ele", ".mesh"}));
}

TEST_CASE("TetGen and Gmsh are judged on 20 domains at least") {
  std::set<std::string> judged;
  for (const DomainRow& row : domain_rows()) {
    if (row.mesh.starts_with("tetgen/") || row.mesh.starts_with("gmsh/")) judged.insert(row.domain);
  }
  CHECK(judged.size() >= 20);
}

TEST_CASE("each domain of the corpus is a piecewise linear complex") {
  for (const std::string& path : files_in({"."}, {".poly"})) {
    CHECK_MESSAGE(breaches_of(kDomainFolder + path) == std::set<std::string>{"valid"}, path);
  }
}

TEST_CASE("each invalid input and each surface has exactly the breaches that invalid.tsv names") {
  for (const auto& [file, breaches] : expected_breaches()) {
    const std::string& path = file;
    INFO(path);
    CHECK(breaches_of(kDomainFolder + path) == breaches);
    if (path.starts_with("invalid/")) CHECK(breaches.contains(cause_in_name(path)));
  }
}

TEST_CASE("invalid.tsv and the inputs on disk are the same set") {
  std::set<std::string> listed;
  for (const auto& [path, breaches] : expected_breaches()) listed.insert(path);
  CHECK(listed == files_in({"invalid", "surfaces"}, {".poly", ".off", ".stl"}));
}

TEST_CASE("there is an invalid input for every breach that a file can have") {
  std::set<std::string> covered;
  for (const auto& [path, breaches] : expected_breaches()) {
    if (path.starts_with("invalid/")) covered.insert(breaches.begin(), breaches.end());
  }
  for (const BreachEntry& entry : breach_kinds()) {
    // The readers refuse these: see corpus/malformed/.
    if (entry.kind == BreachKind::kIndexOutOfRange) continue;
    if (entry.kind == BreachKind::kDegenerateSegment) continue;
    CHECK_MESSAGE(covered.contains(std::string(entry.identifier)), entry.identifier);
  }
}

}  // namespace circumspect::corpus
