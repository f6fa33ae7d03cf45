// Triangles and tetrahedra as Triangle and TetGen write them: .ele.
//
//     simplices k [attributes]                      k: vertices of each
//     index v0 … v(k-1) attributes…                 one line a simplex
#pragma once

#include <ostream>

#include "oracle/formats/simplex_file.hpp"
#include "oracle/formats/source.hpp"
#include "reference/kernel/exact/number.hpp"

namespace circumspect::formats {

// The k vertices of each simplex, as written. An .ele file does not say the dimension, so that
// elements of second order (6 nodes in the plane, 10 in space) come back with all their nodes.
// Attributes have to be numbers and are otherwise ignored. Indices of simplices follow one by one.
Result<SimplexFile> read_ele(const Source& source, NumberReading reading = NumberReading::kDouble);

// Requires: every simplex has vertices_per_simplex vertices, at least 1.
void write_ele(std::ostream& out, const SimplexFile& file);

}  // namespace circumspect::formats
