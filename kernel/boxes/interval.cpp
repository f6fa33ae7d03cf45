#include "kernel/boxes/interval.hpp"

namespace circumspect {

double lower_double(const Rational& value) {
  // GMP rounds towards zero, which may be to either side of the value.
  constexpr double kLargest = std::numeric_limits<double>::max();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double rounded = value.get_d();
  if (!std::isfinite(rounded)) return rounded > 0 ? kLargest : -kInfinity;
  while (exact_value(rounded) > value) {
    rounded = std::nextafter(rounded, -kInfinity);
    if (!std::isfinite(rounded)) break;
  }
  return rounded;
}

double upper_double(const Rational& value) { return -lower_double(-value); }

Interval enclosing(const Rational& value) {
  if (const auto same = as_double(value)) return exactly(*same);  // most values are
  return {lower_double(value), upper_double(value)};
}

}  // namespace circumspect
