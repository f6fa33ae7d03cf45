#include "reference/optimality/min_containment_ball.hpp"

#include <cassert>
#include <optional>

#include "reference/optimality/barycentric.hpp"
#include "reference/optimality/faces.hpp"

namespace circumspect::optimality {

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
