#include "inputs/modifiers.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "inputs/in_doubles.hpp"
#include "inputs/set_parts.hpp"
#include "kernel/piecewise_linear/validity.hpp"

namespace circumspect::generators {
namespace {

constexpr int kLargestExponent = 1000;

// All coordinates that are not 0 have 2^(least−1) ≤ |x| < 2^largest, as doubles.
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
  // Not beyond 2^±kLargestExponent, and no farther if already beyond.
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

namespace {

// The number with another exponent: its own exponent under `moved`.
template <class Moved>
Rational with_exponent(const Rational& value, const Moved& moved) {
  if (sign(value) == 0) return value;
  int exponent = 0;
  const double mantissa = std::frexp(value.get_d(), &exponent);
  return exact_value(std::ldexp(mantissa, moved(exponent)));
}

PointsCase times_power_of_two(PointsCase set, int shift) {
  for (Point& x : set.points) x = power_of_two(shift) * x;
  for (Rational& w : set.weights) w *= power_of_two(2 * shift);
  return set;
}

PointsCase with_distinct_points(PointsCase set, bool may_repeat_points) {
  return may_repeat_points ? set : without_repeated_points(set);
}

}  // namespace

namespace {

bool is_valid_in_doubles(const ComplexCase& whole) {
  const auto are_doubles = [](const std::vector<Point>& points) {
    return std::all_of(points.begin(), points.end(), [](const Point& point) {
      return std::all_of(point.begin(), point.end(),
                         [](const Rational& x) { return exact_value(nearest_double(x)) == x; });
    });
  };
  return are_doubles(whole.input.points) && validated(whole.input, 1).has_value();
}

// Every vertex and seed moved by `image`, rounded to doubles.
template <class Image>
ComplexCase mapped(ComplexCase whole, const Image& image) {
  const auto map = [&image](std::vector<Point>& points) {
    for (Point& point : points) point = image(point);
  };
  map(whole.input.points);
  map(whole.input.hole_seeds);
  for (PolygonLines& polygon : whole.input.polygons) map(polygon.hole_seeds);
  return in_doubles(std::move(whole));
}

// Rows of integers whose product with their transpose is `square` times the identity, and not a
// permutation. In space they are those of a quaternion of integers.
struct Turn {
  std::vector<std::vector<long>> rows;
  long stretch = 1;  // the factor of lengths
};

Turn drawn_turn(Dice& dice, std::size_t dimension) {
  const long a = dice.within(1, 4), b = dice.within(1, 4);
  if (dimension == 2)
    return {{{a * a - b * b, -2 * a * b}, {2 * a * b, a * a - b * b}}, a * a + b * b};
  const long c = dice.within(-3, 3), d = dice.within(-3, 3);
  return {{{a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)},
           {2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)},
           {2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d}},
          a * a + b * b + c * c + d * d};
}

}  // namespace

ComplexCase complex_one_ulp_away(Dice& dice, ComplexCase whole) {
  const double ulp = std::ldexp(1.0, exponents({whole.input.points}).largest - 53);
  for (std::size_t v = 0; v < whole.input.points.size(); ++v) {
    if (dice.below(2) == 0) continue;
    const Point before = whole.input.points[v];
    for (Rational& x : whole.input.points[v]) {
      const int step = dice.within(-1, 1);
      if (step != 0) x = exact_value(neighbour(nearest_double(x), step, ulp));
    }
    if (!is_valid_in_doubles(whole)) whole.input.points[v] = before;
  }
  return whole;
}

ComplexCase complex_far_from_origin(Dice& dice, ComplexCase whole) {
  const int largest = exponents({whole.input.points}).largest;
  const std::size_t dimension = whole.input.points.empty() ? 0 : whole.input.points.front().size();
  const Point direction = integer_point(dice, dimension, 2);
  for (int distance = dice.within(20, 50); distance > 0; distance -= 5) {
    const Point way = power_of_two(largest + distance) * direction;
    ComplexCase moved = mapped(whole, [&way](const Point& x) { return x + way; });
    if (is_valid_in_doubles(moved)) return moved;
  }
  return whole;
}

ComplexCase complex_rotated(Dice& dice, ComplexCase whole) {
  if (whole.input.points.empty()) return whole;
  const Turn turn = drawn_turn(dice, whole.input.points.front().size());
  const auto turned = [&turn, &whole](const Rational& scale) {
    return mapped(whole, [&](const Point& x) {
      Point image;
      for (const std::vector<long>& row : turn.rows) {
        Rational sum = 0;
        for (std::size_t axis = 0; axis < row.size(); ++axis) sum += row[axis] * x[axis];
        image.push_back(sum * scale);
      }
      return image;
    });
  };
  ComplexCase rounded = turned(Rational(1, turn.stretch));
  if (dice.below(4) != 0 && is_valid_in_doubles(rounded)) return rounded;
  ComplexCase larger = turned(1);
  return is_valid_in_doubles(larger) ? larger : whole;
}

bool lie_within(const PointsCase& set, Exponents wanted) {
  const auto [least, largest] = exponents(set);
  return least > wanted.least && largest <= wanted.largest;
}

PointsCase brought_within(const PointsCase& set, Exponents wanted, bool may_repeat_points) {
  const auto [least, largest] = exponents(set);
  if (lie_within(set, wanted)) return set;
  if (largest - least < wanted.largest - wanted.least) {
    return times_power_of_two(
        set, largest > wanted.largest ? wanted.largest - largest : wanted.least + 1 - least);
  }
  const int room = wanted.largest - wanted.least - 1;
  const auto moved = [&, from = least, width = largest - least](int exponent) {
    return wanted.least + 1 + (exponent - from) * room / width;
  };
  PointsCase brought = set;
  for (Point& point : brought.points) {
    for (Rational& x : point) x = with_exponent(x, moved);
  }
  for (Rational& w : brought.weights) {
    w = with_exponent(w, [&](int exponent) {
      return std::clamp(exponent, 2 * wanted.least, 2 * wanted.largest);
    });
  }
  return with_distinct_points(in_doubles(brought, true), may_repeat_points);
}

PointsCase in_integers(const PointsCase& set, int bits, bool may_repeat_points) {
  const int largest = exponents(set).largest;
  const auto is_integer = [](const Rational& x) { return x.get_den() == 1; };
  const bool are_integers = std::all_of(
      set.points.begin(), set.points.end(),
      [&](const Point& point) { return std::all_of(point.begin(), point.end(), is_integer); });
  PointsCase whole = set;
  if (!are_integers || largest > bits) whole = times_power_of_two(set, bits - largest);
  const auto round = [](Rational& x) { x = exact_value(std::nearbyint(nearest_double(x))); };
  for (Point& point : whole.points) std::for_each(point.begin(), point.end(), round);
  std::for_each(whole.weights.begin(), whole.weights.end(), round);
  return with_distinct_points(std::move(whole), may_repeat_points);
}

}  // namespace circumspect::generators
