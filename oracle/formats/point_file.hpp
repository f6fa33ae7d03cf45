// The contents of a file of points, or of a list of simplices, in any format.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "kernel/complex/simplex.hpp"
#include "kernel/exact/number.hpp"
#include "kernel/exact/point.hpp"
#include "kernel/predicates/configuration.hpp"
#include "oracle/formats/bytes/point_rows.hpp"
#include "oracle/formats/bytes/runs.hpp"
#include "oracle/formats/bytes/simplex_rows.hpp"

namespace circumspect::formats {

// Points with more coordinates than this are refused.
inline constexpr std::size_t kLargestDimension = 16;

struct PointFile {
  std::size_t dimension = 0;  // the number of coordinates of every point
  PointRows points = {};
  std::vector<std::vector<Rational>> attributes = {};  // empty, or one row a point
  std::vector<std::string> markers = {};               // empty, or one a point, as written
  Vertex first_index = 0;                              // the user's index of the first point

  friend bool operator==(const PointFile&, const PointFile&) = default;
};

struct SimplexFile {
  SimplexRows simplices = {};            // indices of points exactly as in the file
  Runs<std::size_t> lines = {};          // the line of each, for messages
  Runs<Vertex> labels = {};              // the label of each in the file; empty if there are none
  std::size_t vertices_per_simplex = 0;  // 0 if they differ
  Vertex first_index = 0;                // the user's index of the first simplex
};

}  // namespace circumspect::formats
