// Surfaces and lines: OFF, STL, PLY and OBJ.

#include <algorithm>

#include <doctest/doctest.h>

#include "oracle/formats/element_domain.hpp"
#include "oracle/formats/format.hpp"
#include "oracle/formats/obj.hpp"
#include "oracle/formats/ply.hpp"
#include "oracle/formats/reading_test.hpp"
#include "oracle/formats/stl.hpp"

namespace circumspect::formats {

// STL and PLY, in text and binary: what is read, what is refused, and the messages.

namespace {

using VertexList = std::vector<Vertex>;

Result<DomainFile> stl(const std::string& text) { return read_stl({"f", text}, kDouble); }
Result<DomainFile> ply(const std::string& text) { return read_ply({"f", text}, kDouble); }

std::string facet(const std::string& a, const std::string& b, const std::string& c) {
  return "facet normal 0 0 nan\n outer loop\n  vertex " + a + "\n  vertex " + b + "\n  vertex " +
         c + "\n endloop\nendfacet\n";
}

// The bytes of a number, with the least or the most significant first.
std::string bytes(std::uint64_t value, int size, bool big_endian = false) {
  std::string text;
  for (int i = 0; i < size; ++i) {
    const int place = big_endian ? size - 1 - i : i;
    text += static_cast<char>(value >> (8 * place));
  }
  return text;
}

constexpr std::uint64_t kZero = 0;
constexpr std::uint64_t kOne = 0x3f800000;    // 1 as a float of 32 bits
constexpr std::uint64_t kThird = 0x3eaaaaab;  // 11184811 / 2^25
constexpr std::uint64_t kNan = 0x7fc00000;

std::string binary_triangle(const std::vector<std::uint64_t>& corners) {
  std::string text(12, '\xff');
  for (const std::uint64_t x : corners) text += bytes(x, 4);
  return text + "\x01\x02";
}

std::string binary_stl(std::uint64_t count, const std::string& triangles) {
  return "solid no text" + std::string(67, ' ') + bytes(count, 4) + triangles;
}

const std::string kPlyHeader =
    "ply\nformat ascii 1.0\ncomment made # by hand\nelement vertex 4\nproperty uchar red\n"
    "property double x\nproperty float y\nproperty int z\nelement edge 1\nproperty list uchar int "
    "a\nelement face 2\nproperty float quality\nproperty list uchar int vertex_indices\n"
    "end_header\n";

// Two points and one face in binary.
std::string binary_ply(bool big_endian) {
  const auto number = [big_endian](std::uint64_t value, int size) {
    return bytes(value, size, big_endian);
  };
  std::string text = std::string("ply\nformat binary_") + (big_endian ? "big" : "little") +
                     "_endian 1.0\nelement vertex 3\nproperty float x\nproperty short y\n"
                     "property double z\nelement face 1\nproperty list uchar uint vertex_index\n"
                     "property list ushort short other\nend_header\n";
  text += number(kZero, 4) + number(0, 2) + number(0, 8);
  text += number(kThird, 4) + number(0xfffe, 2) + number(0x3ff8000000000000, 8);
  text += number(kOne, 4) + number(7, 2) + number(0, 8);
  return text + number(3, 1) + number(0, 4) + number(1, 4) + number(2, 4) + number(2, 2) +
         number(1, 2) + number(2, 2);
}

}  // namespace

TEST_CASE("stl in text: equal corners are one point, and that is said") {
  const auto file = stl("solid two words\n" + facet("0 0 0", "1 0 0", "0 1 0") +
                        facet("-0 0.0 0", "0 1 0", "0 0 1e0") + "endsolid\nSOLID b\nEndSolid b\n");
  REQUIRE_MESSAGE(file, error_of(file));
  CHECK(file->input.points == std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  REQUIRE(file->input.polygons.size() == 2);
  CHECK(file->input.polygons[1].lines == std::vector<VertexList>{{0, 2, 3}});
  CHECK(file->polygon_lines == std::vector<std::size_t>{2, 9});
  CHECK(file->notes == std::vector<std::string>{"f: 6 corners of triangles merged into 4 points"});
}

TEST_CASE("stl: a solid ends in the ways of Mathematica and others, which is noted") {
  const std::string one = facet("0 0 0", "1 0 0", "0 1 0");
  const auto joined =
      stl("solid a\n" + one + "endsolidCreated with a program\nSOLID b\n" + one + "End Solid b\n");
  REQUIRE_MESSAGE(joined, error_of(joined));
  CHECK(joined->input.polygons.size() == 2);
  CHECK(joined->notes ==
        std::vector<std::string>{"f:9: \"endsolidCreated\" was read as \"endsolid\"",
                                 "f: 6 corners of triangles merged into 3 points"});
  const auto apart = stl("solid\n" + one + "end solid\n");
  REQUIRE_MESSAGE(apart, error_of(apart));
  CHECK(apart->notes == std::vector<std::string>{"f:9: \"end solid\" was read as \"endsolid\""});
  CHECK(stl("solid\n" + one + "ENDSOLID a\n")->notes.empty());
  CHECK(error_of(stl("solid\n" + one + "end\n")) ==
        "f:9: expected \"facet\" or \"endsolid\", found \"end\"");
  CHECK(error_of(stl("solid\n" + one + "endsoli d\n")) ==
        "f:9: expected \"facet\" or \"endsolid\", found \"endsoli\"");
}

TEST_CASE("stl: what is left of triangles with equal corners is noted") {
  const auto file =
      stl("solid\n" + facet("0 0 0", "1 0 0", "0 0 0") + facet("0 1 0", "0 1 0", "1 0 0") +
          facet("5 5 5", "5 5 5", "5 5 5") + "endsolid\n");
  REQUIRE_MESSAGE(file, error_of(file));
  CHECK(file->input.polygons.empty());
  CHECK(file->input.segments == std::vector<VertexList>{{0, 1}, {2, 1}});
  CHECK(file->notes.back() ==
        "f: 3 triangles with equal corners read as the segments that they are");
}

TEST_CASE("stl as a mesh: equal corners are one vertex, near ones are not, no triangle vanishes") {
  const auto file = read_stl_elements(
      {"f", "solid\n" + facet("0 0 0", "1 0 0", "0 1 0") + facet("-0 0 0", "0 1 0", "0 0 1e-300") +
                facet("0 1 0", "0 1 0", "1 0 0") + "endsolid\n"},
      kDouble);
  REQUIRE_MESSAGE(file, error_of(file));
  CHECK(file->points.points.size() == 4);
  CHECK(file->triangles.simplices == std::vector<Simplex>{{0, 1, 2}, {0, 2, 3}, {2, 2, 1}});
  CHECK(file->triangles.lines[2] == 16);
  CHECK(file->notes == std::vector<std::string>{"f: 9 corners of triangles merged into 4 points"});
}

TEST_CASE("stl in text: what is refused") {
  const std::string good = facet("0 0 0", "1 0 0", "0 1 0");
  CHECK(error_of(stl("solid\n" + good)) ==
        "f:8: expected \"facet\" or \"endsolid\", found the end of the file");
  CHECK(error_of(stl("solid\n" + good + "endsolid\nfoo\n")) ==
        "f:10: expected \"solid\" or the end of the file, found \"foo\"");
  CHECK(error_of(stl("solid\n" + facet("0 0 0", "1 0", "0 1 0") + "endsolid\n")) ==
        "f:5: expected \"vertex\" and 3 coordinates, found 2 of them");
  CHECK(error_of(stl("solid\n" + facet("0 0 0", "1 0 nan", "0 1 0") + "endsolid\n")) ==
        "f:5: expected a finite number, found \"nan\"");
  CHECK(error_of(stl("solid\nfacet normal 0 0 1\nouter loop 1\n")) ==
        "f:3: expected the end of the line, found \"1\"");
  CHECK(error_of(stl("solid\nfacet normal 0 0 1\nouter\n")) ==
        "f:3: expected \"loop\", found the end of the line");
  CHECK(error_of(stl("")) ==
        "f: expected \"solid\", or 80 bytes and the number of triangles of a "
        "binary STL file, found 0 bytes");
}

TEST_CASE("stl in binary, even where it begins with \"solid\"") {
  const std::string one = binary_triangle({0, 0, 0, kThird, 0, 0, 0, kOne, 0});
  const auto file = stl(binary_stl(1, one));
  REQUIRE_MESSAGE(file, error_of(file));
  CHECK(file->input.points ==
        std::vector<Point>{{0, 0, 0}, {Rational(11184811, 33554432), 0, 0}, {0, 1, 0}});
  CHECK(file->notes.empty());
  CHECK(error_of(stl("S" + binary_stl(2, one).substr(1))) ==
        "f: expected triangle 2 of 2, found the end of the file at byte 134");
  CHECK(error_of(stl("S" + binary_stl(0xffffffff, one).substr(1))) ==
        "f: expected triangle 2 of 4294967295, found the end of the file at byte 134");
  CHECK(error_of(stl("S" + binary_stl(1, one + "x").substr(1))) ==
        "f: expected the end of the file after 1 triangles, found 1 more bytes");
  CHECK(error_of(stl(binary_stl(1, binary_triangle({0, 0, 0, kNan, 0, 0, 0, kOne, 0})))) ==
        "f: expected finite coordinates of triangle 1 of 1, found NaN or an infinity at byte "
        "108");
}

TEST_CASE("stl in binary is told by its size, whatever its header says") {
  const std::string one = binary_triangle({0, 0, 0, kThird, 0, 0, 0, kOne, 0});
  const std::string two = "COLOR=\x7f" + binary_stl(2, one + one).substr(7);
  CHECK(is_binary_stl(two));
  for (std::size_t size = 0; size < two.size(); ++size) CHECK(!is_binary_stl(two.substr(0, size)));
  CHECK(!is_binary_stl(two + one));
  CHECK(!is_binary_stl(binary_stl(0, "")));
  CHECK(!is_binary_stl(binary_stl(0xffffffff, one)));
  const Format* const format = told_format(named(two), &Format::has_mesh);
  REQUIRE(format != nullptr);
  CHECK(format->endings.front() == ".stl");
}

TEST_CASE("ply in text: other elements and properties are read over") {
  const auto file =
      ply(kPlyHeader + "255 0 0 0\n0 1 0 0\n0 0 1/2 0\n0 0 0 1\n2 5 6\n0.5 3 0 1 2\n1 4 0 1 2 3\n");
  REQUIRE_MESSAGE(file, error_of(file));
  CHECK(file->input.points ==
        std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, Rational(1, 2), 0}, {0, 0, 1}});
  REQUIRE(file->input.polygons.size() == 2);
  CHECK(file->input.polygons[1].lines == std::vector<VertexList>{{0, 1, 2, 3}});
  CHECK(file->polygon_lines == std::vector<std::size_t>{20, 21});
}

