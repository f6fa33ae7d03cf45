// Facets, the hash table of oriented facets, and stars. Book: Section 5.1.
#include "reference/kernel/complex/facets.hpp"

#include <map>
#include <stdexcept>

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "properties/arguments/numbers.hpp"
#include "reference/kernel/complex/facet_table.hpp"
#include "reference/kernel/complex/star_index.hpp"

namespace circumspect {
namespace {

// ---- Which simplices have which facets ----

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

// ---- The hash table of oriented facets, against a map ----

using Contents = std::map<std::pair<Simplex, bool>, Vertex>;

Contents contents(const FacetTable& table) {
  Contents found;
  for (std::size_t slot = 0; slot < table.slots(); ++slot) {
    if (!table.is_entry(slot)) continue;
    const OrientedFacet facet = table.facet(slot);
    RC_ASSERT(found.emplace(std::pair(facet.vertices, facet.reversed), table.apex(slot)).second);
  }
  return found;
}

TEST_CASE("facet table: insertions and removals, growth and collisions, as in a map") {
  for (const std::size_t size : {1U, 2U, 3U, 4U}) {
    CHECK(rc::check("facets of " + std::to_string(size) + " vertices", [size] {
      FacetTable table;
      Contents expected;
      const int steps = *rc::gen::inRange(0, 400);
      for (int step = 0; step < steps; ++step) {
        Simplex vertices;
        Vertex next = -1;
        while (vertices.size() < size) {
          next += *rc::gen::inRange<Vertex>(0, size == 1 ? 60 : 5) + (vertices.empty() ? 0 : 1);
          vertices.push_back(next);
        }
        const OrientedFacet facet{vertices, *rc::gen::arbitrary<bool>()};
        const std::pair key(facet.vertices, facet.reversed);
        const auto entry = expected.find(key);
        RC_ASSERT(table.find(facet) ==
                  (entry == expected.end() ? std::nullopt : std::optional(entry->second)));
        if (entry == expected.end()) {
          RC_ASSERT(table.insert(facet, step));
          expected[key] = step;
        } else if (step % 3 == 0) {
          RC_ASSERT(!table.insert(facet, step));
        } else {
          table.erase(facet);
          expected.erase(entry);
        }
      }
      RC_ASSERT(contents(table) == expected);
    }));
  }
}

// ---- Stars and links of faces in a triangulation that changes ----

using Simplices = std::vector<Simplex>;

// Two triangles beside the edge 12, given with their vertices in some order.
const Simplices kTwoTriangles{{2, 0, 1}, {1, 3, 2}};

TEST_CASE("star index: the star of a face is all that have it, however its vertices are ordered") {
  const StarIndex index(kTwoTriangles);
  CHECK(index.size() == 2);
  CHECK(index.star({0}) == Simplices{{0, 1, 2}});
  CHECK(index.star({2}) == Simplices{{0, 1, 2}, {1, 2, 3}});
  CHECK(index.star({2, 1}) == Simplices{{0, 1, 2}, {1, 2, 3}});
  CHECK(index.star({3, 1}) == Simplices{{1, 2, 3}});
  CHECK(index.star({3, 1, 2}) == Simplices{{1, 2, 3}});
  CHECK(index.star({}) == Simplices{{0, 1, 2}, {1, 2, 3}});
  CHECK(index.star({0, 3}).empty());
  CHECK(index.star({0, 7}).empty());
  CHECK(index.star({0, 1, 2, 3}).empty());
}

TEST_CASE("star index: the link of a face is what the star joins it to") {
  const StarIndex index(kTwoTriangles);
  CHECK(index.link({2, 1}) == Simplices{{0}, {3}});
  CHECK(index.link({1}) == Simplices{{0, 2}, {2, 3}});
  CHECK(index.link({2, 1, 0}) == Simplices{{}});
  CHECK(index.link({0, 3}).empty());
}

TEST_CASE("star index: simplices are replaced, and stars with them") {
  StarIndex index(kTwoTriangles);
  index.replace({{1, 0, 2}, {1, 2, 3}}, {{3, 0, 1}, {0, 2, 3}});
  CHECK(index.has({1, 0, 3}));
  CHECK(!index.has({0, 1, 2}));
  CHECK(index.star({1, 2}).empty());
  CHECK(index.star({0, 3}) == Simplices{{0, 1, 3}, {0, 2, 3}});
  CHECK(index.triangulation(2) == Triangulation(2, {{0, 1, 3}, {0, 2, 3}}));
  index.replace({{0, 1, 3}}, {});
  CHECK(index.star({1}).empty());
}

TEST_CASE("star index: what is not there cannot be deleted, nor what is there be created") {
  StarIndex index(kTwoTriangles);
  CHECK_THROWS_AS(index.replace({{0, 1, 3}}, {}), std::logic_error);
  CHECK_THROWS_AS(index.replace({}, {{1, 2, 0}}), std::logic_error);
}

TEST_CASE("star index: facets, joins and rests of simplices") {
  CHECK(facets_of(kTwoTriangles) == Simplices{{0, 1}, {0, 2}, {1, 2}, {1, 3}, {2, 3}});
  CHECK(facets_of({{4}}) == Simplices{{}});
  CHECK(join({5, 1}, {3}) == Simplex{1, 3, 5});
  CHECK(join({}, {3}) == Simplex{3});
  CHECK(without({5, 3, 1}, {3}) == Simplex{1, 5});
  CHECK(without({5, 3}, {3, 5}).empty());
}

}  // namespace

}  // namespace circumspect
