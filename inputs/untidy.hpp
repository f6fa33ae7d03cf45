// Domains that are not piecewise linear complexes, for programs that promise to make some of them.
#pragma once

#include <set>
#include <string_view>

#include "inputs/cases.hpp"
#include "inputs/dice.hpp"

namespace circumspect::generators {

// An edge of a polygon is a segment here.
enum class Untidiness {
  kTouching,     // a vertex, which may be the end of a segment, lies inside a segment
  kCrossing,     // two segments cross, or a segment goes through a polygon
  kOverlapping,  // two segments of one line have more than a point in common
  kRepetition,   // two vertices are equal, and one cell has the one, another cell the other
};

std::string_view name(Untidiness kind);

// The domain with one to four such changes, each of one of these kinds. Its arrangement is valid and of doubles: what
// would not be so is left out, so there may be fewer: no polygons cross or overlap. Requires: a valid domain, of
// doubles; kinds.
ComplexCase untidied(Dice& dice, ComplexCase whole, const std::set<Untidiness>& kinds);

}  // namespace circumspect::generators
