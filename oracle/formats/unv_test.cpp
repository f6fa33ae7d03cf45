// Universal files: what is read, what is refused, and the messages.
#include "oracle/formats/unv.hpp"

#include <doctest/doctest.h>

#include "oracle/formats/reading_test.hpp"

namespace circumspect::formats {
namespace {

Result<ElementFile> unv(const std::string& text) { return read_unv(named(text), kDouble); }
std::string unv_error(const std::string& text) { return error_of(unv(text)); }

std::string data_set(const std::string& number, const std::string& lines) {
  return "    -1\n  " + number + "\n" + lines + "    -1\n";
}

std::string unv_node(int label, const std::string& coordinates, int system = 1) {
  return std::to_string(label) + " " + std::to_string(system) + " 1 11\n" + coordinates + "\n";
}

const std::string kUnvNodes = unv_node(1, "0.0D+00 0.0D+00 0.0D+00") +
                              unv_node(2, "1.0D+00 0. 0.") + unv_node(3, "0. 1.0d+0 0.") +
                              unv_node(4, "0. 0. 1.0E-1");
const std::string kUnvElements =
    "1 111 1 7 7 4\n1 2 3 4\n2 91 2 1 7 3\n1 2 3\n3 21 2 1 7 2\n0 1 1\n1 2\n4 136 1 1 7 2\n1 2\n"
    "5 171 1 1 1 2\n2 3\n";

std::string system_of(const std::string& kind, const std::string& first_row) {
  return data_set(
      "2420", "1\n\n8 " + kind + " 11\nlocal\n" + first_row + "\n0. 1. 0.\n0. 0. 1.\n0. 0. 0.\n");
}

}  // namespace

TEST_CASE("unv: nodes and elements, of new files and of old ones; the rest is skipped") {
  const std::string text = data_set("164", "1 SI: Meter 2\n1. 1. 1.\n0.\n") +
                           data_set("2411", kUnvNodes) + data_set("2412", kUnvElements);
  const std::string old =
      data_set("781", kUnvNodes) + data_set("780",
                                            "1 111 1 1 1 1 7 4\n1 2 3 4\n2 91 1 2 1 1 7 3\n1 2 3\n"
                                            "3 21 1 2 1 1 7 2\n0 1 1\n1 2\n");
  for (const std::string& form : {text, old}) {
    const auto file = unv(form);
    REQUIRE_MESSAGE(file, error_of(file));
    CHECK(file->points.points ==
          std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, exact_value(0.1)}});
    CHECK(file->tetrahedra.simplices == std::vector<Simplex>{{1, 2, 3, 4}});
    CHECK(file->triangles.simplices == std::vector<Simplex>{{1, 2, 3}});
    CHECK(file->triangles.labels == std::vector<Vertex>{2});
    CHECK(file->edges.simplices[0] == Simplex{1, 2});
  }
  CHECK(unv(text)->edges.simplices.size() == 2);  // one of a shell around an axis
  CHECK(unv(text)->tetrahedra.lines == std::vector<std::size_t>{20});
  CHECK(is_unv(Beginning(named(text))));
  CHECK(!is_unv(Beginning(named("-1 2\n3\n"))));
}

TEST_CASE("unv: nodes of second order go around a face") {
  std::string nodes;
  for (int i = 1; i <= 10; ++i) nodes += unv_node(i, std::to_string(i) + ". 0. 0.");
  const auto file = unv(data_set("2411", nodes) +
                        data_set("2412",
                                 "1 118 1 1 7 10\n1 2 3 4 5 6 7 8\n9 10\n"
                                 "2 42 1 1 7 6\n1 2 3 4 5 6\n3 24 1 1 7 3\n0 0 0\n1 2 3\n"));
  REQUIRE_MESSAGE(file, error_of(file));
  CHECK(file->tetrahedra.simplices == std::vector<Simplex>{{1, 3, 5, 10}});
  CHECK(file->triangles.simplices == std::vector<Simplex>{{1, 3, 5}});
  CHECK(file->edges.simplices == std::vector<Simplex>{{1, 3}});
  CHECK(file->curved.simplices ==
        std::vector<Simplex>{{1, 3, 5, 10, 2, 4, 6, 7, 8, 9}, {1, 3, 5, 2, 4, 6}, {1, 3, 2}});
}

TEST_CASE("unv: a system of coordinates that leaves nodes in place is none that moves them") {
  const std::string mesh = data_set("2411", unv_node(1, "0. 0. 0.", 8) + unv_node(2, "1. 0. 0.")) +
                           data_set("2412", "1 11 1 1 7 2\n0 0 0\n1 2\n");
  CHECK(unv(system_of("0", "1.0D+00 0. 0.") + mesh));
  const std::string said =
      ": expected nodes in a system of coordinates that leaves them in place, found system 8";
  CHECK(unv_error(system_of("1", "1. 0. 0.") + mesh) == "f:14" + said);
  CHECK(unv_error(system_of("0", "0. 1. 0.") + mesh) == "f:14" + said);
  CHECK(unv_error(mesh + system_of("0", "2. 0. 0.")) == "f:3" + said);
}

TEST_CASE("unv: faults and their lines") {
  const std::string nodes = data_set("2411", kUnvNodes);
  CHECK(unv_error("") == "f:1: expected a data set 2411 of nodes, found the end of the file");
  CHECK(unv_error(nodes) ==
        "f:11: expected a data set 2412 of elements, found the end of the file");
  CHECK(unv_error("2411\n") == "f:1: expected -1 before a data set, found \"2411\"");
  CHECK(unv_error("-1\n") == "f:1: expected the number of a data set, found the end of the file");
  CHECK(unv_error("-1\n2411\n1 1 1\n") ==
        "f:3: expected 3 coordinates of a node, found the end of the file");
  CHECK(unv_error("-1\n2411\n1 1 1\n0. 0.\n") ==
        "f:4: expected 3 coordinates of a node, found the end of the line");
  CHECK(unv_error("-1\n2411\n1 1 1\n0. y 0.\n") == "f:4: expected a finite number, found \"y\"");
  CHECK(unv_error("-1\n151\nx\n") ==
        "f:3: expected -1 behind the data set, found the end of the file");
  CHECK(unv_error(nodes + data_set("2412", "1 999 1 1 7 4\n1 2 3 4\n")) ==
        "f:14: expected a type of elements that is known, as 111, found \"999\"");
  CHECK(unv_error(nodes + data_set("2412", "1 111 1 1 7 5\n1 2 3 4 5\n")) ==
        "f:14: expected a tetrahedron of 4 nodes, found 5");
  CHECK(unv_error(nodes + data_set("2412", "1 111 1 1 7 4\n1 2 3 4 1\n")) ==
        "f:15: expected a tetrahedron of 4 nodes, found 5");
  CHECK(unv_error(nodes + data_set("2412", "1 111\n")) ==
        "f:14: expected the number of nodes of an element, found the end of the line");
}

}  // namespace circumspect::formats
