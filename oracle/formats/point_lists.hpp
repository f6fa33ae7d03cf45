// Points alone, a line each: .xyz with blanks between the coordinates, .csv with commas.
//
//     0.5 1 2             x,y,z                   a first line may name the columns: those named x,
//     3 4 5               0.5,1,2                 y and z (in any case; or ParaView's Points:0 …)
//     …                   3,4,5                   are the coordinates, and any others are skipped
//
// The number of coordinates of the first line is the dimension.
#pragma once

#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/point_file.hpp"

namespace circumspect::formats {

// Points are counted from 0.
Result<PointFile> read_xyz(const Source& source, NumberReading reading);

// Separated by commas, or by semicolons or tabs if the first line has those and no commas.
Result<PointFile> read_csv(const Source& source, NumberReading reading);

}  // namespace circumspect::formats
