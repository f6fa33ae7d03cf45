#include "inputs/flat_and_scaled_sets.hpp"

#include "inputs/set_parts.hpp"

namespace circumspect::generators {
namespace {

std::vector<Point> scaled_integers(Dice& dice, std::size_t dimension, Count count, long exponent) {
  std::vector<Point> points = integer_points(dice, dimension, count);
  const Rational scale = power_of_two(exponent);
  for (Point& x : points) x = scale * x;
  return points;
}

}  // namespace

std::vector<Point> uniform_points(Dice& dice, std::size_t dimension, Count count) {
  const Rational unit = power_of_two(-30);
  return set_of(dice, count, [&] { return unit * integer_point(dice, dimension, 1L << 30); });
}

std::vector<Point> lower_dimensional_points(Dice& dice, std::size_t dimension, Count count) {
  const std::size_t flat_dimension = dice.below(dimension);
  // In R^0 there is one point.
  const auto points = flat_dimension == 0
                          ? set_of(dice, count, [] { return Point{}; })
                          : one_of({integer_points, grid_points}, dice, flat_dimension, count);
  return carried(dice, points, dimension);
}

std::vector<Point> pyramid_points(Dice& dice, std::size_t dimension, Count count) {
  const std::size_t apexes = count.most < 3 ? 0 : 2;
  const bool may_be_round = dimension >= 3 && dice.below(2) == 0;
  std::vector<Point> points =
      may_be_round ? integer_sphere_points(dice, dimension - 1, count.less(apexes))
                   : one_of({grid_points, integer_points}, dice, dimension - 1, count.less(apexes));
  for (Point& point : points) point.emplace_back(0);
  for (std::size_t i = 0; i < apexes; ++i) points.push_back(integer_point(dice, dimension, 3));
  return distinct(points);
}

std::vector<Point> box_boundary_points(Dice& dice, std::size_t dimension, Count count) {
  return set_of(dice, count, [&] {
    Point x = several(dimension, [&] { return Rational(dice.within(0, 4)); });
    const std::size_t side = dice.below(2 * dimension);
    x[side / 2] = side % 2 == 0 ? 0 : 4;
    return x;
  });
}

std::vector<Point> slab_points(Dice& dice, std::size_t dimension, Count count) {
  const Rational thinness = power_of_two(-dice.within(10L, 50L));
  return set_of(dice, count, [&] {
    Point x = integer_point(dice, dimension - 1, 8);
    x.push_back(thinness * integer_number(dice, 3));
    return x;
  });
}

std::vector<Point> cluster_points(Dice& dice, std::size_t dimension, Count count) {
  const Rational unit = power_of_two(-14);
  const auto centres = several(3, [&] { return integer_point(dice, dimension, 1000); });
  return set_of(dice, count, [&] {
    const Point& centre = centres[dice.below(3)];
    return centre + unit * integer_point(dice, dimension, 16);
  });
}

std::vector<Point> nested_points(Dice& dice, std::size_t dimension, Count count) {
  return set_of(dice, count, [&] {
    const Rational scale = power_of_two(-dice.within(0L, 50L));
    return scale * integer_point(dice, dimension, 3);
  });
}

std::vector<Point> huge_points(Dice& dice, std::size_t dimension, Count count) {
  return scaled_integers(dice, dimension, count, 990);
}

std::vector<Point> tiny_points(Dice& dice, std::size_t dimension, Count count) {
  return scaled_integers(dice, dimension, count, -1000);
}

std::vector<Point> far_apart_exponent_points(Dice& dice, std::size_t dimension, Count count) {
  return set_of(dice, count, [&] {
    return several(dimension, [&]() -> Rational {
      const Rational mantissa = integer_number(dice, 3);
      return mantissa * power_of_two(dice.within(-995L, 995L));
    });
  });
}

}  // namespace circumspect::generators
