// Meshes of SU2, as text: .su2.
//
//     % a comment
//     NDIME= 3
//     NELEM= 12                                   then VTK's type and the vertices of each, from 0,
//     10 0 1 2 3 0                                  and perhaps its index, a line each
//     NPOIN= 8                                    then the coordinates of each, and perhaps its
//     0.5 1 2 0                                     index, a line each
//     NMARK= 2                                    parts of the boundary
//     MARKER_TAG= wall
//     MARKER_ELEMS= 4                             their elements, likewise
//     5 0 1 2
//
// Other keys, with the lines below them, are skipped. Several zones, NZONE= n and then IZONE= 1 …,
// have indices of their own, and are read as one mesh with the zones as labels.
#pragma once

#include <string_view>

#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/element_file.hpp"

namespace circumspect::formats {

// Does the text begin with a key of such a file, perhaps behind a page of comments?
bool is_su2(std::string_view text);

// Points are counted from 0, and those of a further zone behind those of the zones before.
Result<ElementFile> read_su2(const Source& source, NumberReading reading);

}  // namespace circumspect::formats
