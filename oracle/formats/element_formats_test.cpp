// Elements of all dimensions: what Medit, Gmsh and others write, and .tet.

#include <algorithm>
#include <sstream>

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "oracle/formats/element_domain.hpp"
#include "oracle/formats/gmsh.hpp"
#include "oracle/formats/obj.hpp"
#include "oracle/formats/reading_test.hpp"
#include "oracle/formats/tet.hpp"
#include "oracle/formats/written_elements_test.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect::formats {

// A mesh of elements is the same in every form of every format, and its numbers are exact to the
// last bit.

namespace {

const WrittenMesh kTwoTetrahedra = {
    {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0.1}, {1.0 / 3, -1e-300, 4}, {0, 0, -1.0009765625}},
    {{0, 3}, {0, 1, 2}, {1, 2, 3}, {0, 1, 2, 3}, {0, 2, 1, 5}}};

// Vertices counted from 0.
std::vector<Simplex> from_zero(const SimplexFile& list, Vertex first_index) {
  std::vector<Simplex> simplices = list.simplices.lists();
  for (Simplex& simplex : simplices) {
    for (Vertex& v : simplex) v -= first_index;
  }
  return simplices;
}

// What differs between a form and the mesh; empty if nothing does.
std::string difference(const WrittenForm& form, const WrittenMesh& mesh) {
  const Result<ElementFile> file = read_form(form, kDouble);
  if (!file) return form.name + ": " + file.error().to_string();
  const ElementFile expected = elements_of(mesh);
  if (file->points.points != expected.points.points) return form.name + ": other points";
  const Vertex first = file->points.first_index;
  if (from_zero(file->tetrahedra, first) != expected.tetrahedra.simplices) {
    return form.name + ": other tetrahedra";
  }
  if (!form.has_faces) return "";
  if (from_zero(file->triangles, first) != expected.triangles.simplices) {
    return form.name + ": other triangles";
  }
  if (from_zero(file->edges, first) != expected.edges.simplices) return form.name + ": other edges";
  for (const SimplexFile* const list : {&file->edges, &file->triangles, &file->tetrahedra}) {
    if (list->first_index != first) return form.name + ": simplices from another index";
    if (list->vertices_per_simplex != list->simplices.columns()) return form.name + ": other sizes";
  }
  return "";
}

bool has_part(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

double any_double() {
  const double value = std::bit_cast<double>(*rc::gen::arbitrary<std::uint64_t>());
  return std::isfinite(value) ? value : 1.5;
}

WrittenMesh any_mesh() {
  WrittenMesh mesh;
  const int points = *rc::gen::inRange(1, 12);
  for (int i = 0; i < points; ++i) {
    mesh.points.push_back({any_double(), any_double(), any_double()});
  }
  const int cells = *rc::gen::inRange(0, 12);
  for (int i = 0; i < cells; ++i) {
    const auto size = *rc::gen::inRange<std::size_t>(2, 5);
    mesh.cells.push_back(*rc::gen::container<std::vector<int>>(size, rc::gen::inRange(0, points)));
  }
  return mesh;
}

}  // namespace

TEST_CASE("the same mesh in every form") {
  for (const WrittenForm& form : all_forms(kTwoTetrahedra)) {
    CHECK_MESSAGE(difference(form, kTwoTetrahedra) == "", difference(form, kTwoTetrahedra));
  }
}

TEST_CASE("any mesh of any doubles in every form") {
  CHECK(properties::holds("forms", [] {
    const WrittenMesh mesh = any_mesh();
    for (const WrittenForm& form : all_forms(mesh)) RC_ASSERT(difference(form, mesh) == "");
  }));
}

TEST_CASE("no form ends early: every text that is cut off is refused") {
  for (const WrittenForm& form : all_forms(kTwoTetrahedra)) {
    CAPTURE(form.name);
    // What follows the last number that counts may be missing: attributes and blanks.
    const std::string whole = form.extension == ".vtk"
                                  ? form.text.substr(0, form.text.find("\nCELL_DATA") + 1)
                                  : form.text;
    const std::size_t last = whole.find_last_not_of(" \n");
    const std::size_t step = 1 + whole.size() / 300;
    for (std::size_t size = 0; size < last; size += step) {
      WrittenForm cut = form;
      cut.text.resize(size);
      const Result<ElementFile> file = read_form(cut, kDouble);
      CAPTURE(size);
      // A VTK section that is missing altogether cannot be noticed, and neither can half a number
      // in text.
      if (!file) CHECK(file.error().to_string().starts_with("f"));
      if (file) CHECK(form.extension != ".msh");
      if (file) CHECK(form.extension != ".vtu");
    }
  }
}

