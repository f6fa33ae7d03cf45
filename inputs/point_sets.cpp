#include "inputs/point_sets.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "inputs/scalars.hpp"
#include "inputs/set_parts.hpp"
#include "reference/kernel/exact/point.hpp"

namespace circumspect::generators {
namespace {

double ulps_away(double x, long steps) {
  for (; steps > 0; --steps) x = std::nextafter(x, HUGE_VAL);
  for (; steps < 0; ++steps) x = std::nextafter(x, -HUGE_VAL);
  return x;
}

// Corner, facet centre or centre number `code` of the cube [0, 2]^d.
Point cube_point(std::size_t dimension, long code) {
  const auto d = static_cast<long>(dimension);
  const long corners = 1L << d;
  Point point(dimension, Rational(1));
  if (code < corners) {
    for (std::size_t i = 0; i < dimension; ++i) point[i] = 2 * ((code >> i) % 2);
  } else if (code < corners + 2 * d) {
    point[static_cast<std::size_t>((code - corners) / 2)] = 2 * ((code - corners) % 2);
  }
  return point;
}

}  // namespace

PointSets integer_points(std::size_t dimension, std::size_t max_points) {
  return sets_of(point_of(dimension, integer_number(20)), max_points);
}

PointSets rational_points(std::size_t dimension, std::size_t max_points) {
  return sets_of(point_of(dimension, small_rational()), max_points);
}

PointSets dyadic_points(std::size_t dimension, std::size_t max_points) {
  return sets_of(point_of(dimension, dyadic_number()), max_points);
}

PointSets extreme_points(std::size_t dimension, std::size_t max_points) {
  return sets_of(point_of(dimension, extreme_number()), max_points);
}

PointSets clustered_points(std::size_t dimension, std::size_t max_points) {
  using Centre = std::vector<long>;
  using Member = std::pair<long, std::vector<long>>;  // of which cluster, how many ulps away
  const auto centres = rc::gen::container<std::vector<Centre>>(
      3, rc::gen::container<Centre>(dimension, integer_within(3)));
  const auto member =
      rc::gen::pair(below(3), rc::gen::container<std::vector<long>>(dimension, integer_within(2)));
  return rc::gen::map(rc::gen::pair(centres, up_to<Member>(max_points, member)),
                      [](const std::pair<std::vector<Centre>, std::vector<Member>>& parts) {
                        std::vector<Point> points;
                        for (const auto& [cluster, ulps] : parts.second) {
                          const Centre& centre = parts.first[static_cast<std::size_t>(cluster)];
                          Point point;
                          for (std::size_t i = 0; i < centre.size(); ++i) {
                            const auto x = static_cast<double>(centre[i]);
                            point.push_back(exact_value(ulps_away(x, ulps[i])));
                          }
                          points.push_back(point);
                        }
                        return distinct(points);
                      });
}

PointSets unrelated_denominator_points(std::size_t dimension, std::size_t max_points) {
  // 2^a − 1 and 2^b − 1 are coprime if a and b are; these exponents are primes.
  static constexpr unsigned long kExponents[] = {907, 911, 919, 929, 937, 941, 947, 953};
  const auto whole = point_of(dimension, integer_number(4));
  const auto part = point_of(dimension, integer_number(4));
  return sets_of(rc::gen::map(rc::gen::tuple(whole, part, below(std::size(kExponents))),
                              [](const std::tuple<Point, Point, long>& parts) {
                                const auto& [integral, rest, choice] = parts;
                                const Integer power =
                                    Integer(1) << kExponents[static_cast<std::size_t>(choice)];
                                Rational unit(Integer(1), power - 1);
                                return integral + unit * rest;
                              }),
                 max_points);
}

PointSets grid_points(std::size_t dimension, std::size_t max_points) {
  const auto coordinate = rc::gen::map(below(3), [](long x) { return Rational(x); });
  return sets_of(point_of(dimension, coordinate), max_points);
}

PointSets cube_points(std::size_t dimension, std::size_t max_points) {
  const auto d = static_cast<long>(dimension);
  const auto point = rc::gen::map(below((1L << d) + 2 * d + 1),
                                  [dimension](long code) { return cube_point(dimension, code); });
  return sets_of(point, max_points);
}

PointSets sphere_points(std::size_t dimension, std::size_t max_points) {
  const auto image = point_of(dimension - 1, small_rational());
  return carried(sets_of(rc::gen::map(image, from_stereographic), max_points), dimension);
}

PointSets integer_sphere_points(std::size_t dimension, std::size_t max_points) {
  const auto representative = point_of(dimension, integer_number(5));
  const auto symmetries = up_to<long>(max_points, below(cube_symmetries(dimension)));
  return rc::gen::map(rc::gen::pair(representative, symmetries),
                      [](const std::pair<Point, std::vector<long>>& parts) {
                        std::vector<Point> points;
                        for (const long code : parts.second)
                          points.push_back(symmetric_image(parts.first, code));
                        return distinct(points);
                      });
}

PointSets embedded(const PointSets& sets, std::size_t flat_dimension, std::size_t dimension) {
  RC_ASSERT(flat_dimension <= dimension);
  return carried(sets, dimension);
}

PointSets line_points(std::size_t dimension, std::size_t max_points) {
  return embedded(integer_points(1, max_points), 1, dimension);
}

PointSets plane_points(std::size_t dimension, std::size_t max_points) {
  return embedded(rc::gen::oneOf(grid_points(2, max_points), integer_sphere_points(2, max_points),
                                 sphere_points(2, max_points), integer_points(2, max_points)),
                  2, dimension);
}

PointSets skew_line_points(std::size_t dimension, std::size_t max_points) {
  const auto point = rc::gen::map(rc::gen::pair(below(2), integer_number(5)),
                                  [](const std::pair<long, Rational>& parts) {
                                    const Rational& t = parts.second;
                                    return parts.first == 0 ? Point{t, 0, 0} : Point{0, t, 1};
                                  });
  return embedded(sets_of(point, max_points), 3, dimension);
}

PointSets moment_curve_points(std::size_t dimension, std::size_t max_points) {
  const auto point = rc::gen::map(integer_number(8), [dimension](const Rational& t) {
    Point powers;
    Rational power = 1;
    for (std::size_t i = 0; i < dimension; ++i) powers.push_back(power *= t);
    return powers;
  });
  return sets_of(point, max_points);
}

PointSets generic_point_set(std::size_t dimension, std::size_t max_points) {
  return rc::gen::oneOf(
      integer_points(dimension, max_points), rational_points(dimension, max_points),
      dyadic_points(dimension, max_points), extreme_points(dimension, max_points),
      clustered_points(dimension, max_points), unrelated_denominator_points(dimension, max_points));
}

PointSets degenerate_point_set(std::size_t dimension, std::size_t max_points) {
  if (dimension <= 1) return line_points(dimension, max_points);
  const auto spheres = rc::gen::oneOf(sphere_points(dimension, max_points),
                                      integer_sphere_points(dimension, max_points));
  const auto skew =
      dimension < 3 ? grid_points(dimension, max_points) : skew_line_points(dimension, max_points);
  return rc::gen::weightedOneOf<std::vector<Point>>(
      {{4, grid_points(dimension, max_points)},
       {4, spheres},
       {3, plane_points(dimension, max_points)},
       {1, line_points(dimension, max_points)},
       {2, cube_points(dimension, max_points)},
       {1, skew},
       {1, moment_curve_points(dimension, max_points)}});
}

PointSets any_point_set(std::size_t dimension, std::size_t max_points) {
  return rc::gen::oneOf(generic_point_set(dimension, max_points),
                        degenerate_point_set(dimension, max_points));
}

rc::Gen<PointsCase> unweighted(const PointSets& sets) {
  return rc::gen::map(sets,
                      [](std::vector<Point> points) { return PointsCase{std::move(points)}; });
}

rc::Gen<PointsCase> weighted(const PointSets& sets, std::size_t max_points) {
  return rc::gen::map(rc::gen::tuple(sets, small_weights(max_points), below(2)),
                      [](const std::tuple<std::vector<Point>, std::vector<Rational>, long>& parts) {
                        PointsCase set{std::get<0>(parts), std::get<1>(parts)};
                        set.weights.resize(set.points.size());
                        if (std::get<2>(parts) == 0) return set;
                        for (std::size_t v = 0; v < set.points.size(); ++v) {
                          set.weights[v] =
                              squared_length(set.points[v]) + (sign(set.weights[v]) > 0 ? 1 : 0);
                        }
                        return set;
                      });
}

rc::Gen<PointsCase> simplex_first(const rc::Gen<PointsCase>& cases) {
  const auto reordered = rc::gen::map(cases, [](const PointsCase& set) {
    std::vector<std::size_t> order = affine_hull(set.points).basis;
    for (std::size_t v = 0; v < set.points.size(); ++v) {
      if (std::find(order.begin(), order.end(), v) == order.end()) order.push_back(v);
    }
    PointsCase result;
    for (const std::size_t v : order) {
      result.points.push_back(set.points[v]);
      if (!set.weights.empty()) result.weights.push_back(set.weights[v]);
    }
    return result;
  });
  return rc::gen::suchThat(reordered, [](const PointsCase& set) {
    const int k = affine_hull(set.points).dimension;
    return k >= 1 && set.points.size() >= static_cast<std::size_t>(k) + 2;
  });
}

rc::Gen<PointsCase> simplex_and_queries(std::size_t dimension) {
  const std::size_t max_points = dimension + 6;
  const PointSets sets = any_point_set(dimension, max_points);
  return simplex_first(rc::gen::oneOf(unweighted(sets), weighted(sets, max_points)));
}

}  // namespace circumspect::generators
