// Meshes of FreeFem, as text: .msh.
//
//     4 2 4                                       in the plane: vertices, triangles, edges
//     0 0 1                                       x, y and a label of each vertex
//     1 2 3 0                                     the vertices of each triangle, from 1; a label
//     1 2 1                                       those of each edge
//
// In space these are vertices, tetrahedra and triangles.
#pragma once

#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/formats/beginning.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/element_file.hpp"

namespace circumspect::formats {

// Are three counts on the first line, and a vertex on the second?
bool is_freefem(const Beginning& beginning);

Result<ElementFile> read_freefem(const Source& source, NumberReading reading);

}  // namespace circumspect::formats
