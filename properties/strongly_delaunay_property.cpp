// Strongly Delaunay simplices, and the Delaunay Lemma on all triangulations of small sets.
#include <algorithm>

#include <doctest/doctest.h>

#include "kernel/complex/circumball.hpp"
#include "kernel/complex/improper_intersection.hpp"
#include "kernel/complex/point_set.hpp"
#include "kernel/complex/simplex.hpp"
#include "kernel/exact/point.hpp"
#include "kernel/predicates/in_ball.hpp"
#include "oracle/judge/domain/judge_exactly.hpp"
#include "properties/arguments/point_sets.hpp"
#include "properties/arguments/run.hpp"
#include "reference/delaunay/genericity.hpp"
#include "reference/delaunay/lifted_hull.hpp"
#include "reference/delaunay/simplex_predicates.hpp"
#include "reference/optimality/all_triangulations.hpp"
#include "reference/optimality/criteria.hpp"

namespace circumspect::properties {

// D3: strongly Delaunay simplices of all dimensions. Book: Section 4.2, Propositions 4.2 and 4.3,
// Exercise 2 of Chapter 4.

namespace {

using delaunay::Delaunayhood;
using delaunay::SimplexDelaunayhood;
using generators::PointsCase;

// All simplices of all dimensions whose vertices are points of the set.
std::vector<Simplex> all_simplices(const PointSet& points) {
  std::vector<Simplex> simplices;
  for (std::size_t size = 1; static_cast<int>(size) <= points.dimension() + 1; ++size) {
    Simplex subset = first_subset(size);
    do {
      const AffineHull hull = affine_hull(coordinates(points, subset));
      if (hull.basis.size() == size) simplices.push_back(subset);
    } while (next_subset(subset, points.size()));
  }
  return simplices;
}

std::vector<Simplex> those_that_are(const PointSet& points, bool strongly) {
  std::vector<Simplex> simplices = all_simplices(points);
  std::erase_if(simplices, [&](const Simplex& simplex) {
    return strongly ? !delaunay::is_strongly_delaunay(points, simplex)
                    : !delaunay::is_delaunay(points, simplex);
  });
  return simplices;
}

// The ball passes through the vertices, is centred in the affine hull of S, and is empty.
void assert_ball_is_a_witness(const PointSet& points, const Simplex& simplex,
                              const SimplexDelaunayhood& answer) {
  const Ball& ball = *answer.ball;
  Simplex hull;
  for (const std::size_t i : points.configuration().hull().basis) {
    hull.push_back(static_cast<Vertex>(i));
  }
  RC_ASSERT(optimality::barycentric_coordinates(points, hull, ball.centre).has_value());
  for (Vertex q = 0; points.names(q); ++q) {
    const int where = sign(power(points, ball, q));
    if (contains(simplex, q)) {
      RC_ASSERT(where == 0);
    } else if (answer.delaunayhood == Delaunayhood::kStronglyDelaunay) {
      RC_ASSERT(where > 0);
    } else {
      RC_ASSERT(where >= 0);
    }
  }
}

// The combination of points, none of them a vertex, is in the simplex's affine hull, and has the
// power that is claimed: for one circumball, hence for all.
void assert_obstruction_is_a_reason(const PointSet& points, const Simplex& simplex,
                                    const SimplexDelaunayhood& answer) {
  const delaunay::Obstruction& why = *answer.obstruction;
  RC_ASSERT(why.points.size() == why.coefficients.size());
  Rational total = 0;
  Rational combined_power = 0;
  const Ball smallest = circumball(points, simplex);
  for (std::size_t i = 0; i < why.points.size(); ++i) {
    RC_ASSERT(!contains(simplex, why.points[i]));
    RC_ASSERT(sign(why.coefficients[i]) > 0);
    total += why.coefficients[i];
    combined_power += why.coefficients[i] * power(points, smallest, why.points[i]);
  }
  RC_ASSERT(total == Rational(1));
  RC_ASSERT(combined_power == why.power);
  RC_ASSERT(sign(why.power) == (answer.delaunayhood == Delaunayhood::kDelaunay ? 0 : -1));
  const Point place = optimality::combination(points, why.points, why.coefficients);
  RC_ASSERT(optimality::barycentric_coordinates(points, simplex, place).has_value());
}

TEST_CASE("D3 every answer of the simplex predicates carries its proof (Section 4.2)") {
  for (const std::size_t d : {1u, 2u, 3u, 4u}) {
    CAPTURE(d);
    CHECK(holds("witnessing balls and obstructions", 20, [d] {
      const auto sets = generators::any_point_set(d, d + 3);
      const PointsCase set =
          *rc::gen::oneOf(generators::unweighted(sets), generators::weighted(sets));
      const PointSet points(set.points, set.weights);
      for (const Simplex& simplex : all_simplices(points)) {
        const SimplexDelaunayhood answer = delaunay::delaunayhood(points, simplex);
        const bool is_delaunay = answer.delaunayhood != Delaunayhood::kNotDelaunay;
        const bool is_strongly = answer.delaunayhood == Delaunayhood::kStronglyDelaunay;
        RC_ASSERT(answer.ball.has_value() == is_delaunay);
        RC_ASSERT(answer.obstruction.has_value() == !is_strongly);
        if (is_delaunay) assert_ball_is_a_witness(points, simplex, answer);
        if (!is_strongly) assert_obstruction_is_a_reason(points, simplex, answer);
      }
    }));
  }
}

TEST_CASE("D3 faces of (strongly) Delaunay simplices are so, and every vertex (Exercise 4.2)") {
  for (const std::size_t d : {1u, 2u, 3u, 4u}) {
    CAPTURE(d);
    CHECK(holds("faces", 20, [d] {
      const PointsCase set = *generators::unweighted(generators::any_point_set(d, d + 3));
      const PointSet points(set.points);
      for (Vertex v = 0; points.names(v); ++v) {
        RC_ASSERT(delaunay::is_strongly_delaunay(points, {v}));
      }
      for (const bool strongly : {false, true}) {
        const std::vector<Simplex> simplices = those_that_are(points, strongly);
        for (const Simplex& simplex : simplices) {
          for (const Simplex& face : faces(simplex)) {
            RC_ASSERT(std::count(simplices.begin(), simplices.end(), face) == 1);
          }
        }
      }
    }));
  }
}

TEST_CASE("D3 a strongly Delaunay simplex meets Delaunay ones in shared faces (Proposition 4.2)") {
  for (const std::size_t d : {1u, 2u, 3u, 4u}) {
    CAPTURE(d);
    CHECK(holds("proper intersection", 15, [d] {
      const PointsCase set =
          *generators::unweighted(generators::any_point_set(d, d == 4 ? 6 : d + 3));
      const PointSet points(set.points);
      const std::vector<Simplex> delaunay_ones = those_that_are(points, false);
      for (const Simplex& sigma : those_that_are(points, true)) {
        for (const Simplex& tau : delaunay_ones) {
          RC_ASSERT(!improper_intersection(points, sigma, tau).has_value());
        }
      }
    }));
  }
}

TEST_CASE("D3 every Delaunay triangulation has every strongly Delaunay simplex (Prop. 4.3)") {
  for (const std::size_t d : {1u, 2u, 3u, 4u}) {
    CAPTURE(d);
    CHECK(holds("strongly Delaunay simplices are in all", d == 4 ? 8 : 20, [d] {
      const PointsCase set =
          *generators::unweighted(generators::any_point_set(d, d == 4 ? 7 : d + 4));
      const PointSet points(set.points);
      const std::vector<Simplex> strongly = those_that_are(points, true);
      for (const Triangulation& one : optimality::all_triangulations(points)) {
        if (!delaunay::is_delaunay(points, one)) continue;
        const std::vector<Simplex> complex = optimality::simplicial_complex(one);
        for (const Simplex& simplex : strongly) {
          RC_ASSERT(std::count(complex.begin(), complex.end(), simplex) == 1);
        }
        // "A generic point set has exactly one Delaunay triangulation, composed of every strongly
        // Delaunay simplex."
        if (!delaunay::cospherical_points(points)) RC_ASSERT(complex.size() == strongly.size());
      }
    }));
  }
}

// D1: the Delaunay Lemma on all triangulations of small sets, Delaunay or not, each of its three
// statements from its own definition. Book: Lemma 4.1, Theorem 4.4. D10: its weighted form.

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
          RC_ASSERT(
              check::judge_exactly(Claim::kDelaunay, {points, one.simplices()}, nullptr, {.by = by})
                  .holds() == expected);
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
      // subdivision has a cell that is not a simplex.
      const bool is_simplicial =
          !delaunay::cospherical_points_of_an_empty_ball(points, canonical).has_value();
      RC_ASSERT(is_simplicial == (delaunay_ones.size() == 1u));
    }));
  }
}

// Is each point that is not a vertex on or above the witness plane of a simplex that contains it?
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
