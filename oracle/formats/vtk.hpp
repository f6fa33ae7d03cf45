// Meshes and surfaces in VTK's legacy format, in text or binary: .vtk.
//
//     # vtk DataFile Version 3.0                  5.1: cells as offsets and vertices, else as rows
//     a title
//     ASCII                                       or BINARY, whose byte order is big-endian
//     DATASET UNSTRUCTURED_GRID                   or POLYDATA
//     POINTS 8 double                             three coordinates each
//     CELLS 12 60, CELL_TYPES 12                  or VERTICES, LINES, POLYGONS, TRIANGLE_STRIPS
//     CELL_DATA, POINT_DATA …                     and what follows: not looked at
//
// Numbers in text are taken as they are written, whatever type is declared.
#pragma once

#include <string_view>

#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/element_file.hpp"

namespace circumspect::formats {

// Does the text begin as such a file does?
bool is_vtk(std::string_view text);

// Points are counted from 0.
Result<ElementFile> read_vtk(const Source& source, NumberReading reading);

}  // namespace circumspect::formats
