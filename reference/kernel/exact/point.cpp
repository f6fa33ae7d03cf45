#include "reference/kernel/exact/point.hpp"

#include <cassert>

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

Rational squared_length(const Point& a) { return inner_product(a, a); }

Rational squared_distance(const Point& a, const Point& b) { return squared_length(a - b); }

Point barycentre(const std::vector<Point>& points) {
  assert(!points.empty());
  Point sum = points.front();
  for (std::size_t i = 1; i < points.size(); ++i) sum = sum + points[i];
  return Rational(1, static_cast<unsigned long>(points.size())) * sum;
}

}  // namespace circumspect
