// Files of engineers' programs, SU2, Abaqus and AVS: what is read, what is refused, and the
// messages.
#include <doctest/doctest.h>

#include "inputs/scratch_folder_test.hpp"
#include "oracle/formats/abaqus.hpp"
#include "oracle/formats/format.hpp"
#include "oracle/formats/mesh_files.hpp"
#include "oracle/formats/reading_test.hpp"
#include "oracle/formats/su2.hpp"
#include "oracle/formats/ucd.hpp"

namespace circumspect::formats {
namespace {

std::string su2_error(const std::string& text) { return error_of(read_su2(named(text), kDouble)); }

std::string abaqus_error(const std::string& text) {
  return error_of(read_abaqus(named(text), kDouble));
}

const std::string kSu2 =
    "% made by hand\n"
    "NDIME= 3\n"
    "NELEM= 2\n"
    "10 0 1 2 3 0\n"
    "10 1 2 3 4 1\n"
    "NPOIN= 5\n"
    "0 0 0 0\n1 0 0 1\n0 1 0 2\n0 0 0.1 3\n1 1 1 4\n"
    "NMARK= 1\nMARKER_TAG= wall\nMARKER_ELEMS= 1\n5 0 1 2\n";

const std::string kAbaqus =
    "** made by hand\n"
    "*HEADING\n a title, with a comma\n"
    "*NODE, NSET=Nall\n10, 0., 0.\n11, 1., , 0.\n12, 0, 1, 0\n14, 0., 0., 0.1\n"
    "*Element, Type=c3d4, elset=E\n1, 10, 11,\n 12, 14\n"
    "*Element, type=S3R\n2, 10, 11, 12\n"
    "*Nset, nset=fixed\n10, 11\n*Node output\nU\n";

}  // namespace

TEST_CASE("su2: elements, points with and without their index, markers, comments") {
  const auto file = read_su2(named(kSu2), kDouble);
  REQUIRE(file);
  CHECK(file->points.points[3] == Point{0, 0, exact_value(0.1)});
  CHECK(file->points.points.size() == 5);
  CHECK(file->tetrahedra.simplices == std::vector<Simplex>{{0, 1, 2, 3}, {1, 2, 3, 4}});
  CHECK(file->triangles.simplices == std::vector<Simplex>{{0, 1, 2}});
  CHECK(file->tetrahedra.lines == std::vector<std::size_t>{4, 5});
}

TEST_CASE("su2: in the plane, with settings that are skipped") {
  const auto file = read_su2(named("NDIME=2\nNPERIODIC= 1\nPERIODIC_INDEX= 0\n1 2 3\nNELEM = 1\n"
                                   "5 0 1 2\nNPOIN=3 3\n0 0\n1 0\n0 1/3\n"),
                             kDouble);
  REQUIRE(file);
  CHECK(file->points.points[2] == Point{0, Rational(1, 3)});
  CHECK(is_su2("NDIME=2"));
  CHECK(is_su2("%\n% Problem dimension\n%\n  NDIME= 2\n"));
  CHECK(is_su2("% two of them\nNZONE= 2\n"));
  CHECK(!is_su2("% NDIME= 2\n"));
  CHECK(!is_su2("% a comment\nNDEF= 2\n"));
  CHECK(!is_su2(""));
}

TEST_CASE("su2: markers of periodic boundaries list vertices that are sent") {
  const std::string sent = "MARKER_TAG= SEND_RECEIVE\nMARKER_ELEMS= 2\nSEND_TO= -1\n1 0 1\n";
  const std::string plane = "NDIME=2\nNELEM= 1\n5 0 1 2\nNPOIN= 3\n0 0\n1 0\n0 1\nNMARK= 1\n";
  const auto file = read_su2(named(plane + sent + "1 2 1\n"), kDouble);
  REQUIRE(file);
  CHECK(file->triangles.simplices == std::vector<Simplex>{{0, 1, 2}});
  CHECK(su2_error(plane + sent) ==
        "f:12: expected element of a marker 2 of 2, found the end of the file");
  CHECK(su2_error(plane + sent + "SEND_TO= 1\n1 2 1\n") ==
        "f:13: expected the type of an element of a marker, an integer, found \"SEND_TO=\"");
}

TEST_CASE("su2: zones are one mesh, each with indices of its own") {
  const std::string zone = "NDIME= 2\nNELEM= 1\n5 0 1 2\nNPOIN= 3\n0 0\n1 0\n0 1\n";
  const auto file = read_su2(
      named("NZONE= 2\nIZONE= 1\n" + zone + "NMARK= 1\nMARKER_ELEMS= 1\n3 0 1\nIZONE= 2\n" + zone),
      kDouble);
  REQUIRE_MESSAGE(file, error_of(file));
  CHECK(file->points.points.size() == 6);
  CHECK(file->triangles.simplices == std::vector<Simplex>{{0, 1, 2}, {3, 4, 5}});
  CHECK(file->triangles.labels == std::vector<Vertex>{1, 2});
  CHECK(file->edges.simplices == std::vector<Simplex>{{0, 1}});
  CHECK(file->notes.size() == 1);
  const auto one = read_su2(named("NZONE= 1\nIZONE= 1\n" + zone), kDouble);
  REQUIRE_MESSAGE(one, error_of(one));
  CHECK(one->notes.empty());
}

TEST_CASE("su2: faults and their lines") {
  // Lines below a key that is skipped are skipped, but not those behind the next list.
  const std::string skipped = "NDIME= 2\nFOO= 1\n3 4\nNPOIN= 1\n0 0\n";
  CHECK(su2_error(skipped + "3 4\n") == "f:6: expected a key, as NDIME= 3, found \"3\"");
  CHECK(su2_error("") == "f:1: expected the key NPOIN, found the end of the file");
  CHECK(su2_error("x\n") == "f:1: expected a key, as NDIME= 3, found \"x\"");
  CHECK(su2_error("NDIME= 4\n") == "f:1: expected dimension 2 or 3, found \"4\"");
  CHECK(su2_error("NPOIN= 1\n0 0\n") == "f:1: expected NDIME before NPOIN, found NPOIN");
  CHECK(su2_error("NDIME= 2\nNPOIN=\n") ==
        "f:2: expected the number of points, 0 or more, found the end of the line");
  CHECK(su2_error("NDIME= 2\nNPOIN= 2\n0 0\n") ==
        "f:3: expected the coordinates of point 2 of 2, found the end of the file");
  CHECK(su2_error("NDIME= 2\nNPOIN= 1\n0 0 0 0 0\n") ==
        "f:3: expected 2 coordinates and perhaps the index of point 1 of 1, found 5 columns");
  CHECK(su2_error("NDIME= 2\nNPOIN= 1\n0 0 0 .5\n") ==
        "f:3: expected the index of point 1 of 1, an integer, found \".5\"");
  CHECK(su2_error("NDIME= 2\nNPOIN= 1\n0 0 x\n") ==
        "f:3: expected the index of point 1 of 1, an integer, found \"x\"");
  CHECK(
      su2_error("NELEM= 1\n22 0 1 2 3 4 5\n") ==
      "f:2: expected a type of elements that SU2 knows (3, 5, 9, 10, 12, 13 or 14), found \"22\"");
  CHECK(su2_error("NELEM= 1\n10 0 1 2\n") ==
        "f:2: expected type 10, 4 vertices and perhaps an index, found 4 columns");
  CHECK(su2_error("NELEM= 1\n") == "f:1: expected element 1 of 1, found the end of the file");
  // An index and one vertex too few look like all vertices and no index.
  CHECK(su2_error("NELEM= 2\n5 0 1 2 0\n5 0 1 2\n") ==
        "f:3: expected 5 columns of an element of type 5, by those of the first in its list, found "
        "4");
  CHECK(su2_error("NDIME= 2\nNPOIN= 2\n0 0\n1 0 0\n") ==
        "f:4: expected 2 columns of point 2 of 2, by those of the first in its list, found 3");
  CHECK(su2_error("NZONE= 0\n") == "f:1: expected 1 zone or more, found 0");
  CHECK(su2_error("NZONE= 2\nIZONE= 2\n") == "f:2: expected zone 1 of 2, found \"2\"");
  CHECK(su2_error("NZONE= 1\nIZONE= 1\nIZONE= 2\n") == "f:3: expected zone 2 of 1, found \"2\"");
  CHECK(su2_error("NZONE= 2\nIZONE= 1\nNDIME= 2\nIZONE= 2\n")
            .ends_with("expected the key NPOIN, found \"IZONE=\""));
  CHECK(su2_error("NZONE= 2\nIZONE= 1\nNDIME= 2\nNPOIN= 0\nNELEM= 0\n") ==
        "f:5: expected zone 2 of 2, found the end of the file");
  CHECK(su2_error("NZONE= 2\nIZONE= 1\nNDIME= 2\nNPOIN= 0\nNELEM= 0\nIZONE= 2\nNDIME= 3\n") ==
        "f:7: expected dimension 2, as in zone 1, found \"3\"");
  CHECK(su2_error("NDIME= 2\nNPOIN= 0\n") ==
        "f:2: expected the key NELEM, found the end of the file");
}

TEST_CASE("abaqus: nodes by their tags, continued lines, empty fields, what is skipped") {
  const auto file = read_abaqus(named(kAbaqus), kDouble);
  REQUIRE(file);
  CHECK(file->points.points ==
        std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, exact_value(0.1)}});
  CHECK(file->points.first_index == 1);
  CHECK(file->notes.size() == 1);  // the tags leave a gap
  CHECK(file->tetrahedra.simplices == std::vector<Simplex>{{1, 2, 3, 4}});
  CHECK(file->triangles.simplices == std::vector<Simplex>{{1, 2, 3}});
  CHECK(file->tetrahedra.lines == std::vector<std::size_t>{10});
  CHECK(is_abaqus(Beginning(named(kAbaqus))));
  CHECK(!is_abaqus(Beginning(named("** comments alone\n"))));
  CHECK(!is_abaqus(Beginning(named("* 1 2\n"))));
  CHECK(!is_abaqus(Beginning(named("*"))));
  const ScratchFolder folder;
  CHECK(read_mesh({.mesh = folder.write("x.msh",
                                        "*NODE\n1, 0, 0\n2, 1, 0\n3, 0, 1\n*Element, "
                                        "type=CPS3\n1, 1, 2, 3\n")}));
}