TEST_CASE("what surfaces and cells of other shapes become") {
  ElementFile file;
  CHECK(!add_element(file, ElementShape::kPolyline, Simplex{0, 1, 2}, "a polyline", 1));
  CHECK(file.edges.simplices == std::vector<Simplex>{{0, 1}, {1, 2}});
  CHECK(!add_element(file, ElementShape::kStrip, Simplex{0, 1, 2, 3, 4}, "a strip", 2));
  CHECK(file.triangles.simplices == std::vector<Simplex>{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}});
  CHECK(check_simplices(file, "f"));
  CHECK(!add_element(file, ElementShape::kPixel, Simplex{0, 1, 2, 3}, "a pixel", 3));
  CHECK(file.polygons.simplices == std::vector<Simplex>{{0, 1, 3, 2}});
  CHECK(check_simplices(file, "f").error().to_string() ==
        "f:3: expected edges, triangles and tetrahedra, found a pixel");
  CHECK(add_element(file, ElementShape::kPolygon, Simplex{0, 1}, "a polygon", 4) ==
        "a polygon of 3 vertices or more");
  CHECK(!add_element(file, ElementShape::kCurved, Simplex{0, 1, 2}, "an edge of second order", 5));
  CHECK(check_simplices(file, "f").error().to_string() ==
        "f:5: expected edges, triangles and tetrahedra, found an edge of second order");
  file.points.dimension = 3;
  file.points.points = std::vector<Point>(5, {0, 0, 0});
  CHECK(domain_of(file, "f").error().to_string() ==
        "f:5: expected elements of first order, found an edge of second order");
}

// Gmsh's .msh: what is skipped, what is refused, and the messages. The forms of the same mesh are
// in the first part of this file.

namespace {

Result<ElementFile> gmsh(const std::string& text) {
  return read_gmsh({"f", text}, NumberReading::kDouble);
}

const std::string kHeader2 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
const std::string kHeader4 = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
const std::string kNodes2 = "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n";
const std::string kNodes4 =
    "$Nodes\n1 4 1 4\n3 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n$EndNodes\n";

std::string elements_2(const std::string& lines, int count = 1) {
  return kHeader2 + kNodes2 + "$Elements\n" + std::to_string(count) + "\n" + lines +
         "$EndElements\n";
}

}  // namespace

TEST_CASE("gmsh: comments in front, sections that are read over, elements of points") {
  const auto file = gmsh(
      "$Comments\n$Nodes\nwhatever\n$EndComments\n" + kHeader2 +
      "$PhysicalNames\n1\n3 1 \"$EndPhysicalNames is no end here\"\n$EndPhysicalNames\n" + kNodes2 +
      "$Elements\n4\n1 15 2 0 1 1\n2 1 2 0 1 1 2\n3 2 0 1 2 3\n4 4 3 0 1 5 1 2 3 4\n"
      "$EndElements\n$NodeData\n1\n\"a\"\n$EndNodeData\n");
  REQUIRE_MESSAGE(file, error_of(file));
  CHECK(file->points.first_index == 1);
  CHECK(file->edges.simplices == std::vector<Simplex>{{1, 2}});
  CHECK(file->triangles.simplices == std::vector<Simplex>{{1, 2, 3}});
  CHECK(file->tetrahedra.simplices == std::vector<Simplex>{{1, 2, 3, 4}});
  CHECK(file->tetrahedra.lines == std::vector<std::size_t>{24});
}

