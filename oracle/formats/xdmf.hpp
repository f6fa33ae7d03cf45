// Meshes in XDMF, versions 2 and 3, as meshio, DOLFIN and DOLFINx write them: .xdmf, .xmf.
//
//     <Xdmf Version="3.0"><Domain><Grid>
//       <Geometry GeometryType="XYZ">       or XY
//         <DataItem Dimensions="4 3" Format="XML">0 0 0  1 0 0  0 1 0  0 0 1</DataItem></Geometry>
//       <Topology TopologyType="Tetrahedron">
//         <DataItem Dimensions="1 4" Format="HDF">x.h5:/Mesh/topology</DataItem></Topology>
//     </Grid></Domain></Xdmf>
#pragma once

#include <string_view>

#include "kernel/exact/number_text.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/element_file.hpp"

namespace circumspect::formats {

// Does the text begin as an XDMF file does?
bool is_xdmf(std::string_view text);

// The first grid that has both points and elements of its own; a note counts the others. Numbers
// are text in the file, in a file of HDF5 (hdf5.hpp), or the bytes of a binary one; both must lie
// in the folder of this file or below it. Points are counted from 0.
Result<ElementFile> read_xdmf(const Source& source, NumberReading reading);

}  // namespace circumspect::formats
