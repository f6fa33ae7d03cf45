// Wavefront's .obj: what is read over, what is refused and with which words.
#include "oracle/formats/obj.hpp"

#include <doctest/doctest.h>

#include "oracle/formats/reading_test.hpp"

namespace circumspect::formats {
namespace {

Result<ElementFile> obj(const std::string& text) {
  return read_obj({"f", text}, NumberReading::kDouble);
}

const std::string kThreeVertices = "v 0 0 0\nv 1 0 0 0.5\nv 0 1/3 0 1 0.5 0\n";

}  // namespace

TEST_CASE("obj: points, faces and lines; the rest is read over") {
  const auto file =
      obj("# a surface\nmtllib a.mtl\n" + kThreeVertices +
          "vt 0 0\nvn 0 0 nan\nusemtl a b\ns off\nf 1/1/1 2//1 3/2\nl 1 2 3\nv 0 0 1\n"
          "f -1 -2 \\\n -3 -4\np 1\nf 1 2 -1\n");
  REQUIRE_MESSAGE(file, error_of(file));
  CHECK(file->points.points ==
        std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, Rational(1, 3), 0}, {0, 0, 1}});
  CHECK(file->points.first_index == 1);
  CHECK(file->triangles.simplices == std::vector<Simplex>{{1, 2, 3}, {1, 2, 4}});
  CHECK(file->triangles.lines == std::vector<std::size_t>{10, 16});
  CHECK(file->edges.simplices == std::vector<Simplex>{{1, 2}, {2, 3}});
  CHECK(file->polygons.simplices == std::vector<Simplex>{{4, 3, 2, 1}});
  CHECK(check_simplices(*file, "f").error().to_string() ==
        "f:13: expected edges, triangles and tetrahedra, found a face of 4 vertices");
}

TEST_CASE("obj: what is refused") {
  CHECK(error_of(obj(kThreeVertices + "f 1 2\n")) ==
        "f:4: expected a face of 3 vertices or more, found 2");
  CHECK(error_of(obj(kThreeVertices + "l 1\n")) ==
        "f:4: expected a line of 2 vertices or more, found 1");
  CHECK(error_of(obj(kThreeVertices + "f 1 2 0\n")) ==
        "f:4: expected a vertex, counted from 1, or back from -1, found \"0\"");
  CHECK(error_of(obj(kThreeVertices + "f 1 2 -4\n")) ==
        "f:4: expected one of the 3 vertices so far, found \"-4\"");
  CHECK(error_of(obj(kThreeVertices + "f 1 2 -9223372036854775808\n")) ==
        "f:4: expected one of the 3 vertices so far, found \"-9223372036854775808\"");
  CHECK(error_of(obj(kThreeVertices + "f 1 2 a\n")) ==
        "f:4: expected a vertex, an integer that fits 64 bits, found \"a\"");
  CHECK(error_of(obj("v 0 0\n")) == "f:1: expected 3 coordinates, found 2");
  CHECK(error_of(obj("v 0 0 inf\n")) == "f:1: expected a finite number, found \"inf\"");
  CHECK(error_of(obj("v 0 0 0 red\n")) == "f:1: expected a finite number, found \"red\"");
  CHECK(error_of(obj("v 0 0 \\\n\\\n x\nv 0 0 y\n")) ==
        "f:1: expected a finite number, found \"x\"");
  CHECK(error_of(obj("v 0 0 \\\n\\\n 0\nv 0 0 y\n")) ==
        "f:4: expected a finite number, found \"y\"");
  CHECK(error_of(obj("curv 0 1 1 2\n")) ==
        "f:1: expected a point (v), a face (f), a line (l) or what may be read over, found "
        "\"curv\"");
}

TEST_CASE("obj: a point that is not there is the mesh's or the domain's fault") {
  const auto file = obj(kThreeVertices + "f 1 2 7\n");
  REQUIRE(file);
  CHECK(domain_of(*file, "f").error().to_string() == "f:4: expected a vertex from 1 to 3, found 7");
}

}  // namespace circumspect::formats
