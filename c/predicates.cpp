// The signs of orientation and in-ball determinants, of doubles or of numbers as text.
#include "oracle/judge/fast/predicates/predicates.hpp"

#include <algorithm>
#include <cmath>
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

// Doubles of the plane and of space have predicates of their own, thirty times as fast, where the
// processor rounds as their bounds assume. Nobody asks them for numbers that are not finite.
bool are_for_doubles(std::int64_t dimension, std::int64_t beyond, const double* doubles) {
  return (dimension == 2 || dimension == 3) && doubles != nullptr &&
         fast::arithmetic_is_as_proved() &&
         std::all_of(doubles, doubles + dimension * (dimension + beyond),
                     [](double x) { return std::isfinite(x); });
}

template <std::size_t kDimension>
fast::Site<kDimension> site(const double* doubles, std::size_t place) {
  fast::Site<kDimension> site{};
  std::copy_n(doubles + place * kDimension, kDimension, site.at.begin());
  return site;
}

template <std::size_t kDimension>
fast::SiteRow<kDimension> simplex(const double* doubles) {
  fast::SiteRow<kDimension> row;
  for (std::size_t i = 0; i <= kDimension; ++i) row[i] = site<kDimension>(doubles, i);
  return row;
}

template <std::size_t kDimension>
int orientation_of_doubles(const double* doubles) {
  fast::Stages stages;
  return fast::orientation<kDimension>(simplex<kDimension>(doubles), stages);
}

// 0 for points that are affinely dependent, too.
template <std::size_t kDimension>
int in_ball_of_doubles(const double* doubles) {
  fast::Stages stages;
  const auto ball = fast::ball_of<kDimension, false>(simplex<kDimension>(doubles));
  return ball.orientation(stages) *
         ball.contains(site<kDimension>(doubles, kDimension + 1), stages);
}

int orientation_sign(std::int64_t dimension, const double* doubles, const char* const* texts) {
  if (are_for_doubles(dimension, 1, doubles)) {
    return dimension == 2 ? orientation_of_doubles<2>(doubles) : orientation_of_doubles<3>(doubles);
  }
  const Configuration points = configuration_of(dimension, 1, doubles, texts);
  return orientation(points, all_axes(dimension), first_vertices(dimension + 1));
}

int in_ball_sign(std::int64_t dimension, const double* doubles, const char* const* texts) {
  if (are_for_doubles(dimension, 2, doubles)) {
    const int sign =
        dimension == 2 ? in_ball_of_doubles<2>(doubles) : in_ball_of_doubles<3>(doubles);
    if (sign != 0) return sign;  // else they may be dependent, which is refused below
  }
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
