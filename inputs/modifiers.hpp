// Changes that can be made to the point sets of any family. Exact sets are rounded to doubles first
// where that is what it is about.
#pragma once

#include "inputs/dice.hpp"
#include "inputs/points_case.hpp"

namespace circumspect::generators {

// Weights are kept where nothing else is said. Points that become equal become one, unless
// `may_repeat_points`.

// Rounded to doubles, then about half of the coordinates moved by one ulp, up or down: what was
// cospherical or coplanar is almost so. A coordinate 0 moves by an ulp of the set's largest coordinate.
PointsCase one_ulp_away(Dice& dice, const PointsCase& set, bool may_repeat_points);

// The whole set times 2^k, weights times 4^k, k from −300 to 300 (nearer to 0 where coordinates would be
// more than 2^1000): an exact change that no verdict may see.
PointsCase scaled_by_power_of_two(Dice& dice, const PointsCase& set, bool may_repeat_points);

// Moved by 2^20 to 2^50 times the size of the set, then rounded to doubles: integers near the origin stay
// exact for the smaller moves, all else loses its low bits.
PointsCase far_from_origin(Dice& dice, const PointsCase& set, bool may_repeat_points);

}  // namespace circumspect::generators
