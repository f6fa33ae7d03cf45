#include "oracle/judge/within/distance.hpp"

#include <algorithm>
#include <optional>

namespace circumspect::check {
namespace {

Rational to_segment(const Point& a, const Point& b, const Point& point) {
  const Point along = b - a;
  const Rational at = inner_product(point - a, along) / squared_length(along);
  if (sign(at) <= 0) return squared_distance(a, point);
  if (at >= 1) return squared_distance(b, point);
  return squared_distance(a + at * along, point);
}

Rational to_triangle(const std::vector<Point>& corners, const Point& point) {
  const Point u = corners[1] - corners[0];
  const Point v = corners[2] - corners[0];
  const Point to = point - corners[0];
  const Rational uu = squared_length(u), vv = squared_length(v), uv = inner_product(u, v);
  const Rational tu = inner_product(to, u), tv = inner_product(to, v);
  const Rational gram = uu * vv - uv * uv;
  const Rational s = (vv * tu - uv * tv) / gram;
  const Rational t = (uu * tv - uv * tu) / gram;
  if (sign(s) >= 0 && sign(t) >= 0 && s + t <= 1) {
    return squared_distance(corners[0] + (s * u + t * v), point);
  }
  Rational least = to_segment(corners[0], corners[1], point);
  least = std::min(least, to_segment(corners[1], corners[2], point));
  return std::min(least, to_segment(corners[2], corners[0], point));
}

// Between the points of two lines that are nearest to each other, if both are in the segments; what
// lies at an end of one of them is found elsewhere.
std::optional<Rational> between_lines(const Point& a, const Point& b, const Point& c,
                                      const Point& d) {
  const Point u = b - a, v = d - c, w = c - a;
  const Rational uu = squared_length(u), vv = squared_length(v), uv = inner_product(u, v);
  const Rational gram = uu * vv - uv * uv;
  if (sign(gram) == 0) return std::nullopt;
  const Rational wu = inner_product(w, u), wv = inner_product(w, v);
  const Rational s = (vv * wu - uv * wv) / gram;
  const Rational t = (uv * wu - uu * wv) / gram;
  if (sign(s) < 0 || s > 1 || sign(t) < 0 || t > 1) return std::nullopt;
  return squared_distance(a + s * u, c + t * v);
}

}  // namespace

Rational squared_distance_to(const std::vector<Point>& simplex, const Point& point) {
  if (simplex.size() == 1) return squared_distance(simplex[0], point);
  if (simplex.size() == 2) return to_segment(simplex[0], simplex[1], point);
  return to_triangle(simplex, point);
}

// Two disjoint convex polytopes are nearest to each other at a vertex of one of them, or inside an
// edge of each.
Rational squared_distance_between(const std::vector<Point>& a, const std::vector<Point>& b) {
  Rational least = squared_distance_to(b, a[0]);
  for (const Point& corner : a) least = std::min(least, squared_distance_to(b, corner));
  for (const Point& corner : b) least = std::min(least, squared_distance_to(a, corner));
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = i + 1; j < a.size(); ++j) {
      for (std::size_t k = 0; k < b.size(); ++k) {
        for (std::size_t l = k + 1; l < b.size(); ++l) {
          if (const auto found = between_lines(a[i], a[j], b[k], b[l])) {
            least = std::min(least, *found);
          }
        }
      }
    }
  }
  return least;
}

}  // namespace circumspect::check
