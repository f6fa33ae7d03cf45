#include "reference/piecewise_linear/lines.hpp"

#include <algorithm>

#include "reference/complex/simplex.hpp"

namespace circumspect {
namespace {

template <typename T>
void keep_each_once(std::vector<T>& items) {
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

}  // namespace

std::set<Simplex> edges_of(const PolygonLines& polygon) {
  std::set<Simplex> edges;
  for (const std::vector<Vertex>& line : polygon.lines) {
    if (line.size() < 2) continue;
    for (std::size_t i = 0; i < line.size(); ++i) {
      edges.insert(sorted({line[i], line[(i + 1) % line.size()]}));
    }
  }
  return edges;
}

std::vector<Vertex> vertices_of(const PolygonLines& polygon) {
  std::vector<Vertex> vertices;
  for (const auto& line : polygon.lines) vertices.insert(vertices.end(), line.begin(), line.end());
  keep_each_once(vertices);
  return vertices;
}

std::vector<Simplex> segments_of(const PiecewiseLinearInput& input) {
  std::vector<Simplex> segments;
  for (const auto& segment : input.segments) segments.push_back(sorted(segment));
  for (const PolygonLines& polygon : input.polygons) {
    for (const Simplex& edge : edges_of(polygon)) segments.push_back(edge);
  }
  keep_each_once(segments);
  return segments;
}

}  // namespace circumspect
