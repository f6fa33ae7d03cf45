#include "inputs/modifiers.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include "inputs/in_doubles.hpp"
#include "inputs/scalars.hpp"

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

Rational power_of_two(int exponent) {
  const Integer power = Integer(1) << static_cast<unsigned long>(std::abs(exponent));
  return exponent >= 0 ? Rational(power) : Rational(1) / power;
}

// One ulp up (steps 1) or down (steps −1).
double neighbour(double x, long step, double ulp_of_largest) {
  if (x == 0) return static_cast<double>(step) * ulp_of_largest;
  return std::nextafter(x, step > 0 ? HUGE_VAL : -HUGE_VAL);
}

PointsCase with_steps(PointsCase set, const std::vector<long>& steps) {
  const double ulp = std::ldexp(1.0, exponents(set).largest - 53);
  std::size_t i = 0;
  for (Point& point : set.points) {
    for (Rational& x : point) {
      const long step = i < steps.size() ? steps[i] : 0;
      ++i;
      if (step != 0) x = exact_value(neighbour(x.get_d(), step, ulp));
    }
  }
  return set;
}

}  // namespace

rc::Gen<PointsCase> one_ulp_away(const rc::Gen<PointsCase>& cases, const ModifierScope& scope) {
  const auto step = rc::gen::map(below(4), [](long code) {
    // 0 twice, so that half of the coordinates stay; RapidCheck shrinks towards the first.
    return code < 2 ? 0L : code == 2 ? 1L : -1L;
  });
  const auto steps =
      rc::gen::container<std::vector<long>>(scope.max_points * scope.dimension, step);
  return rc::gen::map(
      rc::gen::pair(cases, steps),
      [repeats = scope.may_repeat_points](const std::pair<PointsCase, std::vector<long>>& parts) {
        const PointsCase rounded = in_doubles(parts.first, repeats);
        const PointsCase moved = with_steps(rounded, parts.second);
        return repeats ? moved : without_repeated_points(moved);
      });
}

rc::Gen<PointsCase> scaled_by_power_of_two(const rc::Gen<PointsCase>& cases,
                                           const ModifierScope& /*scope*/) {
  return rc::gen::map(
      rc::gen::pair(cases, integer_within(300)), [](const std::pair<PointsCase, long>& parts) {
        const auto& [set, wanted] = parts;
        // Neither beyond 2^±kLargestExponent nor towards it if already beyond.
        const auto [least, largest] = exponents(set);
        const int shift =
            std::clamp(static_cast<int>(wanted), std::min(0, -kLargestExponent - least + 53),
                       std::max(0, kLargestExponent - largest));
        PointsCase scaled = set;
        for (Point& x : scaled.points) x = power_of_two(shift) * x;
        for (Rational& w : scaled.weights) w *= power_of_two(2 * shift);
        return scaled;
      });
}

rc::Gen<PointsCase> far_from_origin(const rc::Gen<PointsCase>& cases, const ModifierScope& scope) {
  const auto direction = rc::gen::container<std::vector<long>>(scope.dimension, integer_within(2));
  return rc::gen::map(
      rc::gen::tuple(cases, direction, below(31)),
      [repeats =
           scope.may_repeat_points](const std::tuple<PointsCase, std::vector<long>, long>& parts) {
        const auto& [set, along, distance] = parts;
        const int exponent =
            std::min(exponents(set).largest + 20 + static_cast<int>(distance), kLargestExponent);
        PointsCase moved = set;
        for (Point& x : moved.points) {
          for (std::size_t i = 0; i < x.size(); ++i) x[i] += along[i] * power_of_two(exponent);
        }
        return in_doubles(moved, repeats);
      });
}

}  // namespace circumspect::generators
