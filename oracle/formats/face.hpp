// Triangles and edges as Triangle and TetGen write them beside a mesh: .face and .edge.
//
//     faces [markers]                             markers: 0 or 1
//     index v0 v1 v2 [marker] …                   .edge: two vertices
//
// TetGen may append the tetrahedra beside each.
#pragma once

#include <ostream>

#include "oracle/formats/simplex_file.hpp"
#include "oracle/formats/source.hpp"

namespace circumspect::formats {

// The `vertices` vertices of each, 3 or 2, as written. Markers and what TetGen appends must be
// integers, as many on every line, and are otherwise ignored.
Result<SimplexFile> read_face(const Source& source, std::size_t vertices);

// Without markers. Requires: all simplices have one number of vertices.
void write_face(std::ostream& out, const SimplexFile& file);

}  // namespace circumspect::formats
