// Points alone, a line each: .xyz with blanks between the coordinates, .csv with commas.
//
//     0.5 1 2             x,y,z                   a first line may name the columns: those named x, y and z
//     3 4 5               0.5,1,2                 (in any case; or Points:0 … as ParaView writes) are the
//     …                   3,4,5                   coordinates, and any others are read over
//
// The number of coordinates of the first line is the dimension.
#pragma once

#include <ostream>

#include "oracle/formats/point_file.hpp"
#include "oracle/formats/source.hpp"
#include "reference/kernel/exact/number.hpp"

namespace circumspect::formats {

// Points are counted from 0.
Result<PointFile> read_xyz(const Source& source, NumberReading reading);

// Separated by commas, or by semicolons or tabs if the first line has those and no commas.
Result<PointFile> read_csv(const Source& source, NumberReading reading);

}  // namespace circumspect::formats
