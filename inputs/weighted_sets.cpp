#include "inputs/weighted_sets.hpp"

#include <algorithm>
#include <utility>

#include "inputs/lattices.hpp"
#include "inputs/scalars.hpp"
#include "inputs/set_parts.hpp"

namespace circumspect::generators {
namespace {

// Sets of integer coordinates, generic and degenerate.
PointSets integer_sets(std::size_t dimension, std::size_t max_points) {
  return rc::gen::oneOf(integer_points(dimension, max_points), grid_points(dimension, max_points),
                        integer_sphere_points(dimension, max_points));
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

rc::Gen<PointsCase> integer_weights(std::size_t dimension, std::size_t max_points) {
  const auto weights = rc::gen::container<std::vector<Rational>>(max_points, integer_number(100));
  return rc::gen::map(rc::gen::pair(integer_sets(dimension, max_points), weights),
                      [](std::pair<std::vector<Point>, std::vector<Rational>> parts) {
                        parts.second.resize(parts.first.size());
                        return PointsCase{std::move(parts.first), std::move(parts.second)};
                      });
}

rc::Gen<PointsCase> lifted_to_parallel_planes(std::size_t dimension, std::size_t max_points) {
  const auto upper = rc::gen::container<std::vector<long>>(max_points, below(2));
  return rc::gen::map(rc::gen::pair(integer_sets(dimension, max_points), upper),
                      [](std::pair<std::vector<Point>, std::vector<long>> parts) {
                        PointsCase set{std::move(parts.first)};
                        for (std::size_t v = 0; v < set.points.size(); ++v) {
                          set.weights.push_back(squared_length(set.points[v]) + parts.second[v]);
                        }
                        return set;
                      });
}

rc::Gen<PointsCase> submerged_points(std::size_t dimension, std::size_t max_points) {
  const std::size_t corners = std::min(max_points, dimension + 1);
  const auto inner = cubic_lattice_points(dimension, max_points - corners);
  const auto submerged = rc::gen::container<std::vector<long>>(max_points, below(2));
  return rc::gen::map(rc::gen::pair(inner, submerged),
                      [=](const std::pair<std::vector<Point>, std::vector<long>>& parts) {
                        PointsCase set{large_simplex(dimension)};
                        set.points.resize(corners);
                        set.weights.resize(corners);
                        for (std::size_t v = 0; v < parts.first.size(); ++v) {
                          set.points.push_back(parts.first[v]);
                          // Every lifted point of the large simplex is less than 1000·d⁴ high.
                          const auto d = static_cast<long>(dimension);
                          set.weights.push_back(
                              parts.second[v] == 0 ? Rational(0) : Rational(-1000 * d * d * d * d));
                        }
                        return set;
                      });
}

rc::Gen<PointsCase> duplicate_points(std::size_t dimension, std::size_t max_points) {
  const std::size_t copies = std::max<std::size_t>(max_points / 3, 1);
  const auto originals = cubic_lattice_points(dimension, max_points - std::min(copies, max_points));
  const auto copied = up_to<long>(copies, below(1L << 40));
  return rc::gen::map(rc::gen::pair(originals, copied),
                      [](const std::pair<std::vector<Point>, std::vector<long>>& parts) {
                        PointsCase set{parts.first};
                        const std::size_t count = set.points.size();
                        if (count == 0) return set;
                        for (const long code : parts.second) {
                          set.points.push_back(set.points[static_cast<std::size_t>(code) % count]);
                        }
                        if (set.points.size() == count) set.points.push_back(set.points.front());
                        return set;
                      });
}

}  // namespace circumspect::generators
