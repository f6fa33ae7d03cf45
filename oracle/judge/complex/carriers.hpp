// Where do two simplices meet?
#pragma once

#include <vector>

#include "kernel/complex/simplex.hpp"
#include "oracle/judge/complex/orientation_signs.hpp"

namespace circumspect::check {

// The least faces of two simplices that hold all that they have in common: their relative interiors
// meet. Both are empty if the simplices are disjoint.
struct Carriers {
  Simplex of_a, of_b;  // ascending
  // Do the simplices meet in a common face or not at all?
  bool are_proper() const { return of_a == of_b; }
};

// By orientations alone. Two simplices whose relative interiors are disjoint have a hyperplane
// through vertices of theirs, as many as there are dimensions, with one on either side and not both
// in it: of the hyperplanes that separate them, these are the extreme ones. What they have in
// common is in it, and so in the faces of theirs that are: these are asked next.
// Requires: both ascending, each affinely independent, no two of their points equal.
Carriers carriers(const OrientationSigns& orientation, Simplex a, Simplex b);

}  // namespace circumspect::check
