// Points as Triangle and TetGen write them: .node.
//
//     points dimension [attributes [markers]]       markers: 0 or 1
//     index x y … attributes… [marker]              one line a point
#pragma once

#include <ostream>

#include "oracle/formats/numbered_lines.hpp"
#include "oracle/formats/point_file.hpp"
#include "oracle/formats/source.hpp"
#include "reference/kernel/exact/number.hpp"

namespace circumspect::formats {

// Points of dimension 1 to kLargestDimension. The first index may be any integer, the others
// follow one by one; a marker is an integer.
Result<PointFile> read_node(const Source& source, NumberReading reading);

// The list with which .poly and .smesh begin. Without points in it, they stand in a .node file, and
// the dimension may be left out: 0.
Result<PointFile> read_node_list(NumberedLines& numbered, NumberReading reading);

// Coordinates and attributes are written so that reading them as doubles gives the same numbers.
// Requires: all points have `dimension` coordinates; attributes and markers are empty or one a
// point, all rows of attributes have one length.
void write_node(std::ostream& out, const PointFile& file);

}  // namespace circumspect::formats
