// Our JSON: what is read, what is refused, and the messages.
#include "oracle/formats/json.hpp"

#include <sstream>

#include <doctest/doctest.h>

namespace circumspect::formats {
namespace {

Result<JsonFile> read(const std::string& text, NumberReading reading = NumberReading::kDouble) {
  return read_json({"f", text}, reading);
}

std::string error(const std::string& text, NumberReading reading = NumberReading::kDouble) {
  const Result<JsonFile> file = read(text, reading);
  return file ? "no error" : file.error().to_string();
}

// A document with one point, whose coordinate is given.
std::string with_coordinate(const std::string& coordinate) {
  return "{\"circumspect\": 1, \"dimension\": 1,\n\"points\": [[\n" + coordinate + "\n]]}";
}

const std::string kTriangle =
    "{\"circumspect\": 1, \"dimension\": 2, \"first_index\": 1,\n"
    "\"points\": [\n[0, 0],\n[1, 0],\n[0, \"1/3\"]],\n"
    "\"weights\": [0, 0.5, \"2/7\"],\n"
    "\"simplices\": [\n[1, 2, 3]]}\n";

}  // namespace

TEST_CASE("json: a whole document") {
  const Result<JsonFile> file = read(kTriangle);
  REQUIRE(file);
  CHECK(file->points.dimension == 2);
  CHECK(file->points.first_index == 1);
  CHECK(file->points.points == std::vector<Point>{{0, 0}, {1, 0}, {0, Rational(1, 3)}});
  CHECK(file->weights == std::vector<Rational>{0, Rational(1, 2), Rational(2, 7)});
  CHECK(file->has_simplices);
  CHECK(file->simplices.simplices == std::vector<Simplex>{{1, 2, 3}});
  CHECK(file->simplices.lines == std::vector<std::size_t>{8});
  CHECK(file->simplices.first_index == 1);
  std::ostringstream out;
  write_json(out, *file);
  CHECK(out.str() == kTriangle);
}

TEST_CASE("json: faces beside the simplices, written only where there are any") {
  const std::string text =
      "{\"circumspect\": 1, \"dimension\": 2, \"first_index\": 1,\n"
      "\"points\": [\n[0, 0],\n[1, 0],\n[0, 1]],\n"
      "\"simplices\": [],\n"
      "\"faces\": [\n[1, 2],\n[3, 1]]}\n";
  const Result<JsonFile> file = read(text);
  REQUIRE(file);
  CHECK(file->simplices.simplices.empty());
  CHECK(file->faces.simplices == std::vector<Simplex>{{1, 2}, {3, 1}});
  CHECK(file->faces.lines == std::vector<std::size_t>{8, 9});
  CHECK(file->faces.vertices_per_simplex == 2);
  std::ostringstream out;
  write_json(out, *file);
  CHECK(out.str() == text);
}

TEST_CASE("json: faces that are none") {
  const std::string points = "{\"circumspect\": 1, \"dimension\": 2, \"points\": [[0, 0]],\n";
  CHECK(error(points + "\"faces\": [[0, 1],\n[0, 1, 2]]}") ==
        "f:3: expected a face of at most 2 vertices in dimension 2, found one of 3");
  CHECK(error("{\"faces\": [[]]}") ==
        "f:1: expected a face of at least 1 vertex, found an empty array");
  CHECK(error("{\"faces\": [7]}") ==
        "f:1: expected a face, which is an array of vertices, found \"7\"");
  CHECK(error("{\"faces\": [[\"0\"]]}") ==
        "f:1: expected a vertex, an integer that fits 64 bits, found the string \"0\"");
  CHECK(error("{\"faces\": 7}") == "f:1: expected an array of faces, found \"7\"");
}

TEST_CASE("json: keys in any order, a comment, no points") {
  const Result<JsonFile> file =
      read("{\"comment\": \"x\", \"points\": [], \"dimension\": 3, \"circumspect\": 1}");
  REQUIRE(file);
  CHECK(file->points.points.empty());
  CHECK(!file->has_simplices);
  CHECK(file->weights.empty());
}

TEST_CASE("json: numbers mean what is written") {
  const auto coordinate = [](const std::string& text, NumberReading reading) {
    return read(with_coordinate(text), reading)->points.points[0][0];
  };
  CHECK(coordinate("0.1", NumberReading::kDecimal) == Rational(1, 10));
  CHECK(coordinate("0.1", NumberReading::kDouble) == exact_value(0.1));
  CHECK(coordinate("\"0.1\"", NumberReading::kDecimal) == Rational(1, 10));
  CHECK(coordinate("\"0x1.8p+0\"", NumberReading::kDouble) == Rational(3, 2));
  CHECK(coordinate("9007199254740993", NumberReading::kDecimal) == Integer("9007199254740993"));
  CHECK(coordinate("9007199254740993", NumberReading::kDouble) == Integer("9007199254740992"));
  CHECK(coordinate("123456789012345678901234567890", NumberReading::kDecimal) ==
        Integer("123456789012345678901234567890"));
  CHECK(coordinate("\"1e400\"", NumberReading::kDecimal) == Integer("1" + std::string(400, '0')));
}

TEST_CASE("json: numbers that are refused, with their line") {
  CHECK(error(with_coordinate("1e400"), NumberReading::kDecimal) ==
        "f:3: expected a number within the range of double (a string may hold more), found "
        "\"1e400\"");
  CHECK(error(with_coordinate("\"1e999999999\""), NumberReading::kDecimal) ==
        "f:3: expected an exponent between -1000 and 1000, found \"1e999999999\"");
  CHECK(error(with_coordinate("\"1/0\"")) ==
        "f:3: expected a denominator other than zero, found \"1/0\"");
  CHECK(error(with_coordinate("\"nan\"")) == "f:3: expected a finite number, found \"nan\"");
  CHECK(error(with_coordinate("\" 1\"")) == "f:3: expected a finite number, found \" 1\"");
  CHECK(error(with_coordinate("NaN")) == "f:3: expected valid JSON, found \"N\" (invalid literal)");
}

TEST_CASE("json: values of the wrong type") {
  CHECK(error(with_coordinate("null")) == "f:3: expected a coordinate, found null");
  CHECK(error(with_coordinate("true")) == "f:3: expected a coordinate, found true");
  CHECK(error(with_coordinate("[1]")) == "f:3: expected a coordinate, found an array");
  CHECK(error(with_coordinate("{\"x\": 1}")) == "f:3: expected a coordinate, found an object");
  CHECK(error("[]") == "f:1: expected a JSON object, found an array");
  CHECK(error("\n7") == "f:2: expected a JSON object, found \"7\"");
  CHECK(error("{\"points\": 7}") == "f:1: expected an array of points, found \"7\"");
  CHECK(error("{\"points\": [7]}") ==
        "f:1: expected a point, which is an array of coordinates, found \"7\"");
  CHECK(error("{\"weights\": [[]]}") == "f:1: expected a weight, found an array");
  CHECK(error("{\"simplices\": [[0.5]]}") ==
        "f:1: expected a vertex, an integer that fits 64 bits, found \"0.5\"");
  CHECK(error("{\"simplices\": [[9223372036854775808]]}") ==
        "f:1: expected a vertex, an integer that fits 64 bits, found \"9223372036854775808\"");
  CHECK(error("{\"simplices\": [[\"0\"]]}") ==
        "f:1: expected a vertex, an integer that fits 64 bits, found the string \"0\"");
  CHECK(error("{\"simplices\": [[]]}") ==
        "f:1: expected a simplex of at least 1 vertex, found an empty array");
  CHECK(error("{\"dimension\": 0}") == "f:1: expected a dimension from 1 to 16, found \"0\"");
  CHECK(error("{\"first_index\": 1e3}") ==
        "f:1: expected the index of the first point, an integer that fits 64 bits, found \"1e3\"");
}

TEST_CASE("json: documents that contradict the schema") {
  CHECK(error("{\"circumspect\": 2}") == "f:1: expected 1, the version of the schema, found \"2\"");
  const std::string form =
      R"(, as in {"circumspect": 1, "dimension": 2, "points": [...], "simplices": [...]})";
  CHECK(error("{\"dimension\": 2,\n\"points\": []}") ==
        "f: expected the key \"circumspect\"" + form + ", found an object without it");
  CHECK(error("{\"circumspect\": 1, \"points\": []}") ==
        "f: expected the key \"dimension\"" + form + ", found an object without it");
  CHECK(error("{\"circumspect\": 1, \"dimension\": 2}") ==
        "f: expected the key \"points\"" + form + ", found an object without it");
  CHECK(error("{\"circumspect\": 1,\n\"circumspect\": 1}") ==
        "f:2: expected every key once, found \"circumspect\" again");
  CHECK(error("{\"simplexes\": []}") ==
        "f:1: expected one of the keys \"circumspect\", \"dimension\", \"points\", \"weights\", "
        "\"simplices\", \"faces\", \"first_index\", \"comment\", found \"simplexes\"");
  CHECK(error("{\"points\": [[1, 2],\n[1]]}") ==
        "f:2: expected a point with 2 coordinates, found one with 1");
  CHECK(error("{\"circumspect\": 1, \"points\": [[1, 2]],\n\"dimension\": 3}") ==
        "f:2: expected the dimension 2, which the points have, found 3");
  CHECK(error("{\"circumspect\": 1, \"dimension\": 1, \"points\": [[1]],\n\"weights\": [1, 2]}") ==
        "f:2: expected one weight for each of 1 points, found 2");
}

TEST_CASE("json: text that is none") {
  CHECK(error("") == "f:1: expected the rest of the JSON text, found the end of the file");
  CHECK(error("{\"points\": [\n[0,") ==
        "f:2: expected the rest of the JSON text, found the end of the file");
  CHECK(error("{\"points\": [\n[0,,") ==
        "f:2: expected valid JSON, found \"[0,,\" (unexpected ',')");
  CHECK(error("{\"points\n") ==
        "f:1: expected valid JSON, found \"{\"points\\x0a\" (invalid string: control character "
        "U+000A (LF) must be escaped to \\u000A or \\n)");
  CHECK(error(kTriangle + "\n{}") == "f:10: expected valid JSON, found \"{\" (unexpected '{')");
}

TEST_CASE("json: a hundred thousand brackets are refused at the first that is too deep") {
  CHECK(error(std::string(100000, '[')) == "f:1: expected a JSON object, found an array");
  CHECK(error("{\"points\": " + std::string(100000, '[')) ==
        "f:1: expected a coordinate, found an array");
}

}  // namespace circumspect::formats
