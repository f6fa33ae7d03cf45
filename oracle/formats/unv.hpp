// Universal files of I-DEAS, as text: .unv.
//
//         -1
//       2411                                      nodes: of each a line with its label, the systems
//          1         1         1        11        of its coordinates, a colour; a line of these
//      0.0000000000000000D+00   5.0D-01   0.0D+00
//         -1
//         -1
//       2412                                      elements: of each a line with its label, type, …
//          1       111         1         1         7         4
//          1         2         3         4        and its number of nodes, and lines of these
//         -1
//
// Data sets 781 and 780 hold the same as 2411 and 2412 in older files; all others are skipped.
#pragma once

#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/formats/beginning.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/element_file.hpp"

namespace circumspect::formats {

// Is the first line -1, and the second the number of a data set alone?
bool is_unv(const Beginning& beginning);

// Points are in the order of their labels and counted from the lowest (node_tags.hpp); physical
// properties are labels. Errors: also, a node in a system of coordinates that a data set 2420
// turns, moves or bends.
Result<ElementFile> read_unv(const Source& source, NumberReading reading);

}  // namespace circumspect::formats
