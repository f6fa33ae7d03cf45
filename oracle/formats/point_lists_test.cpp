// Points as .xyz and .csv: what is read and what is refused.
#include "oracle/formats/point_lists.hpp"

#include <doctest/doctest.h>

#include "oracle/formats/reading_test.hpp"

namespace circumspect::formats {
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
}

}  // namespace circumspect::formats
