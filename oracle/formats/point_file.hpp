// What a file of points holds, in any format.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "reference/kernel/exact/point.hpp"
#include "reference/kernel/predicates/configuration.hpp"

namespace circumspect::formats {

// Points of more coordinates than this are refused.
inline constexpr std::size_t kLargestDimension = 16;

struct PointFile {
  std::size_t dimension = 0;  // the number of coordinates of every point
  std::vector<Point> points = {};
  std::vector<std::vector<Rational>> attributes = {};  // empty, or one row a point
  std::vector<std::string> markers = {};               // empty, or one a point, as written
  Vertex first_index = 0;                              // the user's index of the first point

  friend bool operator==(const PointFile&, const PointFile&) = default;
};

}  // namespace circumspect::formats