TEST_CASE("gmsh in binary: what is read over may end without a line end, names as in text") {
  const std::string names =
      "$PhysicalNames\n1\n3 1 \"$EndPhysicalNames is no end here\"\n$EndPhysicalNames\n";
  for (const WrittenForm& form : all_forms(kTwoTetrahedra)) {
    if (form.extension != ".msh" || !has_part(form.name, "endian")) continue;
    CAPTURE(form.name);
    WrittenForm other = form;
    const std::size_t nodes = form.text.find("$Nodes\n");
    REQUIRE(nodes != std::string::npos);
    other.text.insert(nodes, names + "$NodeData\n1\n\"a\"\n\x01\x02$EndNodeData");
    CHECK_MESSAGE(difference(other, kTwoTetrahedra) == "", difference(other, kTwoTetrahedra));
    for (const std::string end : {"\n$EndNodes", "\n$EndElements"}) {
      other.text.erase(other.text.find(end), 1);
    }
    CHECK_MESSAGE(difference(other, kTwoTetrahedra) == "", difference(other, kTwoTetrahedra));
    other.text = form.text + "$NodeData\n\x01$EndNode";
    CHECK(has_part(error_of(read_form(other, kDouble)), "expected $EndNodeData behind $NodeData"));
  }
}

TEST_CASE("gmsh: a message shows the beginning alone of a section's long name") {
  const std::string name(3000, '\1');
  const std::string header = "$MeshFormat\n2.2 1 8\n" + std::string("\1\0\0\0", 4) + "\n";
  for (const std::string& text :
       {kHeader2 + "$" + name, header + "$EndMeshFormat\n$" + name + "\n\1$End" + name + "\n"}) {
    const std::string message = error_of(gmsh(text));
    CHECK(has_part(message, "$\\x01\\x01"));
    CHECK_MESSAGE(message.size() < 600, message);
  }
}

TEST_CASE("gmsh: lines outside the sections are skipped, as Gmsh skips them, with a note") {
  const std::string elements = "$Elements\n1\n1 1 0 1 2\n$EndElements";
  const auto behind = gmsh(kHeader2 + kNodes2 + elements + "\n\nShow \"*\"; $Nodes\r\nMore\n");
  REQUIRE_MESSAGE(behind, error_of(behind));
  CHECK(behind->notes == std::vector<std::string>{"f:16: lines outside the sections were skipped; "
                                                  "the first is \"Show \"*\"; $Nodes\""});
  const auto between = gmsh(kHeader2 + "x\n" + kNodes2 + elements + " y");
  REQUIRE_MESSAGE(between, error_of(between));
  CHECK(between->edges.simplices == std::vector<Simplex>{{1, 2}});
  CHECK(between->notes == std::vector<std::string>{
                              "f:4: lines outside the sections were skipped; the first is \"x\""});
  const auto binary = gmsh(gmsh_2(kTwoTetrahedra, ByteOrder::kLittleEndian) + "Show \"*\";\n");
  REQUIRE_MESSAGE(binary, error_of(binary));
  CHECK(binary->notes ==
        std::vector<std::string>{
            "f: lines outside the sections were skipped; the first is \"Show \"*\";\""});
}

TEST_CASE("gmsh: tags in a row are indices, in whatever order; gaps are noted") {
  const std::string elements = "$Elements\n1\n1 1 0 8 7\n$EndElements\n";
  const auto in_a_row = gmsh(kHeader2 + "$Nodes\n2\n8 1 0 0\n7 0 0 0\n$EndNodes\n" + elements);
  REQUIRE_MESSAGE(in_a_row, error_of(in_a_row));
  CHECK(in_a_row->points.first_index == 7);
  CHECK(in_a_row->points.points == std::vector<Point>{{0, 0, 0}, {1, 0, 0}});
  CHECK(in_a_row->edges.simplices == std::vector<Simplex>{{8, 7}});
  CHECK(in_a_row->notes.empty());
  const std::string with_gaps = "$Nodes\n3\n100 5 0 0\n8 1 0 0\n7 0 0 0\n$EndNodes\n";
  const auto gaps = gmsh(kHeader2 + with_gaps + elements);
  REQUIRE_MESSAGE(gaps, error_of(gaps));
  CHECK(gaps->points.first_index == 1);
  CHECK(gaps->points.points == std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {5, 0, 0}});
  CHECK(gaps->edges.simplices == std::vector<Simplex>{{2, 1}});
  CHECK(gaps->notes.size() == 1);
  CHECK(error_of(gmsh(kHeader2 + with_gaps + "$Elements\n1\n1 1 0 8 9\n$EndElements\n")) ==
        "f:12: expected the tag of a node in $Nodes, found 9");
  CHECK(error_of(gmsh(kHeader2 + "$Nodes\n2\n7 1 0 0\n7 0 0 0\n$EndNodes\n" + elements)) ==
        "f: expected a tag of its own for each node, found tag 7 twice");
  // A tag that no node has is a fault of the mesh if tags are indices.
  CHECK(gmsh(kHeader2 + "$Nodes\n1\n7 1 0 0\n$EndNodes\n" + elements));
}

