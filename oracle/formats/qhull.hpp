// Qhull's input, a list of points, and what its option `i` prints, the facets.
//
//     dimension [comment]                facets
//     points                             v0 v1 …           one line a facet, indices from 0
//     x y …   one line a point
#pragma once

#include <ostream>

#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/point_file.hpp"

namespace circumspect::formats {

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
