// D2 at length: every construction, order and point location on thousands of degenerate sets. Book:
// Theorem 4.4, Sections 4.2, 4.4, 5.2 to 5.6.
#include <doctest/doctest.h>

#include "inputs/in_doubles.hpp"
#include "properties/arguments/point_sets.hpp"
#include "properties/arguments/run.hpp"
#include "properties/every_construction.hpp"
#include "reference/delaunay/lifted_hull.hpp"

namespace circumspect::properties {
namespace {

// By definition takes n^(k+2) predicates, so that the larger sets are held against gift-wrapping.
void assert_agreement(std::size_t d, std::size_t max_points) {
  const auto sets = generators::degenerate_point_set(d, max_points);
  const generators::PointsCase set =
      *rc::gen::oneOf(generators::unweighted(sets), generators::weighted(sets));
  const PointSet points(set.points, set.weights);
  const Triangulation expected =
      points.size() <= 12 ? delaunay::by_definition(points) : delaunay::gift_wrapping(points);
  for (const NamedConstruction& construction :
       every_construction(*rc::gen::arbitrary<std::uint64_t>())) {
    RC_LOG(construction.name);
    RC_ASSERT(construction.construct(points) == expected);
  }
}

TEST_CASE("D2 every construction agrees on 500 small degenerate sets in each dimension") {
  for (const std::size_t d : {2u, 3u, 4u}) {
    CAPTURE(d);
    CHECK(holds("one canonical triangulation", 500, [d] { assert_agreement(d, 10); }));
  }
}

TEST_CASE("D2 D10 the fast construction agrees on ten thousand sets of doubles") {
  for (const std::size_t d : {2u, 3u}) {
    CAPTURE(d);
    CHECK(holds("one canonical triangulation", 5000, [d] {
      const auto set = generators::in_doubles(*generators::any_case(d, *rc::gen::element(12, 80)));
      RC_ASSERT(fast_agrees(PointSet(set.points, set.weights)) != false);
    }));
  }
}

TEST_CASE("D2 every construction agrees on larger degenerate sets") {
  for (const std::size_t d : {2u, 3u, 4u}) {
    CAPTURE(d);
    CHECK(
        holds("one canonical triangulation", 200, [d] { assert_agreement(d, d == 4 ? 16 : 30); }));
  }
}

}  // namespace
}  // namespace circumspect::properties
