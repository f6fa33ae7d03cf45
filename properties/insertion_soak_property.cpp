// D2 at length: larger sets, more of them, in dimensions up to 5. Book: Sections 5.2 to 5.5.
#include <tuple>

#include <doctest/doctest.h>

#include "properties/arguments/point_sets.hpp"
#include "properties/arguments/run.hpp"
#include "reference/delaunay/bowyer_watson.hpp"
#include "reference/delaunay/lifted_hull.hpp"

namespace circumspect::properties {
namespace {

using delaunay::InsertionOrder;
using delaunay::PointLocation;
using generators::PointsCase;

TEST_CASE("D2 at length: every order and every point location, and the definition") {
  for (const auto& [dimension, max_points, successes] : {std::tuple(1u, 60u, 500),
                                                         {2u, 60u, 3000},
                                                         {3u, 40u, 3000},
                                                         {4u, 16u, 1000},
                                                         {5u, 11u, 200}}) {
    const unsigned d = dimension;
    CAPTURE(d);
    CHECK(holds("orders and locations agree", successes, [d, max_points = max_points] {
      const auto sets = generators::any_point_set(d, max_points);
      const PointsCase set =
          *rc::gen::oneOf(generators::unweighted(sets), generators::weighted(sets));
      const PointSet points(set.points, set.weights);
      const auto seed = *rc::gen::arbitrary<std::uint64_t>();
      const Triangulation expected = delaunay::bowyer_watson(points);
      if (points.size() <= 13) RC_ASSERT(delaunay::by_definition(points) == expected);
      for (const auto order : {InsertionOrder::kAsGiven, InsertionOrder::kRandom,
                               InsertionOrder::kBrioHilbert, InsertionOrder::kBrioZOrder}) {
        for (const auto location :
             {PointLocation::kLinearScan, PointLocation::kConflictGraph, PointLocation::kWalking}) {
          RC_ASSERT(delaunay::bowyer_watson(points, {order, location, seed}) == expected);
        }
      }
    }));
  }
}

}  // namespace
}  // namespace circumspect::properties
