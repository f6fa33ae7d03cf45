#include "inputs/weighted_sets.hpp"

#include <algorithm>

#include "inputs/lattices.hpp"
#include "inputs/set_parts.hpp"

namespace circumspect::generators {
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

}  // namespace circumspect::generators
