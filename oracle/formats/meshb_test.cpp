// Medit's binary form: what is read, what is refused, and the messages.
#include "oracle/formats/meshb.hpp"

#include <doctest/doctest.h>

#include "oracle/formats/reading_test.hpp"
#include "oracle/formats/written_elements_test.hpp"

namespace circumspect::formats {
namespace {

using enum ByteOrder;

const WrittenMesh kTetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0.5}},
                               {{0, 1, 2, 3}, {0, 1, 2}, {2, 3}}};

Result<ElementFile> read_bytes(const std::string& bytes) {
  return read_meshb(named(bytes), kDouble);
}

}  // namespace

TEST_CASE("meshb: points, cells and references, in every version and byte order") {
  for (const std::size_t version : {1, 2, 3, 4}) {
    for (const ByteOrder order : {kLittleEndian, kBigEndian}) {
      CAPTURE(version);
      const std::string bytes = meshb(kTetrahedron, order, version);
      CHECK(is_meshb(bytes));
      const auto file = read_bytes(bytes);
      REQUIRE(file);
      CHECK(file->points.points.points() ==
            std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, Rational(1, 2)}});
      CHECK(file->points.first_index == 1);
      CHECK(file->tetrahedra.simplices[0] == Simplex{1, 2, 3, 4});
      CHECK(file->tetrahedra.labels == std::vector<Vertex>{7});
      CHECK(file->triangles.simplices[0] == Simplex{1, 2, 3});
      CHECK(file->edges.simplices[0] == Simplex{3, 4});
      CHECK(file->notes.empty());
    }
  }
}

TEST_CASE("meshb: the plane, and no other dimension than two or three") {
  const auto plane = read_bytes(meshb({{{0, 0}, {1, 0}, {0, 0.5}}, {{0, 1, 2}}}, kBigEndian, 2));
  REQUIRE_MESSAGE(plane, error_of(plane));
  CHECK(plane->points.dimension == 2);
  CHECK(plane->points.points.points() == std::vector<Point>{{0, 0}, {1, 0}, {0, Rational(1, 2)}});
  CHECK(plane->triangles.simplices[0] == Simplex{1, 2, 3});
  CHECK(error_of(read_bytes(meshb({{{0}, {1}}, {{0, 1}}}, kBigEndian, 2))) ==
        "f: expected dimension 2 or 3, found 1");
  CHECK(error_of(read_bytes(meshb({{{0, 0, 0, 0}}, {}}, kBigEndian, 2))) ==
        "f: expected dimension 2 or 3, found 4");
}

TEST_CASE("meshb: an end without the section End is noted") {
  const std::string whole = meshb(kTetrahedron, kLittleEndian, 2);
  const std::string without = whole.substr(0, whole.size() - 8);
  const auto file = read_bytes(without);
  REQUIRE(file);
  CHECK(file->edges.simplices.size() == 1);
  REQUIRE(file->notes.size() == 1);
  CHECK(file->notes[0] == "f: no section End; if the file was cut off, it is between sections");
}

// With another number of 4 bytes at that place.
std::string changed(std::string bytes, std::size_t at, std::uint64_t value) {
  return bytes.replace(at, 4, stored(value, 4, kLittleEndian));
}

TEST_CASE("meshb: sections of other kinds are skipped, and indices may name no vertex") {
  const std::string whole = meshb(kTetrahedron, kLittleEndian, 2);
  for (const std::uint64_t code : {99, 0}) {  // 0 is the code of no section
    const auto skipped = read_bytes(changed(whole, 144, code));
    REQUIRE(skipped);
    CHECK(skipped->tetrahedra.simplices.size() == 1);
  }
  const auto unknown = read_bytes(changed(whole, 172, 0xFFFFFFFF));
  REQUIRE(unknown);
  CHECK(unknown->tetrahedra.simplices[0] == Simplex{-1, 2, 3, 4});
}

TEST_CASE("meshb: faults") {
  const std::string whole = meshb(kTetrahedron, kLittleEndian, 2);
  const auto with = [&](std::size_t at, std::uint64_t value) {
    return error_of(read_bytes(changed(whole, at, value)));
  };
  CHECK(error_of(read_bytes("")) ==
        "f: expected the integer 1 and a version from 1 to 4, of 4 bytes each, found \"\"");
  CHECK(with(4, 5) ==
        "f: expected the integer 1 and a version from 1 to 4, of 4 bytes each, found "
        "\"\\x01\\x00\\x00\\x00\\x05\\x00\\x00\\x00\"");
  for (const std::size_t at : {0, 4}) {
    CHECK(with(at, 0).starts_with("f: expected the integer 1 and a version from 1 to 4"));
  }
  CHECK(with(16, 4) == "f: expected dimension 2 or 3, found 4");
  CHECK(with(8, 99) == "f: expected the section Dimension before Vertices, found Vertices");
  CHECK(with(20, 3) == "f: expected one section Dimension, found another");
  CHECK(with(28, 5) ==
        "f: expected 5 vertices of 28 bytes, found 112 bytes up to the next section");
  CHECK(with(28, 3) ==
        "f: expected 3 vertices of 28 bytes, found 112 bytes up to the next section");
  CHECK(with(36, 0x7FF00000) == "f: expected a finite number for vertex 1 of 4, found infinity");
  CHECK(with(36, 0x7FF80000) == "f: expected a finite number for vertex 1 of 4, found NaN");
  CHECK(with(144, 4) == "f: expected one section Vertices, found another");
  CHECK(with(24, 145) ==
        "f: expected 4 vertices of 28 bytes, found 113 bytes up to the next section");
  CHECK(with(12, 21) == "f: expected the dimension, of 4 bytes, found another section");
  CHECK(with(148, 99999).ends_with(" at byte 148, found 99999"));
  CHECK(with(12, 19) == "f: expected the dimension, of 4 bytes, found another section");
  CHECK(with(12, 15) == "f: expected the place of the next section, from byte 16 to " +
                            std::to_string(whole.size()) + ", at byte 12, found 15");
  CHECK(error_of(read_bytes(whole.substr(0, 20))) == "f: expected a section Vertices, found none");
  CHECK(error_of(read_bytes(whole.substr(0, 22))) ==
        "f: expected a section, or End, at byte 20, found the end of the file");
}

}  // namespace circumspect::formats
