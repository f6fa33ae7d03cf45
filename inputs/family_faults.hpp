// The messages for an unknown family, and for one without sets in a dimension. The command, C,
// Python and the harnesses all use these words.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "inputs/families.hpp"

namespace circumspect::generators {

// "3", "2 to 6", "3 and above".
std::string dimensions_text(const Family& family);

// `kind`: "points" or "domains", or "" if both are allowed. `nearest`: "; the nearest is …", if
// that is known. Requires: `found` is printable.
std::string unknown_family_text(std::string_view kind, std::string_view found,
                                std::string_view nearest = "");

std::string no_sets_text(std::string_view family, std::string_view dimensions, std::int64_t found);

}  // namespace circumspect::generators
