// D2 and D9: incremental insertion in every order with every point location; what holds after each
// step. Book: Sections 5.2 to 5.5.
#include <algorithm>
#include <set>

#include <doctest/doctest.h>

#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/place.hpp"
#include "properties/arguments/laws.hpp"
#include "properties/arguments/point_sets.hpp"
#include "properties/arguments/run.hpp"
#include "reference/delaunay/bowyer_watson.hpp"
#include "reference/delaunay/conflict_graph.hpp"
#include "reference/delaunay/lifted_hull.hpp"

namespace circumspect::properties {
namespace {

using delaunay::BowyerWatson;
using delaunay::ConflictGraph;
using delaunay::Insertion;
using delaunay::InsertionOrder;
using delaunay::PointLocation;
using generators::PointsCase;

rc::Gen<PointsCase> any_case(std::size_t d, std::size_t max_points) {
  const auto sets = generators::any_point_set(d, max_points);
  const auto degenerate = d == 1 ? sets : generators::degenerate_point_set(d, max_points);
  return rc::gen::oneOf(generators::unweighted(sets), generators::unweighted(degenerate),
                        generators::weighted(sets));
}

TEST_CASE("D2 every order and every point location give one triangulation") {
  for (const std::size_t d : {1u, 2u, 3u, 4u}) {
    CAPTURE(d);
    CHECK(holds("orders and locations agree", d == 4 ? 60 : 150, [d] {
      const PointsCase set = *any_case(d, d == 4 ? 10 : 16);
      const PointSet points(set.points, set.weights);
      const auto seed = *rc::gen::arbitrary<std::uint64_t>();
      const Triangulation expected = delaunay::bowyer_watson(points);
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

std::set<Simplex> ascending(const std::vector<Simplex>& simplices) {
  std::set<Simplex> set;
  for (const Simplex& simplex : simplices) set.insert(sorted(simplex));
  return set;
}

// The created simplices are u joined to the facets of the cavity, and each facet has u strictly in
// front: the cavity is star-shaped about u. In space its boundary is a planar graph.
void assert_star_shaped(const PointSet& points, const Insertion& insertion, std::size_t before) {
  std::set<Simplex> boundary;
  for (const Simplex& deleted : insertion.deleted) {
    for (std::size_t place = 0; place < deleted.size(); ++place) {
      const Simplex facet = sorted(facet_opposite(deleted, place));
      if (!boundary.insert(facet).second) boundary.erase(facet);
    }
  }
  std::set<Simplex> joined;
  std::set<Simplex> ridges;
  std::set<Vertex> vertices;
  for (const Simplex& created : insertion.created) {
    const auto apex = std::find(created.begin(), created.end(), insertion.vertex);
    RC_ASSERT(apex != created.end());
    const Simplex facet =
        sorted(facet_opposite(created, static_cast<std::size_t>(apex - created.begin())));
    RC_ASSERT(joined.insert(facet).second);
    vertices.insert(facet.begin(), facet.end());
    if (!is_ghost(created)) RC_ASSERT(orientation(points.configuration(), created) > 0);
    for (std::size_t place = 0; place < facet.size(); ++place) {
      ridges.insert(facet_opposite(facet, place));
    }
  }
  RC_ASSERT(joined == boundary);
  if (points.dimension() != 3) return;
  // Euler's formula for a triangulated sphere, and the book's bound.
  RC_ASSERT(vertices.size() + joined.size() == ridges.size() + 2);
  RC_ASSERT(joined.size() < 2 * before);
}

void assert_cavities(const PointSet& points, const std::vector<Vertex>& order) {
  if (points.dimension() < 1) return;
  BowyerWatson algorithm(points, delaunay::first_independent(points, order));
  std::size_t inserted = algorithm.first_simplex().size();
  for (const Vertex u : order) {
    if (contains(algorithm.first_simplex(), u)) continue;
    const std::vector<Simplex> before = algorithm.dictionary().simplices();
    if (!algorithm.insert(u)) {
      RC_ASSERT(points.is_weighted());
      continue;
    }
    std::vector<Simplex> conflicts;
    for (const Simplex& simplex : before) {
      if (delaunay::is_in_conflict(points, simplex, u)) conflicts.push_back(simplex);
    }
    RC_ASSERT(ascending(algorithm.last_insertion().deleted) == ascending(conflicts));
    assert_star_shaped(points, algorithm.last_insertion(), inserted);
    ++inserted;
  }
}

TEST_CASE("D9 the deleted simplices are those in conflict, and their union is star-shaped") {
  for (const std::size_t d : {1u, 2u, 3u, 4u}) {
    CAPTURE(d);
    CHECK(holds("the cavity", d == 4 ? 60 : 150, [d] {
      const PointsCase set = *any_case(d, d == 4 ? 9 : 14);
      const PointSet points(set.points, set.weights);
      assert_cavities(points, generators::shuffled(generators::first_vertices(points.size())));
    }));
  }
}

// Where an uninserted vertex is filed.
void assert_filed(const PointSet& points, const BowyerWatson& algorithm, const ConflictGraph& graph,
                  Vertex w) {
  const std::vector<Simplex> simplices = algorithm.dictionary().simplices();
  const std::optional<Simplex> filed = graph.conflict_of(w);
  if (!filed) {
    RC_ASSERT(points.is_weighted());
    RC_ASSERT(std::none_of(simplices.begin(), simplices.end(), [&](const Simplex& simplex) {
      return delaunay::is_in_conflict(points, simplex, w);
    }));
    return;
  }
  RC_ASSERT(ascending(simplices).count(sorted(*filed)) == 1);
  RC_ASSERT(delaunay::is_in_conflict(points, *filed, w));
  if (points.is_weighted()) return;
  if (!is_ghost(*filed)) {
    RC_ASSERT(lies_in(points.configuration(), points.configuration().axes(), *filed, w));
    return;
  }
  // In the closed outer halfspace of a hull facet, hence in the interior of no solid simplex.
  const auto ghost = std::find(filed->begin(), filed->end(), kGhost);
  RC_ASSERT(orientation(points.configuration(),
                        with_vertex_replaced(
                            *filed, static_cast<std::size_t>(ghost - filed->begin()), w)) >= 0);
}

TEST_CASE("D9 each uninserted vertex is filed with a simplex that contains it, in conflict") {
  for (const std::size_t d : {1u, 2u, 3u, 4u}) {
    CAPTURE(d);
    CHECK(holds("the conflict graph", d == 4 ? 60 : 200, [d] {
      const PointsCase set = *any_case(d, d == 4 ? 10 : 16);
      const PointSet points(set.points, set.weights);
      if (points.dimension() < 1) return;
      auto order = generators::shuffled(generators::first_vertices(points.size()));
      BowyerWatson algorithm(points, delaunay::first_independent(points, order));
      std::erase_if(order, [&](Vertex u) { return contains(algorithm.first_simplex(), u); });
      ConflictGraph graph(points, algorithm.dictionary(), order, algorithm.statistics());
      for (std::size_t i = 0; i < order.size(); ++i) {
        for (std::size_t rest = i; rest < order.size(); ++rest) {
          assert_filed(points, algorithm, graph, order[rest]);
        }
        const std::optional<Simplex> located = graph.conflict_of(order[i]);
        if (located) graph.update(algorithm.insert(order[i], *located));
      }
    }));
  }
}

}  // namespace
}  // namespace circumspect::properties
