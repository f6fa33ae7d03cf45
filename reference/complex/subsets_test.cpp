// All subsets of one size.
#include "reference/complex/subsets.hpp"

#include <algorithm>

#include <doctest/doctest.h>

namespace circumspect {
namespace {

std::vector<Simplex> all_subsets(std::size_t size, std::size_t n) {
  std::vector<Simplex> all;
  Simplex subset = first_subset(size);
  do all.push_back(subset);
  while (next_subset(subset, n));
  return all;
}

// The same by counting through all bit patterns.
std::vector<Simplex> by_bit_patterns(std::size_t size, std::size_t n) {
  std::vector<Simplex> all;
  for (std::size_t bits = 0; bits < std::size_t{1} << n; ++bits) {
    Simplex subset;
    for (std::size_t v = 0; v < n; ++v) {
      if ((bits >> v & 1) != 0) subset.push_back(static_cast<Vertex>(v));
    }
    if (subset.size() == size) all.push_back(subset);
  }
  std::sort(all.begin(), all.end());
  return all;
}

TEST_CASE("subsets: the pairs of four, in lexicographic order") {
  CHECK(all_subsets(2, 4) == std::vector<Simplex>{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}});
}

TEST_CASE("subsets: all of every size, each once, from the empty one to the whole set") {
  for (std::size_t n = 0; n <= 7; ++n) {
    for (std::size_t size = 0; size <= n; ++size) {
      CAPTURE(n);
      CAPTURE(size);
      CHECK(all_subsets(size, n) == by_bit_patterns(size, n));
    }
  }
}

}  // namespace
}  // namespace circumspect
