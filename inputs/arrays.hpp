// Generated sets as arrays of doubles, for programs under test, and back.
#pragma once

#include <circumspect/subject.hpp>

#include "inputs/points_case.hpp"

namespace circumspect::generators {

// Each number rounded to the nearest double: call in_doubles first, so that what the program sees is
// what is judged. `dimension`: that of an empty set, which has no point to tell.
PointArray array(const PointsCase& set, std::size_t dimension = 3);

// The exact values. Requires: all numbers are finite; coordinates.size() is a multiple of dimension;
// weights are none or one a point.
PointsCase from(const PointArray& points);

}  // namespace circumspect::generators
