// Sums of two angles of rational vectors.
#pragma once

#include <string>

#include "kernel/exact/number.hpp"

namespace circumspect {

// α + β − 180 in degrees, correctly rounded, as to_decimal writes numbers. Each angle, from 0 to
// 180 degrees, is given by its sign(cos)·cos². Requires: two such squares, from −1 to 1.
std::string excess_in_degrees(const Rational& alpha, const Rational& beta);

}  // namespace circumspect
