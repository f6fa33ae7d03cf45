// Domains that are not piecewise linear complexes, for programs that promise to resolve some kinds
// of these.
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
  kRepetition,   // two vertices are equal, and different cells have them
};

std::string_view name(Untidiness kind);

// The domain with one to four such changes, each of one of these kinds. Its arrangement is valid
// and has double coordinates; changes that would break this are left out, so there may be fewer. No
// polygons cross or overlap. Requires: a valid domain, of doubles; kinds.
ComplexCase untidied(Dice& dice, ComplexCase whole, const std::set<Untidiness>& kinds);

}  // namespace circumspect::generators
