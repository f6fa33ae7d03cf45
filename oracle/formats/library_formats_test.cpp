// Meshes of the finite element libraries FreeFem and MFEM: what is read, what is refused.
#include <doctest/doctest.h>

#include "inputs/scratch_folder_test.hpp"
#include "oracle/formats/format.hpp"
#include "oracle/formats/freefem.hpp"
#include "oracle/formats/mesh_files.hpp"
#include "oracle/formats/mfem.hpp"
#include "oracle/formats/read_domain.hpp"
#include "oracle/formats/reading_test.hpp"

namespace circumspect::formats {
namespace {

std::string freefem_error(const std::string& text) {
  return error_of(read_freefem(named(text), kDouble));
}
std::string mfem_error(const std::string& text) {
  return error_of(read_mfem(named(text), kDouble));
}

const std::string kFreefem = "3 1 2\n0 0 1\n1 0 1\n0 0.1 1\n1 2 3 7\n1 2 5\n2 3 5\n";
const std::string kFreefemInSpace =
    "4 1 1\n0 0 0 1\n1 0 0 1\n0 1 0 1\n0 0 1 1\n1 2 3 4 7\n1 2 3 5\n";
const std::string kMfemElements =
    "MFEM mesh v1.0\n\n# kinds\n\ndimension\n3\n\nelements\n1\n7 4 0 1 2 3\n\nboundary\n1\n5 2 0 1 "
    "2\n\n";
const std::string kMfem = kMfemElements + "vertices\n4\n3\n0 0 0\n1 0 0\n0 1 0\n0 0 0.1\n";

// Vertices by a function on the mesh with one more node.
std::string with_nodes(const std::string& collection, const std::string& ordering,
                       const std::string& values) {
  return kMfemElements +
         "vertices\n4\n\nnodes\nFiniteElementSpace\nFiniteElementCollection: " + collection +
         "\nVDim: 3\nOrdering: " + ordering + "\n\n" + values;
}

}  // namespace

TEST_CASE("freefem: in the plane and in space") {
  const auto plane = read_freefem(named(kFreefem), kDouble);
  REQUIRE_MESSAGE(plane, error_of(plane));
  CHECK(plane->points.points == std::vector<Point>{{0, 0}, {1, 0}, {0, exact_value(0.1)}});
  CHECK(plane->points.first_index == 1);
  CHECK(plane->triangles.simplices == std::vector<Simplex>{{1, 2, 3}});
  CHECK(plane->triangles.labels == std::vector<Vertex>{7});
  CHECK(plane->edges.simplices == std::vector<Simplex>{{1, 2}, {2, 3}});
  const auto space = read_freefem(named(kFreefemInSpace), kDouble);
  REQUIRE_MESSAGE(space, error_of(space));
  CHECK(space->tetrahedra.simplices == std::vector<Simplex>{{1, 2, 3, 4}});
  CHECK(space->tetrahedra.lines == std::vector<std::size_t>{6});
  CHECK(space->triangles.simplices == std::vector<Simplex>{{1, 2, 3}});
}

TEST_CASE("freefem: faults and their lines") {
  CHECK(freefem_error("3 1\n") ==
        "f:1: expected the numbers of vertices and of two kinds of elements, found the end of the "
        "line");
  CHECK(freefem_error("3 -1 2\n0 0 0\n") == "f:1: expected a count, 0 or more, found \"-1\"");
  CHECK(freefem_error("0 0 0\n") == "f:1: expected 1 vertex or more, found 0");
  CHECK(freefem_error("2 1 1\n0 0 1\n") ==
        "f:2: expected vertex 2 of 2, found the end of the file");
  CHECK(freefem_error("2 1 1\n0 0 1\n0 0 0 1\n") ==
        "f:3: expected 3 columns of vertex 2 of 2, found 4");
  CHECK(freefem_error("1 1 1\n0 1\n") ==
        "f:2: expected 2 or 3 coordinates and a label of vertex 1 of 1, found 2 columns");
  CHECK(freefem_error("1 1 0\n0 0 1\n1 1 1\n") ==
        "f:3: expected 4 columns of triangle 1 of 1, found 3");
  CHECK(freefem_error(kFreefem + "1\n") == "f:8: expected the end of the file, found \"1\"");
}

TEST_CASE("mfem: coordinates of vertices, attributes, boundary") {
  for (const std::string& text :
       {kMfem, kMfem + "attribute_sets\n1\n\"a b\" 1 7\nmfem_mesh_end\n",
        with_nodes("H1_3D_P1", "1", "0 0 0\n1 0 0\n0 1 0\n0 0 0.1\n"),
        with_nodes("Linear", "0", "0 1 0 0\n0 0 1 0\n0 0 0\n0.1\nmfem_mesh_end\n")}) {
    const auto file = read_mfem(named(text), kDouble);
    REQUIRE_MESSAGE(file, error_of(file));
    CHECK(file->points.points ==
          std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, exact_value(0.1)}});
    CHECK(file->tetrahedra.simplices == std::vector<Simplex>{{0, 1, 2, 3}});
    CHECK(file->tetrahedra.labels == std::vector<Vertex>{7});
    CHECK(file->triangles.simplices == std::vector<Simplex>{{0, 1, 2}});
    CHECK(file->notes.empty());
  }
  const auto curved =
      read_mfem(named(with_nodes("H1_3D_P2", "0", "0 1 0 0 9 0 0 1 0 9 0 0 0 0.1 9\n")), kDouble);
  REQUIRE_MESSAGE(curved, error_of(curved));
  CHECK(curved->points.points.size() == 4);
  CHECK(curved->points.points[3] == Point{0, 0, exact_value(0.1)});
  CHECK(curved->notes == std::vector<std::string>{
                             "f: elements of higher order (H1_3D_P2) are judged by their corners"});
}

