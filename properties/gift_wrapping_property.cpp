// D2: gift-wrapping, with the perturbation and by whole cells without it, returns the canonical
// triangulation. Book: Section 5.6 and Exercise 4 of Chapter 5.
#include <doctest/doctest.h>

#include "kernel/complex/circumball.hpp"
#include "kernel/complex/point_set.hpp"
#include "oracle/model/verdict.hpp"
#include "properties/arguments/laws.hpp"
#include "properties/arguments/point_sets.hpp"
#include "properties/arguments/run.hpp"
#include "reference/delaunay/bowyer_watson.hpp"
#include "reference/delaunay/genericity.hpp"
#include "reference/delaunay/gift_wrapping.hpp"
#include "reference/delaunay/gift_wrapping_cells.hpp"
#include "reference/delaunay/lifted_hull.hpp"

namespace circumspect::properties {
namespace {

using generators::PointsCase;

int successes(std::size_t d) { return d >= 5 ? 20 : d == 4 ? 60 : 200; }

bool has_facet(const Triangulation& triangulation, const Simplex& facet) {
  return apexes_by_facet(triangulation).count(facet) == 1;
}

TEST_CASE("D2 gift-wrapping is the canonical triangulation (Section 5.6)") {
  for (const std::size_t d : {1u, 2u, 3u, 4u, 5u}) {
    CAPTURE(d);
    CHECK(holds("gift-wrapping, degenerate sets", successes(d), [d] {
      const PointsCase set =
          *generators::unweighted(generators::degenerate_point_set(d, d >= 4 ? 9 : 12));
      const PointSet points(set.points);
      RC_ASSERT(delaunay::gift_wrapping(points) == delaunay::by_definition(points));
    }));
    CHECK(holds("gift-wrapping, any set, with weights and without", successes(d), [d] {
      const PointsCase set = *generators::any_case(d, d >= 4 ? 9 : 12);
      const PointSet points(set.points, set.weights);
      RC_ASSERT(delaunay::gift_wrapping(points) == delaunay::by_definition(points));
    }));
  }
}

TEST_CASE("D2 gift-wrapping of more points agrees with Bowyer-Watson (Sections 5.2, 5.6)") {
  for (const std::size_t d : {2u, 3u}) {
    CAPTURE(d);
    CHECK(holds("gift-wrapping, larger degenerate sets", 30, [d] {
      const PointsCase set = *generators::unweighted(generators::degenerate_point_set(d, 25));
      const PointSet points(set.points);
      const Triangulation expected = delaunay::bowyer_watson(points);
      RC_ASSERT(delaunay::gift_wrapping(points) == expected);
      RC_ASSERT(delaunay::gift_wrapping_by_cells(points) == expected);
    }));
  }
}

TEST_CASE("D2 gift-wrapping of whole cells is canonical (Exercise 4 of Chapter 5)") {
  for (const std::size_t d : {1u, 2u, 3u, 4u, 5u}) {
    CAPTURE(d);
    CHECK(holds("cells wrapped without perturbation", successes(d), [d] {
      const PointsCase set = *generators::any_case(d, d >= 4 ? 9 : 12);
      const PointSet points(set.points, set.weights);
      RC_ASSERT(delaunay::gift_wrapping_by_cells(points) == delaunay::by_definition(points));
    }));
  }
}

TEST_CASE("D2 the seed on the hull is a facet of the canonical triangulation (Section 5.6)") {
  for (const std::size_t d : {1u, 2u, 3u, 4u}) {
    CAPTURE(d);
    CHECK(holds("hull facet seed", successes(d), [d] {
      const PointsCase set = *generators::any_case(d, 8);
      const PointSet points(set.points, set.weights);
      RC_PRE(points.dimension() >= 1);
      const auto apexes = apexes_by_facet(delaunay::by_definition(points));
      const auto found = apexes.find(delaunay::hull_facet_seed(points));
      RC_ASSERT(found != apexes.end());
      RC_ASSERT(found->second.size() == 1);
    }));
  }
}

TEST_CASE("D3 the nearest-neighbour seed of a generic set is strongly Delaunay (Section 5.6)") {
  for (const std::size_t d : {1u, 2u, 3u, 4u}) {
    CAPTURE(d);
    std::size_t inside = 0;
    CHECK(holds("nearest-neighbour seed", successes(d), [&] {
      const PointsCase set = *generators::unweighted(generators::any_point_set(d, 8));
      const PointSet points(set.points);
      RC_PRE(points.dimension() >= 1);
      RC_PRE(!delaunay::cospherical_points(points).has_value());
      const Simplex seed = delaunay::nearest_neighbour_seed(points);
      const Triangulation expected = delaunay::by_definition(points);
      // All simplices of the one triangulation of a generic set are strongly Delaunay.
      RC_ASSERT(has_facet(expected, seed));
      // The smallest circumball is empty, and shows it unless a point lies on its sphere.
      const Ball ball = circumball(points, seed);
      for (Vertex q = 0; points.names(q); ++q) {
        RC_ASSERT(contains(seed, q) || sign(power(points, ball, q)) >= 0);
      }
      RC_ASSERT(delaunay::gift_wrapping(points, seed) == expected);
      inside += apexes_by_facet(expected).at(seed).size() == 2 ? 1u : 0u;
    }));
    CHECK(occurs(inside));  // seeds that are not on the hull occur
  }
}

}  // namespace
}  // namespace circumspect::properties
