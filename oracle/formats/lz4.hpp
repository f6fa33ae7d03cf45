// Blocks of LZ4, which VTK's XML files may hold: copies of literals and of what came before.
#pragma once

#include <span>
#include <string_view>

namespace circumspect::formats {

// Unpacks one block, without a frame around it; false if it does not give exactly the bytes for
// which there is room.
bool unpack_lz4(std::string_view block, std::span<char> to);

}  // namespace circumspect::formats
