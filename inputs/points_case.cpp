#include "inputs/points_case.hpp"

#include <ostream>

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

}  // namespace circumspect::generators
