// D8: deletion gives the canonical triangulation of what is left; insert then delete restores,
// delete then insert restores. Book: Sections 5.2 and 5.6.
#include <algorithm>

#include <doctest/doctest.h>

#include "kernel/complex/point_set.hpp"
#include "kernel/exact/each_once.hpp"
#include "properties/arguments/point_sets.hpp"
#include "properties/arguments/run.hpp"
#include "reference/delaunay/bowyer_watson.hpp"
#include "reference/delaunay/gift_wrapping.hpp"
#include "reference/delaunay/lifted_hull.hpp"
#include "reference/delaunay/vertex_deletion.hpp"

namespace circumspect::properties {
namespace {

using generators::PointsCase;

std::vector<Vertex> vertices_of(const Triangulation& triangulation) {
  std::vector<Vertex> vertices;
  for (const Simplex& simplex : triangulation.simplices()) {
    vertices.insert(vertices.end(), simplex.begin(), simplex.end());
  }
  keep_each_once(vertices);
  return vertices;
}

// Those of a set's points that its triangulation leaves out.
std::vector<Vertex> submerged(const Triangulation& triangulation, const std::vector<Vertex>& set) {
  const std::vector<Vertex> vertices = vertices_of(triangulation);
  std::vector<Vertex> left_out;
  std::set_difference(set.begin(), set.end(), vertices.begin(), vertices.end(),
                      std::back_inserter(left_out));
  return left_out;
}

// The canonical triangulation of some of the points, under their numbers in `set`.
Triangulation canonical(const PointsCase& set, const std::vector<Vertex>& members) {
  PointsCase subset;
  for (const Vertex v : members) {
    subset.points.push_back(set.points[static_cast<std::size_t>(v)]);
    if (!set.weights.empty()) subset.weights.push_back(set.weights[static_cast<std::size_t>(v)]);
  }
  const Triangulation own = delaunay::by_definition(PointSet(subset.points, subset.weights));
  std::vector<Simplex> simplices = own.simplices();
  for (Simplex& simplex : simplices) {
    for (Vertex& v : simplex) v = members[static_cast<std::size_t>(v)];
  }
  return Triangulation(own.dimension(), std::move(simplices));
}

// What the random cases have exercised.
struct Seen {
  std::size_t surfaced = 0, dropped = 0, on_hull = 0, inside = 0;

  void note(const Triangulation& before, const Triangulation& after, Vertex v) {
    dropped += after.dimension() < before.dimension() ? 1u : 0u;
    surfaced += vertices_of(after).size() >= vertices_of(before).size() ? 1u : 0u;
    bool hull = false;
    for (const auto& [facet, apexes] : apexes_by_facet(before)) {
      hull |= apexes.size() == 1 && contains(facet, v);
    }
    ++(hull ? on_hull : inside);
  }
};

TEST_CASE(
    "D8 deleting vertices one after the other stays canonical, down to nothing (Section 5.6)") {
  for (const std::size_t d : {1u, 2u, 3u, 4u}) {
    CAPTURE(d);
    Seen seen;
    CHECK(holds("repeated deletion", d == 4 ? 60 : 250, [&] {
      const PointsCase set = *generators::any_case(d, d == 4 ? 9 : 11);
      const PointSet points(set.points, set.weights);
      std::vector<Vertex> members = all_vertices(points);
      Triangulation triangulation = delaunay::by_definition(points);
      while (!triangulation.simplices().empty()) {
        const std::vector<Vertex> vertices = vertices_of(triangulation);
        const Vertex v = vertices[*rc::gen::inRange<std::size_t>(0, vertices.size())];
        const Triangulation before = triangulation;
        triangulation = delaunay::delete_vertex(points, before, v, submerged(before, members));
        members.erase(std::find(members.begin(), members.end(), v));
        RC_ASSERT(triangulation == canonical(set, members));
        seen.note(before, triangulation, v);
      }
      RC_ASSERT(members.empty());
    }));
    if (d <= 3) CHECK(occurs(seen.surfaced));
    CHECK(occurs(seen.dropped));
    CHECK(occurs(seen.on_hull));
    CHECK(occurs(seen.inside));
  }
}

TEST_CASE("D8 insert then delete restores (Sections 5.2, 5.6)") {
  for (const std::size_t d : {1u, 2u, 3u}) {
    CAPTURE(d);
    CHECK(holds("deletion undoes insertion", 250, [d] {
      const PointsCase set = *generators::simplex_first(generators::any_case(d, 18));
      const PointSet points(set.points, set.weights);
      delaunay::BowyerWatson growing(points);
      std::vector<Vertex> members = sorted(growing.first_simplex());
      for (const Vertex u : all_vertices(points)) {
        if (contains(growing.first_simplex(), u)) continue;
        const Triangulation before = growing.triangulation();
        const bool is_vertex = growing.insert(u);
        const Triangulation after = growing.triangulation();
        members.insert(std::upper_bound(members.begin(), members.end(), u), u);
        if (!is_vertex) continue;
        RC_ASSERT(delaunay::delete_vertex(points, after, u, submerged(after, members)) == before);
      }
    }));
  }
}

TEST_CASE("D8 delete then insert restores (Sections 5.2, 5.6)") {
  for (const std::size_t d : {1u, 2u, 3u}) {
    CAPTURE(d);
    std::size_t restored = 0;
    CHECK(holds("insertion undoes deletion", 250, [&] {
      const PointsCase set = *generators::simplex_first(generators::any_case(d, 18));
      const PointSet points(set.points, set.weights);
      const Triangulation whole = delaunay::bowyer_watson(points);
      std::vector<Vertex> members = all_vertices(points);
      const std::vector<Vertex> vertices = vertices_of(whole);
      const Vertex v = vertices[*rc::gen::inRange<std::size_t>(0, vertices.size())];
      const Triangulation without =
          delaunay::delete_vertex(points, whole, v, submerged(whole, members));
      if (without.dimension() < whole.dimension()) return;  // v cannot be inserted in this flat
      members.erase(std::find(members.begin(), members.end(), v));
      delaunay::BowyerWatson restoring(points, delaunay::first_independent(points, members));
      for (const Vertex u : members) {
        if (!contains(restoring.first_simplex(), u)) restoring.insert(u);
      }
      RC_ASSERT(restoring.triangulation() == without);
      RC_ASSERT(restoring.insert(v));
      RC_ASSERT(restoring.triangulation() == whole);
      ++restored;
    }));
    CHECK(occurs(restored, 101));
  }
}

}  // namespace
}  // namespace circumspect::properties
