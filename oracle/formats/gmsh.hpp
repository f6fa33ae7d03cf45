// Meshes as Gmsh writes them, in text or binary of either byte order: .msh, version 2 and 4.
//
//     $MeshFormat                                 version, 0 (text) or 1 (binary), 8
//     $Nodes                                      each has a tag of its own, in any order
//     $Elements                                   of all dimensions; the (first) physical group of
//                                                 each is its label, 0 if it is in none
//     $Entities                                   of version 4: the physical groups of each
//     $PhysicalNames, $NodeData, …                other sections are skipped
//
// Lines outside the sections are skipped, with a note. Numbers follow one another, wherever lines
// end.
#pragma once

#include <ostream>
#include <string_view>

#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/element_file.hpp"

namespace circumspect::formats {

// Is this the word with which such a file begins?
bool is_gmsh_keyword(std::string_view token);

// Points are in the order of their tags and counted from the lowest; if tags have gaps, they are
// counted from 1, which is noted.
Result<ElementFile> read_gmsh(const Source& source, NumberReading reading);

// Version 2.2, in text; tags count from 1; labels are physical groups. Requires: points of
// dimension 2 or 3, whose third coordinate is written as 0; vertices are counted from the first
// index of the points.
void write_gmsh(std::ostream& out, const ElementFile& file);

}  // namespace circumspect::formats
