// Meshes of the finite element libraries FreeFem, MFEM, Netgen and DOLFIN: what is read, what is
// refused.
#include <doctest/doctest.h>

#include "inputs/scratch_folder_test.hpp"
#include "oracle/formats/dolfin.hpp"
#include "oracle/formats/format.hpp"
#include "oracle/formats/freefem.hpp"
#include "oracle/formats/gmsh.hpp"
#include "oracle/formats/mesh_files.hpp"
#include "oracle/formats/mfem.hpp"
#include "oracle/formats/netgen.hpp"
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

std::string netgen_error(const std::string& text) {
  return error_of(read_netgen(named(text), kDouble));
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
    CHECK(file->tetrahedra.vertices_per_simplex == 4);
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

TEST_CASE("mfem: nodes of two coordinates, and of no other number than two or three") {
  const auto with_dimension = [](const std::string& dimension) {
    return "MFEM mesh v1.0\n\ndimension\n2\n\nelements\n1\n7 2 0 1 2\n\nboundary\n0\n\n"
           "vertices\n3\n\nnodes\nFiniteElementSpace\nFiniteElementCollection: H1_2D_P1\nVDim: " +
           dimension + "\nOrdering: 1\n\n0 0\n1 0\n0 0.1\n";
  };
  const auto file = read_mfem(named(with_dimension("2")), kDouble);
  REQUIRE_MESSAGE(file, error_of(file));
  CHECK(file->points.points == std::vector<Point>{{0, 0}, {1, 0}, {0, exact_value(0.1)}});
  CHECK(file->triangles.simplices == std::vector<Simplex>{{0, 1, 2}});
  for (const std::string dimension : {"1", "4", "x"}) {
    CHECK(mfem_error(with_dimension(dimension)) ==
          "f:19: expected a dimension, 2 or 3, found \"" + dimension + "\"");
  }
}

TEST_CASE("mfem: a set of attributes has a name, in quotes or not, and goes on over lines") {
  const std::string sets =
      "attribute_sets\n4\nWest 1 9\n\"N Even\" 1 10\n\"Rose\" 4 10 11   "
      "12\n13\n\"East\"\n2\n16\n17\n\n";
  std::string text = kMfem;
  text.insert(text.find("boundary"), sets);
  const auto file = read_mfem(named(text), kDouble);
  REQUIRE_MESSAGE(file, error_of(file));
  CHECK(file->tetrahedra.simplices.size() == 1);
  CHECK(mfem_error("MFEM mesh v1.3\nattribute_sets\n1\n\"N\n") ==
        "f:4: expected the end of a name, a quotation mark, found the end of the line");
  CHECK(mfem_error("MFEM mesh v1.3\nattribute_sets\n1\n\"N\" 2 1\n") ==
        "f:4: expected an attribute of a set, found the end of the file");
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
  CHECK(mfem_error("MFEM mesh v1.0\nelements\n1\n1 x 0 1 2\n") ==
        "f:4: expected the kind of an element, an integer, found \"x\"");
  CHECK(mfem_error(kMfemElements + "vertices\n4\n4\n0 0 0\n") ==
        "f:18: expected a dimension from 1 to 3, found \"4\"");
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

const std::string kNetgenPoints = "points\n4\n0 0 0\n1 0 0\n0 1 0\n0 0 .1\n";

TEST_CASE("netgen: elements of volume, surface and edges, in any order; the rest is skipped") {
  const std::string text =
      "mesh3d\ndimension\n3\ngeomtype\n0\n\n# surfnr bcnr domin domout np p1\n"
      "surfaceelementsgi\n1\n 1 5 1 0 3 1 2 3 0 0 0\n" +
      kNetgenPoints +
      "# matnr np p1\nvolumeelements\n1\n7 4 1 2 3 4\nedgesegmentsgi2\n1\n"
      "6 0 1 2 -1 -1 1 2 1 0 1 1\nmaterials\n1\n1 steel\nendmesh\npoints\n";
  const auto file = read_netgen(named(text), kDouble);
  REQUIRE_MESSAGE(file, error_of(file));
  CHECK(file->points.points ==
        std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, exact_value(0.1)}});
  CHECK(file->points.first_index == 1);
  CHECK(file->tetrahedra.simplices == std::vector<Simplex>{{1, 2, 3, 4}});
  CHECK(file->tetrahedra.labels == std::vector<Vertex>{7});
  CHECK(file->tetrahedra.lines == std::vector<std::size_t>{20});
  CHECK(file->triangles.simplices == std::vector<Simplex>{{1, 2, 3}});
  CHECK(file->triangles.labels == std::vector<Vertex>{5});
  CHECK(file->edges.simplices == std::vector<Simplex>{{1, 2}});
  CHECK(file->edges.labels == std::vector<Vertex>{6});
  const auto curved = read_netgen(
      named("mesh3d\nvolumeelements\n2\n1 10 1 2 3 4 1 2 3 4 1 2\n1 5 1 2 3 4 1\n" + kNetgenPoints),
      kDouble);
  REQUIRE_MESSAGE(curved, error_of(curved));
  CHECK(curved->tetrahedra.simplices == std::vector<Simplex>{{1, 2, 3, 4}});
  CHECK(curved->first_other->name == "a pyramid");
  CHECK((told_format(named(text), &Format::has_mesh, false)->elements == read_netgen));
}

