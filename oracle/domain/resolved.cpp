#include "oracle/domain/resolved.hpp"

#include <algorithm>
#include <map>

#include "kernel/piecewise_linear/arrangement.hpp"

namespace circumspect {

ResolvedInput resolved(const PiecewiseLinearInput& input, const std::vector<Vertex>& labels) {
  ResolvedInput result{arranged(input), {}};
  std::map<Point, Vertex> label_of;
  Vertex last = -1;
  for (std::size_t v = 0; v < input.points.size(); ++v) {
    label_of.try_emplace(input.points[v], labels[v]);
    last = v == 0 ? labels[v] : std::max(last, labels[v]);
  }
  const std::size_t listed = label_of.size();
  for (const Point& point : result.input.points) {
    const auto [known, is_new] = label_of.try_emplace(point, last + 1);
    result.labels.push_back(known->second);
    last += is_new ? 1 : 0;
  }
  result.added = label_of.size() - listed;
  result.merged = input.points.size() - listed;
  return result;
}

}  // namespace circumspect
