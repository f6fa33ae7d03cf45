// The text formats: each as it is written, and the messages for files that are wrong.
#include <sstream>

#include <doctest/doctest.h>

#include "oracle/formats/off.hpp"
#include "oracle/formats/point_file.hpp"
#include "oracle/formats/point_lists.hpp"
#include "oracle/formats/qhull.hpp"
#include "oracle/formats/reading_test.hpp"
#include "oracle/formats/tetgen.hpp"

namespace circumspect::formats {

// Every text format: what is read, what is refused, and the messages.

namespace {

constexpr NumberReading kDecimal = NumberReading::kDecimal;

std::string node_error(const std::string& text, NumberReading reading = kDouble) {
  return error_of(read_node(named(text), reading));
}
std::string ele_error(const std::string& text) { return error_of(read_ele(named(text))); }
std::string off_error(const std::string& text) { return error_of(read_off(named(text), kDouble)); }
std::string qhull_error(const std::string& text) {
  return error_of(read_qhull_points(named(text), kDouble));
}

template <class File, class Write>
std::string text_written(const File& file, Write write) {
  std::ostringstream out;
  write(out, file);
  return out.str();
}

}  // namespace

TEST_CASE("node: indices from 1, comments, tabs, CRLF, attributes, markers, no last newline") {
  const auto file = read_node(
      named("# made by hand\r\n\r\n2 3 1 1 # header\r\n1\t0 0.5 -1e2\t1/3 7\r\n  2 1 2 3 4 -1#"),
      kDouble);
  REQUIRE(file);
  CHECK(file->dimension == 3);
  CHECK(file->first_index == 1);
  CHECK(file->points == std::vector<Point>{{0, Rational(1, 2), -100}, {1, 2, 3}});
  CHECK(file->attributes == std::vector<std::vector<Rational>>{{Rational(1, 3)}, {4}});
  CHECK(file->markers == std::vector<std::string>{"7", "-1"});
  CHECK(read_node(named("1 2\n0\v3\f4"), kDouble)->points == std::vector<Point>{{3, 4}});
}

TEST_CASE("node: a short header, any first index, no points, a byte order mark") {
  const auto plane = read_node(named("1 2\n0 3 4"), kDouble);
  REQUIRE(plane);
  CHECK(plane->first_index == 0);
  CHECK(plane->points == std::vector<Point>{{3, 4}});
  CHECK(plane->attributes.empty());
  CHECK(plane->markers.empty());
  CHECK(read_node(named("1 2\n-7 3 4"), kDouble)->first_index == -7);
  CHECK(read_node(named("0 2 0 0\n"), kDouble)->points.empty());
  CHECK(read_node(named("0 2 0 0\n"), kDouble)->first_index == 0);
  CHECK(read_node(named("\xEF\xBB\xBF"
                        "1 1\n0 5\n"),
                  kDouble)
            ->points.size() == 1);
}

TEST_CASE("node: 0.1 as a double and at its word") {
  CHECK(read_node(named("1 1\n0 0.1"), kDecimal)->points[0][0] == Rational(1, 10));
  CHECK(read_node(named("1 1\n0 0.1"), kDouble)->points[0][0] == exact_value(0.1));
}

TEST_CASE("node: headers that cannot be") {
  const std::string header = "a header \"points dimension [attributes [markers]]\"";
  CHECK(node_error("") == "f:1: expected " + header + ", found the end of the file");
  CHECK(node_error(" \n\t\n# only this\n") ==
        "f:3: expected " + header + ", found the end of the file");
  CHECK(node_error("4") == "f:1: expected " + header + ", found the end of the line");
  CHECK(node_error("4 2 0 0 9") ==
        "f:1: expected " + header + " and the end of the line, found \"9\"");
  CHECK(node_error("four 2") == "f:1: expected the number of points, an integer, found \"four\"");
  CHECK(node_error("-3 2") == "f:1: expected the number of points, 0 or more, found \"-3\"");
  CHECK(node_error("99999999999999999999 2") ==
        "f:1: expected the number of points, an integer that fits 64 bits, found "
        "\"99999999999999999999\"");
  CHECK(node_error("1 0") == "f:1: expected a dimension from 1 to 16, found \"0\"");
  CHECK(node_error("1 17") == "f:1: expected a dimension from 1 to 16, found \"17\"");
  CHECK(node_error("1 2 0 2") == "f:1: expected 0 or 1 markers, found \"2\"");
}

TEST_CASE("node: counts that the data belie") {
  CHECK(node_error("3 2\n0 0 0\n1 1 1\n") ==
        "f:3: expected point 3 of 3, found the end of the file");
  CHECK(node_error("999999999999 2\n0 0 0\n") ==
        "f:2: expected point 2 of 999999999999, found the end of the file");
  CHECK(node_error("1 2 9223372036854775807 1\n0 0 0\n") ==
        "f:2: expected 9223372036854775811 columns (an index, 2 coordinates, "
        "9223372036854775807 attributes, a marker), found 3");
  CHECK(node_error("1 2\n0 0 0\n1 1 1\n") ==
        "f:3: expected the end of the file after 1 points, found \"1\"");
}

TEST_CASE("node: lines that cannot be") {
  CHECK(node_error("1 2\n0 0\n") == "f:2: expected 3 columns (an index, 2 coordinates), found 2");
  CHECK(node_error("1 2\n0 0 0 0\n") ==
        "f:2: expected 3 columns (an index, 2 coordinates), found 4");
  CHECK(node_error("2 1\n0 0\n2 0\n") ==
        "f:3: expected index 1, one more than the line before, found \"2\"");
  CHECK(node_error("1 1\n0.5 0\n") ==
        "f:2: expected the index of a point, an integer, found \"0.5\"");
  CHECK(node_error("2 1\n9223372036854775807 0\n9223372036854775808 0") ==
        "f:3: expected the index of a point, an integer that fits 64 bits, found "
        "\"9223372036854775808\"");
  CHECK(node_error("2 1\n9223372036854775807 0\n0 0") ==
        "f:3: expected indices that fit 64 bits, found \"0\"");
}

TEST_CASE("node: tokens that are not numbers") {
  const std::string finite = "f:2: expected a finite number, found ";
  CHECK(node_error("1 1\n0 nan") == finite + "\"nan\"");
  CHECK(node_error("1 1\n0 -inf") == finite + "\"-inf\"");
  CHECK(node_error("1 1\n0 1,5") == finite + "\"1,5\"");
  CHECK(node_error(std::string("1 1\n0 \0\xff\"", 9)) == finite + "\"\\x00\\xff\"\"");
  CHECK(node_error("1 1\n0 1/0") == "f:2: expected a denominator other than zero, found \"1/0\"");
  CHECK(node_error("1 1\n0 1e400") ==
        "f:2: expected a number within the range of double (--coordinates decimal reads more), "
        "found \"1e400\"");
  CHECK(node_error("1 1\n0 1e999999999", kDecimal) ==
        "f:2: expected an exponent between -1000 and 1000, found \"1e999999999\"");
  CHECK(node_error("1 1\n0 " + std::string(10001, '1')) ==
        "f:2: expected a number of at most 10000 characters, found \"" + std::string(40, '1') +
            "...\"");
}

TEST_CASE("ele: vertices as written, attributes counted, elements of second order whole") {
  const auto file = read_ele(named("2 3 1\n5 10 -1 12 0.5\n6 1 2 3 -1e3\n"));
  REQUIRE(file);
  CHECK(file->vertices_per_simplex == 3);
  CHECK(file->first_index == 5);
  CHECK(file->simplices == std::vector<Simplex>{{10, -1, 12}, {1, 2, 3}});
  CHECK(file->lines == std::vector<std::size_t>{2, 3});
  CHECK(read_ele(named("1 6\n1 1 2 3 4 5 6\n"))->simplices[0].size() == 6);
}

TEST_CASE("ele: what is refused") {
  CHECK(ele_error("") ==
        "f:1: expected a header \"simplices vertices-of-each [attributes]\", found the end of the "
        "file");
  CHECK(ele_error("1 0") == "f:1: expected simplices of at least 1 vertex, found \"0\"");
  CHECK(ele_error("1 3\n0 1 2 3.0\n") == "f:2: expected a vertex, an integer, found \"3.0\"");
  CHECK(ele_error("1 3\n0 1 2 9223372036854775808\n") ==
        "f:2: expected a vertex, an integer that fits 64 bits, found \"9223372036854775808\"");
  CHECK(ele_error("1 3\n0 1 2\n") == "f:2: expected 4 columns (an index, 3 vertices), found 3");
  CHECK(ele_error("1 999999999999\n0 1 2\n") ==
        "f:2: expected 1000000000000 columns (an index, 999999999999 vertices), found 3");
  CHECK(ele_error("2 3\n0 1 2 3\n") == "f:2: expected simplex 2 of 2, found the end of the file");
  CHECK(ele_error("2 3\n0 1 2 3\n5 1 2 3\n") ==
        "f:3: expected index 1, one more than the line before, found \"5\"");
}

TEST_CASE("columns that no claim is about are numbers all the same, and markers integers") {
  const std::string marker = "f:2: expected a marker, an integer, found ";
  CHECK(node_error("1 1 0 1\n0 1 x\n") == marker + "\"x\"");
  CHECK(node_error("1 1 0 1\n0 1 1.0\n") == marker + "\"1.0\"");
  CHECK(node_error("1 1 1 1\n0 1 x 1\n") == "f:2: expected a finite number, found \"x\"");
  CHECK(ele_error("1 1 1\n0 1 x\n") == "f:2: expected a finite number, found \"x\"");
  CHECK(ele_error("1 1 2\n0 1 1/3 nan\n") == "f:2: expected a finite number, found \"nan\"");
  CHECK(read_ele(named("1 1 1\n0 1 1/3\n")));
  CHECK(off_error("OFF\n1 1 0\n0 0 0\n1 0 red\n") ==
        "f:4: expected a finite number, found \"red\"");
  CHECK(off_error("COFF\n1 0 0\n0 0 0 red\n") == "f:3: expected a finite number, found \"red\"");
  CHECK(read_off(named("STCNOFF\n1 1 0\n0 0 0 1 .5 0 1 0.25 0.75\n1 0 0.9 0.9 0.9 1\n"), kDouble));
}

TEST_CASE("neigh: of as many simplices as there are, with as many of each as these have vertices") {
  const auto error = [](const std::string& text) {
    return error_of(read_neigh(named(text), ListedSimplices{2, 3, "x.ele"}));
  };
  CHECK(error("2 3\n1 -1 2 -1\n2 -1 -1 1\n") == "no error");
  CHECK(error("# one less\n1 3\n1 -1 2 -1\n") ==
        "f:2: expected 2 simplices, as x.ele has them, found \"1\"");
  CHECK(error("3 3\n") == "f:1: expected 2 simplices, as x.ele has them, found \"3\"");
  CHECK(error("2 4\n1 -1 2 -1 0\n") ==
        "f:1: expected 3 neighbours of each, as many as a simplex of x.ele has vertices, found "
        "\"4\"");
}

TEST_CASE("neigh: neighbours as written") {
  const std::string text = "2 4\n1 -1 2 -1 -1\n2 1 -1 -1 -1\n";
  const auto file = read_neigh(named(text));
  REQUIRE(file);
  CHECK(file->first_index == 1);
  CHECK(file->neighbors == std::vector<std::vector<Vertex>>{{-1, 2, -1, -1}, {1, -1, -1, -1}});
  CHECK(text_written(*file, write_neigh) == text);
  CHECK(error_of(read_neigh(named("1 0\n0\n"))) ==
        "f:1: expected at least 1 neighbour of each, found \"0\"");
  CHECK(error_of(read_neigh(named("1 2\n0 1 x\n"))) ==
        "f:2: expected a neighbour, an integer, found \"x\"");
  CHECK(error_of(read_neigh(named("1\n"))) ==
        "f:1: expected a header \"simplices neighbours-of-each\", found the end of the line");
  CHECK(error_of(read_neigh(named("1 2 3\n"))) ==
        "f:1: expected a header \"simplices neighbours-of-each\" and the end of the line, found "
        "\"3\"");
}

TEST_CASE("off: points and faces, with comments and colours") {
  const auto file = read_off(
      named("OFF # a square\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 255 0 0\n3 0 2 3\n"),
      kDouble);
  REQUIRE(file);
  CHECK(file->points.dimension == 3);
  CHECK(file->points.points.size() == 4);
  CHECK(file->faces.simplices == std::vector<Simplex>{{0, 1, 2}, {0, 2, 3}});
  CHECK(file->faces.lines == std::vector<std::size_t>{7, 8});
  CHECK(file->faces.vertices_per_simplex == 3);
}

TEST_CASE("off: the vertices of a face may go on over further lines") {
  const std::string points = "OFF\n4 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  const auto file = read_off(named(points + "3\n0 1 2\n4 0 1\n2\n3\n3 0 2 3 0.5 1\n"), kDouble);
  REQUIRE_MESSAGE(file, error_of(file));
  CHECK(file->faces.simplices == std::vector<Simplex>{{0, 1, 2}, {0, 1, 2, 3}, {0, 2, 3}});
  CHECK(file->faces.lines == std::vector<std::size_t>{7, 9, 12});
  // A missing vertex is not a file of that kind: the message names the line on which it is missing.
  CHECK(off_error(points + "3 0 1\n3 0 1 2\n3 0 2 3\n") ==
        "f:7: expected a face of 3 vertices, found 2");
  // A face over several lines has no colour after it, because a colour could not be told from a
  // vertex.
  CHECK(off_error(points + "3 0 1\n2 0.5\n3 0 1 2\n3 0 2 3\n") ==
        "f:7: expected a face of 3 vertices, found 2");
}

TEST_CASE("off: variants of the header") {
  CHECK(read_off(named("OFF 1 0\n1 2 3"), kDouble)->points.points.size() == 1);
  CHECK(read_off(named("nOFF\n2\n1 0 0\n1 2"), kDouble)->points.dimension == 2);
  CHECK(read_off(named("nOFF 2\n1 0 0\n1 2"), kDouble)->points.dimension == 2);
  CHECK(read_off(named("4OFF\n1 0 0\n1 2 3 4"), kDouble)->points.dimension == 4);
  CHECK(read_off(named("STCNOFF\n1 0 0\n1 2 3 4 5 6 7 8 9 0 1 2"), kDouble)->points.dimension == 3);
  const auto mixed = read_off(named("OFF\n0 2 0\n3 0 1 2\n4 0 1 2 3\n"), kDouble);
  CHECK(mixed->faces.vertices_per_simplex == 0);
}

TEST_CASE("off: what is refused") {
  CHECK(off_error("") == "f:1: expected the keyword OFF, found the end of the file");
  CHECK(off_error("PLY\n") == "f:1: expected the keyword OFF, found \"PLY\"");
  CHECK(off_error("OFF BINARY\n") == "f:1: expected an OFF file in text, found \"BINARY\"");
  CHECK(off_error("OFF\n") == "f:1: expected the number of points, found the end of the file");
  CHECK(off_error("nOFF\n16\n") == "f:2: expected a dimension from 1 to 15, found 16");
  CHECK(off_error("OFF\n1 0 0 0\n") ==
        "f:2: expected the end of the line after the counts, found \"0\"");
  CHECK(off_error("OFF\n1 0 0\n1 2\n") == "f:3: expected 3 coordinates, found 2");
  CHECK(off_error("OFF\n1 0 0\n1 2 3 4\n") == "f:3: expected 3 coordinates, found 4");
  CHECK(off_error("OFF\n2 0 0\n1 2 3\n") ==
        "f:3: expected point 2 of 2, found the end of the file");
  CHECK(off_error("OFF\n0 1 0\n4 0 1 2\n") == "f:3: expected a face of 4 vertices, found 3");
  CHECK(off_error("OFF\n0 1 0\n0\n") == "f:3: expected a face of at least 1 vertex, found \"0\"");
  CHECK(off_error("OFF\n0 2 0\n1 0\n") == "f:3: expected face 2 of 2, found the end of the file");
  CHECK(off_error("OFF\n0 1 0\n1 z\n") == "f:3: expected a vertex, an integer, found \"z\"");
  CHECK(off_error("OFF\n0 0 0\n1 z\n") ==
        "f:3: expected the end of the file after the last face, found \"1\"");
}

TEST_CASE("qhull: points and facets") {
  const auto points = read_qhull_points(named("2 rbox c D2\n3\n0 0\n1 0\n 0 1\n"), kDouble);
  REQUIRE(points);
  CHECK(points->points == std::vector<Point>{{0, 0}, {1, 0}, {0, 1}});
  CHECK(text_written(*points, write_qhull_points) == "2\n3\n0 0\n1 0\n0 1\n");
  const auto facets = read_qhull_simplices(named("2\n2 0 1 \n0 1 3 4 \n"));
  REQUIRE(facets);
  CHECK(facets->simplices == std::vector<Simplex>{{2, 0, 1}, {0, 1, 3, 4}});
  CHECK(facets->vertices_per_simplex == 0);
  CHECK(text_written(*facets, write_qhull_simplices) == "2\n2 0 1\n0 1 3 4\n");
}

TEST_CASE("qhull: what is refused") {
  CHECK(qhull_error("") == "f:1: expected the dimension, found the end of the file");
  CHECK(qhull_error("0\n0\n") == "f:1: expected a dimension from 1 to 16, found \"0\"");
  CHECK(qhull_error("2\n") == "f:1: expected the number of points, found the end of the file");
  CHECK(qhull_error("2\n1 1\n") ==
        "f:2: expected the end of the line after the number of points, found \"1\"");
  CHECK(qhull_error("2\n1\n0 0 0\n") == "f:3: expected 2 coordinates, found 3");
  CHECK(qhull_error("2\n2\n0 0\n") == "f:3: expected point 2 of 2, found the end of the file");
  CHECK(qhull_error("2\n1\n0 0\n1 2\n") ==
        "f:4: expected the end of the file after the last point, found \"1\"");
  CHECK(error_of(read_qhull_simplices(named("1\n0 1 b\n"))) ==
        "f:2: expected a vertex, an integer, found \"b\"");
  CHECK(error_of(read_qhull_simplices(named("3\n0 1 2\n"))) ==
        "f:2: expected facet 2 of 3, found the end of the file");
  CHECK(error_of(read_qhull_simplices(named("1\n0 1 2\n0 1 2\n"))) ==
        "f:3: expected the end of the file after the last facet, found \"0\"");
}

TEST_CASE("face and edge: markers are labels, and what TetGen appends is read over") {
  const auto faces =
      read_face(named("# TetGen -nn\n2  1\n 1  1 2 3  -7  1 -1\n 2  2 1 4  0  0 1\n"), 3);
  REQUIRE(faces);
  CHECK(faces->simplices == std::vector<Simplex>{{1, 2, 3}, {2, 1, 4}});
  CHECK(faces->lines == std::vector<std::size_t>{3, 4});
  CHECK(faces->labels == std::vector<Vertex>{-7, 0});
  const auto edges = read_face(named("2\n0 1 2\n1 2 3\n"), 2);
  REQUIRE(edges);
  CHECK(edges->labels.empty());
  CHECK(edges->simplices == std::vector<Simplex>{{1, 2}, {2, 3}});
  CHECK(text_written(*edges, write_face) == "2 0\n0 1 2\n1 2 3\n");
  CHECK(error_of(read_face(named("1 0\n1 1 2\n"), 3)) ==
        "f:2: expected 4 columns (an index, 3 vertices) and at most 3 more, found 3");
  CHECK(error_of(read_face(named("1 1\n1 1 2 3\n"), 3)) ==
        "f:2: expected 5 columns (an index, 3 vertices, a marker) and at most 3 more, found 4");
  CHECK(error_of(read_face(named("1 1\n1 1 2 x\n"), 2)) ==
        "f:2: expected a marker or a tetrahedron, an integer, found \"x\"");
  CHECK(error_of(read_face(named("1 2\n"), 2)) == "f:1: expected 0 or 1 markers, found \"2\"");
  CHECK(error_of(read_face(named("2\n1 1 2\n"), 2)) ==
        "f:2: expected edge 2 of 2, found the end of the file");
}

TEST_CASE("face: triangles with a marker other than 0, by their vertices from 0, ascending") {
  const auto faces = read_face(named("3 1\n1 5 4 3 -7\n2 3 4 6 0\n3 6 3 5 9\n"), 3);
  const auto edges = read_face(named("1 1\n1 3 4 7\n"), 2);
  const auto unmarked = read_face(named("1 0\n1 3 4 5 7\n"), 3);
  REQUIRE((faces && edges && unmarked));
  std::map<Simplex, Vertex> markers;
  for (const auto& file : {*edges, *unmarked, *faces}) add_markers(file, 3, markers);
  CHECK(markers == std::map<Simplex, Vertex>{{{0, 1, 2}, -7}, {{0, 2, 3}, 9}});
}

// Points as .xyz and .csv: what is read and what is refused.

namespace {

Result<PointFile> xyz(const std::string& text) {
  return read_xyz({"f", text}, NumberReading::kDouble);
}
Result<PointFile> csv(const std::string& text) {
  return read_csv({"f", text}, NumberReading::kDouble);
}

const std::vector<Point> kTwoPoints = {{0, Rational(1, 2)}, {-3, 4}};

}  // namespace

TEST_CASE("xyz: the first line says the dimension") {
  const auto plane = xyz("# two\n0 0.5\n\n-3\t4e0\r\n");
  REQUIRE_MESSAGE(plane, error_of(plane));
  CHECK(plane->points == kTwoPoints);
  CHECK(plane->dimension == 2);
  CHECK(plane->first_index == 0);
  CHECK(xyz("1 2 3 4 5")->dimension == 5);
  CHECK(error_of(xyz("")) ==
        "f:1: expected a line of coordinates for each point, found the end of the file");
  CHECK(error_of(xyz("C 0 0 0\n")) ==
        "f:1: expected a line of coordinates for each point, found \"C\"");
  CHECK(error_of(xyz("2\n0 0 0\n1 0 0\n")) ==
        "f:2: expected 1 coordinates, as on the first line, found 3");
  CHECK(error_of(xyz("0 0\n0 nan\n")) == "f:2: expected a finite number, found \"nan\"");
  CHECK(error_of(xyz("0 1 2 3 4 5 6 7 8 9 0 1 2 3 4 5 6")) ==
        "f:1: expected at most 16 coordinates, found 17");
}

TEST_CASE("csv: columns by their order or by their names") {
  for (const std::string text :
       {"0,0.5\n-3,4\n", "0;0.5\r\n-3;4\r\n", "0\t0.5\n-3\t4\n", "x,y\n0,0.5\n\n-3,4",
        "\"id\",\"Y\",\"X\",\"note\"\n1,.5,0,a word\n2,\"4\",-3,\n",
        " x , y \n 0 , 0.5 \n -3 , 4 \n", "\xEF\xBB\xBFPoints_0;Points:1\n0;0.5\n-3;4\n"}) {
    CAPTURE(text);
    const auto file = csv(text);
    REQUIRE_MESSAGE(file, error_of(file));
    CHECK(file->points == kTwoPoints);
  }
  CHECK(csv("x,y,z\n")->points.empty());
  CHECK(csv("x,y,z\n")->dimension == 3);
}

TEST_CASE("csv: what is refused") {
  CHECK(error_of(csv("")) ==
        "f:1: expected a point, or the names of columns, found the end of the file");
  CHECK(error_of(csv("a,b\n0,1\n")) ==
        "f:1: expected a number, or columns named x, y and z, found \"a\"");
  CHECK(error_of(csv("x,z\n0,1\n")) ==
        "f:1: expected a number, or columns named x, y and z, found \"x\"");
  CHECK(error_of(csv("x,y,X\n")) == "f:1: expected one column X, found two");
  CHECK(error_of(csv("0,1\n2\n")) == "f:2: expected 2 columns, as on the first line, found 1");
  CHECK(error_of(csv("0,1\n2,\n")) == "f:2: expected a finite number, found \"\"");
  CHECK(error_of(csv("0,1\n2,1e999\n")).starts_with("f:2: expected "));
  std::string wide = "0";
  for (int i = 0; i < 16; ++i) wide += ",0";
  CHECK(error_of(csv(wide)) == "f:1: expected at most 16 coordinates, found 17");
}

}  // namespace circumspect::formats
