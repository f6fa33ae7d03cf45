// Nastran's bulk data: the three ways to write fields, what is read, what is refused, the messages.
#include "oracle/formats/nastran.hpp"

#include <doctest/doctest.h>

#include "oracle/formats/format.hpp"
#include "oracle/formats/reading_test.hpp"

namespace circumspect::formats {
namespace {

Result<ElementFile> nastran(const std::string& text) { return read_nastran(named(text), kDouble); }
std::string nastran_error(const std::string& text) { return error_of(nastran(text)); }

const std::vector<Point> kFourGrids = {
    {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, exact_value(0.0015)}};

}  // namespace

TEST_CASE("nastran: small, large and free fields are one mesh") {
  const std::string small =
      "SOL 101\nCEND\nTITLE = a, b\nBEGIN BULK\n"
      "$ a comment, with commas\n"
      "GRID           1              0.      0.      0.       0\n"
      "GRID           2       0      1.\n"
      "GRID           3                      1.     $ behind it\n"
      "GRID           4                           1.5-3\n"
      "PSOLID         7       1\n"
      "CTETRA         9       7       1       2       3       4\n"
      "CTRIA3        10       8       1       2       3\n"
      "ENDDATA\nGRID,5,,0.,0.,0.\n";
  const std::string large =
      "begin bulk\n"
      "GRID*                  1                              0.              0.*G1\n"
      "*G1                   0.               0\n"
      "GRID*                  2                              1.\n"
      "GRID*                  3                                              1.+\n"
      "GRID*                  4\n"
      "*                 1.5D-3\n"
      "CTETRA*                9               7               1               2\n"
      "*                      3               4\n"
      "CTRIA3*               10               8               1               2\n"
      "*                      3\n";
  const std::string free =
      "GRID,1,,0.,0.,0.\ngrid , 2 , 0 , 1.0E0\r\nGRID,3,,,1.,\nGRID*,4,,,,*G\n*G,+15.-4\n"
      "CTETRA,9,7,1,2,3,4,+\nCTRIA3,10,8,1,+C1\n+C1,,,,\n";
  const std::string tabs =
      "GRID\t1\t\t0.\t0.\t0.\nGRID\t2\t\t1.\nGRID\t3\t\t\t1.\nGRID\t4\t\t\t\t.0015\n"
      "CTETRA\t9\t7\t1\t2\t3\t4\nCTRIA3\t10\t8\t1\t2\t3\n";
  for (const std::string& text : {small, large, tabs}) {
    CAPTURE(text);
    const auto file = nastran(text);
    REQUIRE_MESSAGE(file, error_of(file));
    CHECK(file->points.points == kFourGrids);
    CHECK(file->points.first_index == 1);
    CHECK(file->tetrahedra.simplices == std::vector<Simplex>{{1, 2, 3, 4}});
    CHECK(file->tetrahedra.labels == std::vector<Vertex>{7});
    CHECK(file->triangles.simplices == std::vector<Simplex>{{1, 2, 3}});
    CHECK(file->triangles.labels == std::vector<Vertex>{8});
  }
  CHECK(nastran_error(free) == "f:7: expected a triangle of 3 nodes, found an empty field");
  const auto file = nastran(free.substr(0, free.find("CTRIA3")));
  REQUIRE_MESSAGE(file, error_of(file));
  CHECK(file->points.points == kFourGrids);
  CHECK(file->tetrahedra.simplices == std::vector<Simplex>{{1, 2, 3, 4}});
  CHECK(nastran(small)->tetrahedra.lines == std::vector<std::size_t>{11});
}

TEST_CASE("nastran: entries go on over lines, and nodes between corners make them curved") {
  const std::string grids = "GRID,1\nGRID,2\nGRID,3\nGRID,4\nGRID,5\nGRID,6\nGRID,7\n";
  const auto file =
      nastran(grids +
              "CTETRA         1      11       1       2       3       4       5       0+\n"
              "+                                      7\n"
              "CTRIA6,2,,1,2,3,,,6\nCBAR,3,12,1,2,0.,0.,1.\nCONROD,4,5,6,9\n"
              "CORD2R,1,0,0.,0.,0.,0.,0.,1.\n,1.,0.,0.\n");
  REQUIRE_MESSAGE(file, error_of(file));
  CHECK(file->curved.simplices == std::vector<Simplex>{{1, 2, 3, 4, 5, 7}, {1, 2, 3, 6}});
  CHECK(file->corners_of_curved == std::vector<std::size_t>{4, 3});
  CHECK(file->tetrahedra.labels == std::vector<Vertex>{11});
  CHECK(file->triangles.labels == std::vector<Vertex>{2});  // the element's own tag
  CHECK(file->edges.simplices == std::vector<Simplex>{{1, 2}, {5, 6}});
  const auto solid = nastran(grids + "CHEXA,1,1,1,2,3,4,5,6\n+,7,1\n");
  REQUIRE_MESSAGE(solid, error_of(solid));
  CHECK(check_simplices(*solid, "f").error().to_string() ==
        "f:8: expected edges, triangles and tetrahedra, found a hexahedron");
}

TEST_CASE("nastran: numbers without an E") {
  const auto at = [](const std::string& number) {
    const auto file = nastran("GRID,1,," + number + "\nCBAR,1,1,1,1\n");
    return file ? file->points.points[0][0] : Rational(-99);
  };
  CHECK(at("7.-1") == exact_value(0.7));
  CHECK(at("-7.0+1") == -70);
  CHECK(at("+.7E1") == 7);
  CHECK(at("7.e+1") == 70);
  CHECK(at("7.D-1") == exact_value(0.7));
  CHECK(at("7") == 7);
  CHECK(at("-1") == -1);
}

TEST_CASE("nastran: faults and their lines") {
  const std::string grid = "GRID,1,,0.,0.,0.\n";
  CHECK(nastran_error("") == "f:1: expected an entry GRID, found the end of the file");
  CHECK(nastran_error(grid) ==
        "f:1: expected an entry of elements, as CTETRA, found the end of the file");
  CHECK(nastran_error("$\nGRID,x\n") ==
        "f:2: expected the tag of a node, an integer of 64 bits, found \"x\"");
  CHECK(nastran_error("GRID,,,1.\n") == "f:1: expected the tag of a node, found an empty field");
  CHECK(nastran_error("GRID,1,,0.,1,5\nGRID*,2,,0.,0.\n*,l.\n") ==
        "f:3: expected a finite number, found \"l.\"");
  CHECK(nastran_error("GRID,1,2,0.,0.,0.\n") ==
        "f:1: expected nodes in the basic system of coordinates, 0, found \"2\"");
  CHECK(nastran_error("GRDSET,,3\n") ==
        "f:1: expected nodes in the basic system of coordinates, 0, found \"3\"");
  CHECK(nastran_error("INCLUDE 'x.bdf'\n") == "f:1: expected a mesh in one file, found INCLUDE");
  CHECK(nastran_error(grid + "CTETRA,1,1,1,1,1\n") ==
        "f:2: expected a tetrahedron of 4 nodes, found an empty field");
  CHECK(nastran_error(grid + "CTETRA,1,1,1,1,1,1.5\n") ==
        "f:2: expected a node of an element, an integer of 64 bits, found \"1.5\"");
  CHECK(nastran_error(grid + grid + "CBAR,1,1,1,1\n") ==
        "f: expected a tag of its own for each node, found tag 1 twice");
}

TEST_CASE("nastran: the content tells it, whatever its name") {
  CHECK(is_nastran(Beginning(named("$ x\nID a\nbegin bulk\n"))));
  CHECK(is_nastran(Beginning(named("GRID*   1\n"))));
  CHECK(!is_nastran(Beginning(named("GRIDS\n"))));
  CHECK(!is_nastran(Beginning(named("$MeshFormat\n"))));
  const bool is_read = format_of(".nas")->elements == read_nastran;
  CHECK(is_read);
}

}  // namespace circumspect::formats
