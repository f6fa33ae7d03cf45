// Triangles and edges as Triangle and TetGen write them beside a mesh: .face and .edge.
//
//     faces [markers]                             markers: 0 or 1
//     index v0 v1 v2 [marker] …                   .edge: two vertices
//
// TetGen may append the tetrahedra beside each.
#pragma once

#include <map>
#include <ostream>

#include "oracle/formats/simplex_file.hpp"
#include "oracle/formats/source.hpp"

namespace circumspect::formats {

// The `vertices` vertices of each, 3 or 2, as written; the markers are its labels. What TetGen appends must be
// integers, as many on every line, and is otherwise ignored.
Result<SimplexFile> read_face(const Source& source, std::size_t vertices);

// Adds the markers of triangles to others, by their vertices counted from 0, ascending; but not 0.
void add_markers(const SimplexFile& file, Vertex first_index, std::map<Simplex, Vertex>& markers);

// Without markers. Requires: all simplices have one number of vertices.
void write_face(std::ostream& out, const SimplexFile& file);

}  // namespace circumspect::formats
