// Files of other programs that are not read, and how to make one of them that is.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace circumspect::formats {

// What a file of this extension (".step") is and which command converts it, for a message "found …"; none
// if nothing is known of it.
std::optional<std::string> other_kind(std::string_view extension);

}  // namespace circumspect::formats
