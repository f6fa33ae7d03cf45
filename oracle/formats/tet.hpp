// Meshes of tetrahedra as the program CDT of Attene and Diazzi and others write them: .tet.
//
//     8 vertices
//     6 tets                                      or 6 inner tets, and on a line below 4 outer tets
//     x y z                                       a line each; with option r, fractions
//     4 v0 v1 v2 v3                               a line each, indices from 0
//
// With option b, everything after the counts is binary: doubles, then vertices of 32 bits.
#pragma once

#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/element_file.hpp"

namespace circumspect::formats {

// Outer tetrahedra, which fill the convex hull around a domain, are left out, which is noted.
// Points are counted from 0.
Result<ElementFile> read_tet(const Source& source, NumberReading reading);

}  // namespace circumspect::formats
