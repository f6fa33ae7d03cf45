// Meshes of AVS in UCD format, as text: .inp. LaGriT, ParaView and others write them.
//
//     # a comment
//     4 1 0 0 0                                   nodes, cells, numbers of data
//     1 0.0 0.0 0.0                               index and coordinates of each node
//     1 7 tet 1 2 3 4                             index, material, type and vertices of each cell
//
// What follows are data, which are not read.
#pragma once

#include "kernel/exact/number_text.hpp"
#include "oracle/formats/beginning.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/element_file.hpp"

namespace circumspect::formats {

// Nodes are counted by their tags (node_tags.hpp); materials are labels.
Result<ElementFile> read_ucd(const Source& source, NumberReading reading);

// Are the numbers of nodes, of cells and of three kinds of data on the first line?
bool is_ucd(const Beginning& beginning);

}  // namespace circumspect::formats
