#include "reference/exact/enclosing_box.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace circumspect {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLargest = std::numeric_limits<double>::max();

// lower_double and upper_double at once: most values are doubles.
void enclose(const Rational& value, double& low, double& high) {
  low = high = value.get_d();
  const int side = std::isfinite(low) ? cmp(exact_value(low), value) : 1;
  if (side != 0) {
    if (side > 0) low = lower_double(value);
    if (side < 0 || !std::isfinite(high)) high = upper_double(value);
  }
}

}  // namespace

double lower_double(const Rational& value) {
  // GMP rounds towards zero, which may be to either side of the value.
  double rounded = value.get_d();
  if (!std::isfinite(rounded)) return rounded > 0 ? kLargest : -kInfinity;
  while (exact_value(rounded) > value) {
    rounded = std::nextafter(rounded, -kInfinity);
    if (!std::isfinite(rounded)) break;
  }
  return rounded;
}

double upper_double(const Rational& value) { return -lower_double(-value); }

Box box_around(const Point& point) {
  assert(point.size() == 2 || point.size() == 3);
  const Rational& x = point[0];
  const Rational& y = point[1];
  const Rational z = point.size() == 3 ? point[2] : Rational(0);
  const std::array<Rational, 9> values = {x, y, z, x + y, x - y, x + z, x - z, y + z, y - z};
  Box box;
  for (std::size_t i = 0; i < values.size(); ++i) {
    enclose(values[i], box.low[i], box.high[i]);
  }
  return box;
}

Box box_around(const Box& a, const Box& b) {
  Box box = a;
  for (std::size_t i = 0; i < box.low.size(); ++i) {
    box.low[i] = std::min(a.low[i], b.low[i]);
    box.high[i] = std::max(a.high[i], b.high[i]);
  }
  return box;
}

bool may_meet(const Box& a, const Box& b) {
  for (std::size_t i = 0; i < a.low.size(); ++i) {
    if (a.high[i] < b.low[i] || b.high[i] < a.low[i]) return false;
  }
  return true;
}

}  // namespace circumspect
