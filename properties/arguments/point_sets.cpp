#include "properties/arguments/point_sets.hpp"

#include <algorithm>
#include <utility>

#include "kernel/exact/point.hpp"

namespace circumspect::generators {
namespace {

template <class Value>
Value one_of_them(const rc::Gen<Value>& values, Dice& dice) {
  return values(rc::Random(dice.bits()), rc::kNominalSize).value();
}

}  // namespace

PointSets sets_of(Sets family, std::size_t dimension, std::size_t max_points) {
  return generated([=](Dice& dice) { return family(dice, dimension, {max_points}); });
}

std::vector<Point> generic_points(Dice& dice, std::size_t dimension, Count count) {
  return one_of({integer_points, rational_points, dyadic_points, extreme_points, clustered_points,
                 unrelated_denominator_points},
                dice, dimension, count);
}

std::vector<Point> degenerate_points(Dice& dice, std::size_t dimension, Count count) {
  if (dimension <= 1) return line_points(dice, dimension, count);
  // Some more often than others.
  static constexpr Sets kFamilies[] = {
      grid_points,   grid_points,   grid_points,           grid_points,
      sphere_points, sphere_points, integer_sphere_points, integer_sphere_points,
      plane_points,  plane_points,  plane_points,          line_points,
      cube_points,   cube_points,   moment_curve_points,   skew_line_points};
  const Sets family = kFamilies[dice.below(std::size(kFamilies))];
  if (dimension == 2 && family == skew_line_points) return grid_points(dice, dimension, count);
  return family(dice, dimension, count);
}

std::vector<Point> any_points(Dice& dice, std::size_t dimension, Count count) {
  return one_of({generic_points, degenerate_points}, dice, dimension, count);
}

PointSets generic_point_set(std::size_t dimension, std::size_t max_points) {
  return sets_of(generic_points, dimension, max_points);
}

PointSets degenerate_point_set(std::size_t dimension, std::size_t max_points) {
  return sets_of(degenerate_points, dimension, max_points);
}

PointSets any_point_set(std::size_t dimension, std::size_t max_points) {
  return sets_of(any_points, dimension, max_points);
}

PointSets embedded(const PointSets& sets, std::size_t dimension) {
  return generated([=](Dice& dice) {
    const std::vector<Point> points = one_of_them(sets, dice);
    return carried(dice, points, dimension);
  });
}

rc::Gen<PointsCase> unweighted(const PointSets& sets) {
  return generated([=](Dice& dice) { return PointsCase{one_of_them(sets, dice)}; });
}

rc::Gen<PointsCase> weighted(const PointSets& sets) {
  return generated([=](Dice& dice) {
    PointsCase set{one_of_them(sets, dice)};
    const bool on_parallel_planes = dice.below(2) == 1;
    for (const Point& x : set.points) {
      const Rational weight = small_rational(dice);
      const Rational lifted = squared_length(x) + (sign(weight) > 0 ? 1 : 0);
      set.weights.push_back(on_parallel_planes ? lifted : weight);
    }
    return set;
  });
}

rc::Gen<PointsCase> any_unweighted_case(std::size_t dimension, std::size_t max_points) {
  return unweighted(rc::gen::oneOf(any_point_set(dimension, max_points),
                                   degenerate_point_set(dimension, max_points)));
}

rc::Gen<PointsCase> any_case(std::size_t dimension, std::size_t max_points) {
  const PointSets sets = rc::gen::oneOf(any_point_set(dimension, max_points),
                                        degenerate_point_set(dimension, max_points));
  return rc::gen::oneOf(unweighted(sets), weighted(sets));
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
  const PointSets sets = any_point_set(dimension, dimension + 6);
  return simplex_first(rc::gen::oneOf(unweighted(sets), weighted(sets)));
}

}  // namespace circumspect::generators
