// Simplices as tuples of vertices, and triangulations as sets of simplices.
#include "reference/kernel/complex/simplex.hpp"

#include <algorithm>
#include <utility>

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "properties/arguments/numbers.hpp"
#include "reference/kernel/complex/triangulation.hpp"

namespace circumspect {
namespace {

// ---- Simplices as tuples of vertices, and subsets ----

// Distinct vertices in any order: a subset of 0, 3, 6, … shuffled by transpositions. `odd` says
// whether their number is odd.
Simplex shuffled(std::size_t size, bool& odd) {
  Simplex simplex;
  for (std::size_t i = 0; i < size; ++i) simplex.push_back(static_cast<Vertex>(3 * i));
  odd = false;
  for (std::size_t i = 1; i < size; ++i) {
    const auto j = static_cast<std::size_t>(*generators::below(static_cast<long>(i) + 1));
    if (j == i) continue;
    std::swap(simplex[i], simplex[j]);
    odd = !odd;
  }
  return simplex;
}

TEST_CASE("simplex: worked examples") {
  CHECK(sorted({5, 2, 9}) == Simplex{2, 5, 9});
  CHECK(facet_opposite({5, 2, 9}, 1) == Simplex{5, 9});
  CHECK(facet_opposite({5}, 0).empty());
  CHECK(with_vertex_replaced({5, 2, 9}, 1, 7) == Simplex{5, 7, 9});
  CHECK(contains({5, 2, 9}, 9));
  CHECK_FALSE(contains({5, 2, 9}, 3));
  CHECK(has_repeated_vertex({5, 2, 5}));
  CHECK_FALSE(has_repeated_vertex({5, 2, 9}));
  CHECK_FALSE(has_repeated_vertex({}));
  CHECK(is_odd_permutation({5, 2}));
  CHECK_FALSE(is_odd_permutation({5, 9, 2}) == is_odd_permutation({9, 5, 2}));
}

TEST_CASE("simplex: a permutation is odd iff it is made of an odd number of swaps") {
  CHECK(rc::check([] {
    bool odd = false;
    const Simplex simplex = shuffled(static_cast<std::size_t>(*generators::below(8)), odd);
    RC_ASSERT(is_odd_permutation(simplex) == odd);
  }));
}

TEST_CASE("simplex: sorting keeps the vertices and forgets their order") {
  CHECK(rc::check([] {
    bool odd = false;
    const Simplex simplex = shuffled(6, odd);
    const Simplex ascending = sorted(simplex);
    RC_ASSERT(std::is_sorted(ascending.begin(), ascending.end()));
    RC_ASSERT(std::is_permutation(simplex.begin(), simplex.end(), ascending.begin()));
  }));
}

TEST_CASE("simplex: a facet holds every vertex but its opposite, in their order") {
  CHECK(rc::check([] {
    bool odd = false;
    const Simplex simplex = shuffled(5, odd);
    for (std::size_t place = 0; place < simplex.size(); ++place) {
      const Simplex facet = facet_opposite(simplex, place);
      RC_ASSERT(facet.size() + 1 == simplex.size());
      RC_ASSERT(!contains(facet, simplex[place]));
      Simplex restored = facet;
      restored.insert(restored.begin() + static_cast<Vertex>(place), simplex[place]);
      RC_ASSERT(restored == simplex);
      RC_ASSERT(with_vertex_replaced(simplex, place, 1)[place] == 1);
      RC_ASSERT(facet_opposite(with_vertex_replaced(simplex, place, 1), place) == facet);
    }
  }));
}

TEST_CASE("simplex: a repeated vertex is found wherever it stands") {
  CHECK(rc::check([] {
    bool odd = false;
    Simplex simplex = shuffled(6, odd);
    RC_ASSERT(!has_repeated_vertex(simplex));
    const auto i = static_cast<std::size_t>(*generators::below(6));
    const auto j = static_cast<std::size_t>(*generators::below(6));
    simplex[i] = simplex[j];
    RC_ASSERT(has_repeated_vertex(simplex) == (i != j));
  }));
}

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

// ---- Triangulations as sets of simplices ----

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
