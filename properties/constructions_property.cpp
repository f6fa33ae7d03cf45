// D2: every construction returns the one triangulation that its definition names.
#include <algorithm>
#include <numeric>
#include <set>

#include <doctest/doctest.h>

#include "kernel/complex/point_set.hpp"
#include "oracle/judge/points/check.hpp"
#include "properties/arguments/laws.hpp"
#include "properties/arguments/point_sets.hpp"
#include "properties/arguments/run.hpp"
#include "properties/every_construction.hpp"
#include "reference/delaunay/bowyer_watson.hpp"
#include "reference/delaunay/gift_wrapping.hpp"
#include "reference/delaunay/lexicographic.hpp"
#include "reference/delaunay/lifted_hull.hpp"
#include "reference/delaunay/simplex_predicates.hpp"

namespace circumspect::properties {
namespace {

// ---- constructions ----
// D2: every construction returns the one canonical Delaunay triangulation. Book: Theorem 4.4,
// Section 5.2; the perturbation of Section 2.9.

using generators::PointsCase;

void assert_accepted(const PointSet& points, const Triangulation& triangulation) {
  const ExactMesh mesh{points, triangulation.simplices()};
  for (const check::By by : {check::By::kLemma, check::By::kDefinition}) {
    const Verdict verdict = check::delaunay(mesh, {.by = by});
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

// ---- gift wrapping ----
// D2: gift-wrapping, with the perturbation and by whole cells without it, returns the canonical
// triangulation. Book: Section 5.6 and Exercise 4 of Chapter 5.

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

// ---- lexicographic ----
// The lexicographic triangulation is a triangulation, the one that the definition of Section 2.1
// says, whatever the order of the input. D6 for triangulations that are not Delaunay. Book:
// Sections 2.1 and 4.1.

PointSet any_set(std::size_t d, std::size_t max_points) {
  const PointsCase set = *generators::any_unweighted_case(d, max_points);
  return PointSet(set.points);
}

TEST_CASE("the lexicographic triangulation is a triangulation (Sections 2.1, 4.1)") {
  for (const std::size_t d : {1u, 2u, 3u, 4u}) {
    CAPTURE(d);
    std::size_t not_delaunay = 0;
    CHECK(holds("lexicographic triangulation", d == 4 ? 90 : 120, [&] {
      const PointSet points = any_set(d, d == 4 ? 8 : 11);
      const Triangulation triangulation = delaunay::lexicographic(points);
      const ExactMesh mesh{points, triangulation.simplices()};
      RC_ASSERT(check::triangulation(mesh, {.by = check::By::kLemma}).holds());
      RC_ASSERT(check::triangulation(mesh, {.by = check::By::kDefinition}).holds());
      not_delaunay += check::delaunay(mesh).holds() ? 0u : 1u;
    }));
    if (d == 1) CHECK(not_delaunay == 0);
    if (d > 1) CHECK(occurs(not_delaunay));
  }
}

// Joining each point to what it sees of those before it is what a lower hull does whose heights
// grow fast enough: 2^(200 i) for the i-th point, far more than these coordinates can balance.
TEST_CASE("the lexicographic triangulation is that of heights that grow without bound") {
  for (const std::size_t d : {1u, 2u, 3u}) {
    CAPTURE(d);
    CHECK(holds("lexicographic triangulation as a lower hull", 100, [d] {
      const auto sets = rc::gen::oneOf(generators::sets_of(generators::integer_points, d, 8),
                                       generators::sets_of(generators::grid_points, d, 8),
                                       generators::sets_of(generators::cube_points, d, 8),
                                       generators::sets_of(generators::rational_points, d, 8));
      const PointsCase set = *generators::unweighted(sets);
      const PointSet points(set.points);
      std::vector<Rational> weights;
      for (Vertex v = 0; points.names(v); ++v) {
        const Integer height = Integer(1) << (200 * points.configuration().rank(v));
        weights.push_back(squared_length(points[v]) - height);
      }
      RC_ASSERT(delaunay::lexicographic(points) ==
                delaunay::by_definition(PointSet(set.points, weights)));
    }));
  }
}

TEST_CASE("the lexicographic triangulation does not depend on the order of the input") {
  for (const std::size_t d : {2u, 3u}) {
    CAPTURE(d);
    CHECK(holds("independence of input order", 100, [d] {
      const PointSet points = any_set(d, 14);
      const std::vector<Vertex> order = generators::shuffled(all_vertices(points));
      const PointSet moved(coordinates(points, order));
      std::vector<Simplex> simplices = delaunay::lexicographic(moved).simplices();
      for (Simplex& simplex : simplices) {
        for (Vertex& v : simplex) v = order[static_cast<std::size_t>(v)];
      }
      RC_ASSERT(Triangulation(points.dimension(), simplices) == delaunay::lexicographic(points));
    }));
  }
}

TEST_CASE("D6 t = e - n - h + 3 for the lexicographic triangulation (Section 4.1)") {
  CHECK(holds("Euler", 200, [] {
    const PointSet points = any_set(3, 14);
    RC_PRE(points.dimension() == 3);
    const Triangulation triangulation = delaunay::lexicographic(points);
    std::set<Vertex> on_hull;
    std::set<Simplex> edges;
    for (const auto& [triangle, apexes] : apexes_by_facet(triangulation)) {
      if (apexes.size() == 1) on_hull.insert(triangle.begin(), triangle.end());
      for (std::size_t place = 0; place < 3; ++place) edges.insert(facet_opposite(triangle, place));
    }
    RC_ASSERT(triangulation.simplices().size() + points.size() + on_hull.size() ==
              edges.size() + 3);
  }));
}

}  // namespace

}  // namespace circumspect::properties
