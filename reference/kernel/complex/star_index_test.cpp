// Stars and links of faces in a triangulation that changes.
#include "reference/kernel/complex/star_index.hpp"

#include <stdexcept>

#include <doctest/doctest.h>

namespace circumspect {
namespace {

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
