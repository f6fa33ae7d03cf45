// Every file of corpus/malformed gets the message that its table expects. For files that no reader
// reads, messages say what they are.
#include <filesystem>
#include <fstream>
#include <set>

#include <doctest/doctest.h>

#include "oracle/formats/bytes/packed.hpp"
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

// "x" of x.node.gz.
std::string stem_of(const std::string& path) {
  return std::filesystem::path(name_inside(path)).stem().string();
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
    listed.insert(stem_of(row.file));
    listed.insert(stem_of(row.domain()));
    listed.insert(stem_of(row.points()));
  }
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    if (entry.path().filename() == "expected.tsv" || entry.path().extension() == ".md") continue;
    CHECK_MESSAGE(listed.count(stem_of(entry.path().string())) == 1, entry.path().string());
  }
}

namespace {

std::string kind(const std::string& name, const std::string& text) {
  return foreign_kind({name, text}).value_or("unknown");
}

bool is_known(const std::string& name, const std::string& text) {
  return foreign_kind({name, text}).has_value();
}

}  // namespace

TEST_CASE("foreign files: what begins like one and is none") {
  CHECK(is_known("x.msh", "(0 \"a\")\n"));
  CHECK_FALSE(is_known("x.msh", "(a)\n"));
  CHECK_FALSE(is_known("x.msh", "("));
  CHECK(is_known("x.mesh", "** a comment\n** another\n*part, name=a\n"));
  CHECK_FALSE(is_known("x.mesh", "** comments alone\n"));
  CHECK_FALSE(is_known("x.mesh", "* 1 2\n"));
  CHECK_FALSE(is_known("x.inp", "*part, name=a\n"));
  CHECK_FALSE(is_known("x", "versions\n"));
  CHECK_FALSE(is_known("x", ""));
}

TEST_CASE("foreign files: GiD's, JIGSAW's and single ones of OpenFOAM are named") {
  const std::string foam = "/* a banner */\nFoamFile\n{\n}\n";
  CHECK(kind("x/points", foam) == "a file of OpenFOAM (name the case, or its folder polyMesh)");
  CHECK_FALSE(is_known("x.obj", foam));
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

TEST_CASE("foreign files: what qvoronoi writes is named, and not what is nearly that") {
  const std::string cells = "2\n5 4 1\n-10.101 -10.101 \n0.5 0.5 \n";
  CHECK(kind("x.txt", cells) ==
        "a Voronoi diagram of qvoronoi (--claim voronoi --points SITES judges it)");
  for (const char* text : {"2\n5 4 2\n-10.101 -10.101\n", "2\n5 4 1\n-10.101 0\n", "2 3\n5 4 1\n",
                           "2\n5 4 1\n", "2\n5 4\n-10.101\n", "2\n"}) {
    CHECK_FALSE(is_known("x.txt", text));
  }
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
  const Source packed{"x.off", "BZh9"};
  CHECK(explained(FormatError{"x.off", 7, "a point", "\"a\""}, packed).to_string() ==
        "x.off:1: expected a point, found a file that bzip2 packed (unpack it first)");
  CHECK(explained(FormatError{"x.off", 0, "a point", "none"}, packed).to_string() ==
        "x.off: expected a point, found a file that bzip2 packed (unpack it first)");
  CHECK(explained(FormatError{"x.off", 7, "a point", "none"}, {"x.off", "OFF"}).to_string() ==
        "x.off:7: expected a point, found none");
  // What a reader says about another file concerns that file.
  const Result<int> beside = tl::unexpected(FormatError{"x.node", 3, "a point", "none"});
  CHECK(explained(beside, packed).error().to_string() == "x.node:3: expected a point, found none");
  CHECK(explained(Result<int>(5), packed) == 5);
}

}  // namespace circumspect::formats
