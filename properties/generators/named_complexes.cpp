#include "properties/generators/named_complexes.hpp"

namespace circumspect::generators {

PiecewiseLinearInput box(const Rational& low, const Rational& high) {
  PiecewiseLinearInput input;
  for (int corner = 0; corner < 8; ++corner) {
    Point point;
    for (int axis = 0; axis < 3; ++axis) point.push_back((corner >> axis) & 1 ? high : low);
    input.points.push_back(point);
  }
  for (const std::vector<Vertex>& square : {std::vector<Vertex>{0, 1, 3, 2},
                                            {4, 5, 7, 6},
                                            {0, 1, 5, 4},
                                            {2, 3, 7, 6},
                                            {0, 2, 6, 4},
                                            {1, 3, 7, 5}}) {
    input.polygons.push_back({{square}, {}});
  }
  return input;
}

PiecewiseLinearInput schonhardt() {
  PiecewiseLinearInput input;
  input.points = {{10, 0, 0}, {-5, 9, 0}, {-5, -9, 0}, {9, 5, 10}, {-9, 5, 10}, {0, -10, 10}};
  input.polygons = {{{{0, 1, 2}}, {}}, {{{3, 4, 5}}, {}}};
  for (Vertex i = 0; i < 3; ++i) {
    const Vertex next = (i + 1) % 3;
    input.polygons.push_back({{{i, next, next + 3}}, {}});
    input.polygons.push_back({{{i, next + 3, i + 3}}, {}});
  }
  return input;
}

PiecewiseLinearInput both(PiecewiseLinearInput first, const PiecewiseLinearInput& second) {
  const auto shift = static_cast<Vertex>(first.points.size());
  const auto shifted = [shift](std::vector<Vertex> line) {
    for (Vertex& v : line) v += shift;
    return line;
  };
  first.points.insert(first.points.end(), second.points.begin(), second.points.end());
  for (const auto& segment : second.segments) first.segments.push_back(shifted(segment));
  for (PolygonLines polygon : second.polygons) {
    for (auto& line : polygon.lines) line = shifted(line);
    first.polygons.push_back(polygon);
  }
  first.hole_seeds.insert(first.hole_seeds.end(), second.hole_seeds.begin(),
                          second.hole_seeds.end());
  return first;
}

}  // namespace circumspect::generators
