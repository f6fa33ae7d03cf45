// Surfaces and lines in Wavefront's format, as text: .obj.
//
//     v x y z                                     further numbers, weights or colours, are skipped
//     f 1 2 3 …                                   or 1/t, 1//n, 1/t/n; −1 is the last point so far
//     l 1 2 …                                     a line of edges end to end
//     vt, vn, g, o, s, usemtl, mtllib, …          read over
//
// A backslash at the end of a line joins it with the next one.
#pragma once

#include <ostream>
#include <string_view>

#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/element_file.hpp"

namespace circumspect::formats {

// Does a file with this first word look like one?
bool is_obj_keyword(std::string_view token);

// Points are counted from 1.
Result<ElementFile> read_obj(const Source& source, NumberReading reading);

// The points, the surface (surface_of) and the edges. Requires: as write_gmsh.
void write_obj(std::ostream& out, const ElementFile& file);

}  // namespace circumspect::formats
