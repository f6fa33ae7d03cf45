// D2: every construction returns the one canonical Delaunay triangulation. Book: Theorem 4.4,
// Section 5.2; the perturbation of Section 2.9.
#include <algorithm>
#include <cmath>
#include <numeric>

#include <doctest/doctest.h>

#include "construct/insertion_order.hpp"
#include "inputs/dice.hpp"
#include "inputs/in_doubles.hpp"
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

TEST_CASE("D2 D10 the fast construction makes the canonical triangulation of sets of doubles") {
  for (const std::size_t d : {2u, 3u}) {
    CAPTURE(d);
    std::size_t given = 0;
    CHECK(holds("one canonical triangulation", 400, [&] {
      const PointsCase set = generators::in_doubles(*generators::any_case(d, 25));
      const auto agrees = fast_agrees(PointSet(set.points, set.weights));
      given += agrees ? 1u : 0u;
      RC_ASSERT(agrees != false);
    }));
    CHECK(occurs(given, 200));
  }
}

double length_of_path(const std::vector<double>& coordinates,
                      const std::vector<std::int32_t>& order, std::size_t from) {
  double length = 0;
  for (std::size_t i = from + 1; i < order.size(); ++i) {
    const auto a = static_cast<std::size_t>(order[i - 1]), b = static_cast<std::size_t>(order[i]);
    length += std::hypot(coordinates[3 * a] - coordinates[3 * b],
                         coordinates[3 * a + 1] - coordinates[3 * b + 1],
                         coordinates[3 * a + 2] - coordinates[3 * b + 2]);
  }
  return length;
}

TEST_CASE("the fast construction inserts each point once, and near ones one after the other") {
  generators::Dice dice(7);
  std::vector<double> coordinates;
  for (int i = 0; i < 3 * 4096; ++i) {
    coordinates.push_back(static_cast<double>(dice.bits() >> 11) * 0x1p-53);
  }
  std::vector<std::int32_t> as_given(4096);
  std::iota(as_given.begin(), as_given.end(), 0);
  const auto order = construct::insertion_order(coordinates, 3);
  CHECK(std::is_permutation(order.begin(), order.end(), as_given.begin(), as_given.end()));
  // The last round has half of the points: neighbours on the curve are about 1/13 apart, points as
  // given 2/3. A round before it spreads over the whole cube too.
  CHECK(length_of_path(coordinates, order, 2048) <
        0.2 * length_of_path(coordinates, as_given, 2048));
  const std::vector<std::int32_t> start(order.begin(), order.begin() + 1024);
  CHECK(length_of_path(coordinates, start, 0) < 0.3 * length_of_path(coordinates, as_given, 3072));
  CHECK(length_of_path(coordinates, start, 0) > 0.05 * length_of_path(coordinates, as_given, 3072));
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
