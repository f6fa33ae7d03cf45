#include "reference/optimality/criteria.hpp"

#include <algorithm>
#include <cassert>
#include <optional>

#include "kernel/complex/circumball.hpp"
#include "kernel/exact/linear_algebra.hpp"
#include "kernel/predicates/orientation.hpp"
#include "reference/optimality/all_triangulations.hpp"

namespace circumspect::optimality {

namespace {

// p − v_0 − Σ t_i e_i is orthogonal to every edge e_i = v_i − v_0; nothing if the edges are
// dependent.
std::optional<std::vector<Rational>> projection(const PointSet& points, const Simplex& simplex,
                                                const Point& p) {
  assert(!simplex.empty());
  const Point& origin = points[simplex.front()];
  const std::size_t k = simplex.size() - 1;
  std::vector<Point> edges;
  for (std::size_t i = 1; i <= k; ++i) edges.push_back(points[simplex[i]] - origin);
  RationalMatrix gram(k, std::vector<Rational>(k));
  std::vector<Rational> right(k);
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t j = 0; j < k; ++j) gram[i][j] = inner_product(edges[i], edges[j]);
    right[i] = inner_product(edges[i], p - origin);
  }
  std::optional<std::vector<Rational>> coefficients = solve(gram, right);
  if (!coefficients) return std::nullopt;
  Rational first = 1;
  for (const Rational& t : *coefficients) first -= t;
  coefficients->insert(coefficients->begin(), first);
  return coefficients;
}

}  // namespace

std::optional<std::vector<Rational>> barycentric_coordinates(const PointSet& points,
                                                             const Simplex& simplex,
                                                             const Point& p) {
  auto coefficients = projection(points, simplex, p);
  if (coefficients && combination(points, simplex, *coefficients) != p) return std::nullopt;
  return coefficients;
}

std::vector<Rational> coordinates_of_projection(const PointSet& points, const Simplex& simplex,
                                                const Point& p) {
  auto coefficients = projection(points, simplex, p);
  assert(coefficients.has_value());
  return *coefficients;
}

Point combination(const PointSet& points, const Simplex& simplex,
                  const std::vector<Rational>& coefficients) {
  assert(simplex.size() == coefficients.size());
  Point sum(points.ambient_dimension(), Rational(0));
  for (std::size_t i = 0; i < simplex.size(); ++i) {
    sum = sum + coefficients[i] * points[simplex[i]];
  }
  return sum;
}

bool is_convex(const std::vector<Rational>& coefficients) {
  return std::all_of(coefficients.begin(), coefficients.end(),
                     [](const Rational& coefficient) { return sign(coefficient) >= 0; });
}

namespace {

Rational height(const PointSet& points, Vertex v) {
  return squared_length(points[v]) - points.weight(v);
}

// Σ λ_i h_i: the height of the lifted simplex over a point of it.
Rational combined_height(const PointSet& points, const Simplex& simplex,
                         const std::vector<Rational>& coefficients) {
  Rational sum = 0;
  for (std::size_t i = 0; i < simplex.size(); ++i) {
    sum += coefficients[i] * height(points, simplex[i]);
  }
  return sum;
}

// The barycentric coordinates of the point of aff σ where e is stationary: with p = v_0 + Σ t_i e_i
// and ∂e/∂t_i = h_i − h_0 − 2 e_i·p = 0 for each edge e_i = v_i − v_0.
std::vector<Rational> stationary_point(const PointSet& points, const Simplex& simplex) {
  const Vertex first = simplex.front();
  const std::size_t k = simplex.size() - 1;
  RationalMatrix matrix(k, std::vector<Rational>(k));
  std::vector<Rational> right(k);
  for (std::size_t i = 0; i < k; ++i) {
    const Point edge = points[simplex[i + 1]] - points[first];
    for (std::size_t j = 0; j < k; ++j) {
      matrix[i][j] = 2 * inner_product(edge, points[simplex[j + 1]] - points[first]);
    }
    right[i] = height(points, simplex[i + 1]) - height(points, first) -
               2 * inner_product(edge, points[first]);
  }
  const auto t = solve(matrix, right);
  assert(t.has_value());
  std::vector<Rational> coefficients{Rational(1)};
  for (const Rational& step : *t) {
    coefficients.front() -= step;
    coefficients.push_back(step);
  }
  return coefficients;
}

}  // namespace

