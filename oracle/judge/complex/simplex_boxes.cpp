#include "oracle/judge/complex/simplex_boxes.hpp"

#include <algorithm>

namespace circumspect::check {
namespace {

Box box_of(const Point& point) {
  if (point.size() == 2 || point.size() == 3) return box_around(point);
  Point shadow(point.begin(), point.begin() + std::min<std::ptrdiff_t>(std::ssize(point), 3));
  shadow.resize(std::max<std::size_t>(shadow.size(), 2), 0);
  return box_around(shadow);
}

}  // namespace

std::vector<Box> boxes_around(const std::vector<Point>& points,
                              const std::vector<Simplex>& simplices) {
  std::vector<Box> of_point;
  of_point.reserve(points.size());
  for (const Point& point : points) of_point.push_back(box_of(point));
  std::vector<Box> boxes;
  boxes.reserve(simplices.size());
  for (const Simplex& simplex : simplices) {
    Box box = of_point[static_cast<std::size_t>(simplex.front())];
    for (const Vertex v : simplex) box = box_around(box, of_point[static_cast<std::size_t>(v)]);
    boxes.push_back(box);
  }
  return boxes;
}

}  // namespace circumspect::check
