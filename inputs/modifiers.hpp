// Changes that can be made to the point sets of any family. Exact sets are first rounded to doubles
// if the change is about doubles.
#pragma once

#include "inputs/cases.hpp"
#include "inputs/dice.hpp"

namespace circumspect::generators {

// Weights are kept unless stated otherwise. Points that become equal are merged, unless
// `may_repeat_points`.

// Rounded to doubles, then about half of the coordinates moved by one ulp, up or down: what was
// cospherical or coplanar is almost so. A coordinate 0 moves by an ulp of the set's largest
// coordinate.
PointsCase one_ulp_away(Dice& dice, const PointsCase& set, bool may_repeat_points);

// The whole set times 2^k, weights times 4^k, k from −300 to 300 (closer to 0 if coordinates would
// exceed 2^1000): an exact change that must not affect any verdict.
PointsCase scaled_by_power_of_two(Dice& dice, const PointsCase& set, bool may_repeat_points);

// Moved by 2^20 to 2^50 times the size of the set, then rounded to doubles: integers near the
// origin stay exact for the smaller moves; everything else loses its low bits.
PointsCase far_from_origin(Dice& dice, const PointsCase& set, bool may_repeat_points);

// Domains of doubles stay valid (Book: Definition 4.3) and keep double coordinates: a change that
// would break this is made smaller, or not made. In space only triangles are certain to survive
// rounding.

// About half of the vertices, each moved by an ulp in some coordinates.
ComplexCase complex_one_ulp_away(Dice& dice, ComplexCase whole);

// Moved by 2^20 to 2^50 times its size, or less.
ComplexCase complex_far_from_origin(Dice& dice, ComplexCase whole);

// Turned by a rational rotation and rounded; or, exactly, by that rotation times an integer.
ComplexCase complex_rotated(Dice& dice, ComplexCase whole);

// Restricts sets of doubles, of any family, to what a program is documented to accept.

// Binary exponents: 2^least to 2^largest.
struct Exponents {
  int least = 0;
  int largest = 0;
};

// Do all coordinates other than 0 lie between these powers of two, in absolute value?
bool lie_within(const PointsCase& set, Exponents exponents);

// The unchanged set if they do. Otherwise it is multiplied by a power of two, and weights by its
// square; or, if the exponents of its coordinates are too far apart for that, all exponents are
// compressed into the range in their order. Requires: doubles.
PointsCase brought_within(const PointsCase& set, Exponents exponents, bool may_repeat_points);

// Integers of at most so many bits: the unchanged set if it consists of these, else multiplied by a
// power of two and rounded. The weights become integers too. Requires: doubles; 1 <= bits <= 53.
PointsCase in_integers(const PointsCase& set, int bits, bool may_repeat_points);

}  // namespace circumspect::generators
