// Distances for people, never less than they are.
#pragma once

#include <string>

#include "reference/kernel/exact/number.hpp"

namespace circumspect::report {

// The square root in two significant digits, rounded up: "2.1e-14"; "0" for zero. As a number it is at least
// the square root. Requires: squared >= 0.
std::string square_root_rounded_up(const Rational& squared);

}  // namespace circumspect::report