TEST_CASE("abaqus: what only joins nodes is not an element, and the middle of an edge is between") {
  const std::string nodes = "*Node\n1\n2, 2\n3, 1\n";
  const auto beam = read_abaqus(named(nodes + "*Element, type=B32R\n1, 1, 3, 2\n"
                                              "*Element, type=SpringA\n2, 1, 2\n"
                                              "*Element, type=D\n3, 0, 2, 0\n"
                                              "*Element, type=DCOUP3D\n4, 1\n"),
                                kDouble);
  REQUIRE_MESSAGE(beam, error_of(beam));
  CHECK(beam->points.points == std::vector<Point>{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}});
  CHECK(beam->edges.simplices == std::vector<Simplex>{{1, 2}});
  CHECK(beam->curved.simplices == std::vector<Simplex>{{1, 2, 3}});
  for (const auto& [type, expected] : {std::pair{"F3D6, elset=a", "a prism"},
                                       {"F3D8R", "a hexahedron"},
                                       {"COH3D6", "a prism"},
                                       {"CAX8R", "a quadrilateral of second order"},
                                       {"S9R", "a quadrilateral of second order"},
                                       {"AC2D4", "a quadrilateral"},
                                       {"EC3D8RT", "a hexahedron"}}) {
    const std::string elements = std::string("*Element, type=") + type + "\n1";
    std::string list;
    for (std::size_t i = 0; i < 20; ++i) {
      list += ", 1";
      const auto file = read_abaqus(named(nodes + elements + list + "\n"), kDouble);
      if (file) CHECK(check_simplices(*file, "f").error().found == expected);
    }
  }
  CHECK(abaqus_error(nodes + "*Element, type=F3D4\n1, 1, 2, 3, 1\n") ==
        "f:5: expected a type of elements that is known, as TYPE=C3D4, found \"F3D4\"");
}

