// Elements of second order and more are judged by their corners, in every format that has them.
#include "oracle/formats/curved_elements.hpp"

#include <doctest/doctest.h>

#include "inputs/scratch_folder_test.hpp"
#include "oracle/formats/element_domain.hpp"
#include "oracle/formats/mesh_files.hpp"
#include "oracle/formats/reading_test.hpp"

namespace circumspect::formats {
namespace {

// Two triangles of second order over the unit square; `moved` is the node between 0 and 2.
std::string curved_vtk(const std::string& moved) {
  return "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 9 double\n"
         "0 0 0 1 0 0 1 1 0 0 1 0 .5 0 0 1 .5 0 .5 1 0 0 .5 0\n" +
         moved + "\nCELLS 2 14\n6 0 1 2 4 5 8\n6 0 2 3 8 6 7\nCELL_TYPES 2\n22 22\n";
}

std::string curved_msh(const std::string& elements) {
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n11\n1 0 0 0\n2 2 0 0\n3 0 2 0\n4 0 0 2\n"
         "5 1 0 0\n6 1 1 0\n7 0 1 0\n8 0 0 1\n9 0 1 1\n10 1 0 1\n11 9 9 9\n$EndNodes\n$Elements\n" +
         elements + "$EndElements\n";
}

const std::string kCurvedLine = "1 11 2 0 1 1 2 3 4 5 6 7 8 9 10\n";

}  // namespace

TEST_CASE("curved: corners are judged, and points between them left out with their numbers") {
  const ScratchFolder folder;
  const auto mesh = read_mesh({.mesh = folder.write("x.vtk", curved_vtk(".5 .5 0"))});
  REQUIRE_MESSAGE(mesh, error_of(mesh));
  CHECK(mesh->mesh.points() == 4);
  CHECK(mesh->mesh.dimension() == 2);
  CHECK(mesh->mesh.simplices.lists() == std::vector<Simplex>{{0, 1, 2}, {0, 2, 3}});
  CHECK(mesh->notes.front().ends_with(
      "x.vtk: 2 elements of second order are judged by their corners; all other nodes are in the "
      "middle of edges"));
  const auto moved = read_mesh({.mesh = folder.write("y.vtk", curved_vtk(".5 .75 0"))});
  REQUIRE_MESSAGE(moved, error_of(moved));
  CHECK(moved->notes.front().ends_with(
      "judged by their corners; node 8 is farthest from the middle of its edge, ~ 0.25 off"));
  // At a corner it is half an edge off.
  const auto at_corner = read_mesh({.mesh = folder.write("z.vtk", curved_vtk("0 0 0"))});
  REQUIRE_MESSAGE(at_corner, error_of(at_corner));
  CHECK(at_corner->notes.front().ends_with(
      "node 8 is farthest from the middle of its edge, ~ 0.5 off"));
}

TEST_CASE("curved: indices stay the user's, and a point that no element has stays, too") {
  const ScratchFolder folder;
  // Node 6 is between corners of the tetrahedron, and a corner of the edge.
  const std::string edge = "2 1 2 0 1 6 11\n";
  const auto mesh = read_mesh({.mesh = folder.write("x.msh", curved_msh("1\n" + kCurvedLine))});
  REQUIRE_MESSAGE(mesh, error_of(mesh));
  CHECK(mesh->mesh.simplices.lists() == std::vector<Simplex>{{0, 1, 2, 3}});
  CHECK(mesh->mesh.labels == std::vector<Vertex>{1, 2, 3, 4, 11});
  const auto both = read_mesh(
      {.mesh = folder.write("y.msh", curved_msh("2\n" + kCurvedLine + edge)), .with_faces = true});
  REQUIRE_MESSAGE(both, error_of(both));
  CHECK(both->mesh.labels == std::vector<Vertex>{1, 2, 3, 4, 6, 11});
  CHECK(both->mesh.faces == std::vector<Simplex>{{4, 5}});
  CHECK(both->notes.front().find(": 1 element of second order is judged by its corners; ") !=
        std::string::npos);
}

TEST_CASE("curved: higher orders have no measure, and other shapes are refused") {
  ElementFile file;
  file.points.dimension = 2;
  file.points.points = {{0, 0}, {3, 0}, {0, 3}};
  CHECK(!note_of_curved(file, "f"));
  CHECK(nodes_between_corners(file).empty());
  // A node that names no point.
  CHECK(!add_element(file, ElementShape::kCurvedTriangle, Simplex{0, 1, 2, 7, 8, 9}, "a", 1));
  CHECK(
      note_of_curved(file, "f") ==
      "f: 1 element of second order is judged by its corners; all other nodes are in the middle of "
      "edges");
  CHECK(nodes_between_corners(file) == std::vector<Vertex>{7, 8, 9});
  const Simplex cubic = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  CHECK(!add_element(file, ElementShape::kCurvedTriangle, cubic, "a", 2));
  CHECK(note_of_curved(file, "f") == "f: 2 elements of higher order are judged by their corners");
  CHECK(check_simplices(file, "f"));
  CHECK(add_element(file, ElementShape::kCurvedTetrahedron, Simplex{0, 1, 2}, "a", 3) ==
        "a of 4 vertices or more");
  CHECK(!add_element(file, ElementShape::kCurved, cubic, "a quadrilateral of second order", 4));
  CHECK(error_of(check_simplices(file, "f")) ==
        "f:4: expected edges, triangles and tetrahedra, found a quadrilateral of second order");
}

TEST_CASE("curved: a domain has the corners of faces") {
  ElementFile file;
  file.points.dimension = 3;
  file.points.points = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}};
  add_element(file, ElementShape::kCurvedTriangle, Simplex{0, 1, 2, 3, 4, 5}, "a triangle", 1);
  finish_elements(file);
  const auto domain = domain_of(file, "f");
  REQUIRE_MESSAGE(domain, error_of(domain));
  CHECK(domain->input.points.size() == 3);
  CHECK(domain->input.polygons.size() == 1);
  CHECK(domain->notes.front() ==
        "f: 1 element of second order is judged by its corners; node 4 is farthest from the middle "
        "of its edge, ~ 1 off");
}

