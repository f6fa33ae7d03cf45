// Decodes the wanted number of bytes from base 64.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace circumspect::formats {

// The first `count` bytes, or fewer if the text ends before. Blanks and ends of lines are skipped.
// Padding ends a group of four characters early, and further groups may follow, as when two texts
// are concatenated. Nothing if an invalid character comes first, or the text ends within a group.
std::optional<std::string> decode_base64(std::string_view text, std::size_t count);

}  // namespace circumspect::formats