TEST_CASE("ply in binary, of either byte order") {
  for (const bool big_endian : {false, true}) {
    const std::string text = binary_ply(big_endian);
    const auto file = ply(text);
    REQUIRE_MESSAGE(file, error_of(file));
    CHECK(file->input.points ==
          std::vector<Point>{
              {0, 0, 0}, {Rational(11184811, 33554432), -2, Rational(3, 2)}, {1, 7, 0}});
    CHECK(file->input.polygons.front().lines == std::vector<VertexList>{{0, 1, 2}});
    CHECK(error_of(ply(text + "x")) ==
          "f: expected the end of the file after the last element, found 1 more bytes at byte " +
              std::to_string(text.size()));
    const auto cut = [&](std::size_t size) { return error_of(ply(text.substr(0, size))); };
    const std::string face = "f: expected face 1 of 1, found the end of the file at byte ";
    CHECK(cut(text.size() - 1).starts_with(face));
    CHECK(cut(text.size() - 18).starts_with(face));
    const std::size_t data = text.find("end_header\n") + 11;
    CHECK(cut(data) ==
          "f: expected vertex 1 of 3, found the end of the file at byte " + std::to_string(data));
  }
}

TEST_CASE("ply: lines that end with a carriage return alone, or with one too many") {
  const std::string text =
      kPlyHeader + "255 0 0 0\n0 1 0 0\n0 0 1/2 0\n0 0 0 1\n2 5 6\n0.5 3 0 1 2\n1 4 0 1 2 3\n";
  const auto with_ends = [](const std::string& lines, const std::string& end) {
    std::string other;
    for (const char c : lines) other += c == '\n' ? end : std::string(1, c);
    return other;
  };
  for (const std::string end : {"\r", "\r\n", "\r\r\n"}) {
    CAPTURE(end);
    const auto file = ply(with_ends(text, end));
    REQUIRE_MESSAGE(file, error_of(file));
    CHECK(file->input.points == ply(text)->input.points);
    CHECK(file->polygon_lines == std::vector<std::size_t>{20, 21});
  }
  CHECK(error_of(ply(with_ends(text, "\r") + "5")) ==
        "f:22: expected the end of the file after the last element, found \"5\"");
  // Binary numbers may begin with the byte of a line end.
  const std::string binary = binary_ply(false);
  const std::size_t begin = binary.find("end_header\n") + 11;
  const auto file = ply(with_ends(binary.substr(0, begin), "\r") + binary.substr(begin));
  REQUIRE_MESSAGE(file, error_of(file));
  CHECK(file->input.points == ply(binary)->input.points);
}

