// Formats of other programs that are not read but known by their endings, and how to convert their
// files.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace circumspect::formats {

// What a file with this ending (".step") is and which command converts it, for a message "found …"
// where a mesh or points were expected; nothing if the ending is unknown. A domain (".poly") is one
// of these.
std::optional<std::string> other_kind(std::string_view ending);

// The command that converts a file that meshio reads to .vtu; `format`: meshio's name of the
// format, if the file's name does not tell.
std::string read_by_meshio(const std::string& in, const std::string& format = "",
                           std::string_view packages = "python3-meshio");

}  // namespace circumspect::formats
