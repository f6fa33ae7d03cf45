// Planar files with a third coordinate: one rule for meshes and domains of all formats.
#include "oracle/formats/plane.hpp"

#include <algorithm>

#include <doctest/doctest.h>

#include "inputs/scratch_folder_test.hpp"
#include "oracle/formats/flat_square_test.hpp"
#include "oracle/formats/read_domain.hpp"
#include "oracle/formats/reading_test.hpp"

namespace circumspect::formats {
namespace {

const std::vector<Point> kSquare = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

std::string note(const std::string& path, const std::string& height) {
  return path + ": the third coordinate, " + height + " for all points, was left out";
}

std::size_t dimension_of(const ScratchFolder& folder, const std::string& name,
                         const std::string& text) {
  const auto mesh = read_mesh({.mesh = folder.write(name, text), .with_faces = true});
  REQUIRE_MESSAGE(mesh, error_of(mesh));
  return mesh->mesh.dimension();
}

}  // namespace

TEST_CASE("a flat mesh of triangles is one of the plane, in every format, and a note says so") {
  const ScratchFolder folder;
  for (const std::string& path : flat_square_meshes(folder, "x", "0.5")) {
    CAPTURE(path);
    const auto mesh = read_mesh({.mesh = path});
    REQUIRE_MESSAGE(mesh, error_of(mesh));
    CHECK(mesh->mesh.exact_points() == kSquare);
    CHECK(mesh->mesh.simplices.size() == 2);
    CHECK(mesh->notes == std::vector<std::string>{note(mesh->points_name, "0.5")});
    CHECK(mesh->height == Rational(1) / 2);
    // Not if the user says that it is in space, or that files are read unchanged.
    const auto in_space = read_mesh({.mesh = path, .domain_dimension = 3});
    CHECK(in_space->mesh.dimension() == 3);
    CHECK(!in_space->height);
    CHECK(read_mesh({.mesh = path, .keeps_coordinates = true})->mesh.dimension() == 3);
  }
  for (const std::string& path : flat_square_meshes(folder, "y", "0.5")) {
    MeshFile mesh = *read_mesh({.mesh = path});
    put_back_height(mesh.mesh, *mesh.height);
    CHECK(mesh.mesh.point(2) == Point{1, 1, Rational(1) / 2});
  }
}

TEST_CASE("a flat domain is one of the plane, in every format, and what it is in space is kept") {
  const ScratchFolder folder;
  for (const auto& [end, text] : flat_square("0.5")) {
    const std::string path = folder.write("x" + end, text);
    CAPTURE(path);
    const auto domain = read_domain(path, kDouble);
    REQUIRE_MESSAGE(domain, error_of(domain));
    CHECK(domain->dimension == 2);
    CHECK(domain->input.points == kSquare);
    std::vector<Simplex> segments = domain->input.segments;
    for (Simplex& segment : segments) std::sort(segment.begin(), segment.end());
    std::sort(segments.begin(), segments.end());
    CHECK(segments == std::vector<Simplex>{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {2, 3}});
    CHECK(domain->input.polygons.empty());
    CHECK(domain->faces.size() == 2);
    CHECK(domain->notes.back() == note(path, "0.5"));
    REQUIRE(domain->flat);
    CHECK(domain->flat->height == Rational(1) / 2);
    const DomainFile in_space = as_it_stands(*domain);
    CHECK(in_space.dimension == 3);
    CHECK(in_space.input.polygons.size() == 2);
    CHECK(in_space.input.segments.empty());
    CHECK(of_dimension(*domain, 2).dimension == 2);
    CHECK(of_dimension(*domain, 3).dimension == 3);
  }
}

TEST_CASE("what has cells of space stays there, wherever its points are") {
  const ScratchFolder folder;
  const std::string square = "4 3\n0 0 0 5\n1 1 0 5\n2 1 1 5\n3 0 1 5\n";
  folder.write("t.node", square);
  CHECK(dimension_of(folder, "t.ele", "1 4\n0 0 1 2 3\n") == 3);
  // TetGen's mesh of dangling parts alone: no tetrahedra, which would have four vertices.
  folder.write("t.face", "1 0\n0 0 1 2\n");
  CHECK(dimension_of(folder, "t.ele", "0 4\n") == 3);
  const std::string points =
      R"({"circumspect":1,"dimension":3,"points":[[0,0,5],[1,0,5],[0,1,5],[1,1,5]],)";
  CHECK(dimension_of(folder, "t.json", points + R"("simplices":[[0,1,2,3]]})") == 3);
  CHECK(dimension_of(folder, "t.json", points + R"("simplices":[],"faces":[[0,1,2]]})") == 3);
  CHECK(dimension_of(folder, "t.json", points + R"("simplices":[],"faces":[[0,1]]})") == 2);
  // Simplices of several dimensions.
  CHECK(dimension_of(folder, "t.json", points + R"("simplices":[[0,1],[0,1,2]]})") == 2);
  CHECK(dimension_of(folder, "t.json", points + R"("simplices":[[0,1,2],[0,1,2,3]]})") == 3);
  const std::string medit =
      "MeshVersionFormatted 2 Dimension 3 Vertices 4 0 0 5 0 1 0 5 0 1 1 5 0 0 1 5 0 ";
  CHECK(dimension_of(folder, "t.mesh", medit + "Triangles 1 1 2 3 0 Tetrahedra 1 1 2 3 4 0 End") ==
        3);
  const auto domain = read_domain(
      folder.write("d.mesh", medit + "Triangles 1 1 2 3 0 Tetrahedra 1 1 2 3 4 0 End"), kDouble);
  REQUIRE(domain);
  CHECK(domain->dimension == 3);
  CHECK(domain->notes.size() == 1);  // for the vertex of the tetrahedron alone
}

TEST_CASE("only the third coordinate is left out, and only if it is exactly the same") {
  const ScratchFolder folder;
  for (const std::string points :
       {"5 0 0\n5 1 0\n5 1 1\n", "0 5 0\n1 5 0\n1 5 1\n", "0 0 1.0000000000000002\n1 0 1\n0 1 1\n",
        "0 0 1\n1 0 1.0000000000000002\n0 1 1\n", "0 0 1\n1 0 1\n0 1 1.0000000000000002\n"}) {
    const std::string off = "OFF\n3 1 0\n" + points + "3 0 1 2\n";
    CHECK(dimension_of(folder, "x.off", off) == 3);
    const auto domain = read_domain(folder.write("y.off", off), kDouble);
    CHECK(domain->dimension == 3);
    CHECK(domain->notes.empty());
  }
  CHECK(dimension_of(folder, "x.off", "OFF\n3 1 0\n0 0 -0.0\n1 0 0\n0 1 0e5\n3 0 1 2\n") == 2);
}

TEST_CASE("a domain with holes of space, or with a hole seed off its facet, stays in space") {
  const ScratchFolder folder;
  const std::string square = "4 3\n0 0 0 0\n1 9 0 0\n2 9 9 0\n3 0 9 0\n";
  const auto dimension = [&](const std::string& rest) {
    const auto domain = read_domain(folder.write("x.poly", square + rest), kDouble);
    REQUIRE_MESSAGE(domain, error_of(domain));
    return domain->dimension;
  };
  CHECK(dimension("1\n1\n4 0 1 2 3\n0\n") == 2);
  CHECK(dimension("1\n1\n4 0 1 2 3\n1\n0 1 1 1\n") == 3);
  CHECK(dimension("1\n1 1\n4 0 1 2 3\n0 1 1 0\n0\n") == 2);
  CHECK(dimension("1\n1 1\n4 0 1 2 3\n0 1 1 0.5\n0\n") == 3);
}

TEST_CASE("edges that a mesh of a plane lists are its domain, its triangles are not") {
  const ScratchFolder folder;
  const std::string text =
      "MeshVersionFormatted 2 Dimension 3 Vertices 5 0 0 0 0 1 0 0 0 1 1 0 0 0 1 0 0 0.5 0.5 0 0 "
      "Edges 4 1 2 0 2 3 0 3 4 0 4 1 0 Triangles 4 1 2 5 0 2 3 5 0 3 4 5 0 4 1 5 0 End";
  const auto domain = read_domain(folder.write("x.mesh", text), kDouble);
  REQUIRE_MESSAGE(domain, error_of(domain));
  CHECK(domain->dimension == 2);
  CHECK(domain->input.segments.size() == 4);
  CHECK(domain->input.points == kSquare);
  CHECK(domain->faces.empty());
  CHECK(as_it_stands(*domain).input.polygons.size() == 4);
}

TEST_CASE("the mesh of a flat domain is read in its plane, or in space where it is not in it") {
  const ScratchFolder folder;
  for (const std::string& path : flat_square_meshes(folder, "x", "2")) {
    CAPTURE(path);
    const auto in_plane = read_mesh({.mesh = path, .domain_dimension = 2, .domain_height = 2});
    CHECK(in_plane->mesh.dimension() == 2);
    CHECK(in_plane->mesh.simplices.size() == 2);
    const auto above =
        read_mesh({.mesh = path, .with_faces = true, .domain_dimension = 2, .domain_height = 1});
    CHECK(above->mesh.dimension() == 3);
    CHECK(above->mesh.simplices.empty());
    CHECK(above->mesh.faces.size() == 2);
    // A domain whose points have two coordinates is in no plane of space.
    CHECK(read_mesh({.mesh = path, .domain_dimension = 2})->mesh.dimension() == 2);
  }
}

TEST_CASE("points alone are taken as they stand, in every format") {
  const ScratchFolder folder;
  for (const std::string& path : flat_square_meshes(folder, "x", "0")) {
    if (path.ends_with(".ele")) continue;
    CHECK(read_points(path, kDouble)->points.dimension == 3);
  }
}

}  // namespace circumspect::formats
