#include "fuzz/harness/predicate_arguments.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "kernel/exact/linear_algebra.hpp"

namespace circumspect::harness {

namespace {

// The exponent of a unit in which the double is an integer.
int unit_exponent(double x) { return std::max(std::ilogb(x) - 52, -1074); }

// All coordinates times one power of two that makes them integers, which changes no sign.
std::vector<Integer> integers(const std::vector<double>& coordinates) {
  int least = std::numeric_limits<int>::max();
  for (const double x : coordinates) {
    if (x != 0) least = std::min(least, unit_exponent(x));
  }
  std::vector<Integer> values;
  values.reserve(coordinates.size());
  for (const double x : coordinates) {
    if (x == 0) {
      values.emplace_back(0);
      continue;
    }
    const int unit = unit_exponent(x);
    values.emplace_back(std::ldexp(x, -unit));
    values.back() <<= static_cast<unsigned long>(unit - least);
  }
  return values;
}

}  // namespace

std::size_t argument_count(PredicateKind kind, std::size_t dimension) {
  return dimension + (kind == PredicateKind::kInSphere ? 2 : 1);
}

int exact_sign(PredicateKind kind, std::size_t dimension, const std::vector<double>& coordinates) {
  const std::vector<Integer> values = integers(coordinates);
  const std::size_t order = argument_count(kind, dimension) - 1;
  SquareMatrix matrix(order);
  for (std::size_t row = 0; row < order; ++row) {
    // |p|² − |q|² = |p − q|² + 2 ⟨p − q, q⟩: the second term is a combination of the other columns.
    Integer squared_distance = 0;
    for (std::size_t axis = 0; axis < dimension; ++axis) {
      matrix(row, axis) = values[row * dimension + axis] - values[order * dimension + axis];
      add_product(squared_distance, matrix(row, axis), matrix(row, axis));
    }
    if (kind == PredicateKind::kInSphere) matrix(row, dimension) = squared_distance;
  }
  return sign(determinant(std::move(matrix)));
}

namespace {

using Coordinates = std::vector<double>;

std::size_t points_of(const PredicateOptions& options) {
  return argument_count(options.kind, options.dimension);
}

// A number of at most `bits` bits, at most 53.
double integer(int bits, Dice& dice) {
  const std::uint64_t magnitude = dice.bits() >> (64 - bits);
  return dice.below(2) == 0 ? static_cast<double>(magnitude) : -static_cast<double>(magnitude);
}

// Multiplies all by one power of two that brings them within the limits, anywhere there is room.
Coordinates scaled(const PredicateOptions& options, Coordinates coordinates, Dice& dice) {
  int least = 0, largest = 0;
  bool first = true;
  for (const double x : coordinates) {
    if (x == 0) continue;
    const int exponent = std::ilogb(x);
    least = first ? exponent : std::min(least, exponent);
    largest = first ? exponent : std::max(largest, exponent);
    first = false;
  }
  const int lowest = options.min_exponent - least;
  const int highest = options.max_exponent - largest;
  // Every other time as close to 1 as possible.
  int shift = std::clamp(0, std::min(lowest, highest), highest);
  if (lowest < highest && dice.below(2) == 0) shift = dice.within(lowest, highest);
  for (double& x : coordinates) {
    x = std::ldexp(x, shift);
    if (x != 0 && std::ilogb(x) < options.min_exponent) x = 0;
  }
  return coordinates;
}

Coordinates plain_integers(const PredicateOptions& options, Dice& dice) {
  const int bits = dice.within(1, 53);
  Coordinates coordinates(points_of(options) * options.dimension);
  for (double& x : coordinates) x = integer(bits, dice);
  return coordinates;
}

// The last point an integer combination of the others, of coefficients with sum 1.
Coordinates on_a_plane(const PredicateOptions& options, Dice& dice) {
  const std::size_t d = options.dimension;
  Coordinates coordinates = plain_integers(options, dice);
  const int bits = dice.within(1, 48);
  for (double& x : coordinates) x = integer(bits, dice);
  // The others are p_0 to p_{d−1}: in-sphere has one more point, which is kept.
  double* const last = coordinates.data() + (points_of(options) - 1) * d;
  std::vector<double> coefficients(d, 0);
  for (double& c : coefficients) c = dice.within(-3, 3);
  coefficients[0] += 1 - std::accumulate(coefficients.begin(), coefficients.end(), 0.0);
  for (std::size_t axis = 0; axis < d; ++axis) {
    last[axis] = 0;
    for (std::size_t i = 0; i < d; ++i) last[axis] += coefficients[i] * coordinates[i * d + axis];
  }
  return coordinates;
}

// The images of one point under changes of sign and order of its coordinates.
Coordinates images_of_one_point(const PredicateOptions& options, Dice& dice) {
  const int bits = dice.within(1, 53);
  std::array<double, 3> one{};
  for (double& x : one) x = integer(bits, dice);
  Coordinates coordinates;
  for (std::size_t i = 0; i < points_of(options); ++i) {
    std::array<double, 3> image = one;
    for (std::size_t axis = 1; axis < options.dimension; ++axis) {
      std::swap(image[axis], image[dice.below(axis + 1)]);
    }
    for (std::size_t axis = 0; axis < options.dimension; ++axis) {
      coordinates.push_back(dice.below(2) == 0 ? image[axis] : -image[axis]);
    }
  }
  return coordinates;
}

// A vector of integer length: (m + ni + pj + qk) i (m − ni − pj − qk), or (m + ni)² in the plane.
struct RoundVector {
  std::array<double, 3> vector;
  double length;
};
RoundVector round_vector(std::size_t dimension, Dice& dice) {
  while (true) {
    const double m = dice.within(-4, 4), n = dice.within(-4, 4);
    const double p = dimension == 2 ? 0 : dice.within(-4, 4);
    const double q = dimension == 2 ? 0 : dice.within(-4, 4);
    const double length = m * m + n * n + p * p + q * q;
    if (length == 0) continue;
    if (dimension == 2) return {{m * m - n * n, 2 * m * n, 0}, length};
    return {{m * m + n * n - p * p - q * q, 2 * (n * p + m * q), 2 * (n * q - m * p)}, length};
  }
}

// Different integer points at one distance from an integer centre.
Coordinates on_a_sphere(const PredicateOptions& options, Dice& dice) {
  std::vector<RoundVector> vectors;
  std::uint64_t radius = 1;
  for (std::size_t i = 0; i < points_of(options); ++i) {
    vectors.push_back(round_vector(options.dimension, dice));
    const auto next = std::lcm(radius, static_cast<std::uint64_t>(vectors.back().length));
    // Numbers of 40 bits leave room for the centre.
    if (next >> 40 == 0) {
      radius = next;
    } else {
      vectors.back() = vectors.front();
    }
  }
  const int bits = dice.within(1, 50);
  std::array<double, 3> centre{};
  for (double& x : centre) x = integer(bits, dice);
  Coordinates coordinates;
  for (const RoundVector& v : vectors) {
    for (std::size_t axis = 0; axis < options.dimension; ++axis) {
      coordinates.push_back(centre[axis] + v.vector[axis] * static_cast<double>(radius) / v.length);
    }
  }
  return coordinates;
}

Coordinates with_a_copy(const PredicateOptions& options, Dice& dice) {
  const auto d = static_cast<std::ptrdiff_t>(options.dimension);
  Coordinates coordinates = plain_integers(options, dice);
  const auto from = static_cast<std::ptrdiff_t>(dice.below(points_of(options)));
  const auto to = static_cast<std::ptrdiff_t>(dice.below(points_of(options)));
  if (from != to) std::copy_n(coordinates.begin() + from * d, d, coordinates.begin() + to * d);
  return coordinates;
}

Coordinates any_degenerate(const PredicateOptions& options, Dice& dice) {
  if (dice.below(8) == 0) return with_a_copy(options, dice);
  if (options.kind == PredicateKind::kOrientation) return on_a_plane(options, dice);
  switch (dice.below(5)) {
    case 0:
      return on_a_plane(options, dice);
    case 1:
    case 2:
      return images_of_one_point(options, dice);
    default:
      return on_a_sphere(options, dice);
  }
}

Coordinates one_ulp_away(Coordinates coordinates, Dice& dice) {
  double largest = 0;
  for (const double x : coordinates) largest = std::max(largest, std::fabs(x));
  if (largest == 0) return coordinates;
  for (std::size_t moves = 1 + dice.below(3); moves > 0; --moves) {
    double& x = coordinates[dice.below(coordinates.size())];
    const bool up = dice.below(2) == 0;
    const double ulp = std::ldexp(1.0, std::ilogb(largest) - 52);
    x = x == 0 ? (up ? ulp : -ulp) : std::nextafter(x, up ? HUGE_VAL : -HUGE_VAL);
  }
  return coordinates;
}

Coordinates generic(const PredicateOptions& options, Dice& dice) {
  return scaled(options, plain_integers(options, dice), dice);
}

Coordinates degenerate(const PredicateOptions& options, Dice& dice) {
  return scaled(options, any_degenerate(options, dice), dice);
}

Coordinates neighbours(const PredicateOptions& options, Dice& dice) {
  return scaled(options, one_ulp_away(any_degenerate(options, dice), dice), dice);
}

// Points around a point that is many times farther from the origin than they are from each other.
Coordinates far_cluster(const PredicateOptions& options, Dice& dice) {
  Coordinates coordinates = any_degenerate(options, dice);
  double largest = 1;
  for (const double x : coordinates) largest = std::max(largest, std::fabs(x));
  std::array<double, 3> centre{};
  for (double& x : centre) {
    x = std::ldexp(integer(10, dice), std::ilogb(largest) + dice.within(0, 50) - 10);
  }
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    coordinates[i] += centre[i % options.dimension];
  }
  return scaled(options, coordinates, dice);
}

// Each coordinate of an exponent of its own: from the whole range, or from a narrower one.
Coordinates mixed_exponents(const PredicateOptions& options, Dice& dice) {
  const int width = dice.within(1, options.max_exponent - options.min_exponent);
  const int least = dice.within(options.min_exponent, options.max_exponent - width);
  const int bits = dice.within(1, 53);
  Coordinates coordinates(points_of(options) * options.dimension);
  for (double& x : coordinates) {
    x = integer(bits, dice);
    if (x != 0) x = std::ldexp(x, dice.within(least, least + width) - std::ilogb(x));
  }
  return coordinates;
}

}  // namespace

const std::vector<ArgumentFamily>& argument_families() {
  static const std::vector<ArgumentFamily> all = {
      {"generic", generic},
      {"degenerate", degenerate},
      {"neighbours", neighbours},
      {"far-cluster", far_cluster},
      {"mixed-exponents", mixed_exponents},
  };
  return all;
}

bool is_within_limits(const PredicateOptions& options, const std::vector<double>& coordinates) {
  return std::all_of(coordinates.begin(), coordinates.end(), [&](double x) {
    if (x == 0) return true;
    return std::isfinite(x) && std::ilogb(x) >= options.min_exponent &&
           std::ilogb(x) <= options.max_exponent;
  });
}

}  // namespace circumspect::harness