TEST_CASE("abaqus: elements that are not simplices are named with their line") {
  const auto curved =
      read_abaqus(named("*Node\n1,0,0,0\n*Element, type=CPS8R\n1, 1,1,1,1,1,1,1,1\n"), kDouble);
  REQUIRE(curved);
  CHECK(check_simplices(*curved, "f").error().to_string() ==
        "f:4: expected edges, triangles and tetrahedra, found a quadrilateral of second order");
  const auto corners = read_abaqus(
      named("*Node\n1,0,0,0\n*Element, type=C3D10M\n1, 1,2,3,4,5,6,7,8,9,10\n"), kDouble);
  REQUIRE(corners);
  CHECK(corners->tetrahedra.simplices == std::vector<Simplex>{{1, 2, 3, 4}});
  CHECK(corners->curved.simplices.size() == 1);
  const auto solid =
      read_abaqus(named("*Node\n1,0,0,0\n*Element, type=C3D8R\n1, 1,1,1,1,1,1,1,1\n"), kDouble);
  REQUIRE(solid);
  CHECK(check_simplices(*solid, "f").error().found == "a hexahedron");
}

TEST_CASE("abaqus: faults and their lines") {
  CHECK(abaqus_error("") == "f:1: expected a keyword, as *Node, found the end of the file");
  CHECK(abaqus_error("1, 0, 0, 0\n") == "f:1: expected a keyword, as *Node, found \"1, 0, 0, 0\"");
  CHECK(abaqus_error("*Node\n1, 0, 0, 0\n") ==
        "f:2: expected the keyword *Element, found the end of the file");
  CHECK(abaqus_error("*Element, type=C3D4\n1, 1, 2, 3, 4\n") ==
        "f:2: expected the keyword *Node, found the end of the file");
  CHECK(abaqus_error("*Node\nx, 0, 0, 0\n") ==
        "f:2: expected the tag of a node, an integer of 64 bits, found \"x\"");
  CHECK(abaqus_error("*Node\n1, 0, y, 0\n") == "f:2: expected a finite number, found \"y\"");
  CHECK(abaqus_error("*Node\n1 0 0 0\n") ==
        "f:2: expected the tag of a node, an integer of 64 bits, found \"1 0 0 0\"");
  CHECK(abaqus_error("*Node, system=C\n1, 0, 0, 0\n") ==
        "f:1: expected rectangular coordinates, SYSTEM=R, found \"C\"");
  CHECK(abaqus_error("*Element, type=XYZ\n1, 1\n") ==
        "f:1: expected a type of elements that is known, as TYPE=C3D4, found \"XYZ\"");
  CHECK(abaqus_error("*Element\n1, 1\n") ==
        "f:1: expected a type of elements that is known, as TYPE=C3D4, found none");
  CHECK(abaqus_error("*Element, type=C3D4\n1, 1, 2, 3\n") ==
        "f:2: expected a tetrahedron of 4 nodes, found 3");
  // Without a comma at its end, a line takes nothing from the next one.
  CHECK(abaqus_error("*Node\n1, 0\n2, 1\n*Element, type=T3D2\n1, 1\n2\n") ==
        "f:5: expected an edge of 2 nodes, found 1");
  CHECK(abaqus_error("*Element, type=C3D4\n1, 1, 2, 3, 4, 5\n") ==
        "f:2: expected a tetrahedron of 4 nodes, found 5");
  CHECK(abaqus_error("*Part, name=a\n*Part, name=b\n") ==
        "f:2: expected a mesh of one part, found another *Part");
  CHECK(abaqus_error("*Instance, name=a, part=a\n1., 0., 0.\n") ==
        "f:2: expected a part where its nodes say, found an instance that moves it");
  CHECK(abaqus_error("*Node\n1, 0, 0, 0\n1, 1, 0, 0\n*Element, type=MASS\n1, 1\n") ==
        "f: expected a tag of its own for each node, found tag 1 twice");
  CHECK(abaqus_error("*Node\n1, 0, 0, 0\n3, 1, 0, 0\n*Element, type=T3D2\n1, 1, 2\n") ==
        "f:5: expected the tag of a node below *Node, found 2");
}

