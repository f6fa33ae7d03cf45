// D5: what the Delaunay triangulation minimises, against all triangulations of small sets; D10: the
// anisotropic form. Book: Section 4.3, Propositions 4.5 to 4.8.
#include <algorithm>
#include <optional>

#include <doctest/doctest.h>

#include "kernel/complex/circumball.hpp"
#include "properties/arguments/generated.hpp"
#include "properties/arguments/point_sets.hpp"
#include "properties/arguments/run.hpp"
#include "reference/delaunay/lifted_hull.hpp"
#include "reference/delaunay/simplex_predicates.hpp"
#include "reference/optimality/all_triangulations.hpp"
#include "reference/optimality/criteria.hpp"

namespace circumspect::properties {
namespace {

using generators::PointsCase;
using optimality::all_triangulations;
using optimality::GreatestError;

// At most 8 points, as many as can be enumerated in each dimension without ado.
rc::Gen<PointsCase> small_sets(std::size_t d) {
  return generators::unweighted(generators::any_point_set(d, d == 4 ? 7 : 8));
}

// The barycentres of the edges and of the k-simplices of a triangulation.
std::vector<Point> sample_points(const PointSet& points, const Triangulation& triangulation) {
  std::vector<Point> samples;
  for (const Simplex& simplex : optimality::simplicial_complex(triangulation)) {
    const bool is_edge = simplex.size() == 2;
    const bool is_largest = static_cast<int>(simplex.size()) == triangulation.dimension() + 1;
    if (is_edge || is_largest) samples.push_back(barycentre(points, simplex));
  }
  return samples;
}

TEST_CASE("D5 the error is r^2 - d(o,p)^2 on each simplex, and never negative (Section 4.3)") {
  for (const std::size_t d : {1u, 2u, 3u, 4u}) {
    CAPTURE(d);
    CHECK(holds("e(p)", d == 4 ? 6 : 15, [d] {
      const PointsCase set = *generators::unweighted(generators::any_point_set(d, d + 3));
      const PointSet points(set.points);
      for (const Triangulation& one : all_triangulations(points)) {
        for (Vertex v = 0; points.names(v); ++v) {
          RC_ASSERT(*optimality::interpolation_error(points, one, points[v]) == Rational(0));
        }
        for (const Simplex& simplex : one.simplices()) {
          const Ball ball = circumball(points, simplex);
          for (const Simplex& face : faces(simplex)) {
            const Point p = barycentre(points, face);
            const Rational error = *optimality::interpolation_error(points, one, p);
            RC_ASSERT(error == ball.squared_radius - squared_distance(ball.centre, p));
            RC_ASSERT(sign(error) == (face.size() == 1 ? 0 : 1));
          }
        }
      }
    }));
  }
}

TEST_CASE("D5 at every point a Delaunay triangulation errs least of all (Proposition 4.5)") {
  for (const std::size_t d : {1u, 2u, 3u, 4u}) {
    CAPTURE(d);
    CHECK(holds("least lifted height", d == 4 ? 6 : 12, [d] {
      const PointsCase set = *small_sets(d);
      const PointSet points(set.points);
      const Triangulation best = delaunay::by_definition(points);
      const std::vector<Point> own_samples = sample_points(points, best);
      const Rational least_integral = optimality::lifted_integral(points, best);
      for (const Triangulation& one : all_triangulations(points)) {
        std::vector<Point> samples = sample_points(points, one);
        samples.insert(samples.end(), own_samples.begin(), own_samples.end());
        const bool is_delaunay = delaunay::is_delaunay(points, one);
        for (const Point& p : samples) {
          const Rational least = *optimality::lifted_height(points, best, p);
          const Rational height = *optimality::lifted_height(points, one, p);
          RC_ASSERT((is_delaunay ? height == least : height >= least));
        }
        // Its L₁ norm is least as well, and that of no other triangulation.
        const Rational integral = optimality::lifted_integral(points, one);
        RC_ASSERT((is_delaunay ? integral == least_integral : integral > least_integral));
      }
    }));
  }
}

// From Definition 1.20, without Proposition 4.6: the smallest ball through the vertices of a face,
// of those that contain the whole simplex.
Ball smallest_containing_ball(const PointSet& points, const Simplex& simplex) {
  std::optional<Ball> smallest;
  for (const Simplex& face : faces(simplex)) {
    const Ball ball = circumball(points, face);
    const bool contains_all = std::all_of(simplex.begin(), simplex.end(), [&](Vertex v) {
      return sign(power(points, ball, v)) <= 0;
    });
    if (!contains_all) continue;
    if (!smallest || ball.squared_radius < smallest->squared_radius) smallest = ball;
  }
  return *smallest;
}

TEST_CASE("D5 the min-containment ball, and the greatest error at its centre (Proposition 4.6)") {
  for (const std::size_t d : {1u, 2u, 3u, 4u, 5u}) {
    CAPTURE(d);
    CHECK(holds("o_mc is the point of the simplex nearest to o", 30, [d] {
      const PointsCase set = *generators::unweighted(generators::any_point_set(d, d + 2));
      const PointSet points(set.points);
      for (const Simplex& simplex :
           optimality::simplicial_complex(delaunay::by_definition(points))) {
        const Ball ball = optimality::min_containment_ball(points, simplex);
        const Ball expected = smallest_containing_ball(points, simplex);
        RC_ASSERT(ball.centre == expected.centre);
        RC_ASSERT(ball.squared_radius == expected.squared_radius);
        // "For every simplex σ … that function is f(p) = c|p|²/2, and that point is p = o_mc."
        const GreatestError greatest = optimality::greatest_interpolation_error(points, simplex);
        RC_ASSERT(greatest.where == ball.centre);
        RC_ASSERT(greatest.error == ball.squared_radius);
      }
    }));
  }
}

TEST_CASE("D5 a Delaunay triangulation minimises the largest min-containment ball (Prop. 4.7)") {
  for (const std::size_t d : {1u, 2u, 3u, 4u}) {
    CAPTURE(d);
    CHECK(holds("largest min-containment ball", d == 4 ? 6 : 15, [d] {
      const PointsCase set = *small_sets(d);
      RC_PRE(!set.points.empty());
      const PointSet points(set.points);
      const auto radius = [&](const Triangulation& one) {
        return optimality::largest_min_containment_ball(points, one).squared_radius;
      };
      const Rational least = radius(delaunay::by_definition(points));
      for (const Triangulation& one : all_triangulations(points)) {
        const Rational largest = radius(one);
        RC_ASSERT((delaunay::is_delaunay(points, one) ? largest == least : largest >= least));
        // Proposition 4.8: the worst pointwise error is c r²/2, and the paraboloid c|p|²/2 has it.
        RC_ASSERT(optimality::greatest_interpolation_error(points, one).error == largest);
      }
    }));
  }
}

using SymmetricMatrix = std::vector<std::vector<Rational>>;

Rational quadratic(const SymmetricMatrix& a, const Point& p) {
  Rational sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; j < p.size(); ++j) sum += p[i] * a[i][j] * p[j];
  }
  return sum;
}

