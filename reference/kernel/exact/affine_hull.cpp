#include "reference/kernel/exact/affine_hull.hpp"

#include <algorithm>

namespace circumspect {
namespace {

// A direction of the hull, scaled to 1 on the axis that it is the pivot of.
struct Direction {
  std::size_t axis;
  Point vector;
};

// What is left of a vector after subtracting its part along the directions found so far. In the
// order of finding, each direction is zero on the axes of the earlier ones.
Point reduce(Point vector, const std::vector<Direction>& directions) {
  for (const Direction& direction : directions) {
    const Rational factor = vector[direction.axis];
    if (sign(factor) == 0) continue;
    vector = vector - factor * direction.vector;
  }
  return vector;
}

}  // namespace

AffineHull affine_hull(const std::vector<Point>& points) {
  AffineHull hull;
  if (points.empty()) return hull;
  hull.basis.push_back(0);
  const std::size_t ambient = points.front().size();
  std::vector<Direction> directions;
  for (std::size_t i = 1; i < points.size() && directions.size() < ambient; ++i) {
    const Point rest = reduce(points[i] - points[0], directions);
    const auto pivot =
        std::find_if(rest.begin(), rest.end(), [](const Rational& x) { return sign(x) != 0; });
    if (pivot == rest.end()) continue;
    const auto axis = static_cast<std::size_t>(pivot - rest.begin());
    directions.push_back({axis, (1 / *pivot) * rest});
    hull.basis.push_back(i);
    hull.axes.push_back(axis);
  }
  std::sort(hull.axes.begin(), hull.axes.end());
  hull.dimension = static_cast<int>(directions.size());
  return hull;
}

}  // namespace circumspect
