// Which simplices have which facets.
#include "reference/kernel/complex/facets.hpp"

#include <map>

#include <doctest/doctest.h>

#include "inputs/scalars.hpp"

namespace circumspect {
namespace {

TEST_CASE("facets: two triangles share one of five edges") {
  const std::vector<FacetUse> uses = facet_uses({{2, 0, 1}, {1, 2, 3}});
  REQUIRE(uses.size() == 6);
  std::vector<Simplex> shared;
  std::size_t facets = 0;
  for_each_facet(uses, [&](std::span<const FacetUse> group) {
    ++facets;
    if (group.size() != 2) return;
    shared.push_back(group[0].facet);
    CHECK(group[0].simplex == 0);
    CHECK(group[0].opposite == 1);  // vertex 0 of {2, 0, 1}
    CHECK(group[1].simplex == 1);
    CHECK(group[1].opposite == 2);  // vertex 3 of {1, 2, 3}
  });
  CHECK(facets == 5);
  CHECK(shared == std::vector<Simplex>{{1, 2}});
}

TEST_CASE("facets: none of no simplices; one empty facet of vertices; points of edges") {
  CHECK(facet_uses({}).empty());
  for_each_facet({}, [](std::span<const FacetUse>) { FAIL("there is no facet"); });
  const std::vector<FacetUse> of_vertices = facet_uses({{7}, {4}});
  REQUIRE(of_vertices.size() == 2);
  CHECK(of_vertices[0].facet.empty());
  CHECK(of_vertices[0].simplex == 0);
  CHECK(of_vertices[1].simplex == 1);
  CHECK(facet_uses({{5, 3}}).front().facet == Simplex{3});
  CHECK(facet_uses({{5, 3}}).front().opposite == 0);
}

TEST_CASE("facets: every facet once, with exactly the simplices that contain it, in order") {
  CHECK(rc::check([] {
    const auto size = static_cast<std::size_t>(1 + *generators::below(4));
    const auto simplices = *rc::gen::container<std::vector<Simplex>>(
        rc::gen::unique<Simplex>(size, rc::gen::inRange<Vertex>(0, 6)));
    std::map<Simplex, std::vector<std::pair<std::size_t, std::size_t>>> expected;
    for (std::size_t s = 0; s < simplices.size(); ++s) {
      for (std::size_t place = 0; place < size; ++place) {
        expected[sorted(facet_opposite(simplices[s], place))].emplace_back(s, place);
      }
    }
    auto next = expected.begin();
    for_each_facet(facet_uses(simplices), [&](std::span<const FacetUse> group) {
      RC_ASSERT(next != expected.end());
      RC_ASSERT(group.size() == next->second.size());
      for (std::size_t i = 0; i < group.size(); ++i) {
        RC_ASSERT(group[i].facet == next->first);
        RC_ASSERT(std::pair(group[i].simplex, group[i].opposite) == next->second[i]);
      }
      ++next;
    });
    RC_ASSERT(next == expected.end());
  }));
}

}  // namespace
}  // namespace circumspect
