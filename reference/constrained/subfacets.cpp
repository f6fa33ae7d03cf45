#include "reference/constrained/subfacets.hpp"

#include <algorithm>
#include <cassert>

#include "reference/delaunay/bowyer_watson.hpp"

namespace circumspect::constrained {
namespace {

Rational turn(const std::vector<std::size_t>& axes, const Point& a, const Point& b,
              const Point& c) {
  const std::size_t x = axes[0];
  const std::size_t y = axes[1];
  return (b[x] - a[x]) * (c[y] - a[y]) - (b[y] - a[y]) * (c[x] - a[x]);
}

bool is_in_triangle(const std::vector<std::size_t>& axes, const std::vector<Point>& corners,
                    const Point& point) {
  int least = 1;
  int greatest = -1;
  for (std::size_t i = 0; i < 3; ++i) {
    const int side = sign(turn(axes, corners[i], corners[(i + 1) % 3], point));
    least = std::min(least, side);
    greatest = std::max(greatest, side);
  }
  return least >= 0 || greatest <= 0;
}

// Multiples of the step are the numbers allowed; the nearest one.
Rational rounded(const Rational& value, const Rational& step) {
  const Rational half_up = value / step + Rational(1, 2);
  Integer floor;
  floor = half_up.get_num() / half_up.get_den();
  if (sign(half_up) < 0 && floor * half_up.get_den() != half_up.get_num()) floor -= 1;
  return floor * step;
}

// Vectors of the plane of three points with coordinates (1, 0) and (0, 1) on the axes.
std::vector<Point> unit_steps(const std::vector<std::size_t>& axes,
                              const std::vector<Point>& corners) {
  const Point u = corners[1] - corners[0];
  const Point v = corners[2] - corners[0];
  const std::size_t x = axes[0];
  const std::size_t y = axes[1];
  const Rational determinant = u[x] * v[y] - u[y] * v[x];
  assert(sign(determinant) != 0);
  return {(v[y] / determinant) * u - (u[y] / determinant) * v,
          (u[x] / determinant) * v - (v[x] / determinant) * u};
}

}  // namespace

std::vector<Simplex> subfacets(const PointSet& points, const Polygon& polygon,
                               const std::vector<Vertex>& vertices) {
  const PointSet own(coordinates(points, vertices));
  const delaunay::BowyerWatsonOptions options{delaunay::InsertionOrder::kBrioHilbert,
                                              delaunay::PointLocation::kWalking, 1};
  const Triangulation canonical = delaunay::bowyer_watson(own, options);
  std::vector<Simplex> inside;
  for (Simplex triangle : canonical.simplices()) {
    if (!is_in_polygon(points, polygon, barycentre(coordinates(own, triangle)))) continue;
    for (Vertex& v : triangle) v = vertices[static_cast<std::size_t>(v)];
    inside.push_back(sorted(triangle));
  }
  return inside;
}

bool is_in_polygon(const PointSet& points, const Polygon& polygon, const Point& point) {
  return std::any_of(polygon.triangles.begin(), polygon.triangles.end(),
                     [&](const Simplex& triangle) {
                       return is_in_triangle(polygon.axes, coordinates(points, triangle), point);
                     });
}

// With a step h on the axes the point moves by h/2 or less along each of the unit steps e and f. That
// is a quarter of the radius or less in all if h² · 2 (|e|² + |f|²) ≤ r²/4.
Point near_circumcentre(const PointSet& points, const Polygon& polygon, const Ball& circumball) {
  const std::vector<Point> units =
      unit_steps(polygon.axes, coordinates(points, polygon.triangles.front()));
  const Rational bound =
      circumball.squared_radius / (8 * (squared_length(units[0]) + squared_length(units[1])));
  Rational step = 1;
  while (step * step > bound) step /= 2;
  while (4 * step * step <= bound) step *= 2;
  Point near = circumball.centre;
  for (std::size_t i = 0; i < 2; ++i) {
    const Rational& here = circumball.centre[polygon.axes[i]];
    near = near + (rounded(here, step) - here) * units[i];
  }
  return near;
}

bool do_meet(const std::vector<std::size_t>& axes, const Point& a, const Point& b, const Point& c,
             const Point& d) {
  return sign(turn(axes, a, b, c)) * sign(turn(axes, a, b, d)) <= 0 &&
         sign(turn(axes, c, d, a)) * sign(turn(axes, c, d, b)) <= 0;
}

}  // namespace circumspect::constrained
