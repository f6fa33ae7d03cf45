// What is left out of an XML file before it is parsed, and that nothing changes by it: neither the
// numbers nor the lines of messages.
#include "oracle/formats/xml_skeleton.hpp"

#include <doctest/doctest.h>

#include "oracle/formats/reading_test.hpp"
#include "oracle/formats/vtu.hpp"

namespace circumspect::formats {
namespace {

// A file with one tetrahedron, whose array of points begins with so many empty lines and ends so.
std::string tetrahedron(std::size_t lines, const std::string& last,
                        const std::string& type = "10") {
  return "<VTKFile type=\"UnstructuredGrid\">\n<UnstructuredGrid>\n"
         "<Piece NumberOfPoints=\"4\" NumberOfCells=\"1\">\n<Points>\n"
         "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0" +
         std::string(lines, '\n') + "1 0 0\n0 1 0 0 0 " + last +
         "</DataArray>\n</Points>\n<Cells>\n"
         "<DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">0 1 2 3</DataArray>\n"
         "<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">4</DataArray>\n"
         "<DataArray type=\"Int32\" Name=\"types\" format=\"ascii\">" +
         type + "</DataArray>\n</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

std::string vtu_error(const std::string& text) { return error_of(read_vtu(named(text), kDouble)); }

}  // namespace

TEST_CASE("skeleton: large contents are left out, and places lead back to the file") {
  const std::string large(2000, '7');
  const std::string text = "<a><DataArray x=\">\" y='\"'>" + large + "</DataArray><b/></a>";
  const XmlSkeleton skeleton(text);
  CHECK(skeleton.text() == "<a><DataArray x=\">\" y='\"'></DataArray><b/></a>");
  CHECK(skeleton.content_of(4) == large);
  CHECK(!skeleton.content_of(5));
  CHECK(skeleton.in_file(4) == 4);
  const std::size_t place = skeleton.text().find("<b/>");
  CHECK(skeleton.in_file(place) == text.find("<b/>"));
}

TEST_CASE("skeleton: what may mean something in XML stays") {
  for (const char* const kept : {"&#49;", "-->", "]]>", "\"", "'"}) {
    CAPTURE(kept);
    const std::string text = "<DataArray>" + std::string(2000, '7') + kept + "</DataArray>";
    CHECK(XmlSkeleton(text).text() == text);
    const std::string in_front =
        "<DataArray>" + std::string(kept) + std::string(2000, '7') + "</DataArray>";
    CHECK(XmlSkeleton(in_front).text() == in_front);
  }
  const std::string blank = "<DataArray>" + std::string(2000, ' ') + "</DataArray>";
  CHECK(XmlSkeleton(blank).text() == blank);
  CHECK(XmlSkeleton("<DataArray").text() == "<DataArray");
  CHECK(XmlSkeleton("<DataArray a=\"").text() == "<DataArray a=\"");
  CHECK(XmlSkeleton("<DataArray a=\"<AppendedData>\" _>").appended() == ">");
}

TEST_CASE("skeleton: appended bytes") {
  const std::string text = "<V><AppendedData encoding=\"raw\">_<x>bytes</AppendedData></V>";
  const XmlSkeleton skeleton(text);
  CHECK(skeleton.appended().substr(0, 1) == "<");
  CHECK(skeleton.text().find("bytes") == std::string::npos);
  CHECK(skeleton.in_file(skeleton.text().find("</V>")) == text.find("</V>"));
}

TEST_CASE("skeleton: the same numbers and the same lines with and without it") {
  for (const std::size_t lines : {std::size_t{1}, std::size_t{2000}}) {
    CAPTURE(lines);
    const auto file = read_vtu(named(tetrahedron(lines, "0.1")), kDouble);
    REQUIRE(file);
    CHECK(file->points.points[3] == Point{0, 0, exact_value(0.1)});
    CHECK(file->tetrahedra.simplices == std::vector<Simplex>{{0, 1, 2, 3}});
    const std::string last = std::to_string(6 + lines);
    CHECK(vtu_error(tetrahedron(lines, "x")) ==
          "f:" + last + ": expected a coordinate of point 4 of 4, a finite number, found \"x\"");
    CHECK(vtu_error(tetrahedron(lines, "1 2")) ==
          "f:" + last + ": expected the end of the points, found \"2\"");
    // What comes behind the array has its line in the file.
    CHECK(vtu_error(tetrahedron(lines, "1", "99"))
              .starts_with("f:" + std::to_string(8 + lines) + ": "));
  }
}

}  // namespace circumspect::formats