TEST_CASE("mfem: faults and their lines") {
  CHECK(mfem_error("MFEM NURBS mesh v1.0\n") ==
        "f:1: expected the line MFEM mesh v1.0, found \"NURBS\"");
  CHECK(mfem_error("MFEM mesh\n") ==
        "f:1: expected the line MFEM mesh v1.0, found the end of the line");
  CHECK(mfem_error("MFEM mesh v2.0\n") == "f:1: expected the line MFEM mesh v1.0, found \"v2.0\"");
  CHECK(mfem_error("MFEM mesh v1.1\nvertex_parents\n0\n") ==
        "f:2: expected a section of a conforming mesh, as elements or vertices, found "
        "\"vertex_parents\"");
  CHECK(mfem_error("MFEM mesh v1.0\nelements\n1\n1 9 0\n") ==
        "f:4: expected a kind of elements from 0 to 7, found \"9\"");
  CHECK(mfem_error("MFEM mesh v1.0\nelements\n1\n1 2 0 1\n") ==
        "f:4: expected an attribute, a kind and 3 vertices of a triangle, found 4 columns");
  CHECK(mfem_error("MFEM mesh v1.0\nelements\n2\n1 2 0 1 2\n") ==
        "f:4: expected element 2 of 2, found the end of the file");
  CHECK(mfem_error(kMfemElements) ==
        "f:15: expected the section vertices, found the end of the file");
  CHECK(mfem_error(kMfem + "vertices\n0\n3\n") ==
        "f:23: expected one section of vertices, found another");
  CHECK(mfem_error(kMfemElements + "vertices\n4\n3\n0 0 0\n1 0\n") ==
        "f:20: expected 3 coordinates of vertex 2 of 4, found 2");
  CHECK(mfem_error(with_nodes("L2_T1_3D_P1", "0", "0\n")) ==
        "f:21: expected nodes of a continuous function, as H1_3D_P2, found \"L2_T1_3D_P1\"");
  CHECK(mfem_error(with_nodes("H1_3D_P1", "1", "0 0 0\n1 0 0\n0 1 0\n")) ==
        "f:27: expected 3 numbers for each node, and a node for each of 4 vertices, found 9 "
        "numbers");
}

TEST_CASE("formats that share an ending: the content decides, and the first is the usual one") {
  const ScratchFolder folder;
  const auto mesh = [&](const std::string& name, const std::string& text) {
    return read_mesh({.mesh = folder.write(name, text)});
  };
  CHECK(mesh("a.msh", kFreefem));
  CHECK(mesh("b.mesh", kMfem));
  CHECK(mesh("b", kMfem));
  CHECK(read_domain(folder.write("c.msh", kFreefem), kDouble));
  CHECK(read_points(folder.write("d.mesh", kMfem), kDouble));
  CHECK(error_of(mesh("e.msh", "x\n")).find("expected \"$MeshFormat\"") != std::string::npos);
  // Three counts begin files of many formats.
  CHECK(!mesh("f", kFreefem));
  const std::string endings = endings_of(&Format::has_mesh);
  CHECK(endings.find(".msh") == endings.rfind(".msh"));
}

}  // namespace circumspect::formats
