// The signs of orientation and in-ball determinants, of doubles or of numbers as text.
#include <cstddef>
#include <cstdint>
#include <vector>

#include <circumspect/circumspect.h>
#include <fmt/format.h>

#include "c/guard.hpp"
#include "c/input.hpp"
#include "kernel/predicates/in_ball.hpp"
#include "kernel/predicates/orientation.hpp"

namespace circumspect::c {
namespace {

// All points of one dimension, `count` of them.
Configuration configuration_of(std::int64_t dimension, std::int64_t beyond, const double* doubles,
                               const char* const* texts) {
  if (dimension < 1 || dimension > kLargestDimension) {
    refuse_call(
        fmt::format("expected a dimension from 1 to {}, found {}", kLargestDimension, dimension));
  }
  if (doubles == nullptr && texts == nullptr) refuse_call("expected coordinates, found NULL");
  return Configuration(exact_points(dimension + beyond, dimension, doubles, texts));
}

std::vector<Vertex> first_vertices(std::int64_t count) {
  std::vector<Vertex> vertices;
  for (Vertex v = 0; v < count; ++v) vertices.push_back(v);
  return vertices;
}

std::vector<std::size_t> all_axes(std::int64_t dimension) {
  std::vector<std::size_t> axes;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis)
    axes.push_back(axis);
  return axes;
}

int orientation_sign(std::int64_t dimension, const double* doubles, const char* const* texts) {
  const Configuration points = configuration_of(dimension, 1, doubles, texts);
  return orientation(points, all_axes(dimension), first_vertices(dimension + 1));
}

int in_ball_sign(std::int64_t dimension, const double* doubles, const char* const* texts) {
  const Configuration points = configuration_of(dimension, 2, doubles, texts);
  const std::vector<std::size_t> axes = all_axes(dimension);
  const std::vector<Vertex> simplex = first_vertices(dimension + 1);
  if (orientation(points, axes, simplex) == 0) {
    refuse_input(fmt::format(
        "expected {} affinely independent points before the last, found others", dimension + 1));
  }
  return in_ball(points, axes, simplex, dimension + 1);
}

}  // namespace
}  // namespace circumspect::c

using namespace circumspect;

circumspect_status circumspect_orientation(int64_t dimension, const double* coordinates,
                                           int* sign) {
  return c::guarded([&] {
    int* const place = c::required(sign, "a place for the sign");
    *place = c::orientation_sign(dimension, coordinates, nullptr);
  });
}

circumspect_status circumspect_in_ball(int64_t dimension, const double* coordinates, int* sign) {
  return c::guarded([&] {
    int* const place = c::required(sign, "a place for the sign");
    *place = c::in_ball_sign(dimension, coordinates, nullptr);
  });
}

circumspect_status circumspect_orientation_exact(int64_t dimension, const char* const* coordinates,
                                                 int* sign) {
  return c::guarded([&] {
    int* const place = c::required(sign, "a place for the sign");
    *place = c::orientation_sign(dimension, nullptr, coordinates);
  });
}

circumspect_status circumspect_in_ball_exact(int64_t dimension, const char* const* coordinates,
                                             int* sign) {
  return c::guarded([&] {
    int* const place = c::required(sign, "a place for the sign");
    *place = c::in_ball_sign(dimension, nullptr, coordinates);
  });
}
