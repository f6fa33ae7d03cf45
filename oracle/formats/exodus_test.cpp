// Exodus in netCDF's classic formats: what is read, what is refused, and the messages.
#include "oracle/formats/exodus.hpp"

#include <bit>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

#include "oracle/formats/netcdf.hpp"
#include "oracle/formats/reading_test.hpp"
#include "oracle/formats/written_meshb_test.hpp"

namespace circumspect::formats {
namespace {

constexpr ByteOrder kBig = ByteOrder::kBigEndian;

// A file of netCDF: its dimensions, and variables with their numbers as bytes.
struct WrittenNetcdf {
  struct Variable {
    std::string name;
    std::vector<std::size_t> dimensions;
    std::string elem_type;
    std::size_t type;  // 4: int, 5: float, 6: double, 10: int64
    std::string numbers;
  };
  std::vector<std::size_t> lengths = {};
  std::vector<Variable> variables = {};

  std::string written(std::size_t version) const {
    const std::size_t count = version == 5 ? 8 : 4, place = version == 1 ? 4 : 8;
    const auto number = [&](std::size_t value) { return stored(value, count, kBig); };
    const auto named = [&](std::string name) {
      std::string text = number(name.size());
      name.resize((name.size() + 3) / 4 * 4);
      return text + name;
    };
    const auto tag = [&](std::size_t of, std::size_t size) {
      return stored(size == 0 ? 0 : of, 4, kBig) + number(size);
    };
    std::string head = "CDF" + std::string(1, static_cast<char>(version)) + number(0);
    head += tag(10, lengths.size());
    for (const std::size_t length : lengths) head += named("length") + number(length);
    head += tag(12, 1) + named("title") + stored(2, 4, kBig) + named("by hand");
    head += tag(11, variables.size());
    std::string numbers;
    std::vector<std::size_t> places;
    std::string rest;
    std::vector<std::string> before;
    for (const Variable& one : variables) {
      std::string text = named(one.name) + number(one.dimensions.size());
      for (const std::size_t dimension : one.dimensions) text += number(dimension);
      if (one.elem_type.empty()) {
        text += tag(12, 0);
      } else {
        text += tag(12, 1) + named("elem_type") + stored(2, 4, kBig) + named(one.elem_type);
      }
      before.push_back(text + stored(one.type, 4, kBig) + number(one.numbers.size()));
    }
    std::size_t begin = head.size();
    for (const std::string& text : before) begin += text.size() + place;
    for (std::size_t i = 0; i < variables.size(); ++i) {
      head += before[i] + stored(begin + numbers.size(), place, kBig);
      numbers += variables[i].numbers;
    }
    return head + numbers;
  }
};

std::string doubles(const std::vector<double>& values) {
  std::string text;
  for (const double x : values) text += stored(std::bit_cast<std::uint64_t>(x), 8, kBig);
  return text;
}
std::string integers(const std::vector<int>& values, std::size_t size = 4) {
  std::string text;
  for (const int v : values) {
    text += stored(static_cast<std::uint64_t>(static_cast<std::int64_t>(v)), size, kBig);
  }
  return text;
}

// Lengths: 4 points, 1 element, 4 nodes, 3 nodes, 3 axes, 2 blocks.
WrittenNetcdf tetrahedron_and_triangle() {
  return {{4, 1, 4, 3, 3, 2},
          {{"coordx", {0}, "", 6, doubles({0, 1, 0, 0})},
           {"coordy", {0}, "", 6, doubles({0, 0, 1, 0})},
           {"coordz", {0}, "", 6, doubles({0, 0, 0, 0.1})},
           {"eb_prop1", {5}, "", 4, integers({7, 9})},
           {"connect1", {1, 2}, "TETRA4", 4, integers({1, 2, 3, 4})},
           {"connect2", {1, 3}, "Tri3", 4, integers({1, 2, 3})}}};
}

Result<ElementFile> exodus(const WrittenNetcdf& file, std::size_t version = 1) {
  return read_exodus(named(file.written(version)), kDouble);
}
std::string exodus_error(const WrittenNetcdf& file) { return error_of(exodus(file)); }

}  // namespace

TEST_CASE("exodus: points and blocks, in each of netCDF's classic formats") {
  for (const std::size_t version : {1U, 2U, 5U}) {
    CAPTURE(version);
    const auto file = exodus(tetrahedron_and_triangle(), version);
    REQUIRE_MESSAGE(file, error_of(file));
    CHECK(file->points.points ==
          std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, exact_value(0.1)}});
    CHECK(file->points.first_index == 1);
    CHECK(file->tetrahedra.simplices == std::vector<Simplex>{{1, 2, 3, 4}});
    CHECK(file->tetrahedra.labels == std::vector<Vertex>{7});
    CHECK(file->triangles.simplices == std::vector<Simplex>{{1, 2, 3}});
    CHECK(file->triangles.labels == std::vector<Vertex>{9});
  }
  CHECK(is_exodus(Beginning(named(tetrahedron_and_triangle().written(2)))));
  CHECK(!is_exodus(Beginning(named("CDF\x03 more"))));
}

