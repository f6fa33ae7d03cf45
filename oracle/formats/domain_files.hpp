// Finds and reads domains, whatever their format: a piecewise linear complex in one file, or in two,
// as users of Triangle and TetGen keep it.
#pragma once

#include <string>

#include "oracle/formats/domain_file.hpp"
#include "reference/kernel/exact/number.hpp"

namespace circumspect::formats {

// .poly and .smesh (points in them or in the .node beside them), .off, .stl, .ply, .obj, .mesh, .msh, .vtk,
// .vtu, .vtp; a file of another name by what it holds. "-" is standard input.
Result<DomainFile> read_domain(const std::string& path, NumberReading reading);

// Does the name of this file say that it is a domain? (.off is a list of points as well, and so is a .ply
// without faces, which is read for that.)
bool is_domain_file(const std::string& path);

}  // namespace circumspect::formats
