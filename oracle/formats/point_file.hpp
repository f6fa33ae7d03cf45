// The contents of a file of points, or of a list of simplices, in any format.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "kernel/complex/simplex.hpp"
#include "kernel/exact/number.hpp"
#include "kernel/exact/point.hpp"
#include "kernel/predicates/configuration.hpp"

namespace circumspect::formats {

// Points with more coordinates than this are refused.
inline constexpr std::size_t kLargestDimension = 16;

struct PointFile {
  std::size_t dimension = 0;  // the number of coordinates of every point
  std::vector<Point> points = {};
  std::vector<std::vector<Rational>> attributes = {};  // empty, or one row a point
  std::vector<std::string> markers = {};               // empty, or one a point, as written
  Vertex first_index = 0;                              // the user's index of the first point

  friend bool operator==(const PointFile&, const PointFile&) = default;
};

struct SimplexFile {
  std::vector<Simplex> simplices = {};   // indices of points exactly as in the file
  std::vector<std::size_t> lines = {};   // the line of each, for messages
  std::vector<Vertex> labels = {};       // the label of each in the file; empty if there are none
  std::size_t vertices_per_simplex = 0;  // 0 if they differ
  Vertex first_index = 0;                // the user's index of the first simplex
};

// The number of vertices that all simplices have; 0 if they differ or there are none.
inline std::size_t size_of_each(const std::vector<Simplex>& simplices) {
  for (const Simplex& simplex : simplices) {
    if (simplex.size() != simplices.front().size()) return 0;
  }
  return simplices.empty() ? 0 : simplices.front().size();
}

}  // namespace circumspect::formats