std::vector<std::vector<Rational>> random_matrix(std::size_t d) {
  return *rc::gen::container<std::vector<std::vector<Rational>>>(
      d, rc::gen::container<std::vector<Rational>>(d, generators::integer_number(3)));
}

TEST_CASE("D5 no quadratic function of curvature c errs more than c r^2 / 2 (Proposition 4.8)") {
  for (const std::size_t d : {1u, 2u, 3u}) {
    CAPTURE(d);
    CHECK(holds("Waldron's bound", 60, [d] {
      const PointsCase set = *generators::unweighted(generators::any_point_set(d, d + 1));
      SymmetricMatrix hessian = random_matrix(d);
      Rational curvature = 0;  // a row's absolute values sum to no less than any eigenvalue
      for (std::size_t i = 0; i < d; ++i) {
        Rational row_sum = 0;
        for (std::size_t j = 0; j < d; ++j) {
          if (j < i) hessian[i][j] = hessian[j][i];
          row_sum += abs(hessian[i][j]);
        }
        curvature = std::max(curvature, row_sum);
      }
      const PointSet points(set.points);
      for (const Simplex& simplex :
           optimality::simplicial_complex(delaunay::by_definition(points))) {
        const Ball ball = optimality::min_containment_ball(points, simplex);
        const Point& p = ball.centre;
        const auto place = optimality::barycentric_coordinates(points, simplex, p);
        Rational interpolated = 0;
        for (std::size_t i = 0; i < simplex.size(); ++i) {
          interpolated += (*place)[i] * quadratic(hessian, points[simplex[i]]) / 2;
        }
        const Rational error = abs(interpolated - quadratic(hessian, p) / 2);
        RC_ASSERT(error <= curvature * ball.squared_radius / 2);
      }
    }));
  }
}

// B^T B + 1, which is positive definite: "parabolic rather than hyperbolic".
SymmetricMatrix random_positive_definite(std::size_t d) {
  const SymmetricMatrix b = random_matrix(d);
  SymmetricMatrix a(d, std::vector<Rational>(d));
  for (std::size_t i = 0; i < d; ++i) {
    for (std::size_t j = 0; j < d; ++j) {
      a[i][j] = i == j ? 1 : 0;
      for (std::size_t k = 0; k < d; ++k) a[i][j] += b[k][i] * b[k][j];
    }
  }
  return a;
}

TEST_CASE(
    "D10 an anisotropic quadratic is interpolated best by a weighted Delaunay triangulation") {
  for (const std::size_t d : {1u, 2u, 3u}) {
    CAPTURE(d);
    CHECK(holds("p^T A p, the function determines the vertex heights", 12, [d] {
      const PointsCase set = *small_sets(d);
      const SymmetricMatrix a = random_positive_definite(d);
      std::vector<Rational> weights;  // such that |p|² − w is the function
      for (const Point& p : set.points) weights.push_back(squared_length(p) - quadratic(a, p));
      const PointSet points(set.points, weights);
      const Triangulation best = delaunay::by_definition(points);
      const std::vector<Triangulation> all = all_triangulations(points);
      RC_ASSERT(std::count(all.begin(), all.end(), best) == 1);
      const Rational least_integral = optimality::lifted_integral(points, best);
      for (const Triangulation& one : all) {
        for (const Point& p : sample_points(points, one)) {
          const Rational error = *optimality::lifted_height(points, one, p) - quadratic(a, p);
          const Rational least = *optimality::lifted_height(points, best, p) - quadratic(a, p);
          RC_ASSERT(sign(least) >= 0);
          RC_ASSERT(error >= least);
        }
        const bool is_delaunay = delaunay::is_delaunay(points, one);
        const Rational integral = optimality::lifted_integral(points, one);
        RC_ASSERT((is_delaunay ? integral == least_integral : integral > least_integral));
      }
    }));
  }
}

}  // namespace
}  // namespace circumspect::properties