TEST_CASE("gmsh: headers that are refused") {
  CHECK(error_of(gmsh("")) == "f:1: expected \"$MeshFormat\", found the end of the file");
  CHECK(error_of(gmsh("$MeshFormat\n3 0 8\n")) ==
        "f:2: expected version 2, 4.0 or 4.1 of the format (gmsh writes it with -format msh41), "
        "found \"3\"");
  CHECK(error_of(gmsh("$MeshFormat\n2.2 2 8\n")) ==
        "f:2: expected 0 (text) or 1 (binary), found \"2\"");
  CHECK(error_of(gmsh("$MeshFormat\n2.2 0 4\n")) ==
        "f:2: expected 8, the size of a number, found \"4\"");
  CHECK(error_of(gmsh("$MeshFormat\n2.2 1 8\n\2\1\1\1\n$EndMeshFormat\n")) ==
        "f:1: expected the number 1, in either byte order, found 16843010 at byte 20, in "
        "$MeshFormat");
  CHECK(error_of(gmsh("$MeshFormat\n2.2 1 8\n\1")) ==
        "f:1: expected the number 1, found the end of the data at byte 20, in $MeshFormat");
  CHECK(error_of(gmsh(kHeader2)) == "f:3: expected the section $Nodes, found the end of the file");
  CHECK(error_of(gmsh(kHeader2 + kNodes2)) ==
        "f:10: expected the section $Elements, found the end of the file");
  CHECK(error_of(gmsh(kHeader2 + kNodes2 + kNodes2)) ==
        "f:11: expected one section $Nodes, found \"$Nodes\"");
  CHECK(error_of(gmsh(kHeader2 + "Nodes")) ==
        "f:4: expected the section $Nodes, found the end of the file");
  CHECK(error_of(gmsh(kHeader2 + "Nodes\n1\n1 0 0 0\n$EndNodes\n")) ==
        "f:7: expected a section, as $Nodes, found \"$EndNodes\"");
  CHECK(error_of(gmsh(kHeader2 + "$Periodic\n1\n")) ==
        "f:4: expected $EndPeriodic behind $Periodic, found the end of the file");
}

TEST_CASE("gmsh 2: what is refused") {
  CHECK(error_of(gmsh(kHeader2 + "$Nodes\n99999999999\n1 0 0 0\n")) ==
        "f:6: expected node 2 of 99999999999, found the end of the file");
  CHECK(error_of(gmsh(kHeader2 + "$Nodes\n1\n1 0 0 nan\n")) ==
        "f:6: expected a coordinate of node 1 of 1, a finite number, found \"nan\"");
  CHECK(error_of(gmsh(kHeader2 + "$Nodes\n-1\n")) ==
        "f:5: expected the number of nodes, 0 or more, found -1");
  CHECK(error_of(gmsh(kHeader2 + "$Nodes\n1\n1 0 0 0\n2 0 0 0\n$EndNodes\n")) ==
        "f:7: expected \"$EndNodes\", found \"2\"");
  CHECK(error_of(gmsh(elements_2("1 1 -1 1 2\n"))) ==
        "f:13: expected the number of tags of element 1 of 1, 0 or more, found -1");
  CHECK(error_of(gmsh(elements_2("1 1 2 0 1 1 x\n"))) ==
        "f:13: expected a node of an edge, an integer, found \"x\"");
  for (const std::string type : {"-1", "0", "141", "9223372036854775807"}) {
    CHECK(error_of(gmsh(elements_2("1 " + type + " 2 0 1 1 2\n"))) ==
          "f:13: expected a type of elements from 1 to 140, found " + type);
  }
  for (const std::string type : {"32", "37", "92", "140"}) {
    CHECK(error_of(gmsh(elements_2("1 " + type + " 2 0 1 1 2\n"))) ==
          "f:13: expected edges, triangles and tetrahedra, found an element of Gmsh's type " +
              type);
  }
  std::string binary = gmsh_2(kTwoTetrahedra, ByteOrder::kLittleEndian);
  binary.replace(binary.find("$Elements\n5") + 10, 1, "1");
  const std::size_t block = binary.find("$Elements\n") + 12 + 4;
  CHECK(error_of(gmsh(binary.replace(block, 4, std::string("\2\0\0\0", 4))))
            .find("expected 1 elements, found 2 in blocks at byte ") != std::string::npos);
  CHECK(error_of(gmsh(elements_2("1 1 2 0 1 1 2\n", 2))) ==
        "f:14: expected element 2 of 2, an integer, found \"$EndElements\"");
  CHECK(error_of(gmsh(elements_2("1 1 2 0 1 1 2\n2 1 2 0 1 1 2\n"))) ==
        "f:14: expected \"$EndElements\", found \"2\"");
}

