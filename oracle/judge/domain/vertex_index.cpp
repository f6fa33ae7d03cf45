#include "oracle/judge/domain/vertex_index.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "kernel/boxes/interval.hpp"
#include "kernel/complex/circumball.hpp"
#include "kernel/piecewise_linear/cell_boxes.hpp"

namespace circumspect::check {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Triple<double> first_three(const std::array<double, 9>& sides) {
  return {sides[0], sides[1], sides[2]};
}

// A box around the ball along the axes; its edges are not cut off. The square root is rounded to
// nearest, so the next double is not less than it.
Box box_of_ball(const Ball& ball) {
  Box box = box_around(ball.centre);
  const double radius = std::nextafter(std::sqrt(upper_double(ball.squared_radius)), kInfinity);
  for (std::size_t i = 0; i < box.low.size(); ++i) {
    const bool along_axis = i < ball.centre.size() && std::isfinite(radius);
    box.low[i] = along_axis ? (exactly(box.low[i]) - exactly(radius)).low : -kInfinity;
    box.high[i] = along_axis ? (exactly(box.high[i]) + exactly(radius)).high : kInfinity;
  }
  return box;
}

}  // namespace

VertexIndex::VertexIndex(const PointSet& points) : VertexIndex(CellBoxes(points).of_vertices()) {}

VertexIndex::VertexIndex(const std::vector<Box>& boxes) : index_(boxes) {
  for (const Box& box : boxes) {
    low_.push_back(first_three(box.low));
    high_.push_back(first_three(box.high));
  }
}

std::vector<Vertex> VertexIndex::near(const Ball& ball) const {
  Triple<Interval> centre;
  for (std::size_t i = 0; i < ball.centre.size(); ++i) centre[i] = enclosing(ball.centre[i]);
  const double far = upper_double(ball.squared_radius);
  const auto is_beyond = [&](std::size_t place) {
    return least_squared_distance(low_[place], high_[place], centre) > far;
  };
  std::vector<Vertex> vertices;
  for (const std::size_t place : index_.meeting(box_of_ball(ball))) {
    if (!is_beyond(place)) vertices.push_back(static_cast<Vertex>(place));
  }
  return vertices;
}

}  // namespace circumspect::check
