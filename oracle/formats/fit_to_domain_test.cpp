// A mesh is read as the dimension of its domain requires, and changes are noted.
#include <doctest/doctest.h>

#include "inputs/scratch_folder_test.hpp"
#include "oracle/formats/mesh_files.hpp"

namespace circumspect::formats {
namespace {

const std::string kVertices =
    "MeshVersionFormatted 2 Dimension 3 Vertices 4 0 0 5 0 1 0 5 0 1 1 5 0 0 1 5 0 ";
const std::vector<Simplex> kTwoHalves = {{0, 1, 2}, {0, 2, 3}};

Result<MeshFile> against(std::size_t dimension, const std::string& path) {
  return read_mesh({.mesh = path, .with_faces = true, .domain_dimension = dimension});
}

}  // namespace

TEST_CASE("a constant third coordinate is left out where the domain is in the plane") {
  const ScratchFolder folder;
  const std::string medit =
      folder.write("x.mesh", kVertices + "Edges 1 1 2 0 Triangles 2 1 2 3 0 1 3 4 0 End");
  const std::string off =
      folder.write("x.off", "OFF\n4 2 0\n0 0 5\n1 0 5\n1 1 5\n0 1 5\n3 0 1 2\n3 0 2 3\n");
  for (const std::string& path : {medit, off}) {
    const auto mesh = against(2, path);
    REQUIRE(mesh);
    CHECK(mesh->mesh.dimension() == 2);
    CHECK(mesh->mesh.exact_points() == std::vector<Point>{{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    CHECK(mesh->mesh.simplices.lists() == kTwoHalves);
    CHECK(mesh->notes == std::vector<std::string>{
                             path + ": the third coordinate, 5 for all points, was left out"});
  }
}

TEST_CASE("a third coordinate that differs, by an ulp even, stays") {
  const ScratchFolder folder;
  const std::string path = folder.write("x.off",
                                        "OFF\n3 1 0\n0 0 1\n1 0 1\n"
                                        "0 1 1.0000000000000002\n3 0 1 2\n");
  const auto mesh = against(2, path);
  REQUIRE(mesh);
  CHECK(mesh->mesh.dimension() == 3);
  CHECK(mesh->mesh.simplices.size() == 1);
  CHECK(mesh->notes.empty());
}

TEST_CASE("triangles without tetrahedra, and edges without triangles, are taken for faces") {
  const ScratchFolder folder;
  const std::string triangles =
      folder.write("x.mesh", kVertices + "Edges 1 1 2 0 Triangles 2 1 2 3 0 1 3 4 0 End");
  const auto of_triangles = against(3, triangles);
  REQUIRE(of_triangles);
  CHECK(of_triangles->mesh.simplices.empty());
  CHECK(of_triangles->mesh.faces == std::vector<Simplex>{{0, 1}, {0, 1, 2}, {0, 2, 3}});
  CHECK(of_triangles->notes ==
        std::vector<std::string>{triangles +
                                 ": no tetrahedra; the 2 triangles are judged as dangling ones"});
  const std::string edges = folder.write("y.mesh", kVertices + "Edges 1 1 2 0 End");
  CHECK(against(3, edges)->mesh.faces == std::vector<Simplex>{{0, 1}});
  const auto plane = against(2, edges);
  REQUIRE(plane);
  CHECK(plane->mesh.faces == std::vector<Simplex>{{0, 1}});
  CHECK(plane->notes.size() == 2);
  CHECK(plane->notes.back() == edges + ": no triangles; the 1 edge is judged as a dangling one");
}

TEST_CASE("files of the plain form are fitted as all others are") {
  const ScratchFolder folder;
  folder.write("x.node", "4 3\n1 0 0 5\n2 1 0 5\n3 1 1 5\n4 0 1 5\n");
  const std::string ele = folder.write("x.ele", "2 3\n1 1 2 3\n2 1 3 4\n");
  for (const std::size_t dimension : {2u, 3u}) {
    const MeshRequest request{.mesh = ele, .with_faces = true, .domain_dimension = dimension};
    const auto fast = read_plain_mesh(request);
    const auto slow = read_mesh_line_by_line(request);
    REQUIRE(fast);
    REQUIRE(slow);
    CHECK(fast->notes == slow->notes);
    CHECK(fast->notes.size() == 1);
    CHECK(fast->mesh.dimension() == dimension);
    CHECK(fast->mesh.exact_points() == slow->mesh.exact_points());
    CHECK(fast->mesh.simplices.lists() == slow->mesh.simplices.lists());
    CHECK(fast->mesh.faces == slow->mesh.faces);
    CHECK(fast->mesh.faces == (dimension == 3 ? kTwoHalves : std::vector<Simplex>{}));
  }
}

TEST_CASE(
    "simplices stay what they are beside tetrahedra, of differing sizes, or with neighbours") {
  const ScratchFolder folder;
  const std::string both =
      folder.write("x.mesh",
                   "MeshVersionFormatted 2 Dimension 3 Vertices 4 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 0 "
                   "Triangles 1 1 2 3 0 Tetrahedra 1 1 2 3 4 0 End");
  const auto mesh = against(3, both);
  REQUIRE(mesh);
  CHECK(mesh->mesh.simplices.lists() == std::vector<Simplex>{{0, 1, 2, 3}});
  CHECK(mesh->mesh.faces == std::vector<Simplex>{{0, 1, 2}});
  CHECK(mesh->notes.empty());
  const std::string mixed = folder.write(
      "x.json",
      "{\"circumspect\": 1, \"dimension\": 3, \"points\": [[0,0,0],[1,0,0],[0,1,0],[0,0,1]],\n"
      "\"simplices\": [[0,1,2],[0,1]], \"faces\": [[1,2]]}");
  CHECK(against(3, mixed)->mesh.simplices.size() == 2);
  CHECK(against(3, mixed)->mesh.faces == std::vector<Simplex>{{1, 2}});
  CHECK(read_mesh({.mesh = mixed})->mesh.faces.empty());
  MeshRequest request{.mesh = folder.write("y.ele", "1 3\n0 0 1 2\n"),
                      .points = mixed,
                      .with_neighbors = true,
                      .with_faces = true,
                      .domain_dimension = 3};
  CHECK(read_mesh(request)->mesh.simplices.size() == 1);
  request.with_neighbors = false;
  CHECK(read_mesh(request)->mesh.simplices.empty());
}

namespace {

// Two tetrahedra side by side, labelled 3 and 0, and three triangles: one between them, one of the
// second alone, and one dangling.
const std::string kLabelled =
    "MeshVersionFormatted 2 Dimension 3 Vertices 6 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 0 1 1 1 0 9 9 9 0 "
    "Triangles 3 2 3 4 0 2 3 5 0 1 2 6 0 Tetrahedra 2 1 2 3 4 3 2 3 4 5 0 End";

Result<MeshFile> labelled(const std::string& path, const std::vector<Vertex>& labels) {
  return read_mesh({.mesh = path, .with_faces = true, .kept_labels = labels});
}

}  // namespace

TEST_CASE("cells of a label: what belongs to others alone is left out, and numbers stay") {
  const ScratchFolder folder;
  const std::string path = folder.write("x.mesh", kLabelled);
  const auto mesh = labelled(path, {3});
  REQUIRE(mesh);
  CHECK(mesh->mesh.simplices.lists() == std::vector<Simplex>{{0, 1, 2, 3}});
  CHECK(mesh->mesh.points() == 5);
  CHECK(mesh->mesh.labels == std::vector<Vertex>{1, 2, 3, 4, 6});
  CHECK(mesh->mesh.faces == std::vector<Simplex>{{1, 2, 3}, {0, 1, 4}});
  CHECK(mesh->notes == std::vector<std::string>{path + ": 1 of 2 cells have a label that is kept"});
  const auto all = labelled(path, {0, 3});
  REQUIRE(all);
  CHECK(all->mesh.simplices.size() == 2);
  CHECK(all->mesh.faces.size() == 3);
  CHECK(all->mesh.labels.empty());
  const auto none = labelled(path, {7});
  REQUIRE(!none);
  CHECK(none.error().found == "the labels 0, 3");
}

TEST_CASE("labels: the first attribute of .ele, and the physical groups of .msh") {
  const ScratchFolder folder;
  folder.write("x.node", "5 3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 1 1\n");
  const std::string ele = folder.write("x.ele", "2 4 2\n1 1 2 3 4 5 0\n2 2 3 4 5 -6 0.5\n");
  const auto of_ele = labelled(ele, {-6});
  REQUIRE(of_ele);
  CHECK(of_ele->mesh.simplices.lists() == std::vector<Simplex>{{0, 1, 2, 3}});
  CHECK(of_ele->mesh.labels == std::vector<Vertex>{2, 3, 4, 5});
  const std::string halves = folder.write("x.ele", "2 4 1\n1 1 2 3 4 0.5\n2 2 3 4 5 6\n");
  CHECK(!labelled(halves, {6}));
  const std::string bare = folder.write("x.ele", "2 4 0\n1 1 2 3 4\n2 2 3 4 5\n");
  CHECK(!labelled(bare, {0}));
  const std::string none = folder.write("x.ele", "0 4 1\n");
  CHECK(!labelled(none, {0}));
  const std::string points = "1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 1 1\n";
  const std::string msh2 = folder.write(
      "two.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n" + points +
                     "$EndNodes\n$Elements\n2\n1 4 2 8 1 1 2 3 4\n2 4 0 2 3 4 5\n$EndElements\n");
  CHECK(labelled(msh2, {8})->mesh.simplices.lists() == std::vector<Simplex>{{0, 1, 2, 3}});
  CHECK(labelled(msh2, {0})->mesh.labels == std::vector<Vertex>{2, 3, 4, 5});
  const std::string msh4 =
      folder.write("four.msh",
                   "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n1 1 1 2\n1 0 0 0 1 7\n"
                   "1 0 0 0 1 1 1 0 2 1 -1\n1 0 0 0 1 1 1 0 1 1\n1 0 0 0 1 1 1 2 8 9 1 1\n"
                   "4 0 0 0 1 1 1 0 0\n$EndEntities\n$Nodes\n1 5 1 5\n3 1 0 5\n1\n2\n3\n4\n5\n"
                   "0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 1 1\n$EndNodes\n"
                   "$Elements\n2 2 1 2\n3 1 4 1\n1 1 2 3 4\n3 4 4 1\n2 2 3 4 5\n$EndElements\n");
  const auto of_msh4 = labelled(msh4, {8});
  REQUIRE_MESSAGE(of_msh4, (of_msh4 ? "" : of_msh4.error().to_string()));
  CHECK(of_msh4->mesh.simplices.lists() == std::vector<Simplex>{{0, 1, 2, 3}});
  CHECK(labelled(msh4, {0})->mesh.labels == std::vector<Vertex>{2, 3, 4, 5});
}

}  // namespace circumspect::formats
