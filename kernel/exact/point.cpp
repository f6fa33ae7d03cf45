#include "kernel/exact/point.hpp"

#include <algorithm>
#include <cassert>

#include "kernel/exact/interruption.hpp"

namespace circumspect {

Point operator+(const Point& a, const Point& b) {
  assert(a.size() == b.size());
  Point sum(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) sum[i] = a[i] + b[i];
  return sum;
}

Point operator-(const Point& a, const Point& b) {
  assert(a.size() == b.size());
  Point difference(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) difference[i] = a[i] - b[i];
  return difference;
}

Point operator*(const Rational& factor, const Point& a) {
  Point product(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) product[i] = factor * a[i];
  return product;
}

Rational inner_product(const Point& a, const Point& b) {
  assert(a.size() == b.size());
  Rational sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

Point cross_product(const Point& a, const Point& b) {
  assert(a.size() == 3 && b.size() == 3);
  return {cross_product(a, b, 1, 2), cross_product(a, b, 2, 0), cross_product(a, b, 0, 1)};
}

Rational cross_product(const Point& a, const Point& b, std::size_t x, std::size_t y) {
  return a[x] * b[y] - a[y] * b[x];
}

Rational squared_length(const Point& a) { return inner_product(a, a); }

Rational squared_distance(const Point& a, const Point& b) { return squared_length(a - b); }

Rational squared_distance_to_segment(const Point& p, const Point& a, const Point& b) {
  const Rational t = inner_product(p - a, b - a) / squared_distance(a, b);
  if (sign(t) <= 0) return squared_distance(p, a);
  if (t >= 1) return squared_distance(p, b);
  return squared_distance(p, a + t * (b - a));
}

std::size_t longest_axis(const Point& a) {
  const auto is_shorter = [](const Rational& x, const Rational& y) { return abs(x) < abs(y); };
  return static_cast<std::size_t>(std::max_element(a.begin(), a.end(), is_shorter) - a.begin());
}

Point barycentre(const std::vector<Point>& points) {
  assert(!points.empty());
  Point sum(points.front().size());
  Integer count = 0;
  for (const Point& point : points) {
    sum = sum + point;
    ++count;
  }
  return Rational(1, count) * sum;
}

namespace {

// A direction of the hull, scaled to 1 on its pivot axis.
struct Direction {
  std::size_t axis;
  Point vector;
};

// The rest of a vector after subtracting its part along the directions found so far. Each direction
// is zero on the pivot axes of the earlier ones.
Point reduce(Point vector, const std::vector<Direction>& directions) {
  for (const Direction& direction : directions) {
    const Rational factor = vector[direction.axis];
    if (sign(factor) == 0) continue;
    vector = vector - factor * direction.vector;
  }
  return vector;
}

}  // namespace

AffineHull affine_hull(const std::vector<Point>& points) {
  end_if_interrupted();
  AffineHull hull;
  if (points.empty()) return hull;
  hull.basis.push_back(0);
  const std::size_t ambient = points.front().size();
  std::vector<Direction> directions;
  for (std::size_t i = 1; i < points.size() && directions.size() < ambient; ++i) {
    const Point rest = reduce(points[i] - points[0], directions);
    const auto pivot =
        std::find_if(rest.begin(), rest.end(), [](const Rational& x) { return sign(x) != 0; });
    if (pivot == rest.end()) continue;
    const auto axis = static_cast<std::size_t>(pivot - rest.begin());
    directions.push_back({axis, (1 / *pivot) * rest});
    hull.basis.push_back(i);
    hull.axes.push_back(axis);
  }
  std::sort(hull.axes.begin(), hull.axes.end());
  hull.dimension = static_cast<int>(directions.size());
  return hull;
}

}  // namespace circumspect
