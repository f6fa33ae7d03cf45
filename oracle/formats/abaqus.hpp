// Meshes in the input files of Abaqus and CalculiX, as text: .inp.
//
//     ** a comment
//     *Node, nset=all                             keywords and options in any case
//     1, 0., 0.5, 1e-3                            the tag and the coordinates of each; a field that
//     *Element, type=C3D4, elset=part             is empty is 0
//     1, 1, 2, 3, 4                               the tag and the nodes of each, which go on over
//     …                                           lines that end with a comma
//
// Everything else (sets, materials, steps) is skipped. Planar types (CPS3, CPE3, …) and shells are
// triangles. Nodes are taken as they are listed: what would move or generate them is an error.
// Files that *Include names, or INPUT= of *Node and *Element, are read in its place
// (included_files.hpp).
#pragma once

#include <string_view>

#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/formats/beginning.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/element_file.hpp"
#include "oracle/formats/included_files.hpp"

namespace circumspect::formats {

// Is the first line that is not a comment a keyword?
bool is_abaqus(const Beginning& beginning);

// Points are in the order of their tags and counted from the lowest (node_tags.hpp). Errors: also,
// several parts, other systems of coordinates, generated nodes or elements, a part that is moved
// where it is placed, an inclusion that is still there.
Result<ElementFile> read_abaqus(const Source& source, NumberReading reading);

// *Include, input=nodes.inp or *Node, input=nodes.csv
std::optional<Inclusion> abaqus_inclusion(TextLines lines);

}  // namespace circumspect::formats
