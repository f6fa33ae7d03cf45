// Exercise 3 of Chapter 5: inserting the vertices of a set that is not generic, into Del S (without
// any perturbation) and into Del S[ω] (with it) in the same order, d = 2 and d = 3.
#include <algorithm>
#include <set>

#include <doctest/doctest.h>

#include "kernel/predicates/in_ball.hpp"
#include "properties/arguments/laws.hpp"
#include "properties/arguments/point_sets.hpp"
#include "properties/arguments/run.hpp"
#include "reference/delaunay/bowyer_watson.hpp"
#include "reference/delaunay/lifted_hull.hpp"
#include "reference/delaunay/simplex_predicates.hpp"

namespace circumspect::properties {
namespace {

using delaunay::BowyerWatson;
using delaunay::ConflictTest;
using generators::PointsCase;

std::set<Vertex> solid_neighbors(const std::vector<Simplex>& star, Vertex v) {
  std::set<Vertex> neighbors;
  for (const Simplex& simplex : star) neighbors.insert(simplex.begin(), simplex.end());
  neighbors.erase(v);
  neighbors.erase(kGhost);
  return neighbors;
}

// (a) All edges at the new vertex are strongly Delaunay among the points inserted.
void assert_strongly_delaunay_edges(const PointSet& points, const std::vector<Vertex>& inserted,
                                    Vertex v, const std::set<Vertex>& neighbors) {
  const PointSet prefix(coordinates(points, inserted));
  const auto place = [&](Vertex u) {
    return static_cast<Vertex>(std::find(inserted.begin(), inserted.end(), u) - inserted.begin());
  };
  for (const Vertex w : neighbors) {
    RC_ASSERT(delaunay::is_strongly_delaunay(prefix, {place(v), place(w)}));
  }
}

std::size_t number_of_conflicts(const PointSet& points, const Simplex& simplex,
                                const std::vector<Vertex>& uninserted, ConflictTest in_conflict) {
  return static_cast<std::size_t>(
      std::count_if(uninserted.begin(), uninserted.end(),
                    [&](Vertex w) { return in_conflict(points, simplex, w); }));
}

// (c) "The number of conflicts of a cell (vertices in its open circumball) cannot exceed the number
// of conflicts of any of the corresponding tetrahedra in Del S[ω]": the circumball of such a
// tetrahedron is that of its cell.
void assert_conflicts_of_cells(const PointSet& points, const BowyerWatson& perturbed,
                               const std::vector<Vertex>& uninserted) {
  for (const Simplex& simplex : perturbed.dictionary().simplices()) {
    if (is_ghost(simplex)) continue;
    for (const Vertex w : uninserted) {
      if (in_ball(points.configuration(), simplex, w) <= 0) continue;
      RC_ASSERT(delaunay::is_in_conflict(points, simplex, w));
    }
  }
}

std::size_t conflicts_created(const PointSet& points, const std::vector<Simplex>& created,
                              const std::vector<Vertex>& uninserted, ConflictTest in_conflict) {
  std::size_t sum = 0;
  for (const Simplex& simplex : created) {
    if (is_ghost(simplex)) continue;
    sum += number_of_conflicts(points, simplex, uninserted, in_conflict);
  }
  return sum;
}

const std::vector<Simplex>& insert_unperturbed(const PointSet& points, BowyerWatson& algorithm,
                                               Vertex v) {
  const auto located = algorithm.dictionary().find([&](const Simplex& simplex) {
    return delaunay::is_in_unperturbed_conflict(points, simplex, v);
  });
  RC_ASSERT(located.has_value());
  return algorithm.insert(v, *located).created;
}

void assert_exercise_3(const PointSet& points, std::vector<Vertex> order) {
  const Simplex start = delaunay::first_independent(points, order);
  BowyerWatson plain(points, start, delaunay::is_in_unperturbed_conflict);
  BowyerWatson perturbed(points, start);
  std::vector<Vertex> inserted = start;
  std::vector<Vertex> uninserted = std::move(order);
  std::erase_if(uninserted, [&](Vertex v) { return contains(start, v); });
  while (!uninserted.empty()) {
    const Vertex v = uninserted.back();
    uninserted.pop_back();
    inserted.push_back(v);
    const std::vector<Simplex>& created = insert_unperturbed(points, plain, v);
    RC_ASSERT(perturbed.insert(v));
    const std::vector<Simplex>& created_perturbed = perturbed.last_insertion().created;

    const std::set<Vertex> edges = solid_neighbors(created, v);
    assert_strongly_delaunay_edges(points, inserted, v, edges);
    const std::set<Vertex> edges_perturbed = solid_neighbors(created_perturbed, v);
    RC_ASSERT(
        std::includes(edges_perturbed.begin(), edges_perturbed.end(), edges.begin(), edges.end()));
    RC_ASSERT(created.size() <= created_perturbed.size());  // (b)
    assert_conflicts_of_cells(points, perturbed, uninserted);
    RC_ASSERT(
        conflicts_created(points, created, uninserted, delaunay::is_in_unperturbed_conflict) <=
        conflicts_created(points, created_perturbed, uninserted, delaunay::is_in_conflict));
  }
}

TEST_CASE("Chapter 5, Exercise 3: Del S creates no more than Del S[ω], vertex by vertex") {
  for (const std::size_t d : {2u, 3u}) {
    CAPTURE(d);
    CHECK(holds("Exercise 3 (a), (b), (c)", 120, [d] {
      const PointsCase set = *generators::unweighted(generators::degenerate_point_set(d, 12));
      const PointSet points(set.points);
      // On a line two vertices are never cospherical with a third.
      if (points.dimension() < 2) return;
      assert_exercise_3(points, generators::shuffled(generators::first_vertices(points.size())));
    }));
  }
}

}  // namespace
}  // namespace circumspect::properties
