// Coordinates that say the same in fewer digits.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "inputs/points_case.hpp"

namespace circumspect::generators {

// How long it takes to write the number down, in bits; a sign counts as half a bit more. Returned in
// half bits.
std::size_t length(const Rational& value);
std::size_t length(const PointsCase& set);

// Moves the coordinates and the weights of all points at once, then one by one, to numbers that are
// shorter, as long as `accepts` takes them. Returns whether anything became shorter. Doubles
// whose magnitude is not near the largest become doubles.
bool simplify_numbers(PointsCase& set, const std::function<bool(const PointsCase&)>& accepts);

}  // namespace circumspect::generators
