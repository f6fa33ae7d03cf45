// Simplices, their facets, and the stars of faces.
#include "kernel/complex/simplex.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "kernel/complex/by_facet.hpp"
#include "kernel/complex/star_index.hpp"
#include "kernel/complex/triangulation.hpp"
#include "properties/arguments/generated.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect {

// Simplices as tuples of vertices, and triangulations as sets of simplices.

namespace {

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
  CHECK(properties::holds([] {
    bool odd = false;
    const Simplex simplex = shuffled(static_cast<std::size_t>(*generators::below(8)), odd);
    RC_ASSERT(is_odd_permutation(simplex) == odd);
  }));
}

TEST_CASE("simplex: sorting keeps the vertices and forgets their order") {
  CHECK(properties::holds([] {
    bool odd = false;
    const Simplex simplex = shuffled(6, odd);
    const Simplex ascending = sorted(simplex);
    RC_ASSERT(std::is_sorted(ascending.begin(), ascending.end()));
    RC_ASSERT(std::is_permutation(simplex.begin(), simplex.end(), ascending.begin()));
  }));
}

TEST_CASE("simplex: a facet holds every vertex but its opposite, in their order") {
  CHECK(properties::holds([] {
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
  CHECK(properties::holds([] {
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

TEST_CASE("faces: of a simplex in its order, the smaller first; of several each once") {
  CHECK(faces({9, 4, 7}) == std::vector<Simplex>{{9}, {4}, {7}, {9, 4}, {9, 7}, {4, 7}, {9, 4, 7}});
  CHECK(faces({9, 4, 7}, 2) == std::vector<Simplex>{{9, 4}, {9, 7}, {4, 7}});
  CHECK(faces({9, 4, 7}, 4).empty());
  const std::vector<Simplex> two = {{3, 2, 1}, {0, 1, 2}, {5}};
  CHECK(faces_of(two, 2) == std::vector<Simplex>{{0, 1}, {0, 2}, {1, 2}, {1, 3}, {2, 3}});
  CHECK(faces_of(two, 1) == std::vector<Simplex>{{0}, {1}, {2}, {3}, {5}});
  CHECK(count_with_face(two, {2, 1}) == 2);
  CHECK(count_with_face(two, {0, 1, 3}) == 0);
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

// Facets, the hash table of oriented facets, and stars. Book: Section 5.1.

TEST_CASE("facets: two triangles share one of five edges") {
  const std::vector<FacetUse> uses = facet_uses({{2, 0, 1}, {1, 2, 3}});
  REQUIRE(uses.size() == 6);
  std::vector<Simplex> shared;
  std::size_t facets = 0;
  for (const auto group : ByFacet(uses)) {
    ++facets;
    if (group.size() != 2) continue;
    shared.push_back(group[0].facet);
    CHECK(group[0].simplex == 0);
    CHECK(group[0].opposite == 1);  // vertex 0 of {2, 0, 1}
    CHECK(group[1].simplex == 1);
    CHECK(group[1].opposite == 2);  // vertex 3 of {1, 2, 3}
  }
  CHECK(facets == 5);
  CHECK(shared == std::vector<Simplex>{{1, 2}});
}

TEST_CASE("facets: none of no simplices; one empty facet of vertices; points of edges") {
  CHECK(facet_uses({}).empty());
  for (const auto uses : ByFacet(facet_uses({}))) CHECK(uses.empty());  // there is none
  const std::vector<FacetUse> of_vertices = facet_uses({{7}, {4}});
  REQUIRE(of_vertices.size() == 2);
  CHECK(of_vertices[0].facet.empty());
  CHECK(of_vertices[0].simplex == 0);
  CHECK(of_vertices[1].simplex == 1);
  CHECK(facet_uses({{5, 3}}).front().facet == Simplex{3});
  CHECK(facet_uses({{5, 3}}).front().opposite == 0);
}

TEST_CASE("facets: every facet once, with exactly the simplices that contain it, in order") {
  CHECK(properties::holds([] {
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
    for (const auto group : ByFacet(facet_uses(simplices))) {
      RC_ASSERT(next != expected.end());
      RC_ASSERT(group.size() == next->second.size());
      for (std::size_t i = 0; i < group.size(); ++i) {
        RC_ASSERT(group[i].facet == next->first);
        RC_ASSERT(std::pair(group[i].simplex, group[i].opposite) == next->second[i]);
      }
      ++next;
    }
    RC_ASSERT(next == expected.end());
  }));
}

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
  CHECK(join(Simplex{}, Simplex{3}) == Simplex{3});
  CHECK(without({5, 3, 1}, {3}) == Simplex{1, 5});
  CHECK(without({5, 3}, {3, 5}).empty());
}

}  // namespace
}  // namespace circumspect
