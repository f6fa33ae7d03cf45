#include "reference/delaunay/dictionary.hpp"

#include <algorithm>
#include <stdexcept>

#include <doctest/doctest.h>

#include "properties/arguments/generated.hpp"
#include "properties/arguments/laws.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect {

namespace {

bool is_even_permutation_of(const Simplex& a, const Simplex& b) {
  return sorted(a) == sorted(b) && is_odd_permutation(a) == is_odd_permutation(b);
}

// k+1 different vertices out of few, perhaps the ghost among them, in any order.
rc::Gen<Simplex> simplex_of_dimension(std::size_t k) {
  return rc::gen::unique<Simplex>(k + 1, rc::gen::inRange<Vertex>(kGhost, 5));
}

// Are the two simplices on one side of a facet that they share? Replacing one apex by the other, in
// its place, turns one simplex into the other.
bool crowd_one_side(const Simplex& a, const Simplex& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (const Vertex apex : b) {
      if (is_even_permutation_of(with_vertex_replaced(a, i, apex), b)) return true;
    }
  }
  return false;
}

TEST_CASE("dictionary: joining a facet to the vertex it leaves out is an even permutation") {
  for (const std::size_t k : {1U, 2U, 3U, 4U}) {
    CHECK(properties::holds("dimension " + std::to_string(k), [k] {
      const Simplex simplex = *simplex_of_dimension(k);
      for (std::size_t place = 0; place <= k; ++place) {
        const OrientedFacet facet = OrientedFacet::opposite(simplex, place);
        RC_ASSERT(facet.vertices == sorted(facet_opposite(simplex, place)));
        RC_ASSERT(is_even_permutation_of(join(facet, simplex[place]), simplex));
        RC_ASSERT(!is_even_permutation_of(join(facet.reverse(), simplex[place]), simplex));
        RC_ASSERT(facet.reverse().reverse() == facet);
        RC_ASSERT(!(facet.reverse() == facet));
      }
    }));
  }
}

TEST_CASE("dictionary: the facet uvw is the one that x makes uvwx positive in front of") {
  CHECK(OrientedFacet::of({1, 2, 3}) == OrientedFacet::opposite({1, 2, 3, 9}, 3));
  CHECK(OrientedFacet::of({2, 3, 1}) == OrientedFacet::of({1, 2, 3}));
  CHECK(OrientedFacet::of({2, 1, 3}) == OrientedFacet::of({1, 2, 3}).reverse());
  CHECK(join(OrientedFacet::of({4, 7}), 5) == Simplex{4, 7, 5});
  CHECK(join(OrientedFacet::of({7, 4}), 5) == Simplex{4, 5, 7});
  // On a line: v is in front of u in the edge uv, u is in front of v's other side.
  CHECK(join(OrientedFacet::opposite({3, 8}, 0), 3) == Simplex{3, 8});
  CHECK(join(OrientedFacet::opposite({3, 8}, 1), 8) == Simplex{3, 8});
  CHECK(!(OrientedFacet::opposite({3, 8}, 0).reversed ==
          OrientedFacet::opposite({3, 8}, 1).reversed));
}

TEST_CASE("dictionary: two tetrahedra and a ghost, one on each side of a triangle at most") {
  SimplexDictionary dictionary;
  CHECK(dictionary.size() == 0);
  CHECK(dictionary.simplices().empty());
  CHECK(!dictionary.adjacent_to_vertex(0));
  dictionary.add({0, 1, 2, 3});
  dictionary.add({0, 2, 1, 4});
  dictionary.add({1, 0, 4, kGhost});
  CHECK(dictionary.size() == 3);
  CHECK(dictionary.adjacent(OrientedFacet::of({0, 1, 2})) == 3);
  CHECK(dictionary.adjacent(OrientedFacet::of({1, 2, 0})) == 3);
  CHECK(dictionary.adjacent(OrientedFacet::of({1, 0, 2})) == 4);
  CHECK(dictionary.adjacent(OrientedFacet::of({0, 1, 4})) == 2);
  CHECK(dictionary.adjacent(OrientedFacet::of({1, 0, 4})) == kGhost);
  CHECK(dictionary.adjacent(OrientedFacet::of({0, 1, 3})) == std::nullopt);
  CHECK_THROWS_AS(dictionary.add({0, 1, 2, 5}), std::logic_error);
}

