// .tet: inner and outer tetrahedra, exact coordinates, what is refused. The binary form is in
// element_formats_test.cpp.
#include "oracle/formats/tet.hpp"

#include <doctest/doctest.h>

#include "oracle/formats/reading_test.hpp"

namespace circumspect::formats {
namespace {

Result<ElementFile> tet(const std::string& text) {
  return read_tet({"f", text}, NumberReading::kDouble);
}

const std::string kFourPoints = "0 0 0\n1 0 0\n0 2/3 0\n0 0 0.1\n";

}  // namespace

TEST_CASE("tet: outer tetrahedra are left out, and that is noted") {
  const auto file = tet("4 vertices\n1 inner tets\n2 outer tets\n" + kFourPoints +
                        "4 0 1 2 3\n4 0 1 2 3\n4 3 2 1 0\n");
  REQUIRE_MESSAGE(file, error_of(file));
  CHECK(file->points.points ==
        std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, Rational(2, 3), 0}, {0, 0, exact_value(0.1)}});
  CHECK(file->tetrahedra.simplices == std::vector<Simplex>{{0, 1, 2, 3}});
  CHECK(file->tetrahedra.lines == std::vector<std::size_t>{8});
  CHECK(file->notes == std::vector<std::string>{"f: 2 outer tetrahedra were left out"});
}

TEST_CASE("tet: what is refused") {
  const std::string header = "4 vertices\n1 tets\n";
  CHECK(error_of(tet("")) == "f:1: expected the number of vertices, found the end of the file");
  CHECK(error_of(tet("4 points\n")) == "f:1: expected \"vertices\", found \"points\"");
  CHECK(error_of(tet("4 vertices\n1 cells\n")) ==
        "f:2: expected \"tets\" or \"inner tets\", found \"cells\"");
  CHECK(error_of(tet("4 vertices\n1 inner tets\n1 tets\n")) ==
        "f:3: expected \"outer\", found \"tets\"");
  CHECK(error_of(tet(header + kFourPoints)) ==
        "f:6: expected the number of vertices of tetrahedron 1 of 1, found the end of the file");
  CHECK(error_of(tet(header + kFourPoints + "3 0 1 2\n")) ==
        "f:7: expected 4, the number of vertices of tetrahedron 1 of 1, found \"3\"");
  CHECK(error_of(tet(header + kFourPoints + "4 0 1 2 3\n4 0 1 2 3\n")) ==
        "f:8: expected the end of the file after the last tetrahedron, found \"4\"");
  CHECK(error_of(tet("999999999999 vertices\n1 tets\n0 0 0\n")) ==
        "f:3: expected a coordinate of vertex 2 of 999999999999, found the end of the file");
  const std::string zeros(4 * 24 + 15, '\0');
  CHECK(error_of(tet(header + zeros)) ==
        "f: expected a vertex of tetrahedron 1 of 1, found the end of the data at byte 126");
  CHECK(error_of(tet(header + zeros + std::string(3, '\0'))) ==
        "f: expected the end of the file after the last tetrahedron, found 2 more bytes at byte "
        "126");
}

}  // namespace circumspect::formats