TEST_CASE("gmsh 4.0: physical groups, and boxes of points") {
  const auto file = gmsh(
      "$MeshFormat\n4 0 8\n$EndMeshFormat\n$Entities\n1 0 1 0\n1 0 0 0 0 0 0 1 9\n"
      "5 0 0 0 1 1 0 1 8 0\n$EndEntities\n$Nodes\n1 3\n5 2 0 3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n"
      "$EndNodes\n$Elements\n1 1\n5 2 2 1\n1 1 2 3\n$EndElements\n");
  REQUIRE_MESSAGE(file, error_of(file));
  CHECK(file->triangles.simplices == std::vector<Simplex>{{1, 2, 3}});
  CHECK(file->triangles.labels == std::vector<Vertex>{8});
}

TEST_CASE("gmsh 4.1: what is refused") {
  CHECK(error_of(gmsh(kHeader4 + "$Nodes\n1 2 1 2\n0 1 0 1\n1\n0 0 0\n$EndNodes\n")) ==
        "f:8: expected 2 nodes in all blocks, found 1");
  CHECK(error_of(gmsh(kHeader4 + "$Nodes\n1 1 1 1\n4 1 0 1\n")) ==
        "f:6: expected the dimension of an entity, 3 at most, found 4");
  CHECK(error_of(gmsh(kHeader4 + "$Nodes\n1 999999999999 1 1\n0 1 0 999999999999\n1\n")) ==
        "f:7: expected node 2 of 999999999999, found the end of the file");
  CHECK(error_of(
            gmsh(kHeader4 + kNodes4 + "$Elements\n1 3 1 3\n3 1 4 1\n1 1 2 3 4\n$EndElements\n")) ==
        "f:19: expected 3 elements in all blocks, found 1");
  const std::string whole = gmsh_4(kTwoTetrahedra, ByteOrder::kLittleEndian);
  const std::size_t bounds = whole.find("$Entities\n") + 10 + 32 + 4;
  CHECK(error_of(gmsh(whole.substr(0, bounds + 23))) ==
        "f:9: expected a bound of an entity, found the end of the data at byte " +
            std::to_string(bounds) + ", in $Entities");
  // In binary files, too, a count cannot be trusted.
  std::string binary = gmsh_4({{{0, 0, 0}}, {}}, ByteOrder::kLittleEndian);
  const std::size_t count = binary.rfind("$Nodes") + 7 + 32 + 12 + 32;
  CHECK(error_of(gmsh(binary)) == "no error");
  const std::size_t block = binary.rfind("$Nodes\n") + 7 + 32 + 12;
  REQUIRE(count > block);
  binary.replace(block, 8, std::string(7, '\xff') + "\x7f");
  CHECK(error_of(gmsh(binary)).ends_with(", in $Nodes"));
}

TEST_CASE("gmsh: elements of second order and other shapes") {
  const auto curved = gmsh(elements_2("1 8 2 0 1 1 2 3\n"));
  REQUIRE_MESSAGE(curved, error_of(curved));
  CHECK(curved->edges.simplices == std::vector<Simplex>{{1, 2}});
  const auto quadrilateral = gmsh(elements_2("1 3 2 0 1 1 2 3 4\n"));
  REQUIRE_MESSAGE(quadrilateral, error_of(quadrilateral));
  CHECK(check_simplices(*quadrilateral, "f").error().found == "a quadrilateral");
  const auto domain = domain_of(*quadrilateral, "f");
  REQUIRE(domain);
  CHECK(domain->input.polygons.size() == 1);
}

