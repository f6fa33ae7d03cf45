// D9: the analysis of Section 5.4 as measurements. What happens on average over all permutations,
// or all subsets, of a small set is computed exactly; what happens over BRIOs is measured over
// seeds.
#include <algorithm>
#include <functional>
#include <map>
#include <numeric>
#include <random>

#include <doctest/doctest.h>

#include "kernel/complex/simplex.hpp"
#include "kernel/predicates/orientation.hpp"
#include "properties/arguments/laws.hpp"
#include "properties/arguments/point_sets.hpp"
#include "properties/arguments/run.hpp"
#include "reference/delaunay/bowyer_watson.hpp"
#include "reference/delaunay/genericity.hpp"
#include "reference/delaunay/triggers.hpp"

namespace circumspect::properties {
namespace {

using delaunay::BowyerWatson;
using delaunay::InsertionOrder;

// Points of which no five are cospherical and, so that the first four of any order are the first
// tetrahedron, no four coplanar; the same on every machine.
PointSet generic_points(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  std::vector<Point> points;
  while (points.size() < count) {
    Point point;
    for (int axis = 0; axis < 3; ++axis) point.emplace_back(Integer(engine() >> 44));
    points.push_back(point);
  }
  return PointSet(points);
}

bool in_general_position(const PointSet& points) {
  Simplex subset = first_subset(4);
  do {
    if (orientation(points.configuration(), subset) == 0) return false;
  } while (next_subset(subset, points.size()));
  return !delaunay::cospherical_points(points);
}

// Calls `visit` with each solid simplex that inserting the vertices in this order creates.
void for_each_created(const PointSet& points, const std::vector<Vertex>& order,
                      const std::function<void(const Simplex&)>& visit) {
  BowyerWatson algorithm(points, delaunay::first_independent(points, order));
  visit(algorithm.first_simplex());
  for (const Vertex u : order) {
    if (contains(algorithm.first_simplex(), u)) continue;
    algorithm.insert(u);
    for (const Simplex& simplex : algorithm.last_insertion().created) {
      if (!is_ghost(simplex)) visit(simplex);
    }
  }
}

Integer factorial(std::uint64_t n) {
  Integer product = 1;
  for (std::uint64_t i = 2; i <= n; ++i) product *= Integer(i);
  return product;
}

TEST_CASE("Proposition 5.2: of all permutations, n!/C(j+4,4) create a given j-tetrahedron") {
  const PointSet points = generic_points(7, 1);
  REQUIRE(in_general_position(points));
  std::map<Simplex, std::uint64_t> times_created;
  std::vector<Vertex> order = first_subset(points.size());
  do {
    for_each_created(points, order, [&](const Simplex& s) { ++times_created[sorted(s)]; });
  } while (std::next_permutation(order.begin(), order.end()));

  const auto numbers = delaunay::numbers_of_j_simplices(points);
  Integer created = 0;
  Integer conflicts = 0;
  CHECK(times_created.size() == 35);  // every tetrahedron is, by some permutation
  for (const auto& [tetrahedron, times] : times_created) {
    const std::uint64_t j = delaunay::stoppers(points, tetrahedron).size();
    CHECK(Rational(Integer(times)) ==
          Rational(factorial(7)) * delaunay::probability_in_random_order(3, j));
    created += Integer(times);
    conflicts += Integer(times * j);
  }
  // Theorem 5.4: Σ q_j f_j tetrahedra and Σ j q_j f_j conflicts.
  const auto expected = delaunay::expectation(3, numbers, delaunay::probability_in_random_order);
  CHECK(Rational(created) == Rational(factorial(7)) * expected.simplices);
  CHECK(Rational(conflicts) == Rational(factorial(7)) * expected.conflicts);
}

// The proof of Proposition 5.1: in a random subset R that has each point with probability 1/j, the
// expected number of tetrahedra of Del R is Σ_k p_k f_k, p_k = (1/j)^4 (1 − 1/j)^k. The proof goes
// on with (1 − 1/j)^j ≥ 1/e, which holds in the limit only; for j ≥ 2 it is at least 1/4.
TEST_CASE("Proposition 5.1: F_j against the Delaunay triangulation of a random subset") {
  const PointSet points = generic_points(9, 2);
  REQUIRE(in_general_position(points));
  std::vector<std::uint64_t> tetrahedra_by_size(points.size() + 1);
  for (std::size_t size = 4; size <= points.size(); ++size) {
    Simplex subset = first_subset(size);
    do {
      tetrahedra_by_size[size] +=
          delaunay::bowyer_watson(PointSet(coordinates(points, subset))).simplices().size();
    } while (next_subset(subset, points.size()));
  }
  const auto numbers = delaunay::numbers_of_j_simplices(points);
  for (unsigned long j = 2; j < numbers.size(); ++j) {
    const auto power = [](const Rational& base, std::size_t exponent) {
      Rational product = 1;
      for (std::size_t i = 0; i < exponent; ++i) product *= base;
      return product;
    };
    const Rational chosen(1, j);
    const Rational left_out = 1 - chosen;
    Rational mean = 0;  // E[size(Del R)]
    for (std::size_t r = 4; r <= points.size(); ++r) {
      mean += power(chosen, r) * power(left_out, points.size() - r) *
              Rational(Integer(tetrahedra_by_size[r]));
    }
    Rational by_stoppers = 0;
    Integer up_to_j = 0;  // F_j
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      by_stoppers += power(chosen, 4) * power(left_out, k) * Rational(Integer(numbers[k]));
      if (k <= j) up_to_j += Integer(numbers[k]);
    }
    CHECK(mean == by_stoppers);
    CHECK(Rational(up_to_j) <= 4 * power(Rational(j), 4) * mean);
  }
}

// Means over seeds: of a uniform order they come close to the expectation, of a BRIO they stay
// below the bound, in sum and for each j.
TEST_CASE("Proposition 5.3: what BRIOs create on average stays below the bound for each j") {
  const PointSet points = generic_points(26, 3);
  const auto numbers = delaunay::numbers_of_j_simplices(points);
  const int trials = 150;
  const auto created_by = [&](InsertionOrder order) {
    std::vector<std::uint64_t> created(numbers.size());
    for (int seed = 0; seed < trials; ++seed) {
      for_each_created(points, insertion_order(points, order, static_cast<std::uint64_t>(seed)),
                       [&](const Simplex& s) { ++created[delaunay::stoppers(points, s).size()]; });
    }
    return created;
  };
  const auto total = [](const std::vector<std::uint64_t>& counts) {
    return Rational(Integer(std::accumulate(counts.begin(), counts.end(), std::uint64_t{0})));
  };
  for (const auto order : {InsertionOrder::kBrioHilbert, InsertionOrder::kBrioZOrder}) {
    const auto created = created_by(order);
    for (std::uint64_t j = 0; j < numbers.size(); ++j) {
      CAPTURE(j);
      CHECK(Rational(Integer(created[j])) <=
            trials * delaunay::bound_in_brio(3, j) * Rational(Integer(numbers[j])));
    }
    CHECK(created[0] == trials * numbers[0]);
    CHECK(total(created) <=
          trials * delaunay::expectation(3, numbers, delaunay::bound_in_brio).simplices);
  }
  const Rational mean = total(created_by(InsertionOrder::kRandom)) / trials;
  const Rational expected =
      delaunay::expectation(3, numbers, delaunay::probability_in_random_order).simplices;
  CHECK(abs(mean - expected) < expected / 20);
}

// Exercise 2 of Chapter 5: Del S is given, T inserted in random order. A tetrahedron with a
// triggers and b stoppers in T, a > 0, and no stopper in S is created with probability 1 / C(a + b,
// a).
TEST_CASE("Chapter 5, Exercise 2: inserting T into Del S, over all orders of T") {
  for (const std::size_t s : {4u, 6u, 9u}) {
    const std::size_t t = 5;
    const PointSet points = generic_points(s + t, 10 + s);
    REQUIRE(in_general_position(points));
    const auto in_s = [s](Vertex v) { return v < static_cast<Vertex>(s); };
    Rational expected = 0;
    Rational expected_conflicts = 0;
    Simplex subset = first_subset(4);
    do {
      const Simplex stoppers = delaunay::stoppers(points, subset);
      const auto from_t = 4 - std::count_if(subset.begin(), subset.end(), in_s);
      if (from_t == 0 || std::any_of(stoppers.begin(), stoppers.end(), in_s)) continue;
      const Integer orders = delaunay::binomial(
          static_cast<std::uint64_t>(from_t) + stoppers.size(), static_cast<std::uint64_t>(from_t));
      expected += Rational(1, orders);
      expected_conflicts += Rational(1, orders) * Rational(Integer(stoppers.size()));
    } while (next_subset(subset, points.size()));

    Integer created = 0;
    Integer conflicts = 0;
    std::vector<Vertex> order = first_subset(s + t);
    do {
      for_each_created(points, order, [&](const Simplex& simplex) {
        if (std::all_of(simplex.begin(), simplex.end(), in_s)) return;
        created += 1;
        conflicts += Integer(delaunay::stoppers(points, simplex).size());
      });
    } while (std::next_permutation(order.begin() + static_cast<std::ptrdiff_t>(s), order.end()));
    CHECK(Rational(created) == Rational(factorial(t)) * expected);
    CHECK(Rational(conflicts) == Rational(factorial(t)) * expected_conflicts);
    // O(t² + t s²). The i-th insertion creates, on average over the order, at most the tetrahedra
    // with a vertex in T, times four, over i; there are at most (s + i)²/2 of them.
    CHECK(expected + expected_conflicts < 4 * Rational(Integer(t * t + t * s * s)));
  }
}

}  // namespace
}  // namespace circumspect::properties
