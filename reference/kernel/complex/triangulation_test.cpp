// Triangulations as sets of simplices.
#include "reference/kernel/complex/triangulation.hpp"

#include <doctest/doctest.h>

namespace circumspect {
namespace {

TEST_CASE("triangulation: neither the order of simplices nor that of vertices counts") {
  const Triangulation a(2, {{0, 1, 2}, {1, 3, 2}});
  const Triangulation b(2, {{3, 2, 1}, {2, 0, 1}});
  CHECK(a == b);
  CHECK(a.simplices() == std::vector<Simplex>{{0, 1, 2}, {1, 2, 3}});
  CHECK(!(a == Triangulation(2, {{0, 1, 3}, {0, 2, 3}})));
  CHECK(!(a == Triangulation(2, {{0, 1, 2}})));
}

TEST_CASE("triangulation: it has its simplices, in any order, and no others") {
  const Triangulation triangulation(2, {{0, 1, 2}, {1, 3, 2}});
  CHECK(triangulation.has({2, 1, 0}));
  CHECK(triangulation.has({3, 1, 2}));
  CHECK(!triangulation.has({0, 1, 3}));
  CHECK(!triangulation.has({1, 2}));
}

TEST_CASE("triangulation: that of no points is not that of one point") {
  const Triangulation none(-1, {});
  CHECK(none.dimension() == -1);
  CHECK(none.simplices().empty());
  CHECK(!none.has({}));
  CHECK(!(none == Triangulation(0, {{0}})));
}

TEST_CASE("triangulation: the apexes at each facet, two inside and one on the hull") {
  const auto apexes = apexes_by_facet(Triangulation(2, {{0, 1, 2}, {3, 2, 1}}));
  CHECK(apexes.size() == 5);
  CHECK(apexes.at({1, 2}) == std::vector<Vertex>{0, 3});
  CHECK(apexes.at({0, 1}) == std::vector<Vertex>{2});
  CHECK(apexes.at({2, 3}) == std::vector<Vertex>{1});
  CHECK(apexes_by_facet(Triangulation(0, {{4}})).at({}) == std::vector<Vertex>{4});
  CHECK(apexes_by_facet(Triangulation(-1, {})).empty());
}

}  // namespace
}  // namespace circumspect
