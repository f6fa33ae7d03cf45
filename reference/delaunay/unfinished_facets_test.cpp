#include "reference/delaunay/unfinished_facets.hpp"

#include <vector>

#include <doctest/doctest.h>

namespace circumspect {

namespace {

TEST_CASE("unfinished facets: a simplex finishes those it is in front of and leaves the others") {
  UnfinishedFacets unfinished;
  CHECK(unfinished.empty());
  unfinished.add(OrientedFacet::of({0, 1}));
  unfinished.adjoin({0, 1, 2});
  // The edges 12 and 20 of the triangle 012 are open towards the outside.
  CHECK(unfinished.all() ==
        std::vector<OrientedFacet>{OrientedFacet::of({0, 2}), OrientedFacet::of({2, 1})});
  unfinished.adjoin({2, 1, 3});
  CHECK(unfinished.all().size() == 3);
  unfinished.remove(OrientedFacet::of({0, 2}));
  CHECK(unfinished.first() == OrientedFacet::of({3, 1}));
}

TEST_CASE("unfinished facets: both sides of a seed are apart, also where it is a single point") {
  for (const Simplex& seed : {Simplex{4}, Simplex{4, 7}, Simplex{4, 7, 9}}) {
    UnfinishedFacets unfinished;
    unfinished.add(OrientedFacet::of(seed));
    unfinished.add(OrientedFacet::of(seed).reverse());
    CHECK(unfinished.all().size() == 2);
    unfinished.remove(OrientedFacet::of(seed));
    CHECK(unfinished.first() == OrientedFacet::of(seed).reverse());
  }
}

TEST_CASE("unfinished facets: the boundary of a closed complex is empty") {
  UnfinishedFacets unfinished;
  unfinished.adjoin({0, 1, 2, 3});
  for (const OrientedFacet& facet : unfinished.all()) unfinished.adjoin(join(facet, 4));
  CHECK(unfinished.empty());
}

}  // namespace
}  // namespace circumspect
