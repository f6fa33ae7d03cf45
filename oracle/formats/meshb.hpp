// Medit's binary form, as Gamma, MMG and FreeFem write it: .meshb.
//
//     1, version                                  integers of 4 bytes, in either byte order
//     keyword, place of the next section          4 bytes, and 4, or 8 from version 3 on
//     Dimension (3): 3                            or 2
//     Vertices (4): count, x y [z] reference …    doubles, in version 1 floats
//     Edges (5): count, v0 v1 reference …         indices from 1
//     Triangles, Tetrahedra …                     likewise
//     …                                           other sections are read over
//     End (54)                                    which may be missing: that is noted
//
// Counts, indices and references have 8 bytes from version 4 on.
#pragma once

#include <string_view>

#include "kernel/exact/number_text.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/element_file.hpp"

namespace circumspect::formats {

// Does the file begin with the integer 1 and a version?
bool is_meshb(std::string_view bytes);

// References are labels; the first index is 1. Numbers are what the bytes say, whatever the
// reading.
Result<ElementFile> read_meshb(const Source& source, NumberReading reading);

}  // namespace circumspect::formats
