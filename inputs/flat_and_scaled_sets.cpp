#include "inputs/flat_and_scaled_sets.hpp"

#include <cmath>
#include <utility>

#include "inputs/scalars.hpp"
#include "inputs/set_parts.hpp"

namespace circumspect::generators {
namespace {

Rational power_of_two(long exponent) {
  return exact_value(std::ldexp(1.0, static_cast<int>(exponent)));
}

PointSets scaled_integers(std::size_t dimension, std::size_t max_points, long exponent) {
  const Rational scale = power_of_two(exponent);
  return sets_of(rc::gen::map(point_of(dimension, integer_number(20)),
                              [scale](const Point& x) { return scale * x; }),
                 max_points);
}

}  // namespace

PointSets uniform_points(std::size_t dimension, std::size_t max_points) {
  const auto coordinate = rc::gen::map(integer_within(1L << 30), [](long numerator) {
    return exact_value(std::ldexp(static_cast<double>(numerator), -30));
  });
  return sets_of(point_of(dimension, coordinate), max_points);
}

PointSets lower_dimensional_points(std::size_t dimension, std::size_t max_points) {
  return rc::gen::mapcat(below(static_cast<long>(dimension)), [=](long k) {
    const auto flat_dimension = static_cast<std::size_t>(k);
    // In R^0 there is one point.
    if (k == 0) return embedded(sets_of(rc::gen::just(Point{}), max_points), 0, dimension);
    return embedded(rc::gen::oneOf(integer_points(flat_dimension, max_points),
                                   grid_points(flat_dimension, max_points)),
                    flat_dimension, dimension);
  });
}

PointSets pyramid_points(std::size_t dimension, std::size_t max_points) {
  const std::size_t apexes = max_points < 3 ? 0 : 2;
  const std::size_t in_base = max_points - apexes;
  PointSets bases =
      rc::gen::oneOf(grid_points(dimension - 1, in_base), integer_points(dimension - 1, in_base));
  if (dimension >= 3) {
    bases = rc::gen::oneOf(bases, integer_sphere_points(dimension - 1, in_base));
  }
  const auto apex = point_of(dimension, integer_number(3));
  return rc::gen::map(rc::gen::pair(bases, rc::gen::container<std::vector<Point>>(apexes, apex)),
                      [](const std::pair<std::vector<Point>, std::vector<Point>>& parts) {
                        std::vector<Point> points = parts.first;
                        for (Point& point : points) point.emplace_back(0);
                        points.insert(points.end(), parts.second.begin(), parts.second.end());
                        return distinct(points);
                      });
}

PointSets box_boundary_points(std::size_t dimension, std::size_t max_points) {
  const auto coordinate = rc::gen::map(below(5), [](long x) { return Rational(x); });
  const auto point = rc::gen::map(
      rc::gen::pair(point_of(dimension, coordinate), below(2 * static_cast<long>(dimension))),
      [](const std::pair<Point, long>& parts) {
        Point x = parts.first;
        x[static_cast<std::size_t>(parts.second / 2)] = parts.second % 2 == 0 ? 0 : 4;
        return x;
      });
  return sets_of(point, max_points);
}

PointSets slab_points(std::size_t dimension, std::size_t max_points) {
  const auto point =
      rc::gen::map(rc::gen::pair(point_of(dimension - 1, integer_number(8)), integer_number(3)),
                   [](const std::pair<Point, Rational>& parts) {
                     Point x = parts.first;
                     x.push_back(parts.second);
                     return x;
                   });
  return rc::gen::map(rc::gen::pair(sets_of(point, max_points), below(41)),
                      [](std::pair<std::vector<Point>, long> parts) {
                        const Rational thinness = power_of_two(-10 - parts.second);
                        for (Point& x : parts.first) x.back() *= thinness;
                        return parts.first;
                      });
}

PointSets cluster_points(std::size_t dimension, std::size_t max_points) {
  using Member = std::pair<long, Point>;  // of which cluster, how far from its centre
  const auto centres =
      rc::gen::container<std::vector<Point>>(3, point_of(dimension, integer_number(1000)));
  const auto member = rc::gen::pair(below(3), point_of(dimension, integer_number(16)));
  return rc::gen::map(
      rc::gen::pair(centres, up_to<Member>(max_points, member)),
      [](const std::pair<std::vector<Point>, std::vector<Member>>& parts) {
        const Rational unit = power_of_two(-14);
        std::vector<Point> points;
        for (const auto& [cluster, offset] : parts.second) {
          points.push_back(parts.first[static_cast<std::size_t>(cluster)] + unit * offset);
        }
        return distinct(points);
      });
}

PointSets nested_points(std::size_t dimension, std::size_t max_points) {
  const auto point = rc::gen::map(rc::gen::pair(point_of(dimension, integer_number(3)), below(51)),
                                  [](const std::pair<Point, long>& parts) {
                                    return power_of_two(-parts.second) * parts.first;
                                  });
  return sets_of(point, max_points);
}

PointSets huge_points(std::size_t dimension, std::size_t max_points) {
  return scaled_integers(dimension, max_points, 990);
}

PointSets tiny_points(std::size_t dimension, std::size_t max_points) {
  return scaled_integers(dimension, max_points, -1000);
}

PointSets far_apart_exponent_points(std::size_t dimension, std::size_t max_points) {
  const auto coordinate =
      rc::gen::map(rc::gen::pair(integer_within(3), integer_within(995)),
                   [](const std::pair<long, long>& parts) {
                     return exact_value(std::ldexp(static_cast<double>(parts.first),
                                                   static_cast<int>(parts.second)));
                   });
  return sets_of(point_of(dimension, coordinate), max_points);
}

}  // namespace circumspect::generators
