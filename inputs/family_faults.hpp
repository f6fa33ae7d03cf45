// What to say of a family that somebody names and that is none, or has no sets in a dimension. The command, C, Python and
// the harnesses all say it in these words.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "inputs/families.hpp"

namespace circumspect::generators {

// "3", "2 to 6", "3 and above".
std::string dimensions_text(const Family& family);

// `kind`: "points" or "domains", or "" where both are asked for. `nearest`: "; the nearest is …", if that is known.
// Requires: `found` is fit to be printed.
std::string unknown_family_text(std::string_view kind, std::string_view found,
                                std::string_view nearest = "");

std::string no_sets_text(std::string_view family, std::string_view dimensions, std::int64_t found);

}  // namespace circumspect::generators
