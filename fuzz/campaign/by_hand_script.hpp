// What is wrong with a mesh as a few lines of Python, for who trusts no program of ours.
#pragma once

#include <string>

#include "oracle/report/json.hpp"

namespace circumspect::campaign {

// A script that shows the first witness of a verdict by rational arithmetic: the coordinates of
// what it names are in it, and it prints the numbers that decide. Empty: no rule is broken, or none
// that such numbers show.
std::string by_hand_script(const report::Json& verdict);

}  // namespace circumspect::campaign