TEST_CASE("netgen: faults and their lines") {
  CHECK(netgen_error("mesh\n") == "f:1: expected the keyword mesh3d, found \"mesh\"");
  CHECK(netgen_error("mesh3d\n") == "f:1: expected the section points, found the end of the file");
  CHECK(netgen_error("mesh3d\npoints\n") ==
        "f:2: expected the number of points, found the end of the file");
  CHECK(netgen_error("mesh3d\npoints\n2\n0 0 0\n") ==
        "f:4: expected 3 coordinates of point 2 of 2, found the end of the file");
  CHECK(netgen_error("mesh3d\npoints\n1\n0 0\n") ==
        "f:4: expected 3 coordinates of point 1 of 1, found the end of the line");
  CHECK(netgen_error("mesh3d\npoints\n1\n0 0 0 0\n") ==
        "f:4: expected 3 coordinates of point 1 of 1, found \"0\"");
  CHECK(netgen_error("mesh3d\n" + kNetgenPoints + kNetgenPoints) ==
        "f:9: expected one section of points, found another");
  CHECK(netgen_error("mesh3d\nvolumeelements\n1\n1\n") ==
        "f:4: expected the number of nodes of a volume element, found the end of the line");
  CHECK(netgen_error("mesh3d\nvolumeelements\n1\n1 7 1 2 3 4 5 6 7\n") ==
        "f:4: expected the number of nodes of a volume element, as 3 or 4, found \"7\"");
  CHECK(netgen_error("mesh3d\nvolumeelements\n2\n1 4 1 2 3 4\n") ==
        "f:4: expected a volume element 2 of 2, found the end of the file");
  CHECK(netgen_error("mesh3d\nsurfaceelements\n1\n1 1 1 0 3 1 2\n") ==
        "f:4: expected a node of a triangle, found the end of the line");
  CHECK(netgen_error("mesh3d\nedgesegments\n1\n1 0 1 x\n") ==
        "f:4: expected a node, an integer, found \"x\"");
}

std::string dolfin_mesh(const std::string& vertices, const std::string& cells,
                        const std::string& mesh = "celltype=\"triangle\" dim=\"2\"") {
  return "<?xml version=\"1.0\"?>\n<dolfin xmlns:dolfin=\"x\">\n<mesh " + mesh + ">\n<vertices " +
         vertices + "</vertices>\n<cells " + cells + "</cells>\n</mesh>\n</dolfin>\n";
}
const std::string kDolfinVertices =
    "size=\"3\">\n<vertex index=\"0\" x=\"0\" y=\"0\"/>\n<vertex index=\"1\" x=\"1\" y=\"0\"/>\n"
    "<vertex index=\"2\" x=\"0\" y=\"1e-1\"/>\n";
const std::string kDolfinCells =
    "size=\"1\">\n<triangle index=\"0\" v0=\"0\" v1=\"1\" v2=\"2\"/>\n";

TEST_CASE("dolfin: vertices and cells, exactly; told by its content among other XML") {
  const std::string text = dolfin_mesh(kDolfinVertices, kDolfinCells);
  const auto file = read_dolfin(named(text), kDouble);
  REQUIRE_MESSAGE(file, error_of(file));
  CHECK(file->points.points == std::vector<Point>{{0, 0}, {1, 0}, {0, exact_value(0.1)}});
  CHECK(file->points.first_index == 0);
  CHECK(file->triangles.simplices == std::vector<Simplex>{{0, 1, 2}});
  CHECK(file->triangles.lines == std::vector<std::size_t>{10});
  CHECK((told_format(named(text), &Format::has_mesh, false)->elements == read_dolfin));
  const std::string other = "<?xml version=\"1.0\"?>\n<VTKFile>\n</VTKFile>\n";
  CHECK((told_format(named(other), &Format::has_mesh, false)->elements != read_dolfin));
  const std::string quadrilateral = "celltype=\"quadrilateral\" dim=\"2\"";
  const auto refused =
      read_dolfin(named(dolfin_mesh(
                      kDolfinVertices,
                      "size=\"1\"><quadrilateral index=\"0\" v0=\"0\" v1=\"1\" v2=\"2\" v3=\"0\"/>",
                      quadrilateral)),
                  kDouble);
  REQUIRE_MESSAGE(refused, error_of(refused));
  CHECK(refused->first_other->name == "a quadrilateral");
}