TEST_CASE("curved: .ele lists nodes of second order behind the corners, as -o2 writes them") {
  const ScratchFolder folder;
  folder.write("x.node",
               "9 2\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n5 .5 0\n6 1 .5\n7 .5 1\n8 0 .5\n9 .5 .75\n");
  const auto plane =
      read_mesh({.mesh = folder.write("x.ele", "2 6\n1 1 2 3 6 9 5\n2 1 3 4 7 8 9\n")});
  REQUIRE_MESSAGE(plane, error_of(plane));
  CHECK(plane->mesh.points() == 4);
  CHECK(plane->mesh.first_index == 1);
  CHECK(plane->mesh.simplices.lists() == std::vector<Simplex>{{0, 1, 2}, {0, 2, 3}});
  REQUIRE(plane->notes.size() == 1);
  CHECK(plane->notes.front().ends_with(
      "x.ele: 2 elements of second order are judged by their corners; node 9 is farthest from the "
      "middle of its edge, ~ 0.25 off"));
  folder.write(
      "y.node",
      "10 3\n0 0 0 0\n1 2 0 0\n2 0 2 0\n3 0 0 2\n4 1 0 0\n5 1 1 0\n6 0 1 0\n7 0 0 1\n8 0 1 "
      "1\n9 1 0 1\n");
  folder.write("y.neigh", "1 4\n0 -1 -1 -1 -1\n");
  MeshRequest request{.mesh = folder.write("y.ele", "1 10\n0 0 1 2 3 4 5 6 7 8 9\n")};
  request.with_neighbors = true;
  const auto space = read_mesh(request);
  REQUIRE_MESSAGE(space, error_of(space));
  CHECK(space->mesh.simplices.lists() == std::vector<Simplex>{{0, 1, 2, 3}});
  CHECK(space->mesh.points() == 4);
  CHECK(space->mesh.neighbors);
  // Six nodes are of no simplex in space.
  CHECK(error_of(read_mesh({.mesh = folder.write("y.ele", "1 6\n0 0 1 2 3 4 5\n")}))
            .ends_with(
                "y.ele:2: expected at most 4 vertices of a simplex in dimension 3, found 6 "
                "(elements of second order and facets that are not simplices are not judged)"));
}

}  // namespace circumspect::formats
