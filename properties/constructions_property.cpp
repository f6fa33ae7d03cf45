// D2: every construction returns the one canonical Delaunay triangulation. Book: Theorem 4.4,
// Section 5.2; the perturbation of Section 2.9.
#include <algorithm>
#include <numeric>

#include <doctest/doctest.h>

#include "kernel/complex/point_set.hpp"
#include "oracle/judge/domain/judge_exactly.hpp"
#include "properties/arguments/laws.hpp"
#include "properties/arguments/point_sets.hpp"
#include "properties/arguments/run.hpp"
#include "properties/every_construction.hpp"
#include "reference/delaunay/bowyer_watson.hpp"
#include "reference/delaunay/gift_wrapping.hpp"
#include "reference/delaunay/lifted_hull.hpp"

namespace circumspect::properties {
namespace {

using generators::PointsCase;

void assert_accepted(const PointSet& points, const Triangulation& triangulation) {
  const ExactMesh mesh{points, triangulation.simplices()};
  for (const check::By by : {check::By::kLemma, check::By::kDefinition}) {
    const Verdict verdict = check::judge_exactly(Claim::kDelaunay, mesh, nullptr, {.by = by});
    RC_ASSERT(verdict.holds());
    RC_ASSERT(verdict.canonical == true);
  }
}

// Every construction returns the canonical triangulation.
void assert_agreement(const PointSet& points, std::uint64_t seed) {
  const Triangulation expected = delaunay::by_definition(points);
  for (const NamedConstruction& construction : every_construction(seed)) {
    RC_LOG(construction.name);
    RC_ASSERT(construction.construct(points) == expected);
  }
}

TEST_CASE(
    "D2 by definition and Bowyer-Watson agree, and both checkers accept, on degenerate sets") {
  for (const std::size_t d : {1u, 2u, 3u}) {
    CAPTURE(d);
    // 1,000 sets of up to 9 points in the dimensions that people mesh in.
    CHECK(holds("one canonical triangulation", d == 1 ? 100 : 500, [d] {
      const PointsCase set = *generators::unweighted(
          d == 1 ? generators::any_point_set(d, 9) : generators::degenerate_point_set(d, 9));
      const PointSet points(set.points);
      const Triangulation expected = delaunay::by_definition(points);
      RC_ASSERT(delaunay::bowyer_watson(points) == expected);
      assert_accepted(points, expected);
    }));
  }
}

TEST_CASE("D2 every construction, order and point location agrees on degenerate sets") {
  for (const std::size_t d : {1u, 2u, 3u, 4u}) {
    CAPTURE(d);
    CHECK(holds("one canonical triangulation", d == 4 ? 40 : 100, [d] {
      const PointsCase set =
          *generators::unweighted(d == 1 ? generators::any_point_set(d, 9)
                                         : generators::degenerate_point_set(d, d == 4 ? 11 : 14));
      assert_agreement(PointSet(set.points), *rc::gen::arbitrary<std::uint64_t>());
    }));
  }
}

TEST_CASE("D2 D10 every construction agrees on sets of every family, with weights and without") {
  for (const std::size_t d : {1u, 2u, 3u}) {
    CAPTURE(d);
    CHECK(holds("one canonical triangulation", 60, [d] {
      const auto sets = generators::any_point_set(d, 12);
      const PointsCase set =
          *rc::gen::oneOf(generators::unweighted(sets), generators::weighted(sets));
      assert_agreement(PointSet(set.points, set.weights), *rc::gen::arbitrary<std::uint64_t>());
    }));
  }
}

// The same set of simplices after the points have been put in another order.
Triangulation renumbered(const Triangulation& triangulation, const std::vector<Vertex>& new_index) {
  std::vector<Simplex> simplices = triangulation.simplices();
  for (Simplex& simplex : simplices) {
    for (Vertex& v : simplex) v = new_index[static_cast<std::size_t>(v)];
  }
  return Triangulation(triangulation.dimension(), std::move(simplices));
}

TEST_CASE("D2 the canonical triangulation does not depend on the order of the input") {
  for (const std::size_t d : {2u, 3u}) {
    CAPTURE(d);
    CHECK(holds("independence of input order", 150, [d] {
      const PointsCase set = *generators::unweighted(generators::degenerate_point_set(d, 14));
      // Entry i of a shuffled list of indices: where point i goes.
      std::vector<Vertex> new_index(set.points.size());
      std::iota(new_index.begin(), new_index.end(), Vertex{0});
      const auto keys =
          *rc::gen::container<std::vector<int>>(set.points.size(), rc::gen::inRange(0, 1000));
      std::sort(new_index.begin(), new_index.end(), [&](Vertex a, Vertex b) {
        return std::pair(keys[static_cast<std::size_t>(a)], a) <
               std::pair(keys[static_cast<std::size_t>(b)], b);
      });
      std::vector<Point> moved(set.points.size());
      for (std::size_t i = 0; i < moved.size(); ++i) {
        moved[static_cast<std::size_t>(new_index[i])] = set.points[i];
      }
      RC_ASSERT(delaunay::bowyer_watson(PointSet(moved)) ==
                renumbered(delaunay::bowyer_watson(PointSet(set.points)), new_index));
    }));
  }
}

}  // namespace
}  // namespace circumspect::properties
