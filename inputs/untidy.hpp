// Domains of the plane that are no piecewise linear complexes, for programs that promise to make some of them.
#pragma once

#include <set>
#include <string_view>

#include "inputs/cases.hpp"
#include "inputs/dice.hpp"

namespace circumspect::generators {

enum class Untidiness {
  kTouching,     // a vertex, which may be the end of a segment, lies inside a segment
  kCrossing,     // two segments cross
  kOverlapping,  // two segments of one line have more than a point in common
  kRepetition,   // two vertices are equal
};

std::string_view name(Untidiness kind);

// The domain with one to four such changes, each of one of these kinds. Its arrangement is valid and of doubles: what
// would not be so is left out, so there may be fewer. Requires: a valid domain of the plane, of doubles; kinds.
ComplexCase untidied(Dice& dice, ComplexCase whole, const std::set<Untidiness>& kinds);

}  // namespace circumspect::generators
