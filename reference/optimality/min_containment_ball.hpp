// Min-containment balls. Book: Definition 1.20, Propositions 4.6 and 4.7.
#pragma once

#include "reference/complex/circumball.hpp"
#include "reference/complex/point_set.hpp"
#include "reference/complex/triangulation.hpp"

namespace circumspect::optimality {

// The point of a simplex that is nearest to p. Requires: the simplex affinely independent.
Point nearest_point(const PointSet& points, const Simplex& simplex, const Point& p);

// The smallest closed ball that contains a simplex. Book: Proposition 4.6, "Let q be the point in σ
// nearest o. Then o_mc = q and r_mc² = r² − d(o, q)²".
// Requires: the simplex affinely independent; no weights.
Ball min_containment_ball(const PointSet& points, const Simplex& simplex);

// The largest of the min-containment balls of all simplices, the quantity of Proposition 4.7.
// Requires: at least one simplex; no weights.
Ball largest_min_containment_ball(const PointSet& points, const Triangulation& triangulation);

}  // namespace circumspect::optimality
