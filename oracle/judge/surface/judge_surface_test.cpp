// The claim `surface-delaunay`, by lemma and by definition.
#include "oracle/judge/surface/judge_surface.hpp"

#include <doctest/doctest.h>

namespace circumspect::check {
namespace {

Verdict judged(const std::vector<Point>& points, const std::vector<Simplex>& triangles) {
  const ExactMesh mesh{PointSet(points), triangles};
  const Verdict verdict = judge_surface(mesh, false, 0);
  const Verdict by_definition = judge_surface(mesh, true, 0);
  CHECK(verdict.holds() == by_definition.holds());
  return verdict;
}

const std::vector<Simplex> kTwo = {{0, 1, 2}, {1, 0, 3}};

TEST_CASE("two triangles bent along their edge are as good as flat ones") {
  // The angles opposite are 90 degrees each, whatever the angle between the triangles.
  CHECK(judged({{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, -1, 0}}, kTwo).holds());
  CHECK(judged({{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, 0, 1}}, kTwo).holds());
  const Verdict wide = judged({{0, 0, 0}, {4, 0, 0}, {2, 1, 0}, {2, 0, 1}}, kTwo);
  REQUIRE(wide.violations().size() == 1);
  const Witness& witness = wide.violations()[0].witness;
  CHECK(witness.face == Simplex{0, 1});
  CHECK(witness.vertices == std::vector<Vertex>{2, 3});
  CHECK(witness.values[0].value == Rational(-9, 25));
  CHECK(witness.rounded[0].decimal == "73.73979529168804");
}

TEST_CASE("one wide angle is made up for by a narrow one, to the last bit") {
  // cot α = −3/4, and cot β is 3/4 at a height of 4.
  const auto with_apex_at = [](const Rational& height) {
    return judged({{-2, 0, 0}, {2, 0, 0}, {0, 0, height}, {0, 0, 1}}, kTwo);
  };
  const Verdict exact = with_apex_at(4);
  CHECK(exact.holds());
  CHECK(with_apex_at(Rational(4) + Rational(1, Integer("1000000000000000000000000"))).holds());
  CHECK(!with_apex_at(Rational(4) - Rational(1, Integer("1000000000000000000000000"))).holds());
}

TEST_CASE("edges of more than two triangles are counted and not judged") {
  const Verdict pages = judged({{0, 0, 0}, {4, 0, 0}, {2, 1, 0}, {2, 0, 1}, {2, -1, 0}},
                               {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});
  CHECK(pages.holds());
  CHECK(pages.surface->edges_of_many == 1);
  CHECK(pages.surface->boundary_edges == 6);
  CHECK(pages.surface->interior_edges == 0);
}

TEST_CASE("what is not a surface is refused, with what to do") {
  const auto fault = [](const std::vector<Simplex>& simplices) {
    return fault_of_surface(in_rows(
        {PointSet(std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}), simplices}));
  };
  CHECK(fault({{0, 1, 2}}) == "");
  CHECK(fault({}) == "expected triangles for the claim surface-delaunay, found no simplices");
  CHECK(fault({{0, 1, 2, 3}}) ==
        "expected triangles for the claim surface-delaunay, found simplices of 4 vertices: it is "
        "about surfaces; --claim delaunay is about what fills space");
}

}  // namespace
}  // namespace circumspect::check
