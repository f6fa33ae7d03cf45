// Every file of corpus/malformed gets the message that its table expects.
#include <filesystem>
#include <fstream>
#include <set>

#include <doctest/doctest.h>

#include "oracle/formats/domain_file.hpp"
#include "oracle/formats/mesh_files.hpp"

namespace circumspect::formats {
namespace {

const std::string kFolder = CIRCUMSPECT_CORPUS_DIR "/malformed/";

// A line of expected.tsv: a mesh, options of the command, and a part of the message.
struct Row {
  std::string file;
  std::string options;
  std::string message;

  // The file behind an option; empty if it is another.
  std::string file_behind(const std::string& option) const {
    return options.starts_with(option) ? options.substr(option.size()) : "";
  }
  std::string domain() const { return file_behind("--domain "); }
  std::string points() const { return file_behind("--points "); }
};

// What the readers say of a row; empty if they have no complaint.
std::string message_of(const Row& row) {
  MeshRequest request{kFolder + row.file};
  if (row.options == "--coordinates decimal") request.reading = NumberReading::kDecimal;
  if (row.options == "--neighbors") request.with_neighbors = true;
  if (!row.points().empty()) request.points = kFolder + row.points();
  if (!row.domain().empty()) {
    request.with_faces = true;
    const auto domain = read_domain(kFolder + row.domain(), request.reading);
    if (!domain) return domain.error().to_string();
  }
  const Result<MeshFile> mesh = read_mesh(request);
  return mesh ? "" : mesh.error().to_string();
}

std::vector<Row> rows() {
  std::vector<Row> result;
  std::ifstream table(kFolder + "expected.tsv");
  Row row;
  while (std::getline(table, row.file, '\t') && std::getline(table, row.options, '\t') &&
         std::getline(table, row.message)) {
    result.push_back(row);
  }
  return result;
}

}  // namespace

TEST_CASE("malformed files get the message that is expected") {
  REQUIRE(rows().size() > 30);
  for (const Row& row : rows()) {
    CAPTURE(row.file);
    CAPTURE(row.options);
    const std::string message = message_of(row);
    // What is wrong with a complex that could be read, the command finds.
    if (message.empty() && row.message.starts_with("plc.")) continue;
    CHECK_MESSAGE(message.find(row.message) != std::string::npos, message);
    CHECK(message.find('\n') == std::string::npos);
  }
}

TEST_CASE("no malformed file is left out of the table") {
  // A mesh in two files stands in the table once.
  std::set<std::string> listed;
  for (const Row& row : rows()) {
    listed.insert(std::filesystem::path(row.file).stem());
    listed.insert(std::filesystem::path(row.domain()).stem());
    listed.insert(std::filesystem::path(row.points()).stem());
  }
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    if (entry.path().filename() == "expected.tsv" || entry.path().extension() == ".md") continue;
    CHECK_MESSAGE(listed.count(entry.path().stem()) == 1, entry.path().string());
  }
}

}  // namespace circumspect::formats
