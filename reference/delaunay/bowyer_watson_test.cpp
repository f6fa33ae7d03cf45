// The Bowyer–Watson algorithm: known triangulations, the invariants of every step, how much one
// insertion may change, and what the statistics say. Book: Section 5.2, Figures 4.2 and 4.4.
#include "reference/delaunay/bowyer_watson.hpp"

#include <algorithm>
#include <set>

#include <doctest/doctest.h>

#include "kernel/predicates/orientation.hpp"
#include "properties/arguments/laws.hpp"
#include "properties/arguments/run.hpp"
#include "reference/delaunay/gift_wrapping.hpp"
#include "reference/delaunay/lifted_hull.hpp"
#include "reference/delaunay/point_location.hpp"

namespace circumspect::delaunay {
namespace {

// The points of a grid with the given numbers of points along the axes, in lexicographic order.
std::vector<Point> grid(long nx, long ny, long nz) {
  std::vector<Point> points;
  for (long x = 0; x < nx; ++x) {
    for (long y = 0; y < ny; ++y) {
      for (long z = 0; z < nz; ++z) points.push_back({x, y, z});
    }
  }
  return points;
}

std::size_t number_with(const Triangulation& triangulation, Vertex v) {
  const auto& all = triangulation.simplices();
  return static_cast<std::size_t>(
      std::count_if(all.begin(), all.end(), [v](const Simplex& s) { return contains(s, v); }));
}

TEST_CASE("Bowyer-Watson: of no point, one point, two points, points of a line") {
  CHECK(bowyer_watson(PointSet({})) == Triangulation(-1, {}));
  CHECK(bowyer_watson(PointSet({{5, 5}})) == Triangulation(0, {{0}}));
  CHECK(bowyer_watson(PointSet({{5, 5}, {0, 1}})) == Triangulation(1, {{0, 1}}));
  CHECK(bowyer_watson(PointSet({{3, 3}, {0, 0}, {1, 1}, {-2, -2}})) ==
        Triangulation(1, {{0, 2}, {1, 2}, {1, 3}}));
}

TEST_CASE("Bowyer-Watson: a cube is cut into six tetrahedra at its smallest corner") {
  const Triangulation cube = bowyer_watson(PointSet(grid(2, 2, 2)));
  CHECK(cube.simplices().size() == 6);
  CHECK(number_with(cube, 0) == 6);
  CHECK(cube.has({0, 1, 3, 7}));
}

// Book: Figure 4.4, where two cubes that share a face are cut compatibly.
TEST_CASE("Bowyer-Watson: two cubes that share a face, each cut at its own smallest corner") {
  const PointSet points(grid(3, 2, 2));
  const Triangulation cubes = bowyer_watson(points);
  CHECK(cubes.simplices().size() == 12);
  for (const Simplex& simplex : cubes.simplices()) {
    const bool is_left = simplex.front() < 4;  // it has a vertex with x = 0
    CHECK(contains(simplex, is_left ? 0 : 4));
    CHECK((is_left ? simplex.back() < 8 : simplex.front() == 4));
  }
  CHECK(cubes == by_definition(points));
}

TEST_CASE("Bowyer-Watson: a grid of eight cubes has 48 tetrahedra") {
  const Triangulation triangulation = bowyer_watson(PointSet(grid(3, 3, 3)));
  CHECK(triangulation.simplices().size() == 48);
}

// Book: Section 4.1, Figure 4.2: every edge of one line with every edge of the other.
TEST_CASE("Bowyer-Watson: points on two skew lines, (a-1)(b-1) tetrahedra") {
  for (const auto& sizes : {std::pair(2L, 2L), {3L, 2L}, {3L, 4L}, {5L, 5L}}) {
    const long a = sizes.first;
    const long b = sizes.second;
    CAPTURE(a);
    CAPTURE(b);
    std::vector<Point> points;
    for (long i = 0; i < a; ++i) points.push_back({i * i - 3, 0, 0});
    for (long i = 0; i < b; ++i) points.push_back({0, 2 * i - 5, 7});
    std::vector<Simplex> expected;
    for (long i = 0; i + 1 < a; ++i) {
      for (long j = 0; j + 1 < b; ++j) expected.push_back({i, i + 1, a + j, a + j + 1});
    }
    CHECK(bowyer_watson(PointSet(points)) == Triangulation(3, expected));
  }
}

TEST_CASE("Bowyer-Watson: a square flat in space, a four-dimensional cross") {
  CHECK(bowyer_watson(PointSet({{1, 1, 3}, {0, 1, 2}, {1, 0, 1}, {0, 0, 0}})).dimension() == 2);
  std::vector<Point> cross;
  for (std::size_t axis = 0; axis < 4; ++axis) {
    for (const int x : {-1, 1}) {
      Point point(4, Rational(0));
      point[axis] = x;
      cross.push_back(point);
    }
  }
  // Its 16 facets, 8 at either end of an axis: pulling one end leaves those at the other.
  const Triangulation triangulation = bowyer_watson(PointSet(cross));
  CHECK(triangulation.simplices().size() == 8);
  CHECK(number_with(triangulation, 0) == 8);
  CHECK(number_with(triangulation, 1) == 8);
}

TEST_CASE("Bowyer-Watson: a submerged point changes nothing, and says so") {
  const PointSet points({{0, 0}, {4, 0}, {0, 4}, {1, 1}, {4, 4}}, {0, 0, 0, -100, 0});
  BowyerWatson algorithm(points);
  REQUIRE(sorted(algorithm.first_simplex()) == Simplex{0, 1, 2});
  const auto before = algorithm.dictionary().simplices();
  CHECK(!algorithm.insert(3));
  CHECK(algorithm.dictionary().simplices() == before);
  CHECK(algorithm.insert(4));
  CHECK(algorithm.triangulation() == Triangulation(2, {{0, 1, 4}, {0, 2, 4}}));
}

TEST_CASE("Bowyer-Watson: a heavy point submerges vertices that were there before it") {
  const PointSet points({{0, 0}, {4, 0}, {0, 4}, {1, 1}, {1, 2}}, {0, 0, 0, 0, 100});
  BowyerWatson algorithm(points);
  CHECK(algorithm.insert(3));
  CHECK(number_with(algorithm.triangulation(), 3) == 3);
  CHECK(algorithm.insert(4));
  CHECK(number_with(algorithm.triangulation(), 3) == 0);
}

// Every facet of every simplex, solid or ghost, has this one in front and exactly one behind.
void check_closed(const SimplexDictionary& dictionary) {
  for (const Simplex& simplex : dictionary.simplices()) {
    for (std::size_t place = 0; place < simplex.size(); ++place) {
      const OrientedFacet facet = OrientedFacet::opposite(simplex, place);
      RC_ASSERT(dictionary.adjacent(facet) == simplex[place]);
      const auto behind = dictionary.adjacent(facet.reverse());
      RC_ASSERT(behind.has_value());
      RC_ASSERT(!contains(simplex, *behind));
    }
  }
}

// Each facet of only one solid simplex has one ghost, and no inserted point lies beyond it.
void check_hull(const PointSet& points, const BowyerWatson& algorithm,
                const std::set<Vertex>& inserted) {
  std::set<Simplex> hull;
  for (const auto& [facet, apexes] : apexes_by_facet(algorithm.triangulation())) {
    if (apexes.size() == 1) hull.insert(facet);
  }
  std::set<Simplex> shadowed;
  for (const Simplex& simplex : algorithm.dictionary().simplices()) {
    if (!is_ghost(simplex)) {
      RC_ASSERT(orientation(points.configuration(), simplex) > 0);
      continue;
    }
    const auto place = static_cast<std::size_t>(std::find(simplex.begin(), simplex.end(), kGhost) -
                                                simplex.begin());
    RC_ASSERT(shadowed.insert(sorted(facet_opposite(simplex, place))).second);
    for (const Vertex q : inserted) {
      const Simplex replaced = with_vertex_replaced(simplex, place, q);
      RC_ASSERT(has_repeated_vertex(replaced) ||
                orientation(points.configuration(), replaced) <= 0);
    }
  }
  RC_ASSERT(shadowed == hull);
}

// The canonical triangulation of some of the points, by their indices among all.
Triangulation of_subset(const PointSet& points, const std::set<Vertex>& subset) {
  const Simplex vertices(subset.begin(), subset.end());
  std::vector<Rational> weights;
  for (const Vertex v : vertices) weights.push_back(points.weight(v));
  const Triangulation own = by_definition(PointSet(coordinates(points, vertices), weights));
  std::vector<Simplex> simplices = own.simplices();
  for (Simplex& simplex : simplices) {
    for (Vertex& v : simplex) v = vertices[static_cast<std::size_t>(v)];
  }
  return Triangulation(own.dimension(), simplices);
}

// Inserts the points in a random order, and by a random simplex in conflict.
void check_every_step(const PointSet& points) {
  BowyerWatson algorithm(points);
  const Simplex& first = algorithm.first_simplex();
  std::set<Vertex> inserted(first.begin(), first.end());
  check_closed(algorithm.dictionary());
  check_hull(points, algorithm, inserted);
  for (const Vertex u : generators::shuffled(generators::first_vertices(points.size()))) {
    if (contains(first, u)) continue;
    std::vector<Simplex> conflicts = algorithm.dictionary().simplices();
    conflicts.erase(std::remove_if(conflicts.begin(), conflicts.end(),
                                   [&](const Simplex& s) { return !is_in_conflict(points, s, u); }),
                    conflicts.end());
    if (conflicts.empty()) {
      RC_ASSERT(points.is_weighted());
      RC_ASSERT(!algorithm.insert(u));
    } else {
      algorithm.insert(u, *rc::gen::elementOf(conflicts));
    }
    inserted.insert(u);
    check_closed(algorithm.dictionary());
    check_hull(points, algorithm, inserted);
    RC_ASSERT(algorithm.triangulation() == of_subset(points, inserted));
  }
}

TEST_CASE("Bowyer-Watson: after every insertion, in any order, ghosts close a convex hull") {
  for (const std::size_t d : {1U, 2U, 3U}) {
    const auto sets = generators::any_point_set(d, 8);
    const auto cases = rc::gen::oneOf(generators::unweighted(sets), generators::weighted(sets));
    CHECK(properties::holds("dimension " + std::to_string(d), [&cases] {
      const generators::PointsCase set = *cases;
      RC_PRE(set.points.size() >= 2U);
      check_every_step(PointSet(set.points, set.weights));
    }));
  }
}

// Two skew lines far apart, with a short row of points on each.
std::vector<Point> points_on_two_lines(int on_each) {
  std::vector<Point> points;
  for (int i = 0; i < on_each; ++i) points.push_back({2 * i - on_each + 1, 0, 20 * on_each});
  for (int i = 0; i < on_each; ++i) points.push_back({0, 2 * i - on_each + 1, -20 * on_each});
  return points;
}

// "The insertion of a single vertex into an n-vertex Delaunay triangulation can delete Θ(n²)
// tetrahedra if the triangulation is the one depicted in Figure 4.2. However, a single vertex
// insertion can only create Θ(n) tetrahedra." The vertex in the middle is in every circumball.
TEST_CASE("Bowyer-Watson: one insertion deletes a quadratic number of tetrahedra") {
  for (const int m : {2, 5, 20}) {
    CAPTURE(m);
    std::vector<Point> set = points_on_two_lines(m);
    set.push_back({0, 0, 0});
    const PointSet points(set);
    const auto last = static_cast<Vertex>(points.size()) - 1;
    BowyerWatson algorithm(points);
    for (Vertex u = 0; u < last; ++u) {
      if (!contains(algorithm.first_simplex(), u)) algorithm.insert(u);
    }
    const auto quadratic = static_cast<std::size_t>((m - 1) * (m - 1));
    CHECK(algorithm.triangulation().simplices().size() == quadratic);
    algorithm.insert(last);
    CHECK(algorithm.last_insertion().deleted.size() == quadratic);
    // All vertices are on the hull: the cavity has 2n − 4 facets, and none of them is removed.
    CHECK(algorithm.last_insertion().created.size() == static_cast<std::size_t>(2 * 2 * m - 4));
  }
}

TEST_CASE("statistics: what a triangle, a point inside and a point outside create and delete") {
  const PointSet points({{0, 0}, {4, 0}, {0, 4}, {1, 1}, {9, 9}});
  Statistics statistics;
  bowyer_watson(points, {.order = InsertionOrder::kAsGiven}, &statistics);
  // Three triangles for one; then a triangle beyond the diagonal, and two ghosts for its one.
  CHECK(statistics.solid_simplices_created == 1 + 3 + 1);
  CHECK(statistics.solid_simplices_deleted == 1);
  CHECK(statistics.ghost_simplices_created == 3 + 2);
  CHECK(statistics.ghost_simplices_deleted == 1);
  CHECK(statistics.conflicts_created == 0);
  CHECK(statistics.walk_steps == 0);
  CHECK(statistics.conflict_tests > 0);
  bowyer_watson(points, {.location = PointLocation::kWalking}, &statistics);
  CHECK(statistics.walk_steps > 0);
  CHECK(statistics.solid_simplices_created == 5);
  bowyer_watson(points, {.location = PointLocation::kConflictGraph}, &statistics);
  CHECK(statistics.conflicts_created == 2);
  CHECK(statistics.walk_steps == 0);
}

}  // namespace
}  // namespace circumspect::delaunay
