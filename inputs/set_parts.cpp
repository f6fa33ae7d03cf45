#include "inputs/set_parts.hpp"

#include <cstdlib>
#include <numeric>
#include <set>

namespace circumspect::generators {
namespace {

// A similarity of R^d: the reflection in the hyperplane normal to `mirror`, times |mirror|² so that
// integers stay integers, then a translation. No reflection if mirror is 0.
Point moved(const Point& x, const Point& mirror, const Point& translation) {
  const Rational scale = squared_length(mirror);
  if (sign(scale) == 0) return x + translation;
  return scale * x - (2 * inner_product(mirror, x)) * mirror + translation;
}

}  // namespace

Rational integer_number(Dice& dice, long bound) { return dice.within(-bound, bound); }

Rational small_rational(Dice& dice) {
  const long numerator = dice.within(-12L, 12L);
  Rational value(numerator, dice.within(1L, 6L));
  value.canonicalize();
  return value;
}

Rational power_of_two(long exponent) {
  const Integer power = Integer(1) << static_cast<unsigned long>(std::abs(exponent));
  return exponent >= 0 ? Rational(power) : Rational(1) / power;
}

Point integer_point(Dice& dice, std::size_t dimension, long bound) {
  return several(dimension, [&] { return integer_number(dice, bound); });
}

std::vector<Point> distinct(const std::vector<Point>& points) {
  std::set<Point> seen;
  std::vector<Point> once;
  for (const Point& point : points) {
    if (seen.insert(point).second) once.push_back(point);
  }
  return once;
}

std::vector<Point> one_of(std::initializer_list<Sets> families, Dice& dice, std::size_t dimension,
                          Count count) {
  const Sets family = families.begin()[dice.below(families.size())];
  return family(dice, dimension, count);
}

std::vector<Point> carried(Dice& dice, const std::vector<Point>& points, std::size_t dimension) {
  const Point mirror = integer_point(dice, dimension, 2);
  const Point translation = integer_point(dice, dimension, 2);
  std::vector<Point> images;
  for (Point x : points) {
    x.resize(dimension);
    images.push_back(moved(x, mirror, translation));
  }
  return images;
}

Point from_stereographic(const Point& image) {
  const Rational square = squared_length(image);
  Point point = (2 / (square + 1)) * image;
  point.push_back((square - 1) / (square + 1));
  return point;
}

std::size_t cube_symmetries(std::size_t dimension) {
  std::size_t symmetries = 1;
  for (std::size_t i = 1; i <= dimension; ++i) symmetries *= 2 * i;
  return symmetries;
}

Point symmetric_image(const Point& point, std::size_t code) {
  std::vector<std::size_t> axes(point.size());
  std::iota(axes.begin(), axes.end(), std::size_t{0});
  Point image;
  for (std::size_t left = point.size(); left > 0; --left) {
    const auto chosen = axes.begin() + static_cast<std::ptrdiff_t>(code % left);
    code /= left;
    image.push_back(code % 2 == 0 ? point[*chosen] : Rational(-point[*chosen]));
    code /= 2;
    axes.erase(chosen);
  }
  return image;
}

}  // namespace circumspect::generators
