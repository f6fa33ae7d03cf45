// Files that gzip packed as a whole: mesh.vtk.gz is read as mesh.vtk is.
#pragma once

#include <string>
#include <string_view>

#include "oracle/formats/bytes/source.hpp"

namespace circumspect::formats {

// The name of what a file holds: "x.ele" of "x.ele.gz"; every other name as it is.
std::string_view name_inside(std::string_view path);

// load(), and unpacked if its first bytes are those of gzip, whatever its name. Lines in messages
// are those of what is in it. Errors: also, data that zlib cannot unpack, and more than a mesh of
// this size is known to pack: a megabyte, or two hundred times the size of the file.
Result<Source> load_unpacked(const std::string& path);

}  // namespace circumspect::formats
