// Blocks of LZMA in a container of xz, which VTK's XML files may hold.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace circumspect::formats {

// Unpacks one block; false if it does not give exactly the bytes for which there is room, or needs
// more memory than 128 MB. Null if the program was built without liblzma.
using UnpackBlock = bool (*)(std::string_view block, std::span<char> to);
UnpackBlock lzma_unpacker();

// "5.4.1" of the library; empty without it.
std::string version_of_lzma();

}  // namespace circumspect::formats
