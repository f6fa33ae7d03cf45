#include "fuzz/campaign/domain_text.hpp"

#include <doctest/doctest.h>

#include "inputs/named_complexes.hpp"

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
  // What it lists already is not listed again.
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

}  // namespace
}  // namespace circumspect::campaign
