// Meshes of MFEM, as text: .mesh.
//
//     MFEM mesh v1.0
//     dimension
//     3
//     elements
//     2
//     1 4 0 1 2 3                                 for each: attribute, kind, vertices from 0
//     boundary
//     1
//     1 2 0 1 2                                   likewise
//     vertices
//     5
//     3                                           coordinates of each, then these
//     0 0 0
//
// In place of coordinates there may be a section `nodes`: a function on the mesh, whose first
// values are those at the vertices if it is continuous.
#pragma once

#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/formats/beginning.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/element_file.hpp"

namespace circumspect::formats {

bool is_mfem(const Beginning& beginning);

// Attributes are labels. Errors: also, meshes that are not conforming, and NURBS; nodes of a
// function that is not continuous. A note says that elements of higher order are judged by their
// corners.
Result<ElementFile> read_mfem(const Source& source, NumberReading reading);

}  // namespace circumspect::formats