TEST_CASE("abaqus: what would make the mesh another one than is listed is refused") {
  const std::string nodes = "*Node\n1, 0, 0, 0\n2, 1, 0, 0\n",
                    edge = "*Element, type=T3D2\n1, 1, 2\n";
  CHECK(abaqus_error(nodes + edge) == "no error");
  for (const char* const line :
       {"*Include, input=x.inp", "*Ngen", "*Nfill", "*Ncopy", "*Elgen", "*Elcopy", "*System",
        "*Transform nodes", "*Node, input=x.inp", "*Element, type=T3D2, input=x.inp",
        "*Node, system=S", "*Element, type=C3D45", "*Element, type=S33",
        "*Part, name=a\n*Part, name=b",
        "*Instance, name=a, part=a\n*End instance\n*Instance, name=b, part=a"}) {
    CAPTURE(line);
    CHECK(abaqus_error(nodes + edge + line + "\n") != "no error");
  }
  CHECK(abaqus_error("*Node\n1, 0, 0, 0, 1, 0, 0\n2, 1, 0, 0\n" + edge) == "no error");
  CHECK(abaqus_error("*Node\n1, 0, 0, 0, 1, 0, 0, 0\n2, 1, 0, 0\n" + edge) ==
        "f:2: expected a tag and 3 coordinates of a node, found 8 fields");
  // A comma behind the last node goes on to no further line.
  CHECK(abaqus_error(nodes + "*Element, type=T3D2\n1, 1, 2,\n2, 2, 1\n") == "no error");
}

