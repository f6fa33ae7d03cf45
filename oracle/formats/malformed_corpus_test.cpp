// Every file of corpus/malformed gets the message that its table expects. For files that no reader
// reads, messages say what they are.
#include <filesystem>
#include <fstream>
#include <set>

#include <doctest/doctest.h>

#include "oracle/formats/domain_file.hpp"
#include "oracle/formats/foreign_file.hpp"
#include "oracle/formats/mesh_files.hpp"
#include "oracle/formats/read_domain.hpp"

namespace circumspect::formats {
namespace {

const std::string kFolder = CIRCUMSPECT_CORPUS_DIR "/malformed/";

// A line of expected.tsv: a mesh, options of the command, and a part of the message.
struct Row {
  std::string file;
  std::string options;
  std::string message;

  // The file after an option; empty if it is another option.
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
    // The command finds what is wrong with a complex that could be read.
    if (message.empty() && row.message.starts_with("plc.")) continue;
    CHECK_MESSAGE(message.find(row.message) != std::string::npos, message);
    CHECK(message.find('\n') == std::string::npos);
  }
}

TEST_CASE("no malformed file is left out of the table") {
  // A mesh in two files is in the table once.
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

// ---- Foreign files ----
namespace {

std::string kind(const std::string& name, const std::string& text) {
  return foreign_kind({name, text}).value_or("unknown");
}

bool is_known(const std::string& name, const std::string& text) {
  return foreign_kind({name, text}).has_value();
}

}  // namespace

TEST_CASE("foreign files: what begins like one and is none") {
  const std::string counts = "3 1 3\n0 0 1\n1 0 1\n0 1 1\n";
  CHECK(is_known("x.msh", counts));
  CHECK_FALSE(is_known("x.ele", counts));  // three counts are a header of many formats
  CHECK_FALSE(is_known("x.msh", "3 1\n0 0 1\n"));
  CHECK_FALSE(is_known("x.msh", "3 1 3\n0 0\n"));
  CHECK_FALSE(is_known("x.msh", "3 1 -3\n0 0 1\n"));
  CHECK_FALSE(is_known("x.msh", "3 1 3"));
  CHECK(is_known("x.msh", "(0 \"a\")\n"));
  CHECK_FALSE(is_known("x.msh", "(a)\n"));
  CHECK_FALSE(is_known("x.msh", "("));
  CHECK(is_known("x.mesh", "** a comment\n** another\n*part, name=a\n"));
  CHECK_FALSE(is_known("x.mesh", "** comments alone\n"));
  CHECK_FALSE(is_known("x.mesh", "* 1 2\n"));
  CHECK_FALSE(is_known("x.inp", "*part, name=a\n"));
  CHECK_FALSE(is_known("x", "versions\n"));
  CHECK_FALSE(is_known("x", ""));
  CHECK_FALSE(is_known("x", " \n# MFEM\n"));
}

TEST_CASE("foreign files: FreeFem's in space, GiD's and JIGSAW's are named") {
  CHECK(kind("x.msh", "4 1 4\n0 0 0 0\n1 0 0 0\n") == kind("x.msh", "3 1 3\n0 0 1\n1 0 1\n"));
  CHECK_FALSE(is_known("x.msh", "4 1 4\n0 0 0 0 0\n"));
  const std::string gid =
      "a mesh of GiD (copy its coordinates to IN.node and its elements to IN.ele, each below a "
      "line of counts)";
  CHECK(kind("x.msh", "MESH dimension 3 ElemType Triangle Nnode 3\nCoordinates\n") == gid);
  CHECK(kind("x.msh", "# of GiD\nmesh \"a b\" dimension = 3 elemtype linear nnode = 2\n") == gid);
  CHECK_FALSE(is_known("x.msh", "MESH of something\n"));
  CHECK_FALSE(is_known("x.msh", "MESHES dimension 3 ElemType Triangle\n"));
  const std::string jigsaw =
      "a mesh of JIGSAW (jigsawpy.savevtk(\"OUT.vtk\", mesh) writes one that is read)";
  CHECK(kind("x.msh", "MSHID=3\nNDIMS=2\n") == jigsaw);
  CHECK(kind("x.msh", "# made by hand\nmshid = 3;EUCLIDEAN-MESH\n") == jigsaw);
  CHECK_FALSE(is_known("x.msh", "MSHID\n"));
}

TEST_CASE("foreign files: what compilers write as .obj is named") {
  using namespace std::string_literals;
  for (const std::string& bytes : {"\x4c\x01\x02"s, "\x64\x86\x09\0"s,
                                   "\x7f"
                                   "ELF\2"s}) {
    CHECK(kind("x.OBJ", bytes) == "a compiler's object file, not a mesh of Wavefront's");
    CHECK_FALSE(is_known("x.msh", bytes));
  }
  CHECK_FALSE(is_known("x.obj", "L\n"));
  CHECK_FALSE(is_known("x.obj", "ELF"));
}

TEST_CASE("foreign files: XML is VTK's under the names that say so") {
  const std::string xml = "\n<VTKFile type=\"UnstructuredGrid\">\n</VTKFile>\n";
  CHECK(kind("x.vtk", xml) == "XML (if it is a mesh of VTK, give its name the extension .vtu)");
  CHECK(is_known("x.msh", xml));
  for (const char* const name : {"x.vtu", "x.VTP", "x", "x.xml"}) CHECK_FALSE(is_known(name, xml));
}

TEST_CASE("foreign files: an error keeps what was expected, and speaks of the whole file") {
  const Source packed{"x.off", "\x1f\x8b\x08"};
  CHECK(explained(FormatError{"x.off", 7, "a point", "\"a\""}, packed).to_string() ==
        "x.off:1: expected a point, found a file that gzip packed (unpack it first)");
  CHECK(explained(FormatError{"x.off", 0, "a point", "none"}, packed).to_string() ==
        "x.off: expected a point, found a file that gzip packed (unpack it first)");
  CHECK(explained(FormatError{"x.off", 7, "a point", "none"}, {"x.off", "OFF"}).to_string() ==
        "x.off:7: expected a point, found none");
  // What a reader says about another file concerns that file.
  const Result<int> beside = tl::unexpected(FormatError{"x.node", 3, "a point", "none"});
  CHECK(explained(beside, packed).error().to_string() == "x.node:3: expected a point, found none");
  CHECK(explained(Result<int>(5), packed) == 5);
}

}  // namespace circumspect::formats
