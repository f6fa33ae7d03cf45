#include "inputs/in_doubles.hpp"

#include <cassert>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <set>

namespace circumspect::generators {
namespace {

bool is_even(double value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits % 2 == 0;
}

void round(Rational& value) { value = exact_value(nearest_double(value)); }

void round(std::vector<Point>& points) {
  for (Point& point : points) {
    for (Rational& x : point) round(x);
  }
}

}  // namespace

double nearest_double(const Rational& value) {
  const double toward_zero = value.get_d();
  assert(std::isfinite(toward_zero));
  const Rational below = exact_value(toward_zero);
  if (below == value) return toward_zero;
  const double next = std::nextafter(toward_zero, sign(value) > 0 ? HUGE_VAL : -HUGE_VAL);
  if (!std::isfinite(next)) return toward_zero;
  const int closer = cmp(abs(Rational(value - below)), abs(Rational(exact_value(next) - value)));
  if (closer != 0) return closer < 0 ? toward_zero : next;
  return is_even(toward_zero) ? toward_zero : next;
}

bool is_double(const Rational& value) {
  const double toward_zero = value.get_d();
  return std::isfinite(toward_zero) && exact_value(toward_zero) == value;
}

PointsCase without_repeated_points(const PointsCase& set) {
  std::set<Point> seen;
  PointsCase once;
  for (std::size_t v = 0; v < set.points.size(); ++v) {
    if (!seen.insert(set.points[v]).second) continue;
    once.points.push_back(set.points[v]);
    if (!set.weights.empty()) once.weights.push_back(set.weights[v]);
  }
  return once;
}

PointsCase in_doubles(const PointsCase& set, bool keep_repeated_points) {
  PointsCase rounded = set;
  round(rounded.points);
  for (Rational& weight : rounded.weights) round(weight);
  return keep_repeated_points ? rounded : without_repeated_points(rounded);
}

ComplexCase in_doubles(ComplexCase whole) {
  round(whole.input.points);
  round(whole.input.hole_seeds);
  for (PolygonLines& polygon : whole.input.polygons) round(polygon.hole_seeds);
  return whole;
}

}  // namespace circumspect::generators
