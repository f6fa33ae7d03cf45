// Conflicts, the conflict graph, point location by walking, and the analysis by triggers and
// stoppers. Book: Sections 5.2, 5.4 and 5.5.
#include <algorithm>

#include <doctest/doctest.h>

#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/perturbation.hpp"
#include "properties/arguments/laws.hpp"
#include "properties/arguments/run.hpp"
#include "reference/delaunay/bowyer_watson.hpp"
#include "reference/delaunay/conflict_graph.hpp"
#include "reference/delaunay/dictionary.hpp"
#include "reference/delaunay/lifted_hull.hpp"
#include "reference/delaunay/point_location.hpp"

namespace circumspect::delaunay {

// ---- Conflicts ----

namespace {

// ---- Conflicts with solid and with ghost simplices ----

TEST_CASE("conflict: a solid triangle's open disk, and its ghosts' outer halfplanes") {
  //                     the triangle            beyond   on the line, inside and outside  within
  const PointSet points({{0, 0}, {4, 0}, {0, 4}, {2, -3}, {1, 0}, {5, 0}, {-1, 0}, {1, 1}});
  const Simplex ghost = {1, 0, kGhost};  // below the edge from (0, 0) to (4, 0)
  CHECK(is_in_conflict(points, ghost, 3));
  CHECK(is_in_conflict(points, ghost, 4));
  CHECK(!is_in_conflict(points, ghost, 5));
  CHECK(!is_in_conflict(points, ghost, 6));
  CHECK(!is_in_conflict(points, ghost, 7));
  CHECK(!is_in_conflict(points, ghost, 2));
  CHECK(is_in_conflict(points, {0, 1, 2}, 7));
  CHECK(is_in_conflict(points, {0, 1, 2}, 4));
  CHECK(!is_in_conflict(points, {0, 1, 2}, 3));
}

TEST_CASE("conflict: on a sphere the perturbation decides, for ghosts too") {
  // (0,0) comes first in lexicographic order, so its weight is the largest: it is in the disk.
  const PointSet square({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  CHECK(is_in_conflict(square, {1, 2, 3}, 0));
  CHECK(!is_in_conflict(square, {0, 1, 2}, 3));
  CHECK(is_in_conflict(square, {0, 1, 3}, 2));  // the diagonal without the first point is not there
  // The square as a facet of a pyramid: the ghosts of its two halves.
  const PointSet pyramid({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}});
  CHECK(is_in_conflict(pyramid, {1, 2, 3, kGhost}, 0));
  CHECK(is_in_conflict(pyramid, {2, 1, 3, kGhost}, 0));
  CHECK(!is_in_conflict(pyramid, {0, 1, 2, kGhost}, 3));
  CHECK(!is_in_conflict(pyramid, {1, 0, 2, kGhost}, 3));
  CHECK(is_in_conflict(pyramid, {0, 1, 3, kGhost}, 4) !=
        is_in_conflict(pyramid, {1, 0, 3, kGhost}, 4));
}

TEST_CASE("conflict: on a line the ghosts are the two sides beyond the ends") {
  const PointSet points({{0}, {2}, {1}, {3}, {-1}});
  REQUIRE(positively_oriented(points, {1, 0}) == Simplex{1, 0});
  const Simplex right = {kGhost, 1};  // in front of point 1, which the edge (1, 0) is behind
  const Simplex left = {0, kGhost};
  CHECK(is_in_conflict(points, right, 3));
  CHECK(!is_in_conflict(points, right, 2));
  CHECK(!is_in_conflict(points, right, 4));
  CHECK(is_in_conflict(points, left, 4));
  CHECK(!is_in_conflict(points, left, 3));
  CHECK(is_in_conflict(points, {1, 0}, 2));
  CHECK(!is_in_conflict(points, {1, 0}, 3));
}

// The ghost on the far side of each facet of a positively oriented simplex holds what lies strictly
// beyond the facet, nothing strictly on its inner side, and in its hyperplane the facet's own disk.
TEST_CASE("conflict: a ghost is its open halfspace and the disk of its facet") {
  for (const std::size_t d : {1U, 2U, 3U}) {
    CHECK(properties::holds("dimension " + std::to_string(d), [d] {
      const generators::PointsCase set = *generators::simplex_and_queries(d);
      const PointSet points(set.points, set.weights);
      const Configuration& configuration = points.configuration();
      const auto size = static_cast<std::size_t>(points.dimension()) + 1;
      const Simplex simplex = positively_oriented(points, generators::first_vertices(size));
      for (std::size_t place = 0; place < size; ++place) {
        const OrientedFacet facet = OrientedFacet::opposite(simplex, place);
        const Simplex ghost = join(facet.reverse(), kGhost);
        for (auto q = static_cast<Vertex>(size); points.names(q); ++q) {
          const int inner = orientation(configuration, with_vertex_replaced(simplex, place, q));
          const bool expected =
              inner < 0 || (inner == 0 &&
                            perturbed_in_ball(configuration, axes_of(configuration, facet.vertices),
                                              facet.vertices, q) > 0);
          RC_ASSERT(is_in_conflict(points, ghost, q) == expected);
        }
      }
    }));
  }
}

TEST_CASE(
    "conflict: an even permutation of the simplex changes nothing, wherever the ghost stands") {
  CHECK(properties::holds([] {
    const generators::PointsCase set = *generators::simplex_and_queries(3);
    const PointSet points(set.points, set.weights);
    const auto size = static_cast<std::size_t>(points.dimension()) + 1;
    const Simplex simplex = positively_oriented(points, generators::first_vertices(size));
    const Simplex ghost = join(OrientedFacet::opposite(simplex, 0).reverse(), kGhost);
    Simplex other = generators::shuffled(ghost);
    if (is_odd_permutation(other) != is_odd_permutation(ghost)) std::swap(other[0], other[1]);
    for (auto q = static_cast<Vertex>(size); points.names(q); ++q) {
      RC_ASSERT(is_in_conflict(points, other, q) == is_in_conflict(points, ghost, q));
    }
  }));
}

// ---- The conflict graph, by hand ----

TEST_CASE("conflict graph: inside, outside, and in a triangle that is split twice") {
  const PointSet points({{0, 0}, {9, 0}, {0, 9}, {3, 3}, {1, 2}, {20, 20}});
  BowyerWatson algorithm(points);
  REQUIRE(sorted(algorithm.first_simplex()) == Simplex{0, 1, 2});
  ConflictGraph graph(points, algorithm.dictionary(), {3, 4, 5}, algorithm.statistics());
  CHECK(sorted(graph.conflict_of(4).value()) == Simplex{0, 1, 2});
  CHECK(sorted(graph.conflict_of(5).value()) == Simplex{kGhost, 1, 2});
  graph.update(algorithm.insert(3, *graph.conflict_of(3)));
  CHECK(!graph.conflict_of(3));
  CHECK(sorted(graph.conflict_of(4).value()) == Simplex{0, 2, 3});
  CHECK(sorted(graph.conflict_of(5).value()) == Simplex{kGhost, 1, 2});
  graph.update(algorithm.insert(5, *graph.conflict_of(5)));
  CHECK(sorted(graph.conflict_of(4).value()) == Simplex{0, 2, 3});
  CHECK(algorithm.statistics().conflicts_created == 4);
}

TEST_CASE("conflict graph: a vertex outside comes inside") {
  const PointSet points({{0, 0}, {9, 0}, {0, 9}, {8, 8}, {20, 20}});
  BowyerWatson algorithm(points);
  ConflictGraph graph(points, algorithm.dictionary(), {3, 4}, algorithm.statistics());
  CHECK(is_ghost(graph.conflict_of(3).value()));
  graph.update(algorithm.insert(4, *graph.conflict_of(4)));
  CHECK(sorted(graph.conflict_of(3).value()) == Simplex{1, 2, 4});
}

TEST_CASE("conflict graph: submerged from the start, or by an insertion") {
  const PointSet points({{0, 0}, {9, 0}, {0, 9}, {2, 2}, {3, 3}, {1, 1}}, {0, 0, 0, 60, 0, -99});
  BowyerWatson algorithm(points);
  ConflictGraph graph(points, algorithm.dictionary(), {3, 4, 5}, algorithm.statistics());
  CHECK(!graph.conflict_of(5));
  CHECK(graph.conflict_of(4));
  graph.update(algorithm.insert(3, *graph.conflict_of(3)));
  CHECK(!graph.conflict_of(4));
}

// ---- Point location by walking, and that linear scans find something if walks do ----

TEST_CASE("walk: along a row of points, one step an edge") {
  std::vector<Point> row;
  for (int x = 0; x < 10; ++x) row.push_back({2 * x});
  row.push_back({15});
  row.push_back({40});
  const PointSet points(row);
  BowyerWatson algorithm(points);
  for (Vertex u = 2; u < 10; ++u) algorithm.insert(u);
  const Simplex start = positively_oriented(points, {0, 1});
  Statistics statistics;
  const auto inside = walk(points, algorithm.dictionary(), start, 10, statistics);
  CHECK(sorted(inside.value()) == Simplex{7, 8});
  CHECK(statistics.walk_steps == 7);
  const auto outside = walk(points, algorithm.dictionary(), start, 11, statistics);
  CHECK(sorted(outside.value()) == Simplex{kGhost, 9});
  CHECK(statistics.walk_steps == 7 + 9);
  CHECK(statistics.conflict_tests == 2);
}

bool solid_contains(const PointSet& points, const Simplex& simplex, Vertex q) {
  for (std::size_t place = 0; place < simplex.size(); ++place) {
    if (orientation(points.configuration(), with_vertex_replaced(simplex, place, q)) < 0) {
      return false;
    }
  }
  return true;
}

// From every solid simplex the walk ends: within the simplex that contains q, or at a ghost
// simplex; in conflict with q unless no simplex at all is.
void check_walks(const PointSet& points) {
  if (points.dimension() < 1) return;
  BowyerWatson algorithm(points);
  const std::size_t half = points.size() / 2;
  const auto order = generators::shuffled(generators::first_vertices(points.size()));
  for (std::size_t i = 0; i < half; ++i) {
    if (!contains(algorithm.first_simplex(), order[i])) algorithm.insert(order[i]);
  }
  for (std::size_t i = half; i < order.size(); ++i) {
    const Vertex q = order[i];
    if (contains(algorithm.first_simplex(), q)) continue;
    Statistics statistics;
    const auto scanned = linear_scan(points, algorithm.dictionary(), q, statistics);
    RC_ASSERT(scanned || points.is_weighted());
    for (const Simplex& start : algorithm.dictionary().simplices()) {
      if (is_ghost(start)) continue;
      const auto found = walk(points, algorithm.dictionary(), start, q, statistics);
      RC_ASSERT(found.has_value() == scanned.has_value());
      if (!found) continue;
      RC_ASSERT(is_in_conflict(points, *found, q));
      if (!is_ghost(*found)) RC_ASSERT(solid_contains(points, *found, q));
    }
  }
}

TEST_CASE("walk: it ends in a simplex in conflict, from wherever it starts") {
  for (const std::size_t d : {1U, 2U, 3U, 4U}) {
    const auto sets = generators::any_point_set(d, d == 4 ? 9 : 12);
    CHECK(properties::holds("dimension " + std::to_string(d), [&] {
      const auto set = *rc::gen::oneOf(generators::unweighted(sets), generators::weighted(sets));
      check_walks(PointSet(set.points, set.weights));
    }));
  }
}

// ---- Triggers and stoppers ----
// Triggers, stoppers, and the probabilities of Section 5.4.

TEST_CASE("stoppers: the points in the open circumball; on it, as the perturbation decides") {
  // The circle through the first three has centre (2, 2). (4, 4) is on it, and (0, 0) has the
  // largest perturbation, so that the square is cut at (0, 0).
  const PointSet points({{0, 0}, {4, 0}, {0, 4}, {1, 1}, {4, 4}, {3, 3}, {9, 9}});
  CHECK(stoppers(points, {0, 1, 2}) == Simplex{3, 4, 5});
  CHECK(stoppers(points, {2, 0, 1}) == Simplex{3, 4, 5});
  CHECK(stoppers(points, {0, 1, 4}) == Simplex{3, 5});
}

TEST_CASE("j-simplices: of points on a line, by how many lie between") {
  const PointSet points({{0}, {1}, {2}, {5}, {9}});
  CHECK(numbers_of_j_simplices(points) == std::vector<std::uint64_t>{4, 3, 2, 1});
}

TEST_CASE("j-simplices: 0-simplices are the Delaunay triangulation, flat subsets are none") {
  std::vector<Point> grid;
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 3; ++y) grid.push_back({x, y});
  }
  const PointSet points(grid);
  const auto numbers = numbers_of_j_simplices(points);
  CHECK(numbers.front() == by_definition(points).simplices().size());
  std::uint64_t total = 0;
  for (const std::uint64_t f : numbers) total += f;
  CHECK(total == 84 - 8);  // three rows, three columns, two diagonals
  CHECK(numbers_of_j_simplices(PointSet({})).empty());
}

TEST_CASE("probabilities: Proposition 5.2 below 4!/j^4, Proposition 5.3 as the book states it") {
  CHECK(binomial(7, 4) == 35);
  CHECK(binomial(3, 4) == 0);
  CHECK(binomial(0, 0) == 1);
  CHECK(probability_in_random_order(3, 0) == 1);
  CHECK(probability_in_random_order(3, 1) == Rational(1, 5));
  CHECK(probability_in_random_order(3, 3) == Rational(1, 35));
  for (std::uint64_t j = 1; j < 100; ++j) {
    CHECK(probability_in_random_order(3, j) < Rational(24, Integer(j * j * j * j)));
  }
  CHECK(bound_in_brio(3, 0) == 1);
  CHECK(bound_in_brio(3, 4) == 1);
  CHECK(bound_in_brio(3, 5) == Rational(77, 125));
  CHECK(bound_in_brio(3, 10) == Rational(77, 2000));
  CHECK(bound_in_brio(2, 5) == Rational(49, 125));
}

TEST_CASE("Theorem 5.4: expected numbers of simplices and conflicts, for points on a line") {
  const Expectation sum = expectation(1, {4, 3, 2, 1}, probability_in_random_order);
  CHECK(sum.simplices == 4 + 1 + Rational(1, 3) + Rational(1, 10));
  CHECK(sum.conflicts == 1 + Rational(2, 3) + Rational(3, 10));
}

}  // namespace

}  // namespace circumspect::delaunay
