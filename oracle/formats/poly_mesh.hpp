// Meshes of OpenFOAM: the folder polyMesh with the files points, faces, owner and neighbour, each
// of which may be packed (.gz, .zst).
//
// A face lists its vertices around it; owner and neighbour give for each face the cell behind it
// and, for those that are inside, the cell in front of it. Cells of four triangles are tetrahedra,
// all others are polyhedra.
#pragma once

#include <optional>
#include <string>

#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/element_file.hpp"

namespace circumspect::formats {

// The folder with the four files, for a path that names it, the folder constant or the case; or a
// file of ParaView's in the case, case.foam, which is empty. Nothing if there is none.
std::optional<std::string> poly_mesh_folder(const std::string& path);

// The cells, and the triangles of the boundary. Requires of the source: its name is such a path;
// the text is not looked at. Errors name the files.
Result<ElementFile> read_poly_mesh(const Source& source, NumberReading reading);

}  // namespace circumspect::formats