TEST_CASE("dictionary: what must not be done to it throws") {
  SimplexDictionary dictionary;
  dictionary.add({0, 1, 2});
  CHECK_THROWS_AS(dictionary.add({0, 1, 2}), std::logic_error);
  CHECK_THROWS_AS(dictionary.add({1, 2, 0}), std::logic_error);
  CHECK_THROWS_AS(dictionary.remove({1, 0, 2}), std::logic_error);  // the other orientation
  CHECK_THROWS_AS(dictionary.remove({0, 1, 3}), std::logic_error);
  dictionary.remove({2, 0, 1});
  CHECK_THROWS_AS(dictionary.remove({0, 1, 2}), std::logic_error);
  CHECK(dictionary.size() == 0);
}

TEST_CASE("dictionary: a simplex at a vertex, also after the one added last is gone") {
  SimplexDictionary dictionary;
  dictionary.add({0, 1, 2});
  dictionary.add({0, 2, 3});
  const auto at_one = dictionary.adjacent_to_vertex(1);
  REQUIRE(at_one);
  CHECK(is_even_permutation_of(*at_one, {0, 1, 2}));
  dictionary.remove({0, 2, 3});
  const auto at_zero = dictionary.adjacent_to_vertex(0);
  REQUIRE(at_zero);
  CHECK(is_even_permutation_of(*at_zero, {0, 1, 2}));
  CHECK(!dictionary.adjacent_to_vertex(3));
  CHECK(!dictionary.adjacent_to_vertex(17));
  dictionary.add({0, 2, kGhost});
  CHECK(is_ghost(*dictionary.adjacent_to_vertex(kGhost)));
  CHECK(!is_ghost({0, 1, 2}));
}

// Compares the dictionary's answers for every facet and vertex with a plain list of its simplices.
void check_against_list(const SimplexDictionary& dictionary, const std::vector<Simplex>& list) {
  RC_ASSERT(dictionary.size() == list.size());
  std::vector<Simplex> held = dictionary.simplices();
  RC_ASSERT(std::is_sorted(held.begin(), held.end()));
  RC_ASSERT(held.size() == list.size());
  for (const Simplex& simplex : list) {
    const auto is_it = [&](const Simplex& other) { return is_even_permutation_of(simplex, other); };
    RC_ASSERT(std::count_if(held.begin(), held.end(), is_it) == 1);
    RC_ASSERT(is_it(dictionary.find(is_it).value()));
    for (std::size_t place = 0; place < simplex.size(); ++place) {
      RC_ASSERT(dictionary.adjacent(OrientedFacet::opposite(simplex, place)) == simplex[place]);
    }
  }
  RC_ASSERT(!dictionary.find([](const Simplex&) { return false; }));
  for (Vertex u = kGhost; u < 5; ++u) {
    const bool expected = std::any_of(list.begin(), list.end(),
                                      [u](const Simplex& simplex) { return contains(simplex, u); });
    const auto found = dictionary.adjacent_to_vertex(u);
    RC_ASSERT(found.has_value() == expected);
    if (!found) continue;
    RC_ASSERT(contains(*found, u));
    RC_ASSERT(std::any_of(list.begin(), list.end(), [&](const Simplex& simplex) {
      return is_even_permutation_of(simplex, *found);
    }));
  }
}

TEST_CASE("dictionary: after any additions and removals it is what a list would be") {
  for (const std::size_t k : {1U, 2U, 3U, 4U}) {
    CHECK(properties::holds("dimension " + std::to_string(k), [k] {
      SimplexDictionary dictionary;
      std::vector<Simplex> list;
      for (const Simplex& simplex :
           *rc::gen::container<std::vector<Simplex>>(simplex_of_dimension(k))) {
        const auto same = std::find_if(list.begin(), list.end(), [&](const Simplex& other) {
          return is_even_permutation_of(simplex, other);
        });
        if (same != list.end()) {
          dictionary.remove(simplex);
          list.erase(same);
        } else if (std::none_of(list.begin(), list.end(), [&](const Simplex& other) {
                     return crowd_one_side(simplex, other);
                   })) {
          dictionary.add(simplex);
          list.push_back(simplex);
        }
        check_against_list(dictionary, list);
      }
    }));
  }
}

}  // namespace
}  // namespace circumspect
