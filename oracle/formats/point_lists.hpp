// Points alone, a line each, and Qhull's list of points and of facets.
#pragma once

#include <ostream>

#include "oracle/formats/point_file.hpp"
#include "oracle/formats/source.hpp"
#include "reference/kernel/exact/number.hpp"

namespace circumspect::formats {

// ---- Point lists ----
// Points alone, a line each: .xyz with blanks between the coordinates, .csv with commas.
//
//     0.5 1 2             x,y,z                   a first line may name the columns: those named x, y and z
//     3 4 5               0.5,1,2                 (in any case; or Points:0 … as ParaView writes) are the
//     …                   3,4,5                   coordinates, and any others are read over
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