TEST_CASE("ply: a cloud of points, and a surface as elements") {
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\n"
      "property double y\nproperty double z\nproperty uchar red\n";
  const Source cloud{"f", header + "end_header\n0 0 0 9\n1/3 0 0 9\n0 1 0 9\n"};
  const auto points = read_ply_file(cloud, kDouble);
  REQUIRE(points);
  CHECK(points->points.points == std::vector<Point>{{0, 0, 0}, {Rational(1, 3), 0, 0}, {0, 1, 0}});
  CHECK(points->faces.simplices.empty());
  CHECK(error_of(read_ply(cloud, kDouble)) ==
        "f:8: expected elements vertex and face, found no element face");
  const auto with_face = [&](const std::string& face) {
    return read_ply_elements({"f", header +
                                       "element face 1\nproperty list uchar int vertex_index\n"
                                       "end_header\n0 0 0 9\n1 0 0 9\n0 1 0 9\n" +
                                       face},
                             kDouble);
  };
  CHECK(with_face("3 0 1 2\n")->triangles.simplices == std::vector<Simplex>{{0, 1, 2}});
  CHECK(with_face("2 0 1\n").error().to_string() ==
        "f:14: expected a face of 3 vertices or more, found 2");
  CHECK(read_ply_file(
            {"f", "ply\nformat ascii 1.0\nelement dot 1\nproperty int x\nend_header\n1\n"}, kDouble)
            .error()
            .to_string() == "f:5: expected an element vertex, found no element vertex");
}

