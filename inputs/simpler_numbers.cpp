#include <algorithm>
#include <optional>

#include "inputs/minimise.hpp"
#include "inputs/set_parts.hpp"
#include "kernel/exact/each_once.hpp"

namespace circumspect::generators {
namespace {

// The nearest integer, halves away from zero.
Rational rounded(const Rational& value) {
  const Rational doubled = abs(value) * 2 + 1;
  const Integer denominator = doubled.get_den() * 2;
  const Integer quotient = doubled.get_num() / denominator;
  return sign(value) < 0 ? Rational(-quotient) : Rational(quotient);
}

// The exponent e with 2^(e−1) ≤ |value| < 2^(e+1), about.
long exponent(const Rational& value) {
  return static_cast<long>(bit_length(value.get_num())) -
         static_cast<long>(bit_length(value.get_den()));
}

// Every number of a set: coordinates, then weights.
std::vector<Rational*> numbers(PointsCase& set) {
  std::vector<Rational*> all;
  for (Point& point : set.points) {
    for (Rational& x : point) all.push_back(&x);
  }
  for (Rational& weight : set.weights) all.push_back(&weight);
  return all;
}

// The coordinates of each axis replaced by their ranks.
PointsCase ranked(PointsCase set, std::size_t axis) {
  std::vector<Rational> values;
  for (const Point& point : set.points) values.push_back(point[axis]);
  keep_each_once(values);
  for (Point& point : set.points) {
    const auto place = std::lower_bound(values.begin(), values.end(), point[axis]);
    point[axis] = Rational(static_cast<long>(place - values.begin()));
  }
  return set;
}

// Moved along an axis so that the smallest coordinate is 0.
PointsCase from_zero(PointsCase set, std::size_t axis) {
  Rational least = set.points.front()[axis];
  for (const Point& point : set.points) least = std::min(least, point[axis]);
  for (Point& point : set.points) point[axis] -= least;
  return set;
}

// Scaled by 2^-k; weights, which are squared lengths, by the square of that; and rounded to the
// integer grid if asked for.
PointsCase scaled(PointsCase set, long k, bool on_grid) {
  const Rational factor = power_of_two(-k);
  for (Point& point : set.points) {
    for (Rational& x : point) x = on_grid ? rounded(factor * x) : Rational(factor * x);
  }
  for (Rational& weight : set.weights) weight *= factor * factor;
  return set;
}

// Divided by the common divisor of all coordinates.
PointsCase divided(PointsCase set) {
  Integer divisor = 0;
  Integer multiple = 1;
  for (const Point& point : set.points) multiple = common_denominator(point, multiple);
  for (const Point& point : set.points) {
    for (const Rational& x : point) divisor = gcd(divisor, numerator_over(multiple, x));
  }
  if (divisor == 0) return set;
  const Rational factor = Rational(multiple) / divisor;
  for (Point& point : set.points) {
    for (Rational& x : point) x *= factor;
  }
  for (Rational& weight : set.weights) weight *= factor * factor;
  return set;
}

// Sets in which all points are changed at once.
std::vector<PointsCase> simpler_wholes(const PointsCase& set) {
  std::vector<PointsCase> found;
  if (set.points.empty()) return found;
  const std::size_t dimension = set.points.front().size();
  PointsCase all_ranked = set;
  for (std::size_t axis = 0; axis < dimension; ++axis) all_ranked = ranked(all_ranked, axis);
  found.push_back(std::move(all_ranked));
  for (std::size_t axis = 0; axis < dimension; ++axis) found.push_back(ranked(set, axis));
  found.push_back(divided(set));
  for (std::size_t axis = 0; axis < dimension; ++axis) found.push_back(from_zero(set, axis));
  // Coarse grids before fine ones: the largest coordinate keeps 1, 2, 3, 4, 6, 8, 12, 16 … bits.
  std::optional<long> largest;
  for (const Point& point : set.points) {
    for (const Rational& x : point) {
      if (sign(x) != 0) largest = std::max(largest.value_or(exponent(x)), exponent(x));
    }
  }
  if (!largest) return found;
  for (const long bits : {1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48}) {
    found.push_back(scaled(set, *largest - bits, true));
  }
  found.push_back(scaled(set, *largest, false));
  return found;
}

// Shorter numbers that may replace one, the shortest first.
std::vector<Rational> simpler_numbers(const Rational& value) {
  std::vector<Rational> found = {0, 1, -1, 2};
  const long top = exponent(value);
  if (top > -60 && top < 60) {
    const Rational whole = rounded(value);
    found.push_back(whole);
    found.push_back(rounded(value / 2));
    found.push_back(sign(whole) > 0 ? Rational(whole - 1) : Rational(whole + 1));
  }
  for (const long bits : {1, 2, 3, 4, 5, 6, 8, 12, 16, 24, 32, 48}) {
    const Rational unit = power_of_two(top - bits + 1);
    const Rational nearest = rounded(value / unit);
    found.push_back(unit * nearest);
    found.push_back(unit * (nearest + (unit * nearest < value ? 1 : -1)));
  }
  found.push_back(-value);
  const std::size_t now = length(value);
  std::erase_if(found, [now](const Rational& number) { return length(number) >= now; });
  std::stable_sort(found.begin(), found.end(), [](const Rational& a, const Rational& b) {
    return length(a) != length(b) ? length(a) < length(b) : a < b;
  });
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

bool simplify_wholes(PointsCase& set, const std::function<bool(const PointsCase&)>& accepts,
                     const std::function<bool()>& is_over) {
  bool simpler = false;
  for (bool again = true; again && !is_over();) {
    again = false;
    const std::size_t now = length(set);
    for (PointsCase& candidate : simpler_wholes(set)) {
      if (is_over()) break;
      if (length(candidate) >= now || !accepts(candidate)) continue;
      set = std::move(candidate);
      simpler = again = true;
      break;
    }
  }
  return simpler;
}

bool simplify_one(PointsCase& set, std::size_t which,
                  const std::function<bool(const PointsCase&)>& accepts,
                  const std::function<bool()>& is_over) {
  const Rational value = *numbers(set)[which];
  for (const Rational& candidate : simpler_numbers(value)) {
    if (is_over()) return false;
    PointsCase changed = set;
    *numbers(changed)[which] = candidate;
    if (!accepts(changed)) continue;
    set = std::move(changed);
    return true;
  }
  return false;
}

}  // namespace

std::size_t length(const Rational& value) {
  const std::size_t denominator = bit_length(value.get_den()) - 1;
  return 2 * (bit_length(value.get_num()) + denominator) + (sign(value) < 0 ? 1 : 0);
}

std::size_t length(const PointsCase& set) {
  std::size_t total = 0;
  for (const Point& point : set.points) {
    for (const Rational& x : point) total += length(x);
  }
  for (const Rational& weight : set.weights) total += length(weight);
  return total;
}

bool simplify_numbers(PointsCase& set, const std::function<bool(const PointsCase&)>& accepts,
                      const std::function<bool()>& is_over) {
  bool simpler = simplify_wholes(set, accepts, is_over);
  for (bool again = true; again && !is_over();) {
    again = false;
    const std::size_t count = numbers(set).size();
    for (std::size_t i = 0; i < count && !is_over(); ++i) {
      again = simplify_one(set, i, accepts, is_over) || again;
    }
    simpler = simpler || again;
  }
  return simpler;
}

}  // namespace circumspect::generators
