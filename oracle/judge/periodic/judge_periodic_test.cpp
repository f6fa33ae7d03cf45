// Single meshes that a lattice repeats: what is refused, and what is named. That lemma and
// definition agree is in properties/periodic_property.cpp.
#include "oracle/judge/periodic/judge_periodic.hpp"

#include <doctest/doctest.h>

#include "oracle/judge/periodic/unfolded.hpp"
#include "oracle/model/exact_mesh.hpp"

namespace circumspect::check {
namespace {

// Three copies of a point are the corners of a triangle.
Mesh point_and_triangle() {
  Mesh listed;
  listed.coordinates = numbers_of({{0, 0}}, 2);
  listed.simplices = IndexLists({{0, 0, 0}});
  return listed;
}

// The lattice is twice as fine as the mesh is wide. The long first triangle has its centre twice,
// and no other triangle has it.
TEST_CASE("a cell that covers a point twice, though all facets fit") {
  Mesh listed;
  listed.coordinates =
      numbers_of({{0, 0}, {Rational(8, 5), Rational(-1, 4)}, {Rational(8, 5), Rational(1, 4)}}, 2);
  listed.simplices = IndexLists({{0, 1, 2}, {1, 0, 2}, {0, 2, 1}, {0, 1, 0}, {2, 0, 0}, {2, 0, 1}});
  const Periodic how{.lattice = {{1, 0}, {0, 1}},
                     .offsets = {{0, 0, 0, 0, 0, 0},
                                 {0, 0, 2, 0, 0, 0},
                                 {0, 0, 0, 0, 0, 1},
                                 {0, 0, 0, 1, 0, 1},
                                 {0, 0, 2, 0, 2, 1},
                                 {0, 0, 2, 1, 0, 1}}};
  const Verdict verdict = judge_periodic(unfolded(listed, how), {});
  REQUIRE(verdict.tallies().size() == 1);
  REQUIRE(verdict.tallies().contains(Rule::kCoveredTwice));
  CHECK(verdict.violations().front().witness.places == std::vector<std::size_t>{0, 0});
}

TEST_CASE("a mesh is refused whose offsets are not those of its cells") {
  Mesh listed = point_and_triangle();
  const auto fault = [&listed](const std::vector<Simplex>& offsets) {
    return fault_of_periodic(listed, {.lattice = {{1, 0}, {0, 1}}, .offsets = offsets});
  };
  CHECK(fault({{0, 0, 1, 0, 0, 1}}).empty());
  CHECK(fault({}) == "expected the offsets of 1 cell, found those of 0");
  CHECK(fault({{0, 0, 1, 0, 0}}) ==
        "expected 6 integers as the offsets of cell 0, 2 for each corner, found 5");
  listed.simplices = IndexLists(std::vector<Simplex>{});
  CHECK(fault({}) == "expected cells for the claim periodic-delaunay, found none");
  listed.coordinates = numbers_of({{0}}, 1);
  CHECK(fault({}) ==
        "expected points in the plane or in space for the claim periodic-delaunay, "
        "found dimension 1");
}

TEST_CASE("offsets beyond 2^32 are refused in either direction") {
  const Mesh listed = point_and_triangle();
  Periodic how{.lattice = {{1, 0}, {0, 1}}, .offsets = {{0, 0, 1, 0, 0, 1}}};
  CHECK(fault_of_periodic(listed, how).empty());
  const Vertex most = Vertex{1} << 32U;
  for (Vertex& offset : how.offsets.front()) {
    for (const Vertex beyond : {most, -most}) {
      offset = beyond;
      CHECK(fault_of_periodic(listed, how).empty());
      offset += beyond > 0 ? 1 : -1;
      CHECK(fault_of_periodic(listed, how).find("offsets of at most 2^32, found") !=
            std::string::npos);
    }
    offset = 0;
  }
}

TEST_CASE("a lattice is refused that has not a vector for each axis") {
  const Mesh listed = point_and_triangle();
  for (const std::vector<Point>& lattice : std::vector<std::vector<Point>>{
           {{1, 0}}, {{1, 0}, {0, 1}, {1, 1}}, {{1, 0}, {0, 1, 0}}, {{1}, {0, 1}}}) {
    const Periodic how{.lattice = lattice, .offsets = {{0, 0, 1, 0, 0, 1}}};
    CHECK(fault_of_periodic(listed, how).find("a lattice of 2 vectors that span the plane") !=
          std::string::npos);
  }
}

TEST_CASE("flat cells are named, though they span nothing") {
  const Mesh listed = point_and_triangle();
  const Periodic how{.lattice = {{1, 0}, {0, 1}}, .offsets = {{0, 0, 1, 0, 2, 0}}};
  const Mesh mesh = unfolded(listed, how);
  CHECK(exact(mesh).points.dimension() == 2);
  for (const auto by : {By::kLemma, By::kDefinition}) {
    CHECK(judge_periodic(mesh, {.by = by}).tallies().contains(Rule::kDegenerateSimplex));
  }
}

}  // namespace
}  // namespace circumspect::check
