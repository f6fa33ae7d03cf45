// D1: the Delaunay Lemma on all triangulations of small sets, Delaunay or not, each of its three
// statements from its own definition. Book: Lemma 4.1, Theorem 4.4. D10: its weighted form.
#include <algorithm>

#include <doctest/doctest.h>

#include "oracle/judge/points/check.hpp"
#include "properties/arguments/point_sets.hpp"
#include "properties/arguments/run.hpp"
#include "reference/delaunay/by_definition.hpp"
#include "reference/delaunay/genericity.hpp"
#include "reference/delaunay/simplex_predicates.hpp"
#include "reference/kernel/predicates/in_ball.hpp"
#include "reference/optimality/all_triangulations.hpp"
#include "reference/optimality/barycentric.hpp"

namespace circumspect::properties {
namespace {

using generators::PointsCase;
using optimality::all_triangulations;
using optimality::VertexUse;

// The first statement: "every d-simplex in 𝒯 is Delaunay": no point in its open circumball.
bool every_simplex_is_delaunay(const PointSet& points, const Triangulation& triangulation) {
  for (const Simplex& simplex : triangulation.simplices()) {
    const Ball ball = circumball(points, simplex);
    for (Vertex q = 0; points.names(q); ++q) {
      if (sign(power(points, ball, q)) < 0) return false;
    }
  }
  return true;
}

// The second: "every facet in 𝒯 is Delaunay": some open circumball of it is empty.
bool every_facet_is_delaunay(const PointSet& points, const Triangulation& triangulation) {
  const auto facets = apexes_by_facet(triangulation);
  return std::all_of(facets.begin(), facets.end(), [&](const auto& entry) {
    return entry.first.empty() || delaunay::is_delaunay(points, entry.first);
  });
}

// "A facet f is said to be locally Delaunay if it is a face of fewer than two d-simplices in 𝒯, or
// it is a face of exactly two and it has an open circumball that contains no vertex of τ₁ nor τ₂."
bool is_locally_delaunay(const PointSet& points, const Simplex& facet,
                         const std::vector<Vertex>& apexes) {
  if (apexes.size() < 2) return true;
  std::vector<Point> vertices = coordinates(points, facet);
  std::vector<Rational> weights;
  for (const Vertex v : facet) weights.push_back(points.weight(v));
  Simplex same_facet;
  for (std::size_t i = 0; i < facet.size(); ++i) same_facet.push_back(static_cast<Vertex>(i));
  for (const Vertex apex : apexes) {
    vertices.push_back(points[apex]);
    weights.push_back(points.weight(apex));
  }
  return delaunay::is_delaunay(PointSet(vertices, weights), same_facet);
}

// "Equivalently, the open circumball of τ₁ contains no vertex of τ₂. Equivalently, the open
// circumball of τ₂ contains no vertex of τ₁."
void assert_equivalent_forms(const PointSet& points, const Simplex& facet,
                             const std::vector<Vertex>& apexes, bool locally_delaunay) {
  if (apexes.size() < 2) return;
  for (const std::size_t one : {0u, 1u}) {
    Simplex tau = facet;
    tau.push_back(apexes[one]);
    RC_ASSERT((in_ball(points.configuration(), tau, apexes[1 - one]) <= 0) == locally_delaunay);
  }
}

// The third: "every facet in 𝒯 is locally Delaunay".
bool every_facet_is_locally_delaunay(const PointSet& points, const Triangulation& triangulation) {
  bool all = true;
  for (const auto& [facet, apexes] : apexes_by_facet(triangulation)) {
    const bool locally_delaunay = is_locally_delaunay(points, facet, apexes);
    assert_equivalent_forms(points, facet, apexes, locally_delaunay);
    all = all && locally_delaunay;
  }
  return all;
}

std::size_t most_points(std::size_t d) { return d == 2 ? 7 : d + 4; }

TEST_CASE("D1 the three statements of the Delaunay Lemma agree on all triangulations (Lemma 4.1)") {
  for (const std::size_t d : {1u, 2u, 3u, 4u}) {
    CAPTURE(d);
    std::size_t delaunay_ones = 0;
    std::size_t others = 0;
    CHECK(holds("three equivalent statements", d == 4 ? 15 : 40, [&, d] {
      const PointsCase set =
          *generators::unweighted(generators::any_point_set(d, d == 4 ? 7 : most_points(d)));
      const PointSet points(set.points);
      for (const Triangulation& one : all_triangulations(points)) {
        const bool first = every_simplex_is_delaunay(points, one);
        RC_ASSERT(every_facet_is_delaunay(points, one) == first);
        RC_ASSERT(every_facet_is_locally_delaunay(points, one) == first);
        RC_ASSERT(delaunay::is_delaunay(points, one) == first);
        ++(first ? delaunay_ones : others);
      }
    }));
    CHECK(occurs(delaunay_ones));
    CHECK((d == 1 || occurs(others)));
  }
}

TEST_CASE("D1 both checkers accept exactly the Delaunay ones of all triangulations") {
  for (const std::size_t d : {1u, 2u, 3u}) {
    CAPTURE(d);
    CHECK(holds("checkers against the definition", 40, [d] {
      const PointsCase set = *generators::unweighted(generators::any_point_set(d, d + 4));
      const PointSet points(set.points);
      for (const Triangulation& one : all_triangulations(points)) {
        const bool expected = every_simplex_is_delaunay(points, one);
        for (const check::By by : {check::By::kLemma, check::By::kDefinition}) {
          RC_ASSERT(check::delaunay({points, one.simplices()}, {.by = by}).holds() == expected);
        }
      }
    }));
  }
}

TEST_CASE("D1 a generic point set has exactly one Delaunay triangulation (Theorem 4.4)") {
  for (const std::size_t d : {1u, 2u, 3u, 4u}) {
    CAPTURE(d);
    CHECK(holds("one of all triangulations is Delaunay", d == 4 ? 15 : 40, [d] {
      const PointsCase set =
          *generators::unweighted(generators::any_point_set(d, d == 4 ? 7 : most_points(d)));
      const PointSet points(set.points);
      std::vector<Triangulation> delaunay_ones;
      for (Triangulation& one : all_triangulations(points)) {
        if (every_simplex_is_delaunay(points, one)) delaunay_ones.push_back(std::move(one));
      }
      const Triangulation canonical = delaunay::by_definition(points);
      RC_ASSERT(std::count(delaunay_ones.begin(), delaunay_ones.end(), canonical) == 1);
      if (!delaunay::cospherical_points(points)) RC_ASSERT(delaunay_ones.size() == 1u);
      // "If S is not generic … S has multiple Delaunay triangulations": that is, if its Delaunay
      // subdivision has a cell that is no simplex.
      const bool is_simplicial =
          !delaunay::cospherical_points_of_an_empty_ball(points, canonical).has_value();
      RC_ASSERT(is_simplicial == (delaunay_ones.size() == 1u));
    }));
  }
}

// Is each point that is no vertex on or above the witness plane of a simplex that contains it?
bool no_point_is_below(const PointSet& points, const Triangulation& triangulation) {
  for (Vertex q = 0; points.names(q); ++q) {
    for (const Simplex& simplex : triangulation.simplices()) {
      const auto place = optimality::barycentric_coordinates(points, simplex, points[q]);
      if (!place || !optimality::is_convex(*place)) continue;
      if (in_ball(points.configuration(), simplex, q) > 0) return false;
      break;
    }
  }
  return true;
}

TEST_CASE("D10 the weighted Delaunay Lemma, on all triangulations of some of the points") {
  for (const std::size_t d : {1u, 2u, 3u}) {
    CAPTURE(d);
    CHECK(holds("weighted: every simplex, or every facet and every point left out", 50, [d] {
      const PointsCase set = *generators::weighted(generators::any_point_set(d, d + 3));
      const PointSet points(set.points, set.weights);
      std::size_t delaunay_ones = 0;
      for (const Triangulation& one : all_triangulations(points, VertexUse::kSomePoints)) {
        const bool by_definition = every_simplex_is_delaunay(points, one);
        const bool by_lemma =
            every_facet_is_locally_delaunay(points, one) && no_point_is_below(points, one);
        RC_ASSERT(by_definition == by_lemma);
        if (by_definition) ++delaunay_ones;
      }
      RC_ASSERT(delaunay_ones >= 1u);
    }));
  }
}

}  // namespace
}  // namespace circumspect::properties
