// Files that no reader reads, told by their first bytes. corpus/malformed has one of each kind with its message.
#include "oracle/formats/foreign_file.hpp"

#include <doctest/doctest.h>

#include "oracle/formats/mesh_files.hpp"

namespace circumspect::formats {
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
  CHECK(is_known("x", "** a comment\n** another\n*part, name=a\n"));
  CHECK_FALSE(is_known("x", "** comments alone\n"));
  CHECK_FALSE(is_known("x", "* 1 2\n"));
  CHECK_FALSE(is_known("x", "*\n"));
  CHECK_FALSE(is_known("x", "versions\n"));
  CHECK_FALSE(is_known("x", ""));
  CHECK_FALSE(is_known("x", " \n# MFEM\n"));
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
  // What a reader says of another file is about that.
  const Result<int> beside = tl::unexpected(FormatError{"x.node", 3, "a point", "none"});
  CHECK(explained(beside, packed).error().to_string() == "x.node:3: expected a point, found none");
  CHECK(explained(Result<int>(5), packed) == 5);
}

}  // namespace circumspect::formats
