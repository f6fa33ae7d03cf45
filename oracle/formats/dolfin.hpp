// Meshes of DOLFIN before its version of XDMF, as XML: told by their content.
//
//     <dolfin>
//       <mesh celltype="triangle" dim="2">
//         <vertices size="3"> <vertex index="0" x="0" y="0"/> … </vertices>
//         <cells size="1"> <triangle index="0" v0="0" v1="1" v2="2"/> </cells>
//       </mesh>
//     </dolfin>
#pragma once

#include <string_view>

#include "kernel/exact/number_text.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/element_file.hpp"

namespace circumspect::formats {

// Does the text begin as such a file does?
bool is_dolfin(std::string_view text);

// Points are counted from 0. Errors: also, values on a mesh that is in another file, and vertices
// or cells in another order than that of their indices.
Result<ElementFile> read_dolfin(const Source& source, NumberReading reading);

}  // namespace circumspect::formats
