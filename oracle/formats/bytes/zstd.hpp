// Files that Zstandard packed as a whole.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "oracle/formats/bytes/source.hpp"

namespace circumspect::formats {

inline constexpr std::string_view kZstdMagic = "\x28\xb5\x2f\xfd";

// What the frames of a packed file hold, one behind the other. Errors: data that libzstd cannot
// unpack, or not in 128 MB beside the result; more than `most` bytes; and, where the program was
// built without libzstd, every packed file.
Result<std::string> unpack_zstd(const Source& source, std::size_t most);

// "1.5.4" of the library; empty without it.
std::string version_of_zstd();

}  // namespace circumspect::formats