TEST_CASE("ply: coordinates may come in any order") {
  const std::string begin = "ply\nformat ascii 1.0\nelement vertex 1\n";
  std::string axes = "xyz";
  do {
    std::string text = begin, numbers;
    for (const char axis : axes) {
      text += std::string("property double ") + axis + "\n";
      numbers += std::to_string(axis - 'x' + 5) + " ";
    }
    const auto points = read_ply_file({"f", text + "end_header\n" + numbers + "\n"}, kDouble);
    REQUIRE_MESSAGE(points, error_of(points));
    CHECK(points->points.points == std::vector<Point>{{5, 6, 7}});
  } while (std::next_permutation(axes.begin(), axes.end()));
}

TEST_CASE("ply: strips of triangles, each turned as the first") {
  const auto with_strips = [](const std::string& strips) {
    return read_ply_elements(
        {"f",
         "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\n"
         "property float z\nelement tristrips 1\nproperty list int int vertex_indices\n"
         "end_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n2 0 0\n2 1 0\n" +
             strips},
        kDouble);
  };
  CHECK(with_strips("9 0 1 2 3 -1 4 5 3 -1\n")->triangles.simplices ==
        std::vector<Simplex>{{0, 1, 2}, {2, 1, 3}, {4, 5, 3}});
  CHECK(with_strips("5 -1 0 1 -1 2\n")->triangles.simplices.empty());
}