TEST_CASE("exodus: the axes in one array, in the plane, and indices of 8 bytes") {
  WrittenNetcdf file = {{2, 3, 1},
                        {{"coord", {0, 1}, "", 6, doubles({0, 1, 0, 0, 0, 2})},
                         {"connect1", {2, 1}, "SHELL", 10, integers({1, 2, 3}, 8)}}};
  const auto plane = exodus(file, 5);
  REQUIRE_MESSAGE(plane, error_of(plane));
  CHECK(plane->points.points == std::vector<Point>{{0, 0}, {1, 0}, {0, 2}});
  CHECK(plane->triangles.simplices == std::vector<Simplex>{{1, 2, 3}});
  CHECK(plane->triangles.labels == std::vector<Vertex>{1});
}

TEST_CASE("exodus: a node is an integer") {
  WrittenNetcdf file = tetrahedron_and_triangle();
  file.variables[4] = {"connect1", {1, 2}, "TETRA4", 6, doubles({1, 2, 3.5, 4})};
  CHECK(exodus_error(file) ==
        "f: expected a node of tetrahedron, an integer, found floating-point numbers");
}

TEST_CASE("exodus: what elements are, by their type and how many nodes they have") {
  const auto shape = [](const char* type, std::size_t nodes) {
    WrittenNetcdf file = tetrahedron_and_triangle();
    file.lengths[2] = nodes;
    file.variables[4] = {"connect1", {1, 2}, type, 4, integers(std::vector<int>(nodes, 1))};
    file.variables.pop_back();
    const auto read = exodus(file);
    if (!read) return error_of(read);
    if (read->first_other) return read->first_other->name;
    if (read->first_curved) return read->first_curved->name;
    const std::string order = read->curved.simplices.empty() ? "" : " of second order";
    return !read->edges.simplices.empty()        ? "an edge" + order
           : !read->triangles.simplices.empty()  ? "a triangle" + order
           : !read->tetrahedra.simplices.empty() ? "a tetrahedron" + order
                                                 : std::string("a point");
  };
  CHECK(shape("SPHERE", 1) == "a point");
  CHECK(shape("BAR2", 2) == "an edge");
  CHECK(shape("tri6", 6) == "a triangle of second order");
  CHECK(shape("SHELL6", 6) == "a triangle of second order");
  CHECK(shape("TETRA10", 10) == "a tetrahedron of second order");
  CHECK(shape("SHELL4", 4) == "a quadrilateral");
  CHECK(shape("HEX", 8) == "a hexahedron");
  CHECK(shape("HEX27", 27) == "a hexahedron of second order");
  CHECK(shape("WEDGE", 6) == "a prism");
  CHECK(shape("PYRAMID5", 5) == "a pyramid");
  CHECK(shape("TETRA", 3) ==
        "f: expected a type of the elements of \"connect1\" that is known, as \"TETRA4\", found "
        "\"TETRA\" of 3 nodes");
}

