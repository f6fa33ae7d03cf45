// Meshes of Exodus, as Cubit, MOOSE and libMesh write them: .e, .exo. They are netCDF.
//
//     coordx, coordy, coordz                      or coord, with an axis a row
//     connect1, connect2, …                       nodes from 1 of each element of a block
//       elem_type                                 an attribute, as TETRA4 or TRI3
//     eb_prop1                                    the number of each block
#pragma once

#include "kernel/exact/number_text.hpp"
#include "oracle/formats/beginning.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/element_file.hpp"

namespace circumspect::formats {

bool is_exodus(const Beginning& beginning);

// Numbers of blocks are labels. Points are counted from 1; maps of their numbers are not read.
// Errors: also, netCDF in HDF5.
Result<ElementFile> read_exodus(const Source& source, NumberReading reading);

}  // namespace circumspect::formats
