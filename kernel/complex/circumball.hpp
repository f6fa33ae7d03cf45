// Circumballs with exact centre and squared radius. Book: Definition 1.17 and Section 4.2; for
// weighted points the orthoball whose lifted companion is the witness plane.
#pragma once

#include "kernel/complex/point_set.hpp"

namespace circumspect {

struct Ball {
  Point centre;
  Rational squared_radius;  // of an orthoball possibly negative
};

// The circumball of a simplex whose centre lies in the simplex's affine hull: its smallest one.
// With weights, the orthoball: |p − centre|² − weight(p) = squared_radius at every vertex p.
// Requires: vertices affinely independent.
Ball circumball(const PointSet& points, const Simplex& simplex);

// |q − centre|² − weight(q) − squared_radius: negative iff q is strictly inside (weighted: iff q⁺
// is strictly below the witness plane), zero on the sphere.
Rational power(const PointSet& points, const Ball& ball, Vertex q);

}  // namespace circumspect
