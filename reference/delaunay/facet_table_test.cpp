#include "reference/delaunay/facet_table.hpp"

#include <map>
#include <string>
#include <utility>

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "properties/arguments/run.hpp"

namespace circumspect {

namespace {

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
    CHECK(properties::holds("facets of " + std::to_string(size) + " vertices", [size] {
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

}  // namespace
}  // namespace circumspect
