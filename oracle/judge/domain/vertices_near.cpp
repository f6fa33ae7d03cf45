#include "oracle/judge/domain/vertices_near.hpp"

#include <cmath>
#include <limits>

namespace circumspect::check {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<Box> boxes_of(const PointSet& points) {
  std::vector<Box> boxes;
  boxes.reserve(points.size());
  for (const Point& point : points.points()) boxes.push_back(box_around(point));
  return boxes;
}

// A box around the ball along the axes; its edges are not cut off. Every operation on doubles is
// followed by one step outward, more than it can have rounded inward.
Box box_around(const Ball& ball) {
  Box box = circumspect::box_around(ball.centre);
  const double radius = std::nextafter(std::sqrt(upper_double(ball.squared_radius)), kInfinity);
  for (std::size_t i = 0; i < box.low.size(); ++i) {
    const bool along_axis = i < ball.centre.size() && std::isfinite(radius);
    box.low[i] = along_axis ? std::nextafter(box.low[i] - radius, -kInfinity) : -kInfinity;
    box.high[i] = along_axis ? std::nextafter(box.high[i] + radius, kInfinity) : kInfinity;
  }
  return box;
}

}  // namespace

VertexIndex::VertexIndex(const PointSet& points) : index_(boxes_of(points)) {}

std::vector<Vertex> VertexIndex::near(const Ball& ball) const {
  std::vector<Vertex> vertices;
  for (const std::size_t place : index_.meeting(box_around(ball))) {
    vertices.push_back(static_cast<Vertex>(place));
  }
  return vertices;
}

}  // namespace circumspect::check
