// Point location by walking, and that linear scans find something if walks do. Book: Section 5.5.
#include "reference/delaunay/point_location.hpp"

#include <doctest/doctest.h>

#include "kernel/predicates/orientation.hpp"
#include "properties/arguments/laws.hpp"
#include "properties/arguments/run.hpp"
#include "reference/delaunay/bowyer_watson.hpp"
#include "reference/delaunay/dictionary.hpp"
#include "reference/delaunay/lifted_hull.hpp"

namespace circumspect::delaunay {
namespace {

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

}  // namespace
}  // namespace circumspect::delaunay
