// Changes that can be made to the point sets of any family. Exact sets are rounded to doubles first
// where that is what it is about.
#pragma once

#include "inputs/cases.hpp"
#include "inputs/dice.hpp"

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

// Domains of doubles stay valid (Book: Definition 4.3), and of doubles: what would not is changed less, or
// not at all. In space only triangles survive rounding for certain.

// About half of the vertices, each moved by an ulp in some coordinates.
ComplexCase complex_one_ulp_away(Dice& dice, ComplexCase whole);

// Moved by 2^20 to 2^50 times its size, or less far.
ComplexCase complex_far_from_origin(Dice& dice, ComplexCase whole);

// Turned by a rational rotation and rounded; or by the same times an integer, exactly.
ComplexCase complex_rotated(Dice& dice, ComplexCase whole);

// Of sets of doubles, whatever family they are of: what a program is said to take.

// Binary exponents: 2^least to 2^largest.
struct Exponents {
  int least = 0;
  int largest = 0;
};

// Do all coordinates other than 0 lie between these powers of two, in absolute value?
bool lie_within(const PointsCase& set, Exponents exponents);

// The set as it is if they do. Else times a power of two, weights times its square; or where the exponents of its
// coordinates are too far from each other for that, with every exponent moved by as much as brings all of them in, in
// their order. Requires: doubles.
PointsCase brought_within(const PointsCase& set, Exponents exponents, bool may_repeat_points);

// Integers of at most so many bits: the set as it is if it is of such, else times a power of two and rounded. The
// weights become integers too. Requires: doubles; 1 <= bits <= 53.
PointsCase in_integers(const PointsCase& set, int bits, bool may_repeat_points);

}  // namespace circumspect::generators