TEST_CASE("ply: what is refused") {
  const auto with = [](const std::string& body) {
    return error_of(ply("ply\nformat ascii 1.0\n" + body));
  };
  const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
  const std::string vertex = "element vertex 1\n" + xyz;
  const std::string face = "element face 1\nproperty list uchar int vertex_indices\n";
  CHECK(with(vertex + "element face 1\nproperty float quality\nproperty list uchar int "
                      "vertex_indices\nend_header\n0 0 0\n5\n") ==
        "f:12: expected the number of values of a list, found the end of the line");
  CHECK(error_of(ply("plz\n")) == "f:1: expected the keyword ply, found \"plz\"");
  CHECK(error_of(ply("ply\nformat ascii 2.0\n")) == "f:2: expected version 1.0, found \"2.0\"");
  CHECK(error_of(ply("ply\nformat binary 1.0\n")) ==
        "f:2: expected ascii, binary_little_endian or binary_big_endian, found \"binary\"");
  CHECK(with("property int x\n") ==
        "f:3: expected \"element\" before the first property, found \"property\"");
  CHECK(with("element vertex -1\n") ==
        "f:3: expected the number of elements, 0 or more, found \"-1\"");
  CHECK(with("element vertex 1\nproperty real x\n") ==
        "f:4: expected a type (char, uchar, short, ushort, int, uint, float, double), found "
        "\"real\"");
  CHECK(with("element face 1\nproperty list float int vertex_indices\n") ==
        "f:4: expected the type of a count, an integer type, found \"float\"");
  CHECK(with(vertex + face) == "f:8: expected \"end_header\", found the end of the file");
  CHECK(with(vertex + "end_header\n") ==
        "f:7: expected elements vertex and face, found no element face");
  CHECK(with("element vertex 1\nend_header\n") ==
        "f:4: expected a property of each element, found none of \"vertex\"");
  CHECK(with(vertex + face + "end_header\n0 0 0\n3 0 0 1\n") ==
        "f:11: expected a vertex from 0 to 0, found 1");
  CHECK(with(vertex + face + "end_header\n0 0\n") ==
        "f:10: expected a coordinate, found the end of the line");
  CHECK(with(vertex + face + "end_header\n0 0 0\n3 0 0\n") ==
        "f:11: expected a vertex, found the end of the line");
  CHECK(with(vertex + face + "end_header\n0 0 0\n0\n") ==
        "f:11: expected a face of at least 1 vertex, found none");
  CHECK(with(vertex + face + "end_header\n0 0 0\n") ==
        "f:10: expected face 1 of 1, found the end of the file");
  CHECK(with(vertex + face + face + "end_header\n0 0 0\n1 0\n1 0\n") ==
        "f:11: expected one element face, or tristrips, with a list of integers vertex_indices, "
        "found two elements");
  CHECK(with(vertex + "element face 1\nproperty list uchar float vertex_indices\nend_header\n") ==
        "f:9: expected one element face, or tristrips, with a list of integers vertex_indices, "
        "found another element face");
  CHECK(with("element edge 1\nproperty list uchar int both\n" + vertex + face +
             "end_header\n3 0 0\n") == "f:12: expected 3 values, found the end of the line");
}

// Wavefront's .obj: what is skipped, what is refused, and the messages.

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

TEST_CASE("obj: points of the plane may have two coordinates") {
  const auto file = obj("v 0 0\nv 1 0\nv 0 1/3\nf 1 2 3\n");
  REQUIRE_MESSAGE(file, error_of(file));
  CHECK(file->points.points == std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, Rational(1, 3), 0}});
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
  CHECK(error_of(obj("v 0\n")) == "f:1: expected 3 coordinates, found 1");
  CHECK(error_of(obj("v 0 0 0\nv 0 0\n")) == "f:2: expected 3 coordinates, found 2");
  CHECK(error_of(obj("v 0 0\nv 0 0 0\n")) ==
        "f:2: expected 2 coordinates, as of the points before, found 3");
  CHECK(error_of(obj("v 0 0 inf\n")) == "f:1: expected a finite number, found \"inf\"");
  CHECK(error_of(obj("v 0 0 0 red\n")) == "f:1: expected a finite number, found \"red\"");
  CHECK(error_of(obj("v 0 0 nan 1 1 1\n")) == "f:1: expected a finite number, found \"nan\"");
  CHECK(error_of(obj("v 0 0 0 nan -nan NaN\nf\n")).starts_with("f:2:"));  // colours
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
