#include "inputs/points_case.hpp"

#include <ostream>

#include "inputs/in_doubles.hpp"

namespace circumspect::generators {

PointsCase chosen(const PointsCase& set, const std::vector<std::size_t>& places) {
  PointsCase part;
  for (const std::size_t v : places) {
    part.points.push_back(set.points[v]);
    if (!set.weights.empty()) part.weights.push_back(set.weights[v]);
  }
  return part;
}

std::ostream& operator<<(std::ostream& out, const PointsCase& set) {
  const std::size_t dimension = set.points.empty() ? 0 : set.points.front().size();
  out << set.points.size() << ' ' << dimension << (set.weights.empty() ? " 0 0\n" : " 1 0\n");
  for (std::size_t v = 0; v < set.points.size(); ++v) {
    out << v;
    for (const Rational& x : set.points[v]) out << ' ' << x;
    if (!set.weights.empty()) out << ' ' << set.weights[v];
    out << '\n';
  }
  return out;
}

PointArray array(const PointsCase& set, std::size_t dimension) {
  PointArray result{set.points.empty() ? dimension : set.points.front().size(), {}, {}};
  result.coordinates.reserve(set.points.size() * result.dimension);
  for (const Point& point : set.points) {
    for (const Rational& x : point) result.coordinates.push_back(nearest_double(x));
  }
  for (const Rational& weight : set.weights) result.weights.push_back(nearest_double(weight));
  return result;
}

PointsCase from(const PointArray& points) {
  PointsCase set;
  set.points.reserve(points.size());
  for (std::size_t v = 0; v < points.size(); ++v) {
    Point point;
    for (std::size_t i = 0; i < points.dimension; ++i) {
      point.push_back(exact_value(points.point(v)[i]));
    }
    set.points.push_back(std::move(point));
  }
  for (const double weight : points.weights) set.weights.push_back(exact_value(weight));
  return set;
}

}  // namespace circumspect::generators
