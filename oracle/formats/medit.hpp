// Meshes as Medit and Gmsh write them, as text: .mesh.
//
//     MeshVersionFormatted 2
//     Dimension 3                                 or 2
//     Vertices 8                                  for each: x y [z] reference
//     Edges 12                                    for each: v0 v1 reference
//     Triangles, Quadrilaterals, Tetrahedra …     likewise; indices from 1
//     …                                           other sections are read over
//     End                                         which may be missing: that is noted
//
// Numbers follow one another, wherever lines end.
#pragma once

#include <ostream>
#include <string_view>

#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/element_file.hpp"

namespace circumspect::formats {

// Is this the keyword with which such a file begins?
bool is_medit_keyword(std::string_view token);

// References are dropped; the first index is 1.
Result<ElementFile> read_medit(const Source& source, NumberReading reading);

// Labels are references. Requires: points of dimension 2 or 3; vertices are counted from the first
// index of the points.
void write_medit(std::ostream& out, const ElementFile& file);

}  // namespace circumspect::formats
