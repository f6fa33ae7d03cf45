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
  CHECK(nastran_error("INCLUDE 'x.bdf'\n") == "f:1: expected a file to include, found INCLUDE");
  CHECK(nastran_error(grid + "CTETRA,1,1,1,1,1\n") ==
        "f:2: expected a tetrahedron of 4 nodes, found an empty field");
  CHECK(nastran_error(grid + "CTETRA,1,1,1,1,1,1.5\n") ==
        "f:2: expected a node of an element, an integer of 64 bits, found \"1.5\"");
  CHECK(nastran_error(grid + "GRID,3\nCTRIA6,1,1,1,1,3,-5\n") ==
        "f:3: expected the tag of a node of a GRID, found -5");
  CHECK(nastran_error("CORD2R,7,x,0.,0.,0.,0.,0.,1.\n,1.,0.,0.\n" + grid) ==
        "f:1: expected the system of coordinates that this one is given in, an integer of 64 bits, "
        "found \"x\"");
  CHECK(nastran_error(grid + grid + "CBAR,1,1,1,1\n") ==
        "f: expected a tag of its own for each node, found tag 1 twice");
}

TEST_CASE("nastran: nodes of other systems are moved exactly, wherever the system is defined") {
  const std::string rest = "CBAR,1,1,1,2\n";
  // Its third axis is (0, 3, 4), its first one (1, 0, 0).
  const std::string turned = "CORD2R,7,,10.,0.,0.,10.,3.,4.\n,11.,0.,0.\n";
  const std::string node = "GRID,1,7,1.,5.,10.\nGRID,2\n";
  for (const std::string& text : {turned + node, node + turned}) {
    const auto file = nastran(text + rest);
    REQUIRE_MESSAGE(file, error_of(file));
    CHECK(file->points.points == std::vector<Point>{{11, 10, 5}, {0, 0, 0}});
    CHECK(file->notes.back().find("1 nodes are given in other systems") != std::string::npos);
  }
  const auto usual = nastran("GRDSET,,7\n" + turned + "GRID,1,,1.,5.,10.\nGRID,2,0\n" + rest);
  REQUIRE_MESSAGE(usual, error_of(usual));
  CHECK(usual->points.points == std::vector<Point>{{11, 10, 5}, {0, 0, 0}});
}

TEST_CASE(
    "nastran: nodes of systems without exact places are refused, and never left as they are") {
  const auto said = [](const std::string& system) {
    return nastran_error(system + "GRID,1\nGRID,5,2,1.\nCBAR,1,1,1,5\n");
  };
  const auto has = [&](const std::string& system, const std::string& part) {
    return said(system).find(part) != std::string::npos;
  };
  CHECK(said("CORD2C,2,,0.,0.,0.,0.,0.,1.\n,1.,0.,0.\n") ==
        "f:4: expected GRID 5 in the basic system of coordinates, 0, or in one whose points have "
        "exact places there, found system 2, by CORD2C on line 1 a cylindrical one (write the mesh "
        "in the basic system: here it would have to be rounded)");
  CHECK(has("CORD2S,2,,0.,0.,0.,0.,0.,1.\n,1.,0.,0.\n", "a spherical one"));
  CHECK(has("CORD1R,2,1,2,3\n", "one that nodes define"));
  CHECK(has("", "found system 2, which no CORD entry defines"));
  const std::string irrational = "no rational directions, or that is given in another";
  CHECK(has("CORD2R,2,,0.,0.,0.,0.,1.,1.\n,1.,0.,0.\n", irrational));
  CHECK(has("CORD2R,2,1,0.,0.,0.,0.,0.,1.\n,1.,0.,0.\n", irrational));
  CHECK(has("CORD2R,2,,0.,0.,0.,0.,0.,1.\n,0.,0.,2.\n", irrational));  // no plane
  CHECK(has("CORD2R,2,,0.,0.,0.,0.,0.,x\n", "expected a finite number, found \"x\""));
  const std::string twice = "CORD2R,2,,0.,0.,0.,0.,0.,1.\n,1.,0.,0.\n";
  CHECK(has(twice + twice, "by CORD2R on line 1 and again"));
  CHECK(nastran(twice + twice + "GRID,1\nCBAR,1,1,1,1\n"));
  CHECK(has("CORD1S,9,1,2,3,2,3,4,5\n", "a spherical one"));
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