TEST_CASE("exodus: faults, and a file that ends too early") {
  CHECK(error_of(read_exodus(named("\x89HDF\r\n"), kDouble)).find("netCDF in HDF5 (with Debian") !=
        std::string::npos);
  CHECK(exodus_error({}) == "f: expected coordinates, as \"coordx\" or \"coord\", found none");
  WrittenNetcdf file = tetrahedron_and_triangle();
  file.variables[1].dimensions = {1};
  CHECK(exodus_error(file) == "f: expected 4 coordinates along each axis, found 1");
  file = tetrahedron_and_triangle();
  file.variables[0].type = 2;
  CHECK(exodus_error(file) ==
        "f: expected the numbers of \"coordx\", found text, or a series of records");
  file = tetrahedron_and_triangle();
  file.lengths[0] = 0;  // as many as there are records
  CHECK(exodus_error(file) ==
        "f: expected the numbers of \"coordx\", found text, or a series of records");
  file = tetrahedron_and_triangle();
  file.variables[0].dimensions = {6};
  CHECK(exodus_error(file).find("expected a dimension, one of 6, found 6") != std::string::npos);
  file.variables[0] = {"coordx", {0}, "", 12, ""};
  CHECK(exodus_error(file).find("expected the type of a variable from 1 to 11, found 12") !=
        std::string::npos);
  file = tetrahedron_and_triangle();
  file.variables[2].numbers = doubles({0, 0, 0, std::nan("")});
  CHECK(exodus_error(file) ==
        "f: expected a coordinate of point 4 of 4, a finite number, found NaN or an infinity at "
        "byte 24");
  file = {{2, 3}, {{"coord", {0, 1}, "", 6, doubles({0, 1, 0, 0, 0, std::nan("")})}}};
  CHECK(exodus_error(file) ==
        "f: expected a coordinate of point 3 of 3, a finite number, found NaN or an infinity at "
        "byte 40");
  file = tetrahedron_and_triangle();
  file.variables[4] = {"connect1", {1}, "nfaced", 4, integers({6})};
  CHECK(exodus(file)->first_other);
  file = tetrahedron_and_triangle();
  file.variables.back().numbers.clear();
  CHECK(exodus_error(file).starts_with(
      "f: expected the numbers of \"connect2\", found the end of the file at byte "));
  file = {{3}, {{"coord", {0}, "", 6, doubles({0, 1, 0})}}};
  CHECK(exodus_error(file) == "f: expected two dimensions of \"coord\", found another number");
  file = tetrahedron_and_triangle();
  file.variables[4].elem_type = "NURBS";
  CHECK(exodus_error(file) ==
        "f: expected a type of the elements of \"connect1\" that is known, as \"TETRA4\", found "
        "\"NURBS\" of 4 nodes");
  CHECK(error_of(read_exodus(named("CDF\1"), kDouble)) ==
        "f: expected the number of records, found none at byte 4");
  // So many values of an attribute that their bytes are none, if more than 64 bits are cut off.
  std::string many = tetrahedron_and_triangle().written(5);
  const std::size_t title = many.find("title") + 8;
  many.replace(title, 12, stored(6, 4, kBig) + stored(std::uint64_t{1} << 61, 8, kBig));
  many.erase(title + 12, 8);  // "by hand"
  CHECK(error_of(read_exodus(named(many), kDouble)).find("bytes of an attribute, found the end") !=
        std::string::npos);
  // Wherever it is cut off, the file is refused.
  const std::string whole = tetrahedron_and_triangle().written(1);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    CHECK(!read_exodus(named(whole.substr(0, size)), kDouble));
  }
}

}  // namespace circumspect::formats
