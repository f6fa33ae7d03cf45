// Bytes in base 64, as many as are wanted.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace circumspect::formats {

// The first `count` bytes, or fewer if the text ends before. Blanks and ends of lines are skipped.
// Padding ends four characters early and others may follow, as where two texts stand one behind the
// other. None: a character of no meaning comes first, or the text ends among four.
std::optional<std::string> decode_base64(std::string_view text, std::size_t count);

}  // namespace circumspect::formats
