// Files that gzip or Zstandard packed as a whole: mesh.vtk.gz and mesh.vtk.zst are read as mesh.vtk
// is.
#pragma once

#include <string>
#include <string_view>

#include "oracle/formats/bytes/source.hpp"

namespace circumspect::formats {

// The name of what a file holds: "x.ele" of "x.ele.gz" and of "x.ele.zst"; every other name as it
// is.
std::string_view name_inside(std::string_view path);

// The same path, or "x.node.gz" or "x.node.zst" of "x.node" if only that is there.
std::string packed_or_not(const std::string& path);

// load(), and unpacked if its first bytes are those of gzip or zstd, whatever its name. Lines in
// messages are those of what is in it. Errors: also, data that cannot be unpacked, and
// more than a mesh of this size is known to pack: a megabyte, or two hundred times the size of the
// file.
Result<Source> load_unpacked(const std::string& path);

}  // namespace circumspect::formats
