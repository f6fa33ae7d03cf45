// Meshes in the bulk data of Nastran and OptiStruct, as text: .bdf, .nas.
//
//     $ a comment
//     BEGIN BULK                                  what stands before it is skipped, if it is there
//     GRID,1,,0.,.5,1.5-3                         fields with commas between them; or in ten
//     GRID           2              0.      1.      0.    columns of 8; or, after a star, of 16
//     CTETRA         1       7       1       2       3       4+
//     +              5                            a line may go on after a blank, + or *
//     ENDDATA
//
// All other entries (properties, materials, loads) are skipped. Files that INCLUDE names are read
// in its place (included_files.hpp). Nodes of other systems of coordinates are moved to the basic
// one where that is exact (nastran_systems.hpp), and refused elsewhere.
#pragma once

#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/formats/beginning.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/element_file.hpp"
#include "oracle/formats/included_files.hpp"

namespace circumspect::formats {

// Does one of the first lines begin bulk data, or a node?
bool is_nastran(const Beginning& beginning);

// Points are in the order of their tags and counted from the lowest (node_tags.hpp); properties are
// labels. Errors: also, an INCLUDE that is still there, and nodes in a system of coordinates that
// has no exact place in the basic one.
Result<ElementFile> read_nastran(const Source& source, NumberReading reading);

// INCLUDE 'mesh/nodes.bdf', whose name may go on over lines until the quote ends, or may have none.
std::optional<Inclusion> nastran_inclusion(TextLines lines);

}  // namespace circumspect::formats