TEST_CASE("dolfin: cells may come before vertices, and intervals have one dimension") {
  const std::string cells = "<cells " + kDolfinCells + "</cells>\n";
  std::string text = dolfin_mesh(kDolfinVertices, "size=\"0\">");
  text.erase(text.find("<cells"), text.find("</mesh>") - text.find("<cells"));
  text.insert(text.find("<vertices"), cells);
  const auto file = read_dolfin(named(text), kDouble);
  REQUIRE_MESSAGE(file, error_of(file));
  CHECK(file->triangles.simplices == std::vector<Simplex>{{0, 1, 2}});
  CHECK(file->triangles.lines == std::vector<std::size_t>{5});
  const auto line = read_dolfin(
      named(dolfin_mesh("size=\"2\"><vertex index=\"0\" x=\"0\"/><vertex index=\"1\" x=\"3\"/>",
                        "size=\"1\"><interval index=\"0\" v0=\"0\" v1=\"1\"/>",
                        "celltype=\"interval\" dim=\"1\"")),
      kDouble);
  REQUIRE_MESSAGE(line, error_of(line));
  CHECK(line->points.points == std::vector<Point>{{0}, {3}});
  CHECK(line->edges.simplices == std::vector<Simplex>{{0, 1}});
}

TEST_CASE("dolfin: faults and their lines") {
  const auto error = [](const std::string& text) {
    return error_of(read_dolfin(named(text), kDouble));
  };
  const auto vertices = [&](const std::string& text) {
    return error(dolfin_mesh(text, kDolfinCells));
  };
  const auto cells = [&](const std::string& text) {
    return error(dolfin_mesh(kDolfinVertices, text));
  };
  const auto mesh = [&](const std::string& text) {
    return error(dolfin_mesh(kDolfinVertices, kDolfinCells, text));
  };
  CHECK(error("<dolfin>\n<mesh>") == "f:2: expected XML, found a fault: Start-end tags mismatch");
  CHECK(error("<dolfin>\n<mesh_function/></dolfin>") ==
        "f:1: expected the element mesh, found \"mesh_function\"");
  CHECK(mesh("celltype=\"point\"") ==
        "f:3: expected celltype=\"triangle\", \"tetrahedron\" or \"interval\", found \"point\"");
  CHECK(mesh("celltype=\"triangle\" dim=\"4\"") ==
        "f:3: expected dim=\"1\", \"2\" or \"3\", found 4");
  CHECK(vertices("size=\"x\">") == "f:4: expected size=\"N\", a whole number, found \"x\"");
  CHECK(vertices("size=\"2\"><vertex index=\"0\" x=\"0\" y=\"0\"/>") ==
        "f:4: expected 2 elements vertex, found 1");
  CHECK(vertices("size=\"1\"><node/>") == "f:4: expected the element vertex, found \"node\"");
  CHECK(vertices("size=\"1\">\n<vertex index=\"1\" x=\"0\" y=\"0\"/>") ==
        "f:5: expected the index 0, in ascending order, found 1");
  CHECK(vertices("size=\"1\">\n<vertex index=\"0\" x=\"0\"/>") ==
        "f:5: expected y=\"NUMBER\", found none");
  CHECK(cells("size=\"2\">\n<triangle index=\"0\" v0=\"0\" v1=\"1\" v2=\"2\"/>\n") ==
        "f:9: expected 2 elements triangle, found 1");
  CHECK(cells("size=\"1\"><triangle index=\"0\" v0=\"0\" v1=\"-1\"/>") ==
        "f:9: expected v1=\"N\", a whole number, found \"-1\"");
}

TEST_CASE("gmsh: version 1, as older programs write it") {
  const std::string nodes = "$NOD\n3\n1 0 0 0\n2 1 0 0\n3 0 .1 0\n$ENDNOD\n";
  const auto read = [](const std::string& text) { return read_gmsh(named(text), kDouble); };
  const auto file = read(nodes + "$ELM\n2\n1 2 7 1 3 1 2 3\n2 1 8 1 2 1 2\n$ENDELM\n");
  REQUIRE_MESSAGE(file, error_of(file));
  CHECK(file->points.points[2] == Point{0, exact_value(0.1), 0});
  CHECK(file->triangles.simplices == std::vector<Simplex>{{1, 2, 3}});
  CHECK(file->triangles.labels == std::vector<Vertex>{7});
  CHECK(file->edges.simplices == std::vector<Simplex>{{1, 2}});
  CHECK(error_of(read(nodes + "$ELM\n1\n1 2 7 1 4 1 2 3 3\n$ENDELM\n")) ==
        "f:9: expected 3 nodes of a triangle, found 4");
  CHECK(error_of(read(nodes + nodes)) ==
        "f:7: expected one section $NOD and one section $ELM, found \"$NOD\"");
  CHECK(error_of(read("$Comments\nwithout an end\n" + nodes)) ==
        "f:1: expected $EndComments behind $Comments, found the end of the file");
  CHECK(error_of(read(nodes)) == "f:6: expected the section $Elements, found the end of the file");
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
