#include "inputs/point_sets.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "inputs/round_sets.hpp"
#include "inputs/set_parts.hpp"
#include "kernel/exact/point.hpp"

namespace circumspect::generators {

namespace {

// An integer within the bounds times a power of two within the others, a double.
Rational scaled_integer(Dice& dice, std::int64_t bound, long least_exponent,
                        long largest_exponent) {
  const auto mantissa = static_cast<double>(dice.within(-bound, bound));
  const long exponent = dice.within(least_exponent, largest_exponent);
  return exact_value(std::ldexp(mantissa, static_cast<int>(exponent)));
}

double ulps_away(double x, long steps) {
  for (; steps > 0; --steps) x = std::nextafter(x, HUGE_VAL);
  for (; steps < 0; ++steps) x = std::nextafter(x, -HUGE_VAL);
  return x;
}

// Corner, facet centre or centre number `code` of the cube [0, 2]^d.
Point cube_point(std::size_t dimension, std::size_t code) {
  const std::size_t corners = std::size_t{1} << dimension;
  Point point(dimension, Rational(1));
  if (code < corners) {
    for (std::size_t i = 0; i < dimension; ++i) point[i] = to_integer(2 * ((code >> i) % 2));
  } else if (code < corners + 2 * dimension) {
    point[(code - corners) / 2] = to_integer(2 * ((code - corners) % 2));
  }
  return point;
}

// The least number of steps on each axis that gives enough cells, each with so many points; 1 for
// sets of at most sixty points, which are dense on purpose.
long steps_for(std::size_t points, std::size_t dimension, std::size_t points_each) {
  constexpr std::size_t kFew = 60;
  if (points <= kFew) return 1;
  long steps = 1;
  const double cells = static_cast<double>(points) / static_cast<double>(points_each);
  while (std::pow(static_cast<double>(steps), static_cast<double>(dimension)) < cells) ++steps;
  return steps;
}

}  // namespace

std::vector<Point> integer_points(Dice& dice, std::size_t dimension, Count count) {
  return set_of(dice, count, [&] { return integer_point(dice, dimension, 20); });
}

std::vector<Point> rational_points(Dice& dice, std::size_t dimension, Count count) {
  return set_of(dice, count,
                [&] { return several(dimension, [&] { return small_rational(dice); }); });
}

std::vector<Point> dyadic_points(Dice& dice, std::size_t dimension, Count count) {
  return set_of(dice, count, [&] {
    return several(dimension, [&] { return scaled_integer(dice, std::int64_t{1} << 53, -60, 0); });
  });
}

std::vector<Point> extreme_points(Dice& dice, std::size_t dimension, Count count) {
  return set_of(dice, count, [&] {
    return several(dimension, [&] { return scaled_integer(dice, 3, -300, 300); });
  });
}

std::vector<Point> clustered_points(Dice& dice, std::size_t dimension, Count count) {
  const auto integers = [&](long bound) {
    return several(dimension, [&] { return dice.within(-bound, bound); });
  };
  const auto centres = several(3, [&] { return integers(3); });
  return set_of(dice, count, [&] {
    const std::vector<long>& centre = centres[dice.below(3)];
    const std::vector<long> ulps = integers(2);
    Point point;
    for (std::size_t i = 0; i < dimension; ++i) {
      point.push_back(exact_value(ulps_away(static_cast<double>(centre[i]), ulps[i])));
    }
    return point;
  });
}

std::vector<Point> unrelated_denominator_points(Dice& dice, std::size_t dimension, Count count) {
  // 2^a − 1 and 2^b − 1 are coprime if a and b are; these exponents are primes.
  static constexpr unsigned long kExponents[] = {907, 911, 919, 929, 937, 941, 947, 953};
  return set_of(dice, count, [&] {
    const Point whole = integer_point(dice, dimension, 4);
    const Point part = integer_point(dice, dimension, 4);
    const Integer power = Integer(1) << kExponents[dice.below(std::size(kExponents))];
    const Rational unit(Integer(1), power - 1);
    return whole + unit * part;
  });
}

std::vector<Point> grid_points(Dice& dice, std::size_t dimension, Count count) {
  const long last = std::max(2L, steps_for(count.most, dimension, 1) - 1);
  return set_of(dice, count, [&] {
    return several(dimension, [&] { return Rational(dice.within(0L, last)); });
  });
}

std::vector<Point> cube_points(Dice& dice, std::size_t dimension, Count count) {
  const std::size_t codes = (std::size_t{1} << dimension) + 2 * dimension + 1;
  const long cubes = steps_for(count.most, dimension, codes);
  return set_of(dice, count, [&] {
    Point point = cube_point(dimension, dice.below(codes));
    if (cubes > 1) {
      for (Rational& x : point) x += 2 * dice.within(0L, cubes - 1);
    }
    return point;
  });
}

std::vector<Point> sphere_points(Dice& dice, std::size_t dimension, Count count) {
  const auto points = set_of(dice, count, [&] {
    return from_stereographic(several(dimension - 1, [&] { return small_rational(dice); }));
  });
  return carried(dice, points, dimension);
}

std::vector<Point> integer_sphere_points(Dice& dice, std::size_t dimension, Count count) {
  const Point representative = integer_point(dice, dimension, 5);
  const std::size_t symmetries = cube_symmetries(dimension);
  return set_of(dice, count,
                [&] { return symmetric_image(representative, dice.below(symmetries)); });
}

std::vector<Point> line_points(Dice& dice, std::size_t dimension, Count count) {
  return carried(dice, integer_points(dice, 1, count), dimension);
}

std::vector<Point> plane_points(Dice& dice, std::size_t dimension, Count count) {
  const auto points =
      one_of({grid_points, integer_sphere_points, sphere_points, integer_points}, dice, 2, count);
  return carried(dice, points, dimension);
}

std::vector<Point> skew_line_points(Dice& dice, std::size_t dimension, Count count) {
  const auto points = set_of(dice, count, [&] {
    const bool first_line = dice.below(2) == 0;
    const Rational t = integer_number(dice, 5);
    return first_line ? Point{t, 0, 0} : Point{0, t, 1};
  });
  return carried(dice, points, dimension);
}

std::vector<Point> moment_curve_points(Dice& dice, std::size_t dimension, Count count) {
  return set_of(dice, count, [&] {
    const Rational t = integer_number(dice, 8);
    Point powers;
    Rational power = 1;
    for (std::size_t i = 0; i < dimension; ++i) powers.push_back(power *= t);
    return powers;
  });
}

namespace {

// Sets of integer coordinates, generic and degenerate.
std::vector<Point> integer_sets(Dice& dice, std::size_t dimension, Count count) {
  return one_of({integer_points, grid_points, integer_sphere_points}, dice, dimension, count);
}

// The corners −6·d·(1, …, 1) and 12·d·d·e_i: the points within 3 of the origin lie deep inside.
std::vector<Point> large_simplex(std::size_t dimension) {
  const auto d = static_cast<long>(dimension);
  std::vector<Point> corners = {Point(dimension, Rational(-6 * d))};
  for (std::size_t i = 0; i < dimension; ++i) {
    corners.emplace_back(dimension);
    corners.back()[i] = 12 * d * d;
  }
  return corners;
}

}  // namespace

PointsCase integer_weights(Dice& dice, std::size_t dimension, Count count) {
  PointsCase set{integer_sets(dice, dimension, count)};
  set.weights = several(set.points.size(), [&] { return integer_number(dice, 100); });
  return set;
}

PointsCase lifted_to_parallel_planes(Dice& dice, std::size_t dimension, Count count) {
  PointsCase set{integer_sets(dice, dimension, count)};
  for (const Point& x : set.points) {
    set.weights.push_back(squared_length(x) + dice.within(0, 1));
  }
  return set;
}

PointsCase submerged_points(Dice& dice, std::size_t dimension, Count count) {
  const std::size_t corners = std::min(count.most, dimension + 1);
  PointsCase set{large_simplex(dimension)};
  set.points.resize(corners);
  set.weights.resize(corners);
  // Every lifted point of the large simplex is less than 1000·d⁴ high.
  const auto d = static_cast<long>(dimension);
  const Rational low = -1000 * d * d * d * d;
  for (const Point& inner : cubic_lattice_points(dice, dimension, count.less(corners))) {
    set.points.push_back(inner);
    set.weights.push_back(dice.below(2) == 0 ? Rational(0) : low);
  }
  return set;
}

PointsCase duplicate_points(Dice& dice, std::size_t dimension, Count count) {
  const std::size_t copies = std::max<std::size_t>(count.most / 3, 1);
  PointsCase set{cubic_lattice_points(dice, dimension, count.less(std::min(copies, count.most)))};
  const std::size_t originals = set.points.size();
  if (originals == 0) return set;
  const std::size_t copied = std::max<std::size_t>(Count{copies, count.full}.drawn(dice), 1);
  for (std::size_t i = 0; i < copied; ++i) {
    const Point original = set.points[dice.below(originals)];
    set.points.push_back(original);
  }
  return set;
}

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
