// The table of families that `circumspect generate --list` prints.
#pragma once

#include <string>
#include <vector>

#include "oracle/report/json.hpp"

namespace circumspect::cli {

// One line a family of points, a modifier, a family of domains, in this order.
std::string families_text();

// {"points": […], "modifiers": […], "domains": […]}, each entry with its name and what it is about.
report::Json families_json();

// What to say if there is no family of that name: the nearest names, and where to find all.
std::string unknown_family(const std::string& name);

}  // namespace circumspect::cli