TEST_CASE("su2: what is there twice is refused") {
  const std::string once = "NDIME= 2\nNPOIN= 2\n0 0\n1 0\nNELEM= 1\n3 0 1\n";
  CHECK(su2_error(once) == "no error");
  for (const char* const again :
       {"NDIME= 2\n", "NPOIN= 1\n0 0\n", "NELEM= 1\n3 1 0\n", "NZONE= 2\n"}) {
    CAPTURE(again);
    CHECK(su2_error(once + again) != "no error");
  }
  CHECK(su2_error("NZONE= 1\n" + once) == "no error");
  CHECK(su2_error("NDIME= 2\nNPOIN= 1\n0 0\nNELEM= 1\n3 0 1 7 8\n") ==
        "f:5: expected type 3, 2 vertices and perhaps an index, found 5 columns");
}

TEST_CASE("ucd: nodes by their tags, cells with their materials; data is not read") {
  const std::string text =
      "# a comment\n4 3 1 0 0\n7 0 0 0\n8 1 0 0\n9 0 1 0\n11 0 0 .1\n1 5 tet 7 8 9 11\n2 6 tri 7 8 "
      "9\n"
      "3 6 PT 7\n1 1\nstress, MPa\n7 0\n8 red\n";
  const auto file = read_ucd(named(text), kDouble);
  REQUIRE_MESSAGE(file, error_of(file));
  CHECK(file->points.points[3] == Point{0, 0, exact_value(0.1)});
  CHECK(file->tetrahedra.simplices == std::vector<Simplex>{{1, 2, 3, 4}});
  CHECK(file->tetrahedra.labels == std::vector<Vertex>{5});
  CHECK(file->triangles.simplices == std::vector<Simplex>{{1, 2, 3}});
  CHECK(file->tetrahedra.lines == std::vector<std::size_t>{7});
  CHECK(file->notes.size() == 1);  // the tags leave a gap
  CHECK(is_ucd(Beginning(named(text))));
  CHECK(!is_ucd(Beginning(named("4 2 0 0\n"))));
  CHECK(!is_ucd(Beginning(named("*Heading\n"))));
  CHECK((format_of(".inp", named(text))->elements == read_ucd));
  CHECK((format_of(".ucd", named(text))->elements == read_ucd));
  CHECK((format_of(".inp", named("*Heading\n"))->elements == read_abaqus));
}

TEST_CASE("ucd: faults and their lines") {
  const auto error = [](const char* text) { return error_of(read_ucd(named(text), kDouble)); };
  CHECK(error("") ==
        "f:1: expected the numbers of nodes, cells and data, found the end of the file");
  CHECK(error("1 0 0\n") ==
        "f:1: expected 5 numbers: of nodes, cells and data of 3 kinds, found 3");
  CHECK(error("1 0 0 0 0\n") == "f:1: expected node 1 of 1, found the end of the file");
  CHECK(error("1 0 0 0 0\n1 0 0\n") == "f:2: expected 4 columns of node 1 of 1, found 3");
  CHECK(error("1 1 0 0 0\n1 0 0 0\n1 0\n") ==
        "f:3: expected an index, a material and the type of cell 1 of 1, found 2 columns");
  CHECK(error("1 1 0 0 0\n1 0 0 0\n1 0 cube 1\n") ==
        "f:3: expected pt, line, tri, quad, tet, pyr, prism or hex, found \"cube\"");
  CHECK(error("1 1 0 0 0\n1 0 0 0\n1 0 tri 1 1\n") ==
        "f:3: expected 3 vertices, or 6 of second order, found 2");
  CHECK(error("1 0 0 0 0\n1 0 0 0\n1 0 pt 1\n") ==
        "f:3: expected the end of the file, since no data is announced, found \"1\"");
  CHECK(error("1 0 1 0 0\n1 0 0 0\n1 0 pt 1\n") ==
        "f:3: expected the sizes of 1 components of data, found 3");
  CHECK(error("2 0 0 0 0\n1 0 0 0\n1 0 0 0\n") ==
        "f: expected a tag of its own for each node, found tag 1 twice");
}

}  // namespace circumspect::formats
