// Does a point lie in the open circumball of a simplex? Book: Section 3.1 (InCircle, InSphere),
// Section 5.2 (Orient4D of lifted points, for weighted sets).
#pragma once

#include <span>

#include "kernel/predicates/configuration.hpp"

namespace circumspect {

// Positive iff q lies strictly inside the open circumball of the k-simplex (weighted: q⁺ lies
// strictly below its witness plane), zero iff on the sphere (on the plane), negative iff outside.
// It is the sign of det[p_i⁺ − q⁺] times the orientation of the simplex, hence independent of the
// order of its vertices. Everything happens within the affine hull of simplex and q, in the
// coordinates `axes`; the height stays the full |p|² − w, which over a flat is still a paraboloid
// up to an affine function.
//
// Laws (held by in_ball_test.cpp under these numbers):
//  B1 no permutation of the simplex changes it.
//  B2 it is the sign of r² − |q − o|², o and r the exact circumcentre and circumradius.
//  B3 translation and positive uniform scaling keep it.
//  B4 it agrees with CGAL's exact kernel (side_of_bounded_circle/sphere, power tests).
//  B5 Two simplices on opposite sides of a shared facet: the apex of one is in the ball of the
//     other iff the converse holds (the facet is locally Delaunay "equivalently", Section 4.2).
//  B6 adding one constant to all weights, or an affine function to all heights, keeps it.
//  B7 it does not depend on the axes chosen for the flat.
// Requires: simplex.size() == axes.size() + 1; the simplex not degenerate on the axes; q in its
// affine hull.
int in_ball(const Configuration& points, std::span<const std::size_t> axes,
            std::span<const Vertex> simplex, Vertex q);

// Within the affine hull of all points. Requires: simplex.size() == points.dimension() + 1.
int in_ball(const Configuration& points, std::span<const Vertex> simplex, Vertex q);

}  // namespace circumspect
