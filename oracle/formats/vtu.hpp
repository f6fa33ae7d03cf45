// Meshes and surfaces in VTK's XML format: .vtu (UnstructuredGrid) and .vtp (PolyData), their
// arrays as text, as bytes in base 64, or appended, compressed by zlib or not.
//
// Points of several pieces follow one another. Numbers in text are taken as they are written,
// whatever type is declared. Data of points and cells are ignored.
#pragma once

#include <ostream>
#include <string_view>

#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/element_file.hpp"

namespace circumspect::formats {

// Does the text begin as such a file does?
bool is_vtu(std::string_view text);

// Points are counted from 0.
Result<ElementFile> read_vtu(const Source& source, NumberReading reading);

// An UnstructuredGrid, in text; labels, which all cells have or none, are cell data. Requires:
// points of dimension 2 or 3, whose third coordinate is written as 0; vertices are counted from the
// first index of the points.
void write_vtu(std::ostream& out, const ElementFile& file);

}  // namespace circumspect::formats
