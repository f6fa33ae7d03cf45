// The contents of a file of points, or of a list of simplices, in any format.
#pragma once

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

#include "kernel/complex/simplex.hpp"
#include "kernel/exact/number.hpp"
#include "kernel/exact/point.hpp"
#include "kernel/predicates/configuration.hpp"
#include "oracle/formats/bytes/source.hpp"

namespace circumspect::formats {

// ---- Point file ----

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

// ---- Simplex file ----

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

// Points alone, a line each, and Qhull's list of points and of facets.

// ---- Point lists ----
// Points alone, a line each: .xyz with blanks between the coordinates, .csv with commas.
//
//     0.5 1 2             x,y,z                   a first line may name the columns: those named x,
//     3 4 5               0.5,1,2                 y and z (in any case; or ParaView's Points:0 …)
//     …                   3,4,5                   are the coordinates, and any others are skipped
//
// The number of coordinates of the first line is the dimension.

// Points are counted from 0.
Result<PointFile> read_xyz(const Source& source, NumberReading reading);

// Separated by commas, or by semicolons or tabs if the first line has those and no commas.
Result<PointFile> read_csv(const Source& source, NumberReading reading);

// ---- Qhull ----
// Qhull's input, a list of points, and what its option `i` prints, the facets.
//
//     dimension [comment]                facets
//     points                             v0 v1 …           one line a facet, indices from 0
//     x y …   one line a point

// Points of dimension 1 to kLargestDimension.
Result<PointFile> read_qhull_points(const Source& source, NumberReading reading);

// The vertices of each facet as written. Without option Qt facets need not be simplices, so they
// may differ in their number of vertices.
Result<SimplexFile> read_qhull_simplices(const Source& source);

// Requires: all points have `dimension` coordinates. Attributes and markers are not written.
void write_qhull_points(std::ostream& out, const PointFile& file);

// Requires: no simplex is empty.
void write_qhull_simplices(std::ostream& out, const SimplexFile& file);

}  // namespace circumspect::formats