// .tet: inner and outer tetrahedra, exact coordinates, what is refused. The binary form is in
// the first part of this file.

namespace {

Result<ElementFile> tet(const std::string& text) {
  return read_tet({"f", text}, NumberReading::kDouble);
}

const std::string kFourPoints = "0 0 0\n1 0 0\n0 2/3 0\n0 0 0.1\n";

}  // namespace

TEST_CASE("tet: outer tetrahedra are left out, and that is noted") {
  const auto file = tet("4 vertices\n1 inner tets\n2 outer tets\n" + kFourPoints +
                        "4 0 1 2 3\n4 0 1 2 3\n4 3 2 1 0\n");
  REQUIRE_MESSAGE(file, error_of(file));
  CHECK(file->points.points ==
        std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, Rational(2, 3), 0}, {0, 0, exact_value(0.1)}});
  CHECK(file->tetrahedra.simplices == std::vector<Simplex>{{0, 1, 2, 3}});
  CHECK(file->tetrahedra.lines == std::vector<std::size_t>{8});
  CHECK(file->notes == std::vector<std::string>{"f: 2 outer tetrahedra were left out"});
}

TEST_CASE("tet: what is refused") {
  const std::string header = "4 vertices\n1 tets\n";
  CHECK(error_of(tet("")) == "f:1: expected the number of vertices, found the end of the file");
  CHECK(error_of(tet("4 points\n")) == "f:1: expected \"vertices\", found \"points\"");
  CHECK(error_of(tet("4 vertices\n1 cells\n")) ==
        "f:2: expected \"tets\" or \"inner tets\", found \"cells\"");
  CHECK(error_of(tet("4 vertices\n1 inner tets\n1 tets\n")) ==
        "f:3: expected \"outer\", found \"tets\"");
  CHECK(error_of(tet(header + kFourPoints)) ==
        "f:6: expected the number of vertices of tetrahedron 1 of 1, found the end of the file");
  CHECK(error_of(tet(header + kFourPoints + "3 0 1 2\n")) ==
        "f:7: expected 4, the number of vertices of tetrahedron 1 of 1, found \"3\"");
  CHECK(error_of(tet(header + kFourPoints + "4 0 1 2 3\n4 0 1 2 3\n")) ==
        "f:8: expected the end of the file after the last tetrahedron, found \"4\"");
  CHECK(error_of(tet("999999999999 vertices\n1 tets\n0 0 0\n")) ==
        "f:3: expected a coordinate of vertex 2 of 999999999999, found the end of the file");
  const std::string zeros(4 * 24 + 15, '\0');
  CHECK(error_of(tet(header + zeros)) ==
        "f: expected a vertex of tetrahedron 1 of 1, found the end of the data at byte 126");
  CHECK(error_of(tet(header + zeros + std::string(3, '\0'))) ==
        "f: expected the end of the file after the last tetrahedron, found 2 more bytes at byte "
        "126");
}

TEST_CASE(
    "the surface of tetrahedra is seen counterclockwise from outside, and each facet that two have "
    "is within") {
  ElementFile file;
  file.points.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}};
  file.tetrahedra.simplices = {{0, 2, 1, 3}, {0, 1, 2, 4}};  // both are positively oriented
  std::vector<Simplex> surface = surface_of(file);
  for (Simplex& facet : surface) {
    std::rotate(facet.begin(), std::min_element(facet.begin(), facet.end()), facet.end());
  }
  std::sort(surface.begin(), surface.end());
  CHECK(surface ==
        std::vector<Simplex>{{0, 1, 3}, {0, 2, 4}, {0, 3, 2}, {0, 4, 1}, {1, 2, 3}, {1, 4, 2}});
  // In OBJ, planar points have a third coordinate.
  ElementFile plane;
  plane.points.points = {{1, 2}};
  std::ostringstream out;
  write_obj(out, plane);
  CHECK(out.str() == "v 1 2 0\n");
}

}  // namespace circumspect::formats
