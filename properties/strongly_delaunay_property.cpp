// D3: strongly Delaunay simplices of all dimensions. Book: Section 4.2, Propositions 4.2 and 4.3,
// Exercise 2 of Chapter 4.
#include <algorithm>

#include <doctest/doctest.h>

#include "properties/arguments/point_sets.hpp"
#include "properties/arguments/run.hpp"
#include "reference/delaunay/genericity.hpp"
#include "reference/delaunay/simplex_predicates.hpp"
#include "reference/kernel/complex/proper_intersection.hpp"
#include "reference/kernel/complex/simplex.hpp"
#include "reference/kernel/exact/affine_hull.hpp"
#include "reference/optimality/all_triangulations.hpp"
#include "reference/optimality/barycentric.hpp"
#include "reference/optimality/faces.hpp"

namespace circumspect::properties {
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
          for (const Simplex& face : optimality::faces(simplex)) {
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

}  // namespace
}  // namespace circumspect::properties
