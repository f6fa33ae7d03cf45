#include "fuzz/campaign/domain_text.hpp"

#include <string>

#include <doctest/doctest.h>

#include "fuzz/campaign/input.hpp"
#include "inputs/named_complexes.hpp"
#include "inputs/scratch_folder_test.hpp"
#include "oracle/formats/domain_file.hpp"
#include "oracle/formats/read_domain.hpp"

namespace circumspect::campaign {
namespace {

// A square, and vertices at (1, 1, 0), (2, 1, 0) and (3, 3, 1).
PiecewiseLinearInput square() {
  PiecewiseLinearInput input;
  input.points = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {1, 1, 0}, {2, 1, 0}, {3, 3, 1}};
  input.polygons = {{{{0, 1, 2, 3}}, {}}};
  return input;
}

std::string facets_of(const PiecewiseLinearInput& input) {
  const std::string text = poly_text(input, 0);
  const std::size_t end_of_points = text.find("\n6 3 3 1\n") + 9;
  return text.substr(end_of_points);
}

TEST_CASE("a facet lists the segments and vertices that lie in it") {
  PiecewiseLinearInput input = square();
  CHECK(facets_of(input) == "1 0\n3 0\n4 0 1 2 3\n1 4\n1 5\n0\n");
  input.segments = {{4, 5}, {0, 4}, {5, 6}};
  CHECK(facets_of(input) ==
        "4 0\n3 0\n4 0 1 2 3\n2 0 4\n2 4 5\n1 0\n2 4 5\n1 0\n2 0 4\n1 0\n2 5 6\n0\n");
  // Cells that are already listed are not listed again.
  input.polygons[0].lines.insert(input.polygons[0].lines.end(), {{4, 5}, {0, 4}});
  CHECK(facets_of(input) ==
        "4 0\n3 0\n4 0 1 2 3\n2 4 5\n2 0 4\n1 0\n2 4 5\n1 0\n2 0 4\n1 0\n2 5 6\n0\n");
}

TEST_CASE("a domain that is none is written as it stands") {
  PiecewiseLinearInput input = square();
  input.segments = {{0, 2}, {1, 3}};
  CHECK(facets_of(input) == "3 0\n1 0\n4 0 1 2 3\n1 0\n2 0 2\n1 0\n2 1 3\n0\n");
}

TEST_CASE("domains as Gmsh reads them, if they are one closed surface") {
  PiecewiseLinearInput box = generators::box(0, 1);
  const auto text = geo_text(box);
  REQUIRE(text);
  CHECK(text->find("Line(12) = ") != std::string::npos);
  CHECK(text->find("Surface Loop(1) = {1,2,3,4,5,6};") != std::string::npos);
  box.polygons.pop_back();
  CHECK(!geo_text(box));
}

// Every format is read back by the reader of domains, and holds the same faces.
TEST_CASE("surfaces are files of five kinds, of triangles in two of them") {
  const formats::ScratchFolder folder;
  PiecewiseLinearInput tetrahedron;
  tetrahedron.points = {{0, 0, 0}, {0.5, 0, 0}, {0, 0.1, 0}, {0, 0, 3}};
  for (const std::vector<Vertex>& face :
       {std::vector<Vertex>{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}) {
    tetrahedron.polygons.push_back({{face}, {}});
  }
  for (const std::string extension : {".off", ".obj", ".ply", ".stl", ".msh"}) {
    CAPTURE(extension);
    REQUIRE(is_surface_extension(extension));
    const auto text = surface_text(tetrahedron, extension);
    REQUIRE(text);
    const auto read =
        formats::read_domain(folder.write("x" + extension, *text), NumberReading::kDouble);
    REQUIRE(read);
    CHECK(read->input.points == tetrahedron.points);
    REQUIRE(read->input.polygons.size() == 4);
    for (std::size_t i = 0; i < 4; ++i) {
      CHECK(read->input.polygons[i].lines == tetrahedron.polygons[i].lines);
    }
    PiecewiseLinearInput with_segment = tetrahedron;
    with_segment.points.push_back({1, 1, 1});
    CHECK(!surface_text(with_segment, extension));
    const bool of_triangles = extension == ".stl" || extension == ".msh";
    CHECK(surface_text(generators::box(0, 1), extension).has_value() != of_triangles);
  }
}

TEST_CASE("a text that is not a sequence of updates is none") {
  const std::string head = "2 2 0 0 0 0 1\n0 0\n1 0\n";
  CHECK(read_updates(head + "delete 1\n"));
  for (const char* const wrong :
       {"delete 2\n", "delete\n", "delete 1 1\n", "insert 1\n", "insert 1 0\n", "insert 1 2 3\n",
        "insert 1 x\n", "move 1\n", "", "delete 1\nrestore\n"}) {
    CAPTURE(wrong);
    CHECK(!read_updates(head + wrong));
  }
  for (const char* const wrong :
       {"", "1 2 0 0 0 0\n0 0\n", "0 0 0 0 0 0 0\n", "1 2 0 0 0 0 0 0\n1 1\n", "-1 2 0 0 0 0 0\n",
        "99999999999 2 0 0 0 0 0\n1 1\n"}) {
    CAPTURE(wrong);
    CHECK(!read_updates(wrong));
  }
}

}  // namespace
}  // namespace circumspect::campaign
