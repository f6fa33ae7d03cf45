// Surfaces and clouds of points as PLY, in text or binary of either byte order.
//
//     ply
//     format ascii 1.0                            or binary_little_endian, binary_big_endian
//     comment …                                   and obj_info …: ignored
//     element vertex 8
//     property float x                            y and z too, of any type, among other properties
//     element face 6
//     property list uchar int vertex_indices      or vertex_index
//     end_header
//     …                                           the elements, one list of each kind
//
// Elements and properties of other names are read over.
#pragma once

#include <ostream>

#include "oracle/formats/element_file.hpp"
#include "oracle/formats/source.hpp"
#include "reference/kernel/exact/number.hpp"

namespace circumspect::formats {

struct PlyFile {
  PointFile points;        // counted from 0
  SimplexFile faces = {};  // of any number of vertices; none in a cloud of points
};

// The points, and the faces if there are any.
Result<PlyFile> read_ply_file(const Source& source, NumberReading reading);

// The same as elements, faces as polygons.
Result<ElementFile> read_ply_elements(const Source& source, NumberReading reading);

// In text: the points, the surface (surface_of) and, as far as there are any, the edges. Requires: as write_gmsh.
void write_ply(std::ostream& out, const ElementFile& file);

// A surface. Faces are polygons of one line. Errors: also, a file without the element face.
Result<DomainFile> read_ply(const Source& source, NumberReading reading);

}  // namespace circumspect::formats