std::optional<Rational> lifted_height(const PointSet& points, const Triangulation& triangulation,
                                      const Point& p) {
  for (const Simplex& simplex : triangulation.simplices()) {
    const auto coefficients = barycentric_coordinates(points, simplex, p);
    if (!coefficients || !is_convex(*coefficients)) continue;
    return combined_height(points, simplex, *coefficients);
  }
  return std::nullopt;
}

std::optional<Rational> interpolation_error(const PointSet& points,
                                            const Triangulation& triangulation, const Point& p) {
  const std::optional<Rational> interpolated = lifted_height(points, triangulation, p);
  if (!interpolated) return std::nullopt;
  return *interpolated - squared_length(p);
}

GreatestError greatest_interpolation_error(const PointSet& points, const Simplex& simplex) {
  std::optional<GreatestError> greatest;
  for (const Simplex& face : faces(simplex)) {
    const std::vector<Rational> coefficients = stationary_point(points, face);
    if (!is_convex(coefficients)) continue;
    const Point where = combination(points, face, coefficients);
    const Rational error = combined_height(points, face, coefficients) - squared_length(where);
    if (!greatest || error > greatest->error) greatest = GreatestError{where, error};
  }
  assert(greatest.has_value());  // a vertex is stationary on itself
  return *greatest;
}

GreatestError greatest_interpolation_error(const PointSet& points,
                                           const Triangulation& triangulation) {
  std::optional<GreatestError> greatest;
  for (const Simplex& simplex : triangulation.simplices()) {
    const GreatestError here = greatest_interpolation_error(points, simplex);
    if (!greatest || here.error > greatest->error) greatest = here;
  }
  assert(greatest.has_value());
  return *greatest;
}

// Over one simplex the integral of a linear function is the volume times the mean of its values at
// the k+1 vertices, and the determinant is k! times the volume.
Rational lifted_integral(const PointSet& points, const Triangulation& triangulation) {
  Rational sum = 0;
  for (const Simplex& simplex : triangulation.simplices()) {
    const Rational determinant =
        orientation_determinant(points.configuration(), points.configuration().axes(), simplex);
    const std::vector<Rational> ones(simplex.size(), Rational(1));
    sum += abs(determinant) * combined_height(points, simplex, ones);
  }
  return sum;
}

// The nearest point lies in the relative interior of some face, and there it is the nearest point
// of the face's whole affine hull.
Point nearest_point(const PointSet& points, const Simplex& simplex, const Point& p) {
  std::optional<Point> nearest;
  for (const Simplex& face : faces(simplex)) {
    const std::vector<Rational> coefficients = coordinates_of_projection(points, face, p);
    if (!is_convex(coefficients)) continue;
    const Point candidate = combination(points, face, coefficients);
    if (!nearest || squared_distance(candidate, p) < squared_distance(*nearest, p)) {
      nearest = candidate;
    }
  }
  assert(nearest.has_value());  // a vertex is its own affine hull
  return *nearest;
}

Ball min_containment_ball(const PointSet& points, const Simplex& simplex) {
  assert(!points.is_weighted());
  const Ball circumscribed = circumball(points, simplex);
  const Point& o = circumscribed.centre;
  const Point q = nearest_point(points, simplex, o);
  return {q, circumscribed.squared_radius - squared_distance(o, q)};
}

Ball largest_min_containment_ball(const PointSet& points, const Triangulation& triangulation) {
  std::optional<Ball> largest;
  for (const Simplex& simplex : triangulation.simplices()) {
    const Ball ball = min_containment_ball(points, simplex);
    if (!largest || ball.squared_radius > largest->squared_radius) largest = ball;
  }
  assert(largest.has_value());
  return *largest;
}

}  // namespace circumspect::optimality
