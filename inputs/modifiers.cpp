#include "inputs/modifiers.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "inputs/in_doubles.hpp"
#include "inputs/set_parts.hpp"

namespace circumspect::generators {
namespace {

constexpr int kLargestExponent = 1000;

// All coordinates that are not 0 have 2^(least−1) ≤ |x| < 2^largest, as doubles.
struct Exponents {
  int least = 0;
  int largest = 0;
};
Exponents exponents(const PointsCase& set) {
  Exponents result;
  bool first = true;
  for (const Point& point : set.points) {
    for (const Rational& x : point) {
      if (sign(x) == 0) continue;
      int exponent = 0;
      std::frexp(nearest_double(x), &exponent);
      result.least = first ? exponent : std::min(result.least, exponent);
      result.largest = first ? exponent : std::max(result.largest, exponent);
      first = false;
    }
  }
  return result;
}

// One ulp up (steps 1) or down (steps −1).
double neighbour(double x, int step, double ulp_of_largest) {
  if (x == 0) return step * ulp_of_largest;
  return std::nextafter(x, step > 0 ? HUGE_VAL : -HUGE_VAL);
}

}  // namespace

PointsCase one_ulp_away(Dice& dice, const PointsCase& set, bool may_repeat_points) {
  PointsCase moved = in_doubles(set, may_repeat_points);
  const double ulp = std::ldexp(1.0, exponents(moved).largest - 53);
  for (Point& point : moved.points) {
    for (Rational& x : point) {
      if (dice.below(2) == 0) continue;
      x = exact_value(neighbour(x.get_d(), dice.below(2) == 0 ? 1 : -1, ulp));
    }
  }
  return may_repeat_points ? moved : without_repeated_points(moved);
}

PointsCase scaled_by_power_of_two(Dice& dice, const PointsCase& set, bool /*may_repeat_points*/) {
  const int wanted = dice.within(-300, 300);
  // Neither beyond 2^±kLargestExponent nor towards it if already beyond.
  const auto [least, largest] = exponents(set);
  const int shift = std::clamp(wanted, std::min(0, -kLargestExponent - least + 53),
                               std::max(0, kLargestExponent - largest));
  PointsCase scaled = set;
  for (Point& x : scaled.points) x = power_of_two(shift) * x;
  for (Rational& w : scaled.weights) w *= power_of_two(2 * shift);
  return scaled;
}

PointsCase far_from_origin(Dice& dice, const PointsCase& set, bool may_repeat_points) {
  const int distance = dice.within(20, 50);
  const Rational far = power_of_two(std::min(exponents(set).largest + distance, kLargestExponent));
  const std::size_t dimension = set.points.empty() ? 0 : set.points.front().size();
  const Point translation = far * integer_point(dice, dimension, 2);
  PointsCase moved = set;
  for (Point& x : moved.points) x = x + translation;
  return in_doubles(moved, may_repeat_points);
}

}  // namespace circumspect::generators
